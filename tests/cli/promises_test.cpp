// Promises of the pages about the command that no other test is about.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "expectations.h"
#include "folder.h"
#include "program.h"

namespace promises_test {

using namespace lacuna::tests;
using Json = nlohmann::json;

TEST(TheExitCode, Is70ForABugOfTheProgram) {
    Setting faulty;
    faulty.program = LACUNA_FAULTY_PROGRAM;
    const Words words{"compare", "--radius", "0.1", "--backends", "reference", "--seed", "15"};
    expect_one_error(run(words, faulty), 70, {"lacuna: this is a bug: a box of no sheet"});
}

TEST(KeptPoints, HaveTheirClassesInEveryFormatThatNamesThem) {
    const Folder folder;
    const Words wood{"sample", "--class", "trees:0.1", "--class", "grass:0.03"};
    const auto made = [&](const Words& more) {
        const std::string csv = folder.path("made.csv");
        expect_success(joined(joined(wood, more), {"--quiet", "-o", csv}));
        return content_of(csv);
    };
    Words first = joined(wood, {"--limit", "40", "--quiet"});
    for (const std::string extension : {"csv", "ply", "json"})
        first = joined(first, {"-o", folder.path("kept." + extension)});
    expect_success(first);
    const auto going_on = [&](const std::string& extension) {
        return made({"--keep", folder.path("kept." + extension), "--seed", "2"});
    };
    const std::string expected = going_on("csv");
    for (const std::string extension : {"ply", "json"})
        EXPECT_EQ(going_on(extension), expected) << extension;
}

// NAME:FILE is a class and its file; ./NAME:FILE is a file.
TEST(FilesOfClasses, AreNoClassesAfterADotAndASlash) {
    const Folder folder;
    write_file(folder.path("a:b.txt"), "0.5 0\n1 0\n1 1\n0.5 1\n");
    write_file(folder.path("b.txt"), "0 0\n0.5 0\n0.5 1\n0 1\n");
    const auto made = [&](const std::string& inside) {
        const Outcome outcome =
            run_in(folder, LACUNA_PROGRAM
                               " sample --class a:0.1 --class c:0.1 --domain 1x1 "
                               "--format csv --inside " +
                               inside);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    };
    const std::string of_class = made("a:b.txt"), of_all = made("./a:b.txt");
    for (const bool is_of_all : {false, true}) {
        const std::string& set = is_of_all ? of_all : of_class;
        std::istringstream lines(set.substr(set.find('\n') + 1));
        for (std::string line; std::getline(lines, line);) {
            const double x = std::stod(line);
            const bool is_right = is_of_all ? x >= 0.5 : x <= 0.5 || !line.ends_with(",a");
            EXPECT_TRUE(is_right) << line;
        }
    }
}

TEST(TheEnvironment, NamesABackendThatAnOptionReplaces) {
    const Folder folder;
    Setting setting;
    setting.environment["LACUNA_BACKEND"] = "reference";
    const auto backend_of = [&](const Words& more) {
        const std::string report = folder.path("r.json");
        expect_success(joined({"sample", "--radius", "0.1", "--quiet", "-o", folder.path("a.npy"),
                               "--report", report},
                              more),
                       setting);
        return Json::parse(content_of(report)).at("backend").get<std::string>();
    };
    EXPECT_EQ(backend_of({}), "reference");
    EXPECT_EQ(backend_of({"--backend", "cpu"}), "cpu");
}

TEST(Compare, HasARowForEachDeviceOfABackend) {
    if (line_of(run({"devices"}).out, "opencl").find("not available") != std::string::npos)
        GTEST_SKIP() << "without OpenCL";
    const Folder folder;
    Setting two;
    two.environment["POCL_DEVICES"] = "basic pthread";
    const std::string json = folder.path("a.json");
    expect_success(
        {"compare", "--count", "200", "--runs", "1", "--backends", "opencl,cpu", "--json", json},
        two);
    const Json entries = Json::parse(content_of(json)).at("entries");
    ASSERT_EQ(entries.size(), 3U);
    EXPECT_NE(entries[0].at("device"), entries[1].at("device"));
    for (const Json& entry : entries)
        EXPECT_EQ(entry.at("points_sha256"), entries[2].at("points_sha256"));
}

}  // namespace promises_test
