// Given trouble from outside - disks, pipes, signals - a file is whole or not there at all.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "program.h"
#include "required.h"

namespace trouble_test {

using namespace lacuna::tests;
using Names = std::vector<std::string>;

void expect_one_line(const std::string& text) {
    EXPECT_TRUE(text.starts_with("lacuna: ")) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(AFileThatCannotBeFinished, LeavesTheOlderOneUntouched) {
    const Folder folder;
    write_file(folder.path("a.txt"), "older\n");
    Setting small_files;
    small_files.largest_file_bytes = 1000;
    const Outcome outcome =
        run({"sample", "--radius", "0.05", "-o", folder.path("a.txt")}, small_files);
    EXPECT_EQ(outcome.exit_code, 3);
    expect_one_line(outcome.err);
    EXPECT_NE(outcome.err.find("a.txt"), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(folder.path("a.txt")), "older\n");
    EXPECT_EQ(folder.names(), Names{"a.txt"});
}

// A program that ignores the signal, as under nohup or in a daemon, must report the error.
TEST(StandardOutput, WithoutAReaderIsAnErrorOfOutputWhereTheSignalIsIgnored) {
    std::array<int, 2> ends{};
    ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    close(ends[0]);
    Setting no_reader;
    no_reader.stdout_fd = ends[1];
    no_reader.program = "/bin/sh";
    for (const std::string words : {"sample --radius 0.05 -o -", "--help"}) {
        const Outcome outcome =
            run({"-c", "trap '' PIPE; exec " LACUNA_PROGRAM " " + words}, no_reader);
        EXPECT_EQ(outcome.exit_code, 3);
        expect_one_line(outcome.err);
    }
    close(ends[1]);
}

TEST(StandardOutput, OnAFullDiskIsAnErrorOfOutput) {
    if (!std::filesystem::is_character_file("/dev/full"))
        GTEST_SKIP() << "this system has no /dev/full";
    Setting full;
    full.stdout_fd = open("/dev/full", O_WRONLY | O_CLOEXEC);
    ASSERT_GE(full.stdout_fd, 0);
    const Outcome outcome = run({"sample", "--radius", "0.05"}, full);
    EXPECT_EQ(outcome.exit_code, 3);
    expect_one_line(outcome.err);
    close(full.stdout_fd);
}

// For the commands that use several threads.
TEST(ASystem, ThatMakesNoThreadsIsToldOfInOneLine) {
    const Folder folder;
    const std::string points = run({"sample", "--radius", "0.02"}).out;
    std::filesystem::permissions(folder.path("."), std::filesystem::perms::all);
    write_file(folder.path("a.txt"), points);
    std::filesystem::permissions(folder.path("a.txt"), std::filesystem::perms::all);
    Setting alone;
    alone.no_threads = true;
    const Outcome one = run({"sample", "--radius", "0.01", "--threads", "1"}, alone);
    if (one.exit_code == 126) GTEST_SKIP() << "another user may not start the program";
    EXPECT_EQ(one.exit_code, 0) << one.err;
    for (const Names& words : {Names{"sample", "--radius", "0.01", "--threads", "2"},
                               Names{"sample", "--count", "2000", "--threads", "8", "--relax", "2"},
                               Names{"relax", folder.path("a.txt"), "--threads", "3"}}) {
        const Outcome outcome = run(words, alone);
        EXPECT_EQ(outcome.exit_code, 4) << words.front();
        EXPECT_EQ(outcome.out, "");
        expect_one_line(outcome.err);
        EXPECT_NE(outcome.err.find("the system does not make"), std::string::npos) << outcome.err;
    }
    if (std::thread::hardware_concurrency() < 2) return;
    for (const Names& words : {Names{"analyze", folder.path("a.txt")},
                               Names{"verify", folder.path("a.txt"), "--radius", "0.02"},
                               Names{"reproduce", "fig5", "--runs", "2", "--quiet"}}) {
        const Outcome outcome = run(words, alone);
        EXPECT_EQ(outcome.exit_code, 4) << words.front();
        expect_one_line(outcome.err);
    }
}

TEST(ASystem, ThatGrantsATinyStackIsToldOfInOneLine) {
    Setting tiny;
    tiny.stack_bytes = 100 << 10;
    const Outcome outcome = run({"sample", "--radius", "0.1"}, tiny);
    EXPECT_EQ(outcome.exit_code, 2);
    expect_one_line(outcome.err);
    EXPECT_NE(outcome.err.find("limited to 100 KiB"), std::string::npos) << outcome.err;
}

TEST(APicture, ThatNeedsMoreMemoryThanThereIsIsNamedWithItsSize) {
    const Folder folder;
    const std::string path = folder.path("a.pgm");
    write_file(path, "P5 16384 16384 255\n");
    Setting setting;
    setting.memory_bytes = 3'000'000'000;
    expect_one_error(run({"stipple", path, "--count", "100"}, setting), 3,
                     {path, "16384 x 16384 pixels need about 5.4 GB of memory"});
}

class AnInterruptedRun : public testing::TestWithParam<int> {};

TEST_P(AnInterruptedRun, ExitsWithTheSignalsCodeAndLeavesNothing) {
    const Folder folder;
    write_file(folder.path("a.txt"), "older\n");
    const Words fine{"sample",
                     "--radius",
                     "0.0005",
                     "-o",
                     folder.path("a.txt"),
                     "--report",
                     folder.path("report.json")};
    // Both take minutes: with rounds small enough to be stopped soon, or in a few dozen rounds, so
    // that most polls come from within a round.
    for (const Words& more :
         {Words{"--backend", "reference", "--round-size", "64", "--mode", "lines"},
          Words{"--lines-per-radius", "1000", "--backend", "cpu", "--threads", "1"}}) {
        Program program(joined(fine, more));
        ASSERT_TRUE(program.waits_for(GetParam()));
        program.send(GetParam());
        const Outcome outcome = program.wait();
        EXPECT_EQ(outcome.exit_code, 128 + GetParam());
        EXPECT_EQ(outcome.out, "");
        expect_one_line(outcome.err);
        EXPECT_EQ(content_of(folder.path("a.txt")), "older\n");
        EXPECT_EQ(folder.names(), Names{"a.txt"});
    }
}

// Files that are no pipes are finished first.
TEST_P(AnInterruptedRun, ThatWaitsForAReaderOfItsPipeEnds) {
    const Folder folder;
    ASSERT_EQ(mkfifo(folder.path("pipe.txt").c_str(), 0600), 0);
    Program program({"sample", "--radius", "0.2", "-o", folder.path("pipe.txt"), "--report",
                     folder.path("report.json")});
    while (content_of(folder.path("report.json")).empty())
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    program.send(GetParam());
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 128 + GetParam());
    EXPECT_EQ(folder.names(), (Names{"pipe.txt", "report.json"}));
}

TEST_P(AnInterruptedRun, ThatWaitsForAWriterOfItsPipeEnds) {
    const Folder folder;
    ASSERT_EQ(mkfifo(folder.path("pipe.txt").c_str(), 0600), 0);
    Program program({"relax", folder.path("pipe.txt"), "-o", folder.path("a.txt")});
    ASSERT_TRUE(program.waits_for(GetParam()));
    program.send(GetParam());
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit_code, 128 + GetParam());
    expect_one_line(outcome.err);
    EXPECT_EQ(folder.names(), Names{"pipe.txt"});
}

