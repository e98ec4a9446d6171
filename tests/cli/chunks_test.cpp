// Chunks and tiles, as a user of the command makes and proves them.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "files/read_points.h"
#include "program.h"

namespace chunks_test {

using namespace lacuna;
using namespace lacuna::tests;
using Json = nlohmann::json;

// A chunk to the west of another, and the domain of that.
class Chunks : public testing::Test {
protected:
    void make(const Words& options) {
        expect_success(joined({"sample", "--quiet", "-o", west_, "--domain", "1x1"}, options));
        const Outcome made = run(joined({"sample", "-o", east_, "-o", json_, "--keep", west_},
                                        joined(options, domain_)));
        ASSERT_EQ(made.exit_code, 0) << made.err;
        summary_ = made.err;
    }
    Outcome verified(const Words& more) const { return run(joined({"verify"}, more)); }

    const Folder folder_;
    const std::string west_ = folder_.path("west.csv"), east_ = folder_.path("east.csv");
    const std::string json_ = folder_.path("east.json");
    const Words domain_{"--domain", "1,0+1x1"};
    std::string summary_;
};

TEST_F(Chunks, AreProvenWithTheirNeighboursAndNotWithout) {
    make({"--radius", "0.05"});
    const std::vector<Point> west = files::read_points(west_);
    const std::string count = std::to_string(west.size());
    const std::string near = std::to_string(
        std::count_if(west.begin(), west.end(), [](Point p) { return p.x >= 0.95; }));
    EXPECT_NE(summary_.find(", beside " + near + " kept outside, "), std::string::npos) << summary_;
    const Json set = Json::parse(content_of(json_));
    EXPECT_EQ(set["options"]["keep"], west_);
    EXPECT_EQ(set["options"]["kept"], 0);
    EXPECT_EQ(std::to_string(set["options"]["neighbours"].get<int>()), near);

    const Words claim = joined({east_, "--radius", "0.05"}, domain_);
    const Outcome proven = verified(joined(claim, {"--keep", west_}));
    EXPECT_EQ(proven.exit_code, 0) << proven.out;
    EXPECT_NE(proven.out.find(count + " points, " + count + " of them outside of the domain"),
              std::string::npos)
        << proven.out;
    EXPECT_EQ(verified({json_, "--keep", west_}).exit_code, 0);
    const Outcome alone = verified(claim);
    EXPECT_EQ(alone.exit_code, 1);
    EXPECT_NE(alone.out.find("there is room for a point at (1"), std::string::npos) << alone.out;
    const Outcome asking = verified({json_});
    EXPECT_EQ(asking.exit_code, 2);
    EXPECT_NE(asking.err.find("made with --keep " + west_ + ": give that too"), std::string::npos)
        << asking.err;
}

TEST_F(Chunks, NameANeighbourThatIsTooClose) {
    write_file(west_, "x,y\n-3,0.5\n0.96,0.5\n");
    write_file(east_, "x,y\n1.01,0.5\n");
    const Words claim = joined({east_, "--radius", "0.1", "--keep", west_}, domain_);
    const Outcome refuted = verified(claim);
    EXPECT_EQ(refuted.exit_code, 1);
    EXPECT_NE(refuted.out.find("points 0 at (1.01, 0.5) and 1 of " + west_ +
                               " at (0.96, 0.5) are closer than 0.1"),
              std::string::npos)
        << refuted.out;
    const Json report = Json::parse(verified(joined(claim, {"--json"})).out);
    EXPECT_EQ(report["sets"][0]["closest_pair"]["points"], Json::parse("[0, 2]"));
    EXPECT_EQ(report["sets"][0]["neighbours"], 1);
}

// With a count the distances, and so the neighbours, are known only when the set is made.
TEST_F(Chunks, AreNeededOnlyWhereTheyAreNear) {
    make({"--count", "100"});
    const Json set = Json::parse(content_of(json_));
    const std::vector<Point> west = files::read_points(west_);
    const double begin = 1 - set["radius"].get<double>();
    const auto near =
        std::count_if(west.begin(), west.end(), [&](Point p) { return p.x >= begin; });
    EXPECT_EQ(set["options"]["neighbours"], near);
    EXPECT_NE(summary_.find(", beside " + std::to_string(near) + " kept"), std::string::npos);

    write_file(west_, "x,y\n0.94,0.5\n");
    const Outcome alone =
        run(joined({"sample", "--radius", "0.05", "--keep", west_, "-o", json_}, domain_));
    EXPECT_EQ(alone.err.find("outside"), std::string::npos) << alone.err;
    EXPECT_EQ(verified({json_}).exit_code, 0);
}

TEST_F(Chunks, OfManySeedsSayWhatEachAloneWouldSay) {
    write_file(west_, "x,y,class\n0.999,0.5,a\n0.9,0.2,b\n0.8,0.2,b\n0.7,0.2,b\n");
    const Words options = joined(
        {"sample", "--class", "a:2", "--class", "b:1", "--count", "200", "--keep", west_}, domain_);
    const Outcome made =
        run(joined(options, {"--seeds", "0..1", "-o", folder_.path("{seed}.json")}));
    EXPECT_NE(made.err.find(", beside up to 4 kept outside, "), std::string::npos) << made.err;
    expect_success(joined(options, {"--seed", "1", "-o", json_, "--quiet"}));
    EXPECT_EQ(content_of(folder_.path("1.json")), content_of(json_));
}

TEST_F(Chunks, OfClassesNameANeighbourThatIsTooClose) {
    make({"--class", "trees:0.06", "--class", "grass:0.01"});
    write_file(west_, "x,y,class\n0.999,0.5,trees\n");
    const Outcome refuted = verified({json_, "--keep", west_});
    EXPECT_EQ(refuted.exit_code, 1);
    expect_has(refuted.out, {"0 of " + west_ + " at (0.999, 0.5), of class trees, are closer"});
}

TEST(Tiles, OfOneFrameBeginWithItsPointsAndSayHowMany) {
    const Folder folder;
    const Words options{"sample", "--radius", "0.05", "--torus"};
    const Outcome made = run(
        joined(options, {"--frame", "0.1", "--seeds", "4..7", "-o", folder.path("{seed}.csv"), "-o",
                         folder.path("{seed}.json"), "--report", folder.path("all.json")}));
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Json tile = Json::parse(content_of(folder.path("5.json")));
    const std::size_t kept = tile["options"]["kept"];
    EXPECT_EQ(tile["options"]["frame"], 0.1);
    EXPECT_NE(made.err.find(", " + std::to_string(kept) + " of them kept, "), std::string::npos)
        << made.err;
    EXPECT_EQ(Json::parse(content_of(folder.path("all.json")))["request"]["kept"], kept);
    const std::vector<Point> first = files::read_points(folder.path("4.csv"));
    const std::vector<Point> other = files::read_points(folder.path("7.csv"));
    ASSERT_LT(kept, first.size());
    EXPECT_TRUE(std::equal(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(kept),
                           other.begin()));
    EXPECT_NE(first[kept], other[kept]);
    EXPECT_EQ(run({"verify", folder.path("5.json")}).exit_code, 0);
    // The same as with the frame in a file.
    std::string frame;
    const std::string all = content_of(folder.path("5.csv"));
    for (std::size_t line = 0, at = 0; line <= kept; ++line)
        frame = all.substr(0, at = all.find('\n', at) + 1);
    write_file(folder.path("frame.csv"), frame);
    expect_success(joined(options, {"--seed", "5", "--keep", folder.path("frame.csv"), "-o",
                                    folder.path("same.csv"), "--quiet"}));
    EXPECT_EQ(content_of(folder.path("same.csv")), all);
}

// One file serves all chunks: those without a lake, and those wholly in one.
class ChunksOfALake : public testing::Test {
protected:
    ChunksOfALake() {
        write_file(lake_, R"({"type":"Polygon","coordinates":[[[0,0],[100,0],[100,100],[0,100],)"
                          R"([0,0]]]})");
        write_file(black_, std::string("P5 1 1 255 ") + '\0');
    }
    Outcome made(const Words& options, const Words& outputs) const {
        Words words = joined({"sample", "--radius", "3"}, options);
        for (const std::string& output : outputs) words = joined(words, {"-o", output});
        return run(words);
    }

