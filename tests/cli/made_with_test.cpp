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

const std::string kEllipses = LACUNA_EXAMPLES "/../tests/pinned/ellipses.npy";

struct Capability {
    std::string name;
    Words options;
    std::string asked;       // the option that verify asks for; empty if the file holds all
    Words given = {};        // what verify is given then
    bool is_for_csv = true;  // whether verify has these options, too, for a .csv
};

std::vector<Capability> capabilities(const Folder& folder) {
    const auto file = [&](const char* name, const std::string& content) {
        write_file(folder.path(name), content);
        return folder.path(name);
    };
    const std::string picture =
        file("picture.pgm", pgm(4, 2, bytes({40, 80, 120, 160, 200, 90, 60, 30})));
    const std::string mask = file("mask.pgm", pgm(2, 2, bytes({255, 0, 255, 255})));
    const std::string left = file("left.pgm", pgm(2, 1, bytes({255, 0})));
    const std::string ring = file("ring.txt", "0.1 0.1\n0.9 0.1\n0.9 0.9\n0.1 0.9\n");
    const std::string wet = file("wet.txt", "0.2 0.2\n0.7 0.2\n0.7 0.5\n0.2 0.5\n");
    const std::string road = file("b:road.txt", "0.4 0\n0.6 0\n0.6 1\n0.4 1\n");
    const std::string rocks = file("rocks.csv", "x,y,radius\n0.5,0.5,0.2\n");
    const std::string kept = file("kept.csv", "x,y\n0.3,0.3\n0.7,0.31\n");
    const std::string west = file("west.csv", "x,y\n0.98,0.3\n0.97,0.6\n");
    const std::string west_kinds = file("kinds.csv", "x,y,class\n0.98,0.3,a\n0.97,0.6,b\n");
    const std::string kept_kinds = file("own.csv", "x,y,class\n.25,.5,b\n.75,.5,a\n");
    const std::string pond = file("pond.txt", "0.3 0.3\n0.45 0.3\n0.45 0.45\n");
    const std::string map =
        file("map.svg",
             "<svg viewBox='0 0 60 40'><circle cx='10' cy='30' r='5'/>"
             "<g id='roads' stroke='black' stroke-width='8'><line x1='30' x2='30' "
             "y2='40'/><line y1='5' x2='60' y2='5' stroke-width='2'/></g></svg>");
    const std::string matrix = file("m.csv", "# a, b\n.06,.08\n.08,.03\n");
    const Words radius{"--radius", ".05"}, unit{"--domain", "1x1"};
    const Words kinds{"--class", "a:.06", "--class", "b:.02"}, east{"--domain", "1,0+1x1"};
    const Words of_a{"--inside", ring, "--inside", "b:" + wet, "--outside", "a:" + road};
    return {{"uniform", radius, ""},
            {"torus", joined(radius, {"--torus", "--domain", "2x1"}), ""},
            {"border", joined(radius, {"--border", ".1"}), ""},
            {"mask", joined(radius, {"--mask", mask}), "--mask", {"--mask", mask}},
            {"inside", joined(radius, {"--inside", ring}), "--inside", {"--inside", ring}},
            {"inside with an edge and a border",
             joined(radius, {"--inside", ring, "--edge", ".002", "--border", ".03"}),
             "--inside",
             {"--inside", ring}},
            {"inside by radius",
             joined(radius, {"--inside", ring, "--inside-by-radius"}),
             "--inside",
             {"--inside", ring}},
            {"outside", joined(radius, {"--outside", ring}), "--outside", {"--outside", ring}},
            {"avoid", joined(radius, {"--avoid", rocks}), "--avoid", {"--avoid", rocks}},
            {"avoid around a torus",
             joined(radius, {"--avoid", kept + ":.4", "--torus", "--domain", "1x1"}),
             "--avoid",
             {"--avoid", kept + ":.4"}},
            {"near and avoid",
             joined(radius, {"--near", rocks, "--near", wet + ":.05", "--avoid", road + ":.01"}),
             "--avoid",
             {"--near", rocks, "--near", wet + ":.05", "--avoid", road + ":.01"}},
            {"several polygons",
             joined(radius, {"--inside", ring, "--inside", wet, "--outside", pond}),
             "--inside",
             {"--inside", ring, "--inside", wet, "--outside", pond}},
            {"strokes of a drawing",
             {"--avoid", map + "#roads:stroke", "--radius", "2", "--domain", "120x80"},
             "--avoid",
             {"--avoid", map + "#roads:stroke"}},
            {"keep", joined(radius, {"--keep", kept}), ""},
            {"keep outside",
             joined(radius, joined(east, {"--keep", west})),
             "--keep",
             {"--keep", west}},
            {"keep outside, with an obstacle and a border",
             joined(radius, joined(east, {"--keep", west, "--avoid", kept + ":.5", "--border",
                                          ".01", "--edge", ".002"})),
             "--avoid",
             {"--keep", west, "--avoid", kept + ":.5"}},
            {"classes", {"--class", "a:.06", "--class", "b:.02:3"}, ""},
            {"classes by union", joined(kinds, {"--between", "union"}), ""},
            {"classes by a matrix", {"--class", "a", "--class", "b::3", "--between", matrix}, ""},
            {"numbers of classes", {"--class", "a:.06:1:12", "--class", "b:.02"}, ""},
            {"classes one after the other", joined(kinds, {"--priority"}), ""},
            {"borders of classes", joined(kinds, {"--border", "a:.2", "--border", ".1"}), ""},
            {"masks of classes",
             joined(joined(kinds, unit), {"--mask", "a:" + left, "--mask", mask}),
             "--mask",
             {"--mask", "a:" + left, "--mask", mask}},
            {"polygons of classes", joined(kinds, of_a), "--inside", of_a},
            {"classes inside by their radius", joined(kinds, joined(of_a, {"--inside-by-radius"})),
             "--inside", of_a},
            {"classes beside others",
             joined(kinds, joined(east, {"--keep", west_kinds})),
             "--keep",
             {"--keep", west_kinds}},
            {"classes and kept points", joined(kinds, {"--keep", kept_kinds}), ""},
            {"ellipses",
             {"--ellipses", kEllipses, "--scale", ".05"},
             "--ellipses",
             {"--ellipses", kEllipses}},
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
            {"progressive", joined(radius, {"--progressive"}), "", {}, false},
            {"progressive, of a count", {"--count", "300", "--progressive"}, "", {}, false}};
}

