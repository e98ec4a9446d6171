// Given a request, `lacuna compare` makes it on every backend, and says whether all agree.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "expectations.h"
#include "program.h"
#include "required.h"

namespace compare_test {

using namespace lacuna::tests;
using Json = nlohmann::json;

// Small requests in all three modes.
const std::vector<Words> kRequests = {
    {"--radius", "0.05", "--torus"},
    {"--radius", "0.07", "--mode", "lines", "--domain", "2x1"},
    {LACUNA_EXAMPLES "/raccoon.png", "--count", "500", "--seed", "3"},
};

// How many devices this machine must have.
std::size_t devices_required() {
    return std::size_t{is_required("opencl")} + std::size_t{is_required("vulkan")};
}

Setting faulty() {
    Setting setting;
    setting.program = LACUNA_FAULTY_PROGRAM;
    return setting;
}

Words compare(const Words& request, const Words& more) {
    return joined(joined({"compare"}, request), more);
}

TEST(Compare, FindsTheSamePointsOnEveryBackendInEveryMode) {
    for (const Words& request : kRequests) {
        const Folder folder;
        const Outcome outcome =
            run(compare(request, {"--runs", "2", "--json", folder.path("a.json")}));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("made these points"), std::string::npos) << outcome.out;
        const Json json = Json::parse(content_of(folder.path("a.json")));
        EXPECT_TRUE(json.at("same_points"));
        std::size_t ran = 0;
        for (const Json& entry : json.at("entries")) {
            if (entry.contains("not_run")) continue;
            ++ran;
            EXPECT_EQ(entry.at("points_sha256"), json.at("entries")[0].at("points_sha256"));
            EXPECT_EQ(entry.at("seconds").size(), 2u);
            EXPECT_GT(entry.at("count"), 0);
            EXPECT_GT(entry.at("median_seconds"), 0);
        }
        EXPECT_GE(ran, 1 + devices_required());
        EXPECT_EQ(json.at("entries").size(), 3u) << "cpu, opencl and vulkan, missing or not";
    }
}

// Compares a request, and expects the points that sample or stipple makes of the same options.
void expect_set_of_the_command(const Words& request, const Words& more) {
    const Folder folder;
    const std::string json = folder.path("a.json"), alone = folder.path("b.json");
    const Outcome outcome = run(compare(request, joined(more, {"--runs", "1", "--json", json})));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("made these points"), std::string::npos) << outcome.out;
    const bool is_uniform = request.front().starts_with("--");
    expect_success(joined(joined({is_uniform ? "sample" : "stipple"}, request),
                          {"--quiet", "-o", folder.path("b.npy"), "--report", alone}));
    EXPECT_EQ(Json::parse(content_of(json)).at("entries")[0].at("points_sha256"),
              Json::parse(content_of(alone)).at("points_sha256"));
}

TEST(Compare, FindsTheSameRelaxedPointsOnEveryBackend) {
    expect_set_of_the_command({LACUNA_EXAMPLES "/raccoon.png", "--count", "500", "--relax", "3"},
                              {});
    expect_set_of_the_command({"--count", "300", "--torus", "--relax", "3"}, {});
}

TEST(Compare, MakesTheSetsOfSampleAndStipple) {
    const std::string raccoon = LACUNA_EXAMPLES "/raccoon.png";
    for (const Words& request :
         {Words{raccoon, "--scale", "0.03", "--relax", "3"},
          Words{raccoon, "--count", "300", "--mode", "exact", "--relax", "2"},
          Words{raccoon, "--count", "300", "--metric", "max", "--relax", "2"},
          Words{raccoon, "--count", "100", "--along", "3", "--relax", "0"},
          Words{raccoon, "--scale", "0.03", "--relax", "0"},
          Words{"--radius", "0.06", "--relax", "3"}})
        expect_set_of_the_command(request, {"--backends", "cpu"});
}

TEST(Compare, NamesTheFirstPointThatOneBitMakesDifferent) {
    for (const Words& request : kRequests) {
        const Folder folder;
        const Outcome outcome = run(compare(request, {"--runs", "1", "--backends", "cpu,reference",
                                                      "--json", folder.path("a.json")}),
                                    faulty());
        EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("reference differs first in point 17: ("), std::string::npos)
            << outcome.out;
        const Json json = Json::parse(content_of(folder.path("a.json")));
        EXPECT_FALSE(json.at("same_points"));
        EXPECT_TRUE(json.at("entries")[0].at("same_points"));
        const Json& difference = json.at("entries")[1].at("first_difference");
        EXPECT_EQ(difference.at("index"), 17);
        EXPECT_EQ(difference.at("expected")[1], difference.at("got")[1]);
        EXPECT_NE(difference.at("expected")[0], difference.at("got")[0]);
    }
}