// The signal may come at any time, also while the file still has its temporary name.
TEST_P(AnInterruptedRun, WhileItWritesLeavesAWholeFileOrNone) {
    const std::string whole = run({"sample", "--radius", "0.003", "--format", "csv"}).out;
    for (int i = 0; i < 3; ++i) {
        const Folder folder;
        Program program({"sample", "--radius", "0.003", "-o", folder.path("a.csv"), "--quiet"});
        while (program.is_running() && folder.names().empty()) continue;
        program.send(GetParam());
        const int code = program.wait().exit_code;
        EXPECT_TRUE(code == 0 || code == 128 + GetParam()) << code;
        for (const std::string& name : folder.names()) {
            EXPECT_EQ(name, "a.csv");
            EXPECT_EQ(content_of(folder.path(name)), whole);
        }
    }
}

// Also while the driver's compiler is at work: its cache is empty. The set would take minutes.
TEST_P(AnInterruptedRun, OnADeviceDoesNotWaitForIt) {
    const Folder folder;
    Setting cold;
    cold.environment["POCL_CACHE_DIR"] = folder.path("");
    cold.environment["MESA_SHADER_CACHE_DISABLE"] = "true";
    const std::string table = run({"devices"}).out;
    for (const std::string backend : {"opencl", "vulkan"}) {
        const bool is_missing = line_of(table, backend).find("not available") != std::string::npos;
        if (is_missing && !is_required(backend)) continue;
        const Folder out;
        Program program({"sample", "--radius", "0.0005", "--mode", "lines", "--round-size", "64",
                         "--backend", backend, "-o", out.path("a.txt")},
                        cold);
        ASSERT_TRUE(program.waits_for(GetParam()));
        program.send(GetParam());
        // LLVM's handlers, while a driver sets them, may swallow a signal: see
        // cli/terminal/driver.h.
        while (GetParam() == SIGQUIT && program.is_running()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            program.send(GetParam());
        }
        EXPECT_EQ(program.wait().exit_code, 128 + GetParam());
        EXPECT_EQ(out.names(), Names{});
    }
}

INSTANTIATE_TEST_SUITE_P(ByCtrlCOrTheSystem, AnInterruptedRun,
                         testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT));

TEST(AnInterruptedCommand, OfAnyKindExitsWith130AndWritesNothing) {
    const Folder folder;
    const std::string set = folder.path("set.npy");
    expect_success({"sample", "--count", "200000", "--quiet", "-o", set});
    for (const Names& words :
         {Names{"relax", set, "--iterations", "10000", "-o", folder.path("even.npy")},
          Names{"analyze", set, "-o", folder.path("a.pdf")},
          Names{"reproduce", "table1", "-o", folder.path("")},
          Names{"stipple", kRaccoon, "--count", "100000", "--lines-per-radius", "3", "--pen-path",
                "-o", folder.path("a.svg")}}) {
        SCOPED_TRACE(words.front());
        Program program(words);
        ASSERT_TRUE(program.waits_for(SIGINT));
        program.send(SIGINT);
        expect_one_error(program.wait(), 130, {"lacuna: interrupted, nothing was written\n"});
        EXPECT_EQ(folder.names(), Names{"set.npy"});
    }
}

TEST(ASecondSignal, DoesNotWaitForTheEndOfTheRound) {
    const Folder folder;
    // One round, which would last longer than any test.
    Program program({"sample", "--radius", "0.0005", "--backend", "reference", "--round-size",
                     "2147483648", "-o", folder.path("a.txt")});
    ASSERT_TRUE(program.waits_for(SIGINT));
    while (program.is_running()) {
        program.send(SIGINT);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(program.wait().exit_code, 130);
    EXPECT_EQ(folder.names(), Names{});
}

}  // namespace trouble_test
