// A domain whose lower left corner is not (0, 0) is read from a .json by every command. What sample
// writes of it is in placement_test.cpp.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "expectations.h"
#include "program.h"

namespace corner_test {

using namespace lacuna::tests;
using Json = nlohmann::json;

const std::string kMap = "448000,5411000+2000x1500";

void sample_to(const std::string& path, const Words& arguments) {
    expect_success(joined(joined({"sample"}, arguments), {"--quiet", "-o", path}));
}

TEST(ACorner, IsReadBackFromAJsonByEveryCommand) {
    const Folder folder;
    const std::string set = folder.path("a.json");
    sample_to(set, {"--radius", "90", "--domain", kMap, "--torus"});
    const std::string where = "2000 x 1500 at (448000, 5411000), torus";
    const Outcome proof = run({"verify", set});
    EXPECT_EQ(proof.exit_code, 0) << proof.out;
    expect_has(line_of(proof.out, "domain"), {where});
    const Json verdict = Json::parse(run({"verify", set, "--json"}).out)["sets"][0];
    EXPECT_EQ(verdict["domain"]["x0"], 448000);
    EXPECT_EQ(verdict["domain"]["y0"], 5411000);
    expect_has(line_of(run({"analyze", set, "--quiet"}).out, "domain"), {where});
    EXPECT_EQ(Json::parse(run({"analyze", set, "--json", "--quiet"}).out)["domain"]["y0"], 5411000);
    for (const Words& command : {Words{"relax", set, "--iterations", "3"}, Words{"order", set}}) {
        const std::string path = folder.path(command[0] + ".json");
        expect_success(joined(command, {"--quiet", "-o", path}));
        const Json json = Json::parse(content_of(path));
        EXPECT_EQ(json["x0"], 448000) << command[0];
        EXPECT_EQ(json["y0"], 5411000) << command[0];
        EXPECT_EQ(run({"verify", path, "--radius", "1", "--distances-only"}).exit_code, 0)
            << command[0];
    }
    // Without a .json the option says it, and a set that lies elsewhere is refused.
    sample_to(folder.path("a.csv"), {"--radius", "90", "--domain", kMap, "--torus"});
    const Words proven{"verify", folder.path("a.csv"), "--radius", "90", "--torus"};
    Words there = proven;
    there.insert(there.end(), {"--domain", kMap});
    EXPECT_EQ(run(there).exit_code, 0);
    there.back() = "448100,5411000+2000x1500";
    const Outcome moved = run(there);
    EXPECT_EQ(moved.exit_code, 1);
    expect_has(line_of(moved.out, "verdict"),
               {"outside the domain [448100, 450100) x [5411000, 5412500)"});
    expect_has(run({"analyze", folder.path("a.csv")}).err,
               {"lies outside the domain [0, 1] x [0, 1]: give --domain"});
}

}  // namespace corner_test