TEST(Compare, OfABackendWithItselfAgrees) {
    const Outcome outcome =
        run({"compare", "--radius", "0.1", "--backends", "reference,reference", "--runs", "1"},
            faulty());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

TEST(Compare, DrawsAChart) {
    const Folder folder;
    const Outcome outcome = run({"compare", "--radius", "0.1", "--backends", "cpu,reference", "-o",
                                 folder.path("chart.svg"), "--runs", "1"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(content_of(folder.path("chart.svg")).starts_with("<?xml"));
}

TEST(Compare, WithoutABackendThatIsNamedExitsWith4) {
    Setting no_opencl;
    no_opencl.environment = {{"OCL_ICD_VENDORS", "/nonexistent/"}};
    const Outcome outcome =
        run({"compare", "--radius", "0.1", "--backends", "cpu,opencl"}, no_opencl);
    expect_one_error(outcome, 4, {"backend opencl: "});
    EXPECT_EQ(outcome.out, "");
    // A backend that was not named is listed in the table, and is no failure.
    const Outcome others = run({"compare", "--radius", "0.1", "--runs", "1"}, no_opencl);
    EXPECT_EQ(others.exit_code, 0) << others.err;
    EXPECT_NE(others.out.find("not run: "), std::string::npos) << others.out;
}

TEST(Compare, TellsOfABackendThatFailsAfterItsFirstRun) {
    const Folder folder;
    const Outcome outcome =
        run({"compare", "--radius", "0.1", "--seed", "9", "--backends", "cpu,reference", "--runs",
             "3", "--json", folder.path("a.json"), "-o", folder.path("a.svg")},
            faulty());
    EXPECT_EQ(outcome.exit_code, 4) << outcome.out;
    EXPECT_NE(outcome.err.find("device of the test: lost"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find("the same until it failed"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("reference failed in run 2: device of the test: lost"),
              std::string::npos)
        << outcome.out;
    const Json json = Json::parse(content_of(folder.path("a.json")));
    EXPECT_FALSE(json.at("entries")[0].contains("failed"));
    EXPECT_EQ(json.at("entries")[0].at("seconds").size(), 3u);
    EXPECT_EQ(json.at("entries")[1].at("failed"), "device of the test: lost");
    EXPECT_EQ(json.at("entries")[1].at("seconds").size(), 1u);
    EXPECT_NE(content_of(folder.path("a.svg")).find("then failed"), std::string::npos);
}

TEST(Compare, ShowsWhatDevicesWereAskedToDo) {
    const Folder folder;
    const Outcome outcome = run({"compare", "--radius", "0.02", "--torus", "--runs", "1", "--work",
                                 "--json", folder.path("a.json")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json entries = Json::parse(content_of(folder.path("a.json"))).at("entries");
    EXPECT_FALSE(entries[0].contains("work")) << "the cpu is asked for nothing";
    std::size_t with_work = 0;
    for (const Json& entry : entries) {
        if (!entry.contains("work")) continue;
        ++with_work;
        EXPECT_GT(entry.at("work").at("waits"), 0);
        double seconds = 0;
        for (const auto& [kernel, work] : entry.at("work").at("kernels").items()) {
            expect_has(outcome.out, {entry.at("backend").get<std::string>() + "     " + kernel});
            EXPECT_GT(work.at("items"), 0) << kernel;
            seconds += work.at("seconds").get<double>();
        }
        EXPECT_GT(seconds, 0);
    }
    EXPECT_GE(with_work, devices_required());
    EXPECT_EQ(outcome.out.find("bytes down") == std::string::npos,
              outcome.out.find("locate_in_boxes") == std::string::npos);
}

// A driver may compile kernels as late as at their first launch; no set's time should include that.
TEST(Compare, MakesASetOnEachBeforeThoseThatItTakesTimesOf) {
    const auto with_runs = [](const std::string& runs) {
        return run({"compare", "--radius", "0.1", "--seed", "9", "--backends", "cpu,reference",
                    "--runs", runs},
                   faulty());
    };
    EXPECT_EQ(with_runs("1").exit_code, 4);  // at the third set
}

TEST(Compare, ShowsTheOthersWhereOneRunsOutOfMemory) {
    const Outcome outcome = run({"compare", "--radius", "0.1", "--seed", "14", "--backends",
                                 "cpu,reference", "--runs", "2"},
                                faulty());
    EXPECT_EQ(outcome.exit_code, 4) << outcome.out;
    EXPECT_EQ(outcome.err, "lacuna: backend reference: out of memory\n");
    expect_has(outcome.out, {"failed in run 1: backend reference: out of memory"});
}

// A driver's exit(1) must not become exit code 1, which means that points differ.
TEST(Compare, TellsOfADriverThatEndsTheProgram) {
    const std::string table = run({"devices"}).out;
    for (const std::string backend : {"opencl", "vulkan"}) {
        const bool is_missing = line_of(table, backend).find("not available") != std::string::npos;
        if (is_missing && !is_required(backend)) continue;
        const std::vector<std::pair<std::string, std::string>> ways{
            {"10", "exit()"}, {"11", "abort()"}, {"12", "SIGSEGV"}, {"13", "an exception"}};
        for (const auto& [seed, way] : ways)
            expect_one_error(run({"compare", "--radius", "0.1", "--runs", "1", "--backends",
                                  "cpu," + backend, "--seed", seed},
                                 faulty()),
                             4,
                             {"backend " + backend + ": its driver ended the program by " + way});
    }
}

}  // namespace compare_test
