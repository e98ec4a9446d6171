// When something goes wrong on one rank: one message, the right exit code, no hang, and nothing
// half written.
#include <gtest/gtest.h>

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "cli/program.h"
#include "mpi/mpirun.h"

namespace {

using lacuna::tests::content_of;
using lacuna::tests::Folder;
using lacuna::tests::occurrences;
using lacuna::tests::Outcome;
using namespace lacuna::tests::mpi;

void expect_one_message(const Outcome& outcome, int exit_code, const std::string& message) {
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    EXPECT_EQ(occurrences(outcome.err, "lacuna-mpi: "), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

TEST(MpiFaults, ABadOptionIsToldOnce) {
    expect_one_message(mpirun(ranks(3, {"sample", "--radus", "0.1"})), 2, "did you mean --radius");
    expect_one_message(mpirun(ranks(3, {"sample", "--radius", "x", "-o", "x.npy"})), 2,
                       "--radius x");
}

TEST(MpiFaults, AnOutputThatIsNoNpyIsRefused) {
    expect_one_message(mpirun(ranks(2, {"sample", "--radius", "0.1", "-o", "x.svg"})), 2, ".npy");
    expect_one_message(mpirun(ranks(2, {"sample", "--radius", "0.1"})), 2, "--output");
    expect_one_message(mpirun(ranks(2, {"sample", "--radius", "0.1", "-o", "/nowhere/x.npy"})), 3,
                       "there is no folder /nowhere");
}

TEST(MpiFaults, MoreRanksThanTheDomainHasRoomForAreRefused) {
    Folder folder;
    expect_one_message(mpirun(ranks(5, {"sample", "--radius", "0.1", "-o", folder.path("x.npy")})),
                       2, "5 ranks are too many for this radius: at most 4");
    EXPECT_TRUE(folder.names().empty());
}

TEST(MpiFaults, RanksWithDifferentRequestsAreRefused) {
    Folder folder;
    const std::string path = folder.path("x.npy");
    expect_one_message(mpirun(joined(ranks(2, {"sample", "--radius", "0.01", "-o", path}),
                                     ranks(1, {"sample", "--radius", "0.02", "-o", path}))),
                       2, "rank 2 was given another request than rank 0");
    expect_one_message(mpirun(joined(ranks(2, {"sample", "--radius", "0.01", "-o", path}),
                                     ranks(1, {"sample", "--radius"}))),
                       2, "--radius: a value must follow");
    EXPECT_TRUE(folder.names().empty());
}

TEST(MpiFaults, HelpForSomeRanksIsRefused) {
    Folder folder;
    const auto make = ranks(1, {"sample", "--radius", "0.01", "-o", folder.path("x.npy")});
    const std::string message = "rank 1 was given another request than rank 0";
    expect_one_message(mpirun(joined(make, ranks(1, {"sample", "--help"}))), 2, message);
    expect_one_message(mpirun(joined(ranks(1, {"--version"}), make)), 2, message);
    expect_one_message(mpirun(joined(ranks(1, {"--help"}), ranks(1, {"sample", "--radus"}))), 2,
                       "did you mean --radius");
    EXPECT_TRUE(folder.names().empty());
}

TEST(MpiFaults, ABackendThatOneRankLacksIsToldOnce) {
    Folder folder;
    const std::string path = folder.path("x.npy");
    expect_one_message(mpirun(joined(ranks(1, {"sample", "--radius", "0.01", "-o", path}),
                                     ranks(1, {"sample", "--radius", "0.01", "--backend",
                                               "reference", "-o", path}))),
                       2, "--backend reference");
    EXPECT_TRUE(folder.names().empty());
}

TEST(MpiFaults, ADiskThatIsFullForOneRankLeavesNothing) {
    Folder folder;
    const std::string path = folder.path("x.npy");
    lacuna::tests::write_file(path, "an older file");
    const Outcome outcome =
        mpirun(joined(ranks(1, {"sample", "--radius", "0.001", "-o", path}),
                      limited_ranks(1, 10000, "sample --radius 0.001 -o " + path)));
    expect_one_message(outcome, 3, path + ": File too large");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"x.npy"});
    EXPECT_EQ(content_of(path), "an older file");
}

// MPI_Init makes a file of more than 100 KiB in shared memory.
TEST(MpiFaults, ALimitBelowMpisOwnFilesIsTold) {
    Folder folder;
    const std::string path = folder.path("x.npy");
    expect_one_message(mpirun(limited_ranks(2, 100, "sample --radius 0.005 -o " + path)), 3,
                       path + ": File too large");
    expect_one_message(mpirun(limited_ranks(2, 0, "sample --radius 0.1 -o " + path)), 3,
                       "(File too large)");
    EXPECT_TRUE(folder.names().empty());
}

TEST(MpiFaults, AReportThatCannotBeWrittenLeavesNoSet) {
    Folder folder;
    const std::string path = folder.path("x.npy");
    const std::string report = folder.path("x.json");
    // The set fits into 1 KiB, the report does not.
    expect_one_message(
        mpirun(limited_ranks(2, 1,
                             "sample --radius 0.1 --limit 9 -o " + path + " --report " + report)),
        3, report + ": File too large");
    EXPECT_TRUE(folder.names().empty()) << folder.names().front();
}

TEST(MpiFaults, ARankThatDoesNotSeeTheFolderIsTold) {
    Folder seen;
    Folder other;
    const auto rank_in = [](const Folder& folder) {
        return std::vector<std::string>{
            "-n",     "1",        "/usr/bin/env", "--chdir", folder.path(""), LACUNA_MPI_PROGRAM,
            "sample", "--radius", "0.01",         "-o",      "x.npy"};
    };
    const std::string others = std::filesystem::path(other.path("x")).parent_path().string();
    const Outcome outcome = mpirun(joined(rank_in(seen), rank_in(other)));
    expect_one_message(outcome, 3, "x.npy: rank 1, in the folder " + others);
    EXPECT_NE(outcome.err.find("cannot write into .x.npy."), std::string::npos) << outcome.err;
    EXPECT_TRUE(seen.names().empty());
    EXPECT_TRUE(other.names().empty());
}

// Finds the processes of lacuna-mpi that write into the folder, from Linux's /proc.
std::vector<pid_t> ranks_writing_to(const std::string& path) {
    std::vector<pid_t> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        std::ifstream file(entry.path() / "cmdline", std::ios::binary);
        const std::string line((std::istreambuf_iterator<char>(file)), {});
        if (line.starts_with(LACUNA_MPI_PROGRAM) && line.find(path) != std::string::npos)
            found.push_back(static_cast<pid_t>(std::stol(name)));
    }
    return found;
}

