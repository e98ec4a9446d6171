// Meshes from files: every format gives the same surface, and what has none is refused by name.
#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "folder.h"
#include "refusal.h"
#include "required.h"
#include "space/meshes.h"

namespace mesh_test {

using namespace lacuna;
using namespace lacuna::tests;

const std::string kObj =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 0.5\nf 1 2 3 4\nf 1 5 2\nl 1 5\n";
const std::string kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n";
// A triangle of area 1/2 in a file beside it, under a node that doubles it and moves it by 3.
const std::string kGltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"scale":[2,2,2],"translation":[3,0,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
"min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"uri":"beside.bin","byteLength":36}]})";

class AMeshFromAFile : public testing::Test {
protected:
    void SetUp() override {
        const std::string said = refusal_of([] { decode_mesh(kObj, "a.obj"); });
        if (said.find("assimp cannot be loaded") != std::string::npos ||
            said.find("without assimp") != std::string::npos)
            if (!is_required("assimp")) GTEST_SKIP() << said;
    }
    Folder folder_;
};

TEST_F(AMeshFromAFile, HasTheTrianglesOfItsPolygons) {
    const Mesh mesh = decode_mesh(kObj, "a.OBJ");
    EXPECT_EQ(mesh.triangles.size(), 3U);
    EXPECT_NEAR(area_of(mesh), 2.5, 1e-6);
    EXPECT_NEAR(area_of(decode_mesh(kPly, "a.ply")), 2, 1e-6);
    EXPECT_NEAR(area_of(decode_mesh("OFF\n3 1 3\n0 0 0\n1 0 0\n0 4 0\n3 0 1 2\n", "a.off")), 2,
                1e-6);
    EXPECT_NEAR(area_of(decode_mesh("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                    "vertex 1 0 0\nvertex 0 4 0\nendloop\nendfacet\nendsolid a\n",
                                    "a.stl")),
                2, 1e-6);
}

TEST_F(AMeshFromAFile, MayHaveItsNumbersBesideItAndNodes) {
    const float numbers[]{0, 0, 0, 1, 0, 0, 0, 1, 0};
    write_file(folder_.path("beside.bin"),
               std::string(reinterpret_cast<const char*>(numbers), sizeof numbers));
    write_file(folder_.path("a.gltf"), kGltf);
    const Mesh mesh = read_mesh(folder_.path("a.gltf"));
    EXPECT_NEAR(area_of(mesh), 2, 1e-6);
    const auto [low, high] =
        std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                            [](const Point3& a, const Point3& b) { return a.x < b.x; });
    EXPECT_EQ(low->x, 3);
    EXPECT_EQ(high->x, 5);
}

TEST_F(AMeshFromAFile, WithoutASurfaceIsRefused) {
    const std::string points = kPly.substr(0, kPly.find("element face")) + "end_header\n0 0 0\n";
    for (const auto& [name, bytes, part] :
         {std::tuple{"a.ply", points, "has no element face: points alone are no surface"},
          {"a.ply", kPly.substr(0, 99), "must be the number of elements"},
          {"a.obj", kObj.substr(0, kObj.find("f 1")) + "l 1 2\n", "has no triangle: points and"},
          {"a.off", std::string("OFF\n3 1 3\n0 0 0\n"), "assimp cannot read it"},
          {"a.stl", std::string("rubbish"), "assimp cannot read it"},
          {"a.glb", std::string(), "is empty"},
          {"a.fbx", kObj, "must end in .ply, .obj, .stl, .off, .gltf or .glb"}}) {
        const std::string said = refusal_of([&] { decode_mesh(bytes, name); });
        EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos);
    }
    // Assimp ends the process of its own for some of these.
    for (std::size_t size = 1; size < kPly.find("0 0 0"); size += 3)
        EXPECT_NE(refusal_of([&] { decode_mesh(kPly.substr(0, size), "a.ply"); }), "accepted")
            << size;
}

}  // namespace mesh_test
