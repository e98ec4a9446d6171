// Given the ways in which people join programs, the command fits in: pipes and words.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::test;

// Runs the command with a pipe for standard output that nobody reads.
Outcome run_into_closed_pipe(const Words& words) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    close(ends[0]);
    Setting setting;
    setting.stdout_fd = ends[1];
    Program program(words, setting);
    close(ends[1]);
    return program.wait();
}

TEST(AClosedPipe, EndsTheCommandSilentlyWithSigpipesCode) {
    const Folder folder;
    ASSERT_EQ(run({"sample", "--radius", "0.1", "-o", folder.path("a.txt")}).exit_code, 0);
    for (const Words& words : {Words{"sample", "--radius", "0.05"},
                               Words{"verify", folder.path("a.txt"), "--radius", "0.1"},
                               Words{"devices"}, Words{"sample", "--help"}, Words{"help"}}) {
        const Outcome outcome = run_into_closed_pipe(words);
        EXPECT_EQ(outcome.exit_code, 128 + SIGPIPE) << words[0];
        EXPECT_EQ(outcome.err, "");
    }
}

TEST(ANumber, MayBeWrittenShort) {
    const std::string expected = run({"sample", "--count", "2000"}).out;
    for (const std::string count : {"2e3", "2k", "2K", "0.002M", "2.0e3", "2000."})
        EXPECT_EQ(run({"sample", "--count", count}).out, expected) << count;
    for (const std::string count :
         {"2.5", "2kk", "k", "1e-3", "2e3k2", "-2k", "1e40", "nan", "inf"})
        expect_one_error(run({"sample", "--count", count}), 2,
                         {"--count " + count + ":", "whole number"});
}

TEST(Help, IsPrintedByACommandToo) {
    EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
    for (const std::string command : {"sample", "stipple", "verify", "analyze", "compare"})
        EXPECT_EQ(run({"help", command}).out, run({command, "--help"}).out) << command;
    EXPECT_NE(run({"help"}).out, "");
    expect_one_error(run({"help", "sampel"}), 2, {"sampel: no such command, did you mean sample?"});
}

TEST(Version, IsPrintedByACommandAndAShortOptionToo) {
    const Outcome version = run({"--version"});
    EXPECT_TRUE(version.out.starts_with("lacuna "));
    EXPECT_EQ(run({"version"}).out, version.out);
    EXPECT_EQ(run({"-V"}).out, version.out);
}

TEST(AMisspeltWord, IsSetRightWhereOneIsNear) {
    expect_one_error(run({"smaple"}), 2, {"smaple: no such command", "did you mean sample?"});
    expect_one_error(run({"sample", "--raduis", "0.1"}), 2, {"--raduis", "did you mean --radius?"});
    expect_one_error(run({"stipple", "a.png", "--papersize=A4"}), 2,
                     {"did you mean --paper-size?"});
    const Outcome far = run({"sample", "--colour", "red"});
    EXPECT_EQ(far.err.find("did you mean"), std::string::npos) << far.err;
}

TEST(ADoubleDash, EndsTheOptions) {
    const Folder folder;
    write_file(folder.path("-a.txt"), "0.5 0.5\n");
    Setting setting;
    setting.program = "/bin/sh";
    const std::string cd = "cd " + folder.path(".") + " && exec " LACUNA_PROGRAM " ";
    EXPECT_EQ(run({"-c", cd + "verify --radius 0.8 -- -a.txt"}, setting).exit_code, 0);
    EXPECT_EQ(run({"-c", cd + "analyze --quiet -- -a.txt"}, setting).exit_code, 0);
    write_file(folder.path("-b.pgm"), pgm(2, 2, std::string(4, '\x40')));
    const std::string stipple = cd + "stipple --count 20 --quiet -o ";
    EXPECT_EQ(run({"-c", stipple + "a.svg -- -b.pgm"}, setting).exit_code, 0);
}

TEST(Threads, HaveALimitThatIsNamed) {
    expect_one_error(run({"sample", "--radius", "0.1", "--threads", "100000"}), 2,
                     {"--threads 100000: must be at most 1024"});
    EXPECT_EQ(run({"sample", "--radius", "0.1", "--threads", "1024"}).exit_code, 0);
}

}  // namespace