// The processor time of a process, in the system's ticks: 100 a second.
long ticks_of(pid_t process) {
    std::istringstream stat(content_of("/proc/" + std::to_string(process) + "/stat"));
    stat.ignore(10000, ')');
    std::string field;
    for (int i = 0; i < 12; ++i) stat >> field;  // the fields from 3 to 14
    return field.empty() ? 0 : std::stol(field);
}

// Ends a rank of a run that takes some seconds, once all ranks are at work on the set: they have
// the name of the unfinished file then, which docs/mpi.md says.
void end_a_rank_by(int signal) {
    Folder folder;
    const std::string path = folder.path("x.npy");
    lacuna::tests::Program program(
        command_of(ranks(3, {"sample", "--count", "10M", "--torus", "-o", path})), setting());
    std::vector<pid_t> found;
    const auto is_at_work = [](pid_t rank) { return ticks_of(rank) >= 50; };
    while (program.is_running() && (folder.names().empty() || found.size() < 3 ||
                                    !std::all_of(found.begin(), found.end(), is_at_work))) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        found = ranks_writing_to(path);
    }
    ASSERT_EQ(found.size(), 3u);
    ASSERT_EQ(folder.names().size(), 1u);
    EXPECT_TRUE(folder.names().front().starts_with(".x.npy.")) << folder.names().front();

    ASSERT_EQ(kill(found[1], signal), 0);
    const Outcome outcome = program.wait();

    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_NE(outcome.exit_code, 124) << "ended by the time limit";
    EXPECT_TRUE(folder.names().empty()) << folder.names().front() << "\n" << outcome.err;
}

TEST(MpiFaults, AKilledRankEndsAllAndLeavesNothing) {
    end_a_rank_by(SIGKILL);
}

TEST(MpiFaults, ATerminatedRankEndsAllAndLeavesNothing) {
    end_a_rank_by(SIGTERM);
}

}  // namespace
