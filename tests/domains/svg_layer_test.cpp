// FILE.svg#LAYER: the polygons and lines of one layer of a drawing.
#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {
namespace {

constexpr std::string_view kMap =
    R"svg(<svg id="all" viewBox="0 0 10 10" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">
<g id="layer1" inkscape:label="Lakes" transform="translate(1,0)"><rect id="pond" width="2" height="2"/></g>
<g id="layer2" inkscape:label="Roads"><path d="M0,5 L10,5" fill="none"/></g>
<g id="layer3" inkscape:label="Trees"><g inkscape:label="Old"><circle r="1" cx="8" cy="8"/></g></g>
<g inkscape:label="Trees" clip-path="url(#none)"><rect x="4" y="4" width="1" height="1"/></g>
<svg><switch systemLanguage="de"/></svg><use href="other.svg#x"/><use href="#pond" x="5"/>
<g id="empty"/><g id="twice"/><g id="twice"/></svg>)svg";

class LayersOfAnSvg : public testing::Test {
protected:
    LayersOfAnSvg() {
        std::string folder = (std::filesystem::temp_directory_path() / "svg-XXXXXX").string();
        folder_ = ::mkdtemp(folder.data());
        path_ = folder_ / "map.svg";
        std::ofstream(path_) << kMap;
    }
    ~LayersOfAnSvg() override { std::filesystem::remove_all(folder_); }

    std::vector<PolygonRing> rings_of(const std::string& layer) const {
        return read_polygons(path_.string() + "#" + layer).rings;
    }
    std::string refusal_of(const std::string& layer) const {
        try {
            rings_of(layer);
        } catch (const FileError& error) {
            const std::string text = error.what();
            return text.substr(text.find(": ") + 2);
        } catch (const BadRequest& error) {
            return error.what();
        }
        return "";
    }

    std::filesystem::path folder_;
    std::filesystem::path path_;
};

TEST_F(LayersOfAnSvg, AreNamedByIdOrLabelAndMovedAsInTheDrawing) {
    for (const char* layer : {"layer1", "Lakes", "pond"}) {
        const std::vector<PolygonRing> rings = rings_of(layer);
        ASSERT_EQ(rings.size(), 1U) << layer;
        ASSERT_EQ(rings[0].size(), 4U) << layer;
        for (const Point& corner : rings[0]) {
            EXPECT_TRUE(corner.x == 1 || corner.x == 3) << layer;
            EXPECT_TRUE(corner.y == 8 || corner.y == 10) << layer;
        }
    }
    EXPECT_EQ(rings_of("Old").size(), 1U);
    EXPECT_EQ(read_polygons(path_.string() + "#Old").page->width, 10);
    EXPECT_EQ(read_lines(path_.string() + "#Roads").rings.size(), 1U);
}

TEST_F(LayersOfAnSvg, ThatAreNotReadMayHaveWhatIsRefused) {
    EXPECT_NE(refusal_of("Roads").find("a line, which encloses nothing"), std::string::npos);
    EXPECT_NO_THROW(rings_of("layer3"));
    EXPECT_THROW(read_polygons(path_.string()), FileError);
}

TEST_F(LayersOfAnSvg, MayBeTheDrawingItself) {
    EXPECT_NE(refusal_of("all").find("a line, which encloses nothing"), std::string::npos);
}

TEST_F(LayersOfAnSvg, DoNotHideAFileWithSuchAName) {
    std::filesystem::rename(path_, folder_ / "a.svg#b.svg");
    EXPECT_EQ(read_polygons((folder_ / "a.svg#b.svg").string() + "#Lakes").rings.size(), 1U);
    std::ofstream(folder_ / "a.svg#b.svg")
        << "<svg viewBox='0 0 1 1'><rect width='1' height='1'/></svg>";
    EXPECT_EQ(read_polygons(folder_ / "a.svg#b.svg").rings.size(), 1U);
}

TEST_F(LayersOfAnSvg, ThatAreNotThereOrTwiceAreRefused) {
    EXPECT_EQ(refusal_of("Seas"),
              "no element has the id or the label \"Seas\": there are \"Lakes\", \"Roads\", "
              "\"Trees\", \"Old\", \"Trees\"");
    EXPECT_EQ(refusal_of("Trees"), "2 elements have the label \"Trees\": must be one");
    EXPECT_EQ(refusal_of("twice"), "2 elements have the id \"twice\": must be one");
    EXPECT_EQ(refusal_of("empty"),
              "no polygon in the layer \"empty\", or it is hidden or in defs: there must be at "
              "least one, of three points or "
              "more");
    EXPECT_NE(refusal_of("").find("must end in .svg"), std::string::npos);
}

}  // namespace
}  // namespace lacuna
