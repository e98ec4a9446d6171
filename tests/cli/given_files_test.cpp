// Given files that lead to one another, no command overwrites what it was given.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::test;
namespace fs = std::filesystem;

constexpr const char* kOther = "must be another file than ";

const std::string kPicture = pgm(2, 2, std::string(4, '\x40'));

// A case of a command that would overwrite `given`, with what stands in for F/ replaced by a
// folder.
void expect_refused(const Words& words, const std::string& told, const std::string& given) {
    const Folder folder;
    const std::string points = "0.5 0.5\n0.1 0.1\n";
    const std::string content = given == "a.txt" ? points : kPicture;
    fs::create_directory(folder.path("figs"));
    write_file(folder.path(given), content);
    Words in_folder;
    for (const std::string& word : words)
        in_folder.push_back(word.starts_with("F/") ? folder.path(word.substr(2)) : word);
    const Outcome outcome = run(in_folder);
    expect_one_error(outcome, 2, {told, kOther});
    EXPECT_EQ(content_of(folder.path(given)), content) << told;
}

TEST(NoFile, ThatIsReadIsOverwritten) {
    expect_refused({"compare", "F/p.png", "--count", "9", "-o", "F/p.png"}, "--output ", "p.png");
    expect_refused({"compare", "F/p.json", "--count", "9", "--json", "F/p.json"}, "--json ",
                   "p.json");
    expect_refused({"stipple", "F/p.json", "--count", "9", "-o", "F/a.svg", "--report", "F/p.json"},
                   "--report ", "p.json");
    expect_refused({"stipple", "F/p.png", "--count", "9", "-o", "F/figs/../p.png"}, "--output ",
                   "p.png");
    expect_refused(
        {"reproduce", "fig7", "--runs", "1", "--image", "F/figs/fig7.json", "-o", "F/figs"},
        "--output ", "figs/fig7.json");
    expect_refused({"relax", "F/a.txt", "-o", "F/a.txt"}, "than POINTS ", "a.txt");
    expect_refused({"relax", "F/none.txt", "F/p.png", "-o", "F/p.png"}, "than IMAGE ", "p.png");
    expect_refused({"analyze", "F/a.txt", "-o", "F/a.txt", "--format", "json"}, "than FILE ",
                   "a.txt");
}

TEST(NoFile, ThatIsWrittenIsOverwrittenThroughALink) {
    const Folder folder;
    fs::create_symlink("a.json", folder.path("link.json"));  // dangling
    const Words sample{"sample", "--radius", "0.2"};
    const auto with = [&](Words more) {
        more.insert(more.begin(), sample.begin(), sample.end());
        return run(more);
    };
    expect_one_error(with({"-o", folder.path("a.json"), "--report", folder.path("link.json")}), 2,
                     {"--report ", kOther, "--output "});
    expect_one_error(with({"-o", folder.path("link.json"), "-o", folder.path("a.json")}), 2,
                     {"--output ", kOther});
    fs::create_directory_symlink(folder.path("."), folder.path("here"));
    expect_one_error(with({"-o", folder.path("b.txt"), "-o", folder.path("here/b.txt")}), 2,
                     {"--output ", kOther});
    EXPECT_EQ(folder.names(), (Words{"here", "link.json"}));
}

TEST(NoFile, BehindStandardInputOrOutputIsOverwritten) {
    const Folder folder;
    write_file(folder.path("p.png"), kPicture);
    Setting shell;
    shell.program = "/bin/sh";
    const std::string lacuna = "cd " + folder.path(".") + " && exec " LACUNA_PROGRAM " ";
    expect_one_error(run({"-c", lacuna + "stipple - --count 9 -o p.png < p.png"}, shell), 2,
                     {"--output p.png: must be another file than IMAGE -"});
    EXPECT_EQ(content_of(folder.path("p.png")), kPicture);
    expect_one_error(run({"-c", lacuna + "sample --radius 0.3 --report a.json > a.json"}, shell), 2,
                     {"--report a.json: must be another file than --output -"});
    write_file(folder.path("a.txt"), "0.5 0.5\n");
    const Outcome outcome = run({"-c", lacuna + "relax a.txt >> a.txt"}, shell);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(kOther), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(folder.path("a.txt")), "0.5 0.5\n");
}

TEST(NullAndTerminals, MayBeNamedTwice) {
    const Words twice{"sample",    "--radius", "0.3",       "--quiet", "-o",
                      "/dev/null", "--report", "/dev/null", "-o",      "/dev/null"};
    EXPECT_EQ(run(twice).exit_code, 0);
    Setting null;
    null.stdout_fd = open("/dev/null", O_RDWR);
    EXPECT_EQ(run({"sample", "--radius", "0.3", "-o", "/dev/null", "-o", "-"}, null).exit_code, 0);
    close(null.stdout_fd);
}

}  // namespace
