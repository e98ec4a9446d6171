// lacuna-mpi as a user runs it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/program.h"
#include "mpi/mpirun.h"

namespace {

using lacuna::tests::content_of;
using lacuna::tests::Folder;
using lacuna::tests::occurrences;
using lacuna::tests::Outcome;
using namespace lacuna::tests::mpi;

TEST(Mpi, TheCommandWritesTheFileOfLacunaAndReportsWhatItCost) {
    Folder folder;
    const std::string alone = folder.path("alone.npy");
    const std::string path = folder.path("ranks.npy");
    const std::string report = folder.path("report.json");
    ASSERT_EQ(lacuna::tests::run({"sample", "--radius", "0.004", "--torus", "-o", alone}).exit_code,
              0);

    const Outcome outcome = mpirun(
        ranks(3, {"sample", "--radius", "0.004", "--torus", "-o", path, "--report", report}));

    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(" on 3 ranks -> "), std::string::npos) << outcome.err;
    EXPECT_EQ(occurrences(outcome.err, "\n"), 1u) << outcome.err;
    EXPECT_EQ(content_of(path), content_of(alone));
    const std::string told = content_of(report);
    for (const char* const word : {"\"ranks\": 3", "border_bytes_sent", "points_sha256", "median",
                                   "most_border_messages_in_a_round", "exchange"})
        EXPECT_NE(told.find(word), std::string::npos) << word;
}

TEST(Mpi, TheProgressBarIsShownWhereItIsAskedFor) {
    Folder folder;
    const std::vector<std::string> options{"sample", "--count", "1M", "-o", folder.path("x.npy")};
    std::vector<std::string> with_bar = options;
    with_bar.emplace_back("--progress");
    EXPECT_EQ(mpirun(ranks(2, options)).err.find('\r'), std::string::npos);
    for (const char* const terminal : {"xterm", "dumb"}) {
        setenv("TERM", terminal, 1);
        const std::string shown = mpirun(ranks(2, with_bar)).err;
        EXPECT_NE(shown.find("% "), std::string::npos) << shown;
        EXPECT_EQ(shown.find('\x1b') == std::string::npos, terminal == std::string("dumb"));
    }
}

TEST(Mpi, HelpAndVersionAreToldOnce) {
    const Outcome version = mpirun(ranks(3, {"--version"}));
    EXPECT_EQ(version.exit_code, 0) << version.err;
    EXPECT_EQ(occurrences(version.out, "lacuna-mpi "), 1u) << version.out;
    const Outcome help = mpirun(ranks(2, {"sample", "--help"}));
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(occurrences(help.out, "Usage: "), 1u) << help.out;
}

}  // namespace