    const Folder folder_;
    const std::string lake_ = folder_.path("lake.geojson"), black_ = folder_.path("black.pgm");
    const std::string csv_ = folder_.path("next.csv");
    const Words in_{"--domain", "10,10+64x64"}, beside_{"--domain", "0,192+64x64"};
};

TEST_F(ChunksOfALake, BesideItAreFull) {
    for (const Words& places : {Words{"--outside", lake_}, Words{"--avoid", lake_ + ":2"}}) {
        const Outcome outcome = made(joined(beside_, places), {csv_});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_GT(files::read_points(csv_).size(), 300U);
        EXPECT_EQ(run(joined(joined({"verify", csv_, "--radius", "3"}, beside_), places)).exit_code,
                  0);
    }
}

TEST_F(ChunksOfALake, WithoutAnOpenPlaceAreEmptyInEveryFormat) {
    const std::string drawn = "has no open place wider than twice the --edge), ";
    for (const auto& [places, told] : std::vector<std::pair<Words, std::string>>{
             {joined(in_, {"--outside", lake_}), drawn},
             {joined(beside_, {"--inside", lake_}), drawn},
             {joined(beside_, {"--near", lake_ + ":2"}), drawn},
             {joined(in_, {"--outside", lake_, "--progressive"}), drawn},
             {joined(in_, {"--mask", black_}), "(the mask is black all over), "}}) {
        Words outputs;
        for (const char* const end : {"txt", "csv", "npy", "ply", "json", "svg"})
            outputs.push_back(folder_.path(std::string("a.") + end));
        const Outcome outcome = made(places, outputs);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        expect_has(outcome.err, {"0 points (", told});
        outputs.pop_back();
        for (const std::string& output : outputs) {
            EXPECT_TRUE(files::read_points(output).empty()) << output;
            Words claim = places;
            claim.erase(std::remove(claim.begin(), claim.end(), "--progressive"), claim.end());
            const Outcome proof = run(joined({"verify", output, "--radius", "3"}, claim));
            EXPECT_EQ(proof.exit_code, 0) << proof.out << proof.err;
            expect_has(proof.out, {"none, since points may lie nowhere"});
            // The next chunk keeps what there is: nothing.
            EXPECT_EQ(made({"--domain", "74,10+64x64", "--keep", output}, {csv_}).exit_code, 0);
        }
        // What is said of an empty set is said, too, where the points go to standard output.
        expect_has(made(places, {"-"}).err, {"0 points ("});
        const Words counted = joined({"sample", "--count", "9"}, places);
        expect_one_error(run(counted), 2, {"--count 9: points may lie nowhere"});
    }
}

TEST_F(ChunksOfALake, AreEmptyForAClassThatMayLieNowhere) {
    const Words kinds = joined(in_, {"--class", "reed:3", "--class", "tree:4"});
    const Outcome some =
        run(joined(joined({"sample", "-o", csv_}, kinds), {"--outside", "tree:" + lake_}));
    EXPECT_EQ(some.exit_code, 0) << some.err;
    expect_has(some.err, {"has no open place for tree wider than"});
    EXPECT_EQ(content_of(csv_).find("tree"), std::string::npos);
    EXPECT_GT(files::read_points(csv_).size(), 50U);
    EXPECT_EQ(
        run(joined(joined({"verify", csv_}, kinds), {"--outside", "tree:" + lake_})).exit_code, 0);
    EXPECT_EQ(run(joined(joined({"sample", "-o", csv_, "--count", "50"}, kinds),
                         {"--outside", "tree:" + lake_}))
                  .exit_code,
              0);
    expect_one_error(
        run(joined(joined({"sample", "-o", csv_, "--count", "50"}, kinds), {"--outside", lake_})),
        2, {"--count 50: points may lie nowhere"});
    expect_one_error(
        run(joined(joined({"sample", "-o", csv_}, kinds), {"--outside", "tre:" + lake_})), 2,
        {"tre is not a class"});
}

}  // namespace chunks_test