TEST(AFile, OfEachCapabilityIsProvenOrAsksForWhatItLacksAndRefutedWithoutAPoint) {
    const Folder folder;
    for (const Capability& one : capabilities(folder)) {
        SCOPED_TRACE(one.name);
        const std::string path = folder.path("a.json"), csv = folder.path("a.csv");
        expect_success(joined(joined({"sample", "--quiet"}, one.options), {"-o", path, "-o", csv}));
        const Outcome alone = run({"verify", path});
        if (one.asked.empty()) {
            EXPECT_EQ(alone.exit_code, 0) << alone.out << alone.err;
        } else {
            // How a picture is read is asked for once there is one.
            const bool is_reading = one.given[0] == "--field" && one.asked != "--field";
            const Outcome lacking =
                is_reading ? run({"verify", path, one.given[0], one.given[1]}) : alone;
            expect_one_error(lacking, 2, {"a.json: made with " + one.asked});
            expect_success(joined({"verify", path}, one.given));
            // Without the last option of several.
            const Words fewer(one.given.begin(), one.given.end() - 2);
            if (!fewer.empty() && *(one.given.end() - 2) != fewer[0] && !is_reading)
                expect_one_error(run(joined({"verify", path}, fewer)), 2,
                                 {"made with " + *(one.given.end() - 2)});
        }
        if (!one.is_for_csv) continue;
        const Words claim = joined({"verify", csv}, one.options);
        expect_success(claim);
        std::string points = content_of(csv);
        // The first: the last may lie in the strip at an outline that is drawn to an edge.
        const std::size_t first = points.find('\n') + 1;
        points.erase(first, points.find('\n', first) + 1 - first);
        write_file(csv, points);
        EXPECT_EQ(run(claim).exit_code, 1);
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
