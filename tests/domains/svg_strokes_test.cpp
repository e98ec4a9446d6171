// The lines of an SVG with the widths of their strokes.
#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <map>
#include <string>
#include <vector>

#include "domains/rings.h"
#include "refusal.h"

namespace svg_strokes_test {

using namespace lacuna;

// The number of lines by their width.
std::map<double, std::size_t> widths_in(const std::string& inner, const std::string& root = "") {
    std::map<double, std::size_t> widths;
    for (const domains::Strokes& strokes : domains::decode_strokes(
             "<svg viewBox='0 0 80 80' " + root + ">" + inner + "</svg>", "file"))
        widths[2 * strokes.distance] = strokes.lines.rings.size();
    return widths;
}

using Widths = std::map<double, std::size_t>;

TEST(Strokes, HaveTheWidthsThatTheDrawingShows) {
    const std::string line = "<line x2='9' ", road = "stroke='red' stroke-width='8'";
    for (const auto& [inner, widths] : std::vector<std::pair<std::string, Widths>>{
             {line + road + "/>", {{8, 1}}},
             {line + "stroke='red'/>", {{1, 1}}},
             {line + "/><circle r='3'/><rect width='3' height='2' stroke='none'/>", {}},
             {"<circle r='3' " + road + "/><path d='M1 1h5 M9 9h3v3z' " + road + "/>", {{8, 3}}},
             // Inherited, by whatever way it is given.
             {"<g " + road + ">" + line + "/><g stroke-width='2'>" + line + "/>" + line +
                  "stroke-width='inherit'/></g></g>",
              {{8, 1}, {2, 2}}},
             {"<g style='stroke: red; stroke-width: 2mm'>" + line + "/></g>", {{2 * 96 / 25.4, 1}}},
             {"<style>.a {stroke: red} line.b {stroke-width: 3px}</style>" + line +
                  "class='a b' stroke-width='9'/>",
              {{3, 1}}},
             {"<g " + road + ">" + line + "stroke='none'/>" + line + "stroke='initial'/>" + line +
                  "stroke='transparent'/>" + line + "stroke-opacity='0'/>" + line +
                  "stroke-width='0'/>" + line + "stroke-width='initial'/></g>",
              {{1, 1}}},
             // A transform that keeps shapes changes widths by its factor.
             {"<g transform='scale(2) rotate(30)' " + road + ">" + line +
                  "transform='scale(-.25 .25) translate(3 5)'/></g>",
              {{4, 1}}},
             {"<defs>" + line + "id='p'/></defs><use href='#p' " + road + "/>", {{8, 1}}},
             {line + "display='none' " + road + "/><g visibility='hidden'>" + line + road +
                  "/></g>",
              {}}}) {
        const Widths found = widths_in(inner);
        ASSERT_EQ(found.size(), widths.size()) << inner;
        for (auto one = found.begin(), wanted = widths.begin(); one != found.end();
             ++one, ++wanted) {
            EXPECT_NEAR(one->first, wanted->first, 1e-9) << inner;
            EXPECT_EQ(one->second, wanted->second) << inner;
        }
    }
    EXPECT_EQ(widths_in(line + "/>", road), (Widths{{8, 1}}));
}

TEST(Strokes, ThatAreNotEquallyWideOrNotReadAreRefused) {
    const std::string line = "<line id='a' x2='9' stroke='red' ";
    for (const auto& [inner, told] : std::vector<std::pair<std::string, std::string>>{
             {line + "transform='scale(2 1)'/>",
              "<line id=\"a\">: its stroke of 1 is stretched by a transform"},
             {line + "transform='skewX(9)'/>", "its stroke of 1 is stretched by a transform"},
             {line + "stroke-width='2%'/>",
              "<line id=\"a\">: stroke-width is \"2%\": must be a number of at least 0"},
             {line + "stroke-width='-2'/>", "stroke-width is \"-2\""},
             {line + "vector-effect='non-scaling-stroke'/>",
              "vector-effect \"non-scaling-stroke\": is not read"},
             {line + "clip-path='url(#b)'/>", "clip-path is not read"},
             {"<style>g > .a {stroke-width: 3}</style>" + line + "/>", "sets stroke-width"}})
        EXPECT_NE(tests::refusal_of([&] { widths_in(inner); }).find(told), std::string::npos)
            << tests::refusal_of([&] { widths_in(inner); });
    // Without their widths these decide nothing.
    const auto read = [&](const std::string& inner) {
        decode_lines("<svg viewBox='0 0 8 8'>" + inner + "</svg>", "svg", "file");
    };
    read("<style>g > .a {stroke-width: 3}</style>" + line + "stroke-width='2%'/>");
    read(line + "transform='scale(2 1)' vector-effect='non-scaling-stroke'/>");
}

}  // namespace svg_strokes_test
