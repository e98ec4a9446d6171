// Given the ways in which people join programs, the command fits in: outputs, formats, pipes,
// messages.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "options/options.h"
#include "program.h"

namespace {

using namespace lacuna::tests;

TEST(AFormat, OfStandardOutputIsWhatFormatSays) {
    const Folder folder;
    for (const std::string name :
         {"csv", "npy", "ply", "geojson", "json", "svg", "pdf", "png", "txt"}) {
        const std::string path = folder.path("a." + name);
        expect_success({"sample", "--radius", "0.1", "-o", path});
        for (const std::string output : {"-", "/dev/stdout", "/dev/fd/1"}) {
            const Outcome outcome =
                run({"sample", "--radius", "0.1", "-o", output, "--format", name});
            EXPECT_EQ(outcome.exit_code, 0);
            EXPECT_EQ(outcome.err, "");
            EXPECT_EQ(outcome.out, content_of(path)) << name << " to " << output;
        }
        EXPECT_EQ(run({"sample", "--radius", "0.1", "--format", name}).out, content_of(path));
    }
}

TEST(AFormat, MayBeGivenForANameWithoutOne) {
    const Folder folder;
    const std::string path = folder.path("points");
    expect_success({"sample", "--radius", "0.2", "-o", path, "--format", "CSV"});
    EXPECT_TRUE(content_of(path).starts_with("x,y\n"));
    EXPECT_EQ(folder.names(), Words{"points"});
}

TEST(AnOutput, MayBeADeviceOrADescriptor) {
    expect_success({"sample", "--radius", "0.2", "-o", "/dev/null", "--quiet"});
    expect_success({"sample", "--radius", "0.2", "-o", "/dev/null", "--format", "png", "--quiet"});
    const Folder folder;
    const int file = open(folder.path("a").c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_GE(file, 0);
    const std::string name = "/dev/fd/" + std::to_string(file);
    expect_success({"sample", "--radius", "0.2", "-o", name, "--format", "json", "--quiet"});
    close(file);
    EXPECT_TRUE(content_of(folder.path("a")).starts_with("{\"width\":1.0,"));
}

TEST(Outputs, MayBeSeveralOfOneSet) {
    const Folder folder;
    const Outcome outcome = run({"sample", "--radius", "0.1", "-o", folder.path("a.svg"), "-o", "-",
                                 "-o", folder.path("a.npy")});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, run({"sample", "--radius", "0.1"}).out);
    EXPECT_EQ(folder.names(), (Words{"a.npy", "a.svg"}));
    const Outcome dots = run({"stipple", kRaccoon, "--count", "100", "-o", folder.path("b.svg"),
                              "-o", folder.path("b.png")});
    EXPECT_EQ(dots.exit_code, 0);
    EXPECT_TRUE(dots.err.ends_with("b.svg, " + folder.path("b.png") + "\n")) << dots.err;
}

TEST(Reports, MayGoToStandardOutput) {
    const Folder folder;
    const Outcome report =
        run({"sample", "--radius", "0.1", "--report", "-", "-o", folder.path("a.npy")});
    EXPECT_EQ(nlohmann::json::parse(report.out).at("radius"), 0.1);
    EXPECT_EQ(report.err, "");
    const Outcome numbers = run({"analyze", folder.path("a.npy"), "-o", "-", "--quiet"});
    EXPECT_EQ(nlohmann::json::parse(numbers.out).at("sets"), 1);
    const Outcome sheet =
        run({"analyze", folder.path("a.npy"), "-o", "-", "--format", "svg", "--quiet"});
    EXPECT_TRUE(sheet.out.starts_with("<?xml")) << sheet.out.substr(0, 100);
    const Outcome compared = run({"compare", "--radius", "0.2", "--backends", "cpu, reference",
                                  "--runs", "1", "--json", "-"});
    EXPECT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_EQ(nlohmann::json::parse(compared.out).at("entries").size(), 2U);
}

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
    expect_success({"sample", "--radius", "0.1", "-o", folder.path("a.txt")});
    for (const Words& words : {Words{"sample", "--radius", "0.05"},
                               Words{"sample", "--radius", "0.05", "-o", "/dev/fd/1"},
                               Words{"verify", folder.path("a.txt"), "--radius", "0.1"},
                               Words{"devices"}, Words{"sample", "--help"}, Words{"help"}}) {
        const Outcome outcome = run_into_closed_pipe(words);
        EXPECT_EQ(outcome.exit_code, 128 + SIGPIPE) << words[0];
        EXPECT_EQ(outcome.err, "");
    }
}

