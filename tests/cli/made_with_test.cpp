// A .json holds what verify needs to prove its set, or verify asks for the option by its name.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/expectations.h"
#include "cli/pictures.h"
#include "program.h"

namespace made_with_test {

using namespace lacuna::tests;

struct Capability {
    std::string name;
    Words options;
    std::string asked;  // the option that verify asks for; empty if the file holds all
    Words given = {};   // what verify is given then
};

std::vector<Capability> capabilities(const Folder& folder) {
    const std::string picture = folder.path("picture.pgm"), ring = folder.path("ring.txt");
    const std::string rocks = folder.path("rocks.csv"), kept = folder.path("kept.csv");
    write_file(picture, pgm(4, 2, bytes({40, 80, 120, 160, 200, 90, 60, 30})));
    write_file(folder.path("mask.pgm"), pgm(2, 2, bytes({255, 0, 255, 255})));
    write_file(ring, "0.1 0.1\n0.9 0.1\n0.9 0.9\n0.1 0.9\n");
    write_file(rocks, "x,y,radius\n0.5,0.5,0.2\n");
    write_file(kept, "x,y\n0.3,0.3\n0.7,0.31\n");
    const std::string mask = folder.path("mask.pgm");
    const Words radius{"--radius", ".05"};
    return {
        {"uniform", radius, ""},
        {"torus", joined(radius, {"--torus", "--domain", "2x1"}), ""},
        {"border", joined(radius, {"--border", ".1"}), ""},
        {"mask", joined(radius, {"--mask", mask}), "--mask", {"--mask", mask}},
        {"inside", joined(radius, {"--inside", ring}), "--inside", {"--inside", ring}},
        {"inside with an edge and a border",
         joined(radius, {"--inside", ring, "--edge", ".002", "--border", ".03"}),
         "--inside",
         {"--inside", ring}},
        {"outside", joined(radius, {"--outside", ring}), "--outside", {"--outside", ring}},
        {"avoid", joined(radius, {"--avoid", rocks}), "--avoid", {"--avoid", rocks}},
        {"keep", joined(radius, {"--keep", kept}), ""},
        {"classes", {"--class", "a:.06", "--class", "b:.02:3"}, ""},
        {"classes by union", {"--class", "a:.06", "--class", "b:.02", "--between", "union"}, ""},
        {"field", {"--field", picture, "--scale", ".03"}, "--field", {"--field", picture}},
        {"field and tone",
         {"--field", picture, "--scale", ".03", "--gamma", "2", "--invert"},
         "--invert",
         {"--field", picture, "--gamma", "2", "--invert"}},
        {"along",
         {"--field", picture, "--scale", ".04", "--along", "3"},
         "--along",
         {"--field", picture, "--along", "3"}},
        {"stretch", {"--stretch", ".1:.04@30"}, ""},
        {"stretch and scale", {"--stretch", ".1:.04@30", "--scale", ".5"}, ""},
        {"progressive", joined(radius, {"--progressive"}), ""},
        {"progressive, of a count", {"--count", "300", "--progressive"}, ""}};
}

TEST(AJsonFile, OfEachCapabilityIsProvenOrAsksForWhatItLacks) {
    const Folder folder;
    for (const Capability& one : capabilities(folder)) {
        SCOPED_TRACE(one.name);
        const std::string path = folder.path("a.json");
        expect_success(joined(joined({"sample", "--quiet"}, one.options), {"-o", path}));
        const Outcome alone = run({"verify", path});
        if (one.asked.empty()) {
            EXPECT_EQ(alone.exit_code, 0) << alone.out << alone.err;
            continue;
        }
        if (one.given.size() == 2)
            expect_one_error(alone, 2, {"a.json: made with " + one.asked});
        else  // the picture alone is not enough
            expect_one_error(run({"verify", path, one.given[0], one.given[1]}), 2,
                             {"a.json: made with " + one.asked});
        const Outcome proven = run(joined({"verify", path}, one.given));
        EXPECT_EQ(proven.exit_code, 0) << proven.out << proven.err;
    }
}

TEST(AJsonFile, OfACountSaysItsSizeSoThatItsDistancesAreProven) {
    const Folder folder;
    const std::string path = folder.path("a.json"), picture = folder.path("picture.pgm");
    write_file(picture, pgm(2, 1, bytes({40, 160})));
    for (const Words& options :
         {Words{}, Words{"--stretch", ".1:.04@30"}, Words{"--class", "a:.06", "--class", "b:.02"},
          Words{"--field", picture}}) {
        expect_success(joined({"sample", "--quiet", "--count", "200", "-o", path}, options));
        Words verify{"verify", path, "--distances-only"};
        if (!options.empty() && options[0] == "--field")
            verify.insert(verify.end(), {"--field", picture});
        const Outcome outcome = run(verify);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    }
}

TEST(AJsonFile, IsStillRefutedWhereItIsWrong) {
    const Folder folder;
    const std::string path = folder.path("a.json");
    for (const Words& options :
         {Words{"--radius", ".1", "--border", ".1"}, Words{"--stretch", ".2:.1@30"}}) {
        expect_success(joined({"sample", "--quiet", "-o", path}, options));
        auto set = nlohmann::json::parse(content_of(path));
        set["points"][0] = set["points"][1];
        write_file(path, set.dump());
        EXPECT_EQ(run({"verify", path}).exit_code, 1);
    }
}

TEST(AJsonFile, OfOrderAndRelaxSaysItsTorusAndWhatItPromises) {
    const Folder folder;
    const std::string a = folder.path("a.json"), b = folder.path("b.json");
    expect_success({"sample", "--quiet", "--radius", ".1", "--torus", "-o", a});
    expect_success({"order", a, "--quiet", "-o", b});
    expect_success({"verify", b, "--radius", ".1"});
    expect_success({"relax", a, "--quiet", "-o", b});
    expect_one_error(run({"verify", b}), 2, {"b.json: made in mode stratified and relaxed"});
}

}  // namespace made_with_test