TEST(AClosedPipe, DoesNotKeepTheOtherOutputsFromBeingWritten) {
    const Folder folder;
    const Outcome outcome =
        run_into_closed_pipe({"sample", "--radius", "0.05", "-o", "-", "-o", folder.path("a.csv")});
    EXPECT_EQ(outcome.exit_code, 128 + SIGPIPE);
    EXPECT_EQ(folder.names(), Words{"a.csv"});
}

TEST(Help, IsPrintedByACommandToo) {
    EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
    for (const std::string command : {"sample", "stipple", "verify", "analyze", "compare"})
        EXPECT_EQ(run({"help", command}).out, run({command, "--help"}).out) << command;
    EXPECT_NE(run({"help"}).out, "");
}

TEST(Help, BeginsWithExamples) {
    const Outcome outcome = run({"--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    expect_has(outcome.out, {"Examples:"});
}

TEST(Help, OfACommandBeginsWithExamplesAndNamesEveryOption) {
    using namespace lacuna::options;
    for (const Commands command :
         {kSample, kStipple, kRelax, kOrder, kVerify, kAnalyze, kCompare, kReproduce}) {
        const Outcome outcome = run({std::string(name_of_command(command)), "--help-all"});
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_LT(outcome.out.find("Examples:"), outcome.out.find("Options:"));
        for (const Option* option : options_of(command))
            expect_has(outcome.out.substr(outcome.out.find("Options:")),
                       {option->is_argument() ? "" : "--" + std::string(option->name)});
    }
}

TEST(Help, OfACommandWithManyOptionsIsAScreenOfTheUsualOnes) {
    for (const std::string command : {"sample", "stipple", "verify"}) {
        const std::string help = run({command, "--help"}).out;
        const std::string listed = help.substr(help.find("\nOptions:"));
        EXPECT_LE(std::count(listed.begin(), listed.end(), '\n'), 40) << listed;
        expect_has(help, {"options: lacuna " + command + " --help-all"});
        EXPECT_LT(help.size(), run({command, "--help-all"}).out.size());
    }
}

TEST(Version, IsPrintedByACommandAndAShortOptionToo) {
    const Outcome version = run({"--version"});
    EXPECT_TRUE(version.out.starts_with("lacuna "));
    EXPECT_EQ(run({"version"}).out, version.out);
    EXPECT_EQ(run({"-V"}).out, version.out);
}

TEST(AMisspeltWord, IsLeftAloneWhereNoneIsNear) {
    const Outcome far = run({"sample", "--colour", "red"});
    EXPECT_EQ(far.err.find("did you mean"), std::string::npos) << far.err;
}

TEST(ADoubleDash, EndsTheOptions) {
    const Folder folder;
    write_file(folder.path("-a.txt"), "0.5 0.5\n");
    Setting setting;
    setting.program = "/bin/sh";
    const std::string cd = "cd " + folder.path(".") + " && exec " LACUNA_PROGRAM " ";
    expect_success({"-c", cd + "verify --radius 0.8 -- -a.txt"}, setting);
    expect_success({"-c", cd + "analyze --quiet -- -a.txt"}, setting);
    write_file(folder.path("-b.pgm"), pgm(2, 2, std::string(4, '\x40')));
    const std::string stipple = cd + "stipple --count 20 --quiet -o ";
    expect_success({"-c", stipple + "a.svg -- -b.pgm"}, setting);
    // The command line stored in the file must find the picture again.
    expect_success({"-c", stipple + "a.json -- -b.pgm"}, setting);
    EXPECT_EQ(nlohmann::json::parse(content_of(folder.path("a.json"))).at("command"),
              "lacuna stipple ./-b.pgm --count 20");
}

TEST(AnOutput, MayStandBeforeThePictureAndBetweenOptions) {
    const Folder folder;
    expect_success({"stipple", "-o", folder.path("a.svg"), kRaccoon, "--count", "20", "--quiet"});
    expect_success({"sample", "--radius", "0.2", "-o", folder.path("a.txt")});
    expect_success({"analyze", "-o", folder.path("b.json"), folder.path("a.txt"), "--quiet"});
}

TEST(Reproduce, MakesItsFolder) {
    const Folder folder;
    expect_success({"reproduce", "table1", "--runs", "1", "--smallest-radius", "0.05", "--quiet",
                    "-o", folder.path("new/figures")});
    EXPECT_NE(content_of(folder.path("new/figures/table1.json")), "");
}

TEST(Devices, ListABackendWhoseDriverIsMissing) {
    const Folder folder;
    Setting no_driver;
    no_driver.environment["OCL_ICD_VENDORS"] = folder.path("");
    no_driver.environment["OPENCL_VENDOR_PATH"] = folder.path("");
    const Outcome table = run({"devices"}, no_driver);
    EXPECT_EQ(table.exit_code, 0);
    expect_has(line_of(table.out, "opencl"), {"not available: "});
    const auto json = nlohmann::json::parse(run({"devices", "--json"}, no_driver).out);
    bool is_there = false;
    for (const auto& device : json.at("devices")) {
        if (device.at("backend") == "cpu") {
            EXPECT_EQ(device.at("usable"), true);
        }
        if (device.at("backend") != "opencl") continue;
        is_there = true;
        EXPECT_EQ(device.at("usable"), false);
        EXPECT_NE(device.at("why_not"), nullptr);
    }
    EXPECT_TRUE(is_there);
}

TEST(Devices, OfABrokenDriverDoNotHideTheOthers) {
    const Folder folder;
    write_file(folder.path("bad.json"), R"({"file_format_version" : "1.0.0", "ICD": )");
    Setting broken;
    broken.environment["VK_DRIVER_FILES"] = folder.path("bad.json");
    broken.environment["VK_ICD_FILENAMES"] = folder.path("bad.json");
    const Outcome table = run({"devices"}, broken);
    EXPECT_EQ(table.exit_code, 0) << table.err;
    expect_has(line_of(table.out, "vulkan"), {"not available: "});
    EXPECT_EQ(line_of(table.out, "cpu").find("not available"), std::string::npos);
    const Outcome comparison = run({"compare", "--radius", "0.2", "--runs", "1"}, broken);
    EXPECT_EQ(comparison.exit_code, 0) << comparison.err;
    expect_has(line_of(comparison.out, "vulkan"), {"not run: "});
    expect_one_error(run({"sample", "--radius", "0.2", "--backend", "vulkan"}, broken), 4,
                     {"backend vulkan: "});
    expect_one_error(run({"compare", "--radius", "0.2", "--backends", "cpu,vulkan"}, broken), 4,
                     {"backend vulkan"});
}

TEST(NullAndTerminals, MayBeNamedTwice) {
    const Words twice{"sample",    "--radius", "0.3",       "--quiet", "-o",
                      "/dev/null", "--report", "/dev/null", "-o",      "/dev/null"};
    expect_success(twice);
    const Folder folder;
    for (const char* name : {"0.txt", "1.txt"})
        std::filesystem::create_symlink("/dev/null", folder.path(name));
    expect_success({"sample", "--radius", "0.3", "--seeds", "0..1", "--quiet", "-o",
                    folder.path("{seed}.txt")});
    Setting null;
    null.stdout_fd = open("/dev/null", O_RDWR);
    expect_success({"sample", "--radius", "0.3", "-o", "/dev/null", "-o", "-"}, null);
    close(null.stdout_fd);
}

}  // namespace
