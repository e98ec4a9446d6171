// Polygons from SVG drawings, and the messages for broken ones.
#include <gtest/gtest.h>
#include <lacuna/domains.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace svg_test {

using namespace lacuna;

using Rings = std::vector<PolygonRing>;

Rings rings_of(std::string_view bytes) {
    return decode_polygons(bytes, "svg", "file").rings;
}

std::string refusal_of(std::string_view bytes) {
    try {
        decode_polygons(bytes, "svg", "file");
    } catch (const FileError& error) {
        return error.what();
    }
    return "";
}

std::string svg(std::string_view elements) {
    return "<svg viewBox=\"0 0 8 10\" fill-rule=\"evenodd\" xmlns=\"http://www.w3.org/2000/svg\">" +
           std::string(elements) + "</svg>";
}

Rings rings_of_svg(std::string_view elements) {
    return rings_of(svg(elements));
}

// By the shoelace formula; positive where the ring goes counterclockwise.
double area_of(const PolygonRing& ring) {
    double doubled = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = ring[(i + 1) % ring.size()];
        doubled += a.x * b.y - b.x * a.y;
    }
    return doubled / 2;
}

TEST(AnSvg, IsReadAsItIsSeen) {
    const Polygons read =
        decode_polygons(svg(R"(<polygon points="0,0 8,0 0,10"/>)"), "svg", "file");
    EXPECT_EQ(read.page->width, 8);
    EXPECT_EQ(read.page->height, 10);
    EXPECT_EQ(read.rings, (Rings{{{0, 10}, {8, 10}, {0, 0}}}));
}

TEST(AnSvg, HasThePageOfItsViewBoxOrOfItsSize) {
    const auto page = [](const std::string& attributes) {
        const Polygons read = decode_polygons(
            "<svg fill-rule='evenodd' " + attributes + "><rect width='1' height='1'/></svg>", "svg",
            "file");
        return std::vector<double>{read.page->width, read.page->height, read.rings[0][0].x,
                                   read.rings[0][0].y};
    };
    EXPECT_EQ(page("viewBox='-2 -3 8 10' width='800' height='5mm'"),
              (std::vector<double>{8, 10, 2, 7}));
    EXPECT_EQ(page("width='2in' height='96'"), (std::vector<double>{192, 96, 0, 96}));
    EXPECT_EQ(refusal_of("<svg width='100%' height='2'/>"),
              "file: without a viewBox, width \"100%\" and height \"2\": there must be a viewBox, "
              "or both sizes over 0, in px, mm, cm, in, pt or pc");
    for (const std::string box : {"0 0 1", "0 0 1 0", "0 0 -1 1", "0 0 1 1 1", "0 0 nan 1"})
        EXPECT_EQ(refusal_of("<svg viewBox='" + box + "'/>"),
                  "file: viewBox is \"" + box +
                      "\": must be four numbers, left, top, width and height, the last two over 0");
}

TEST(AnSvg, IsStretchedWithItsPageOverTheDomain) {
    EXPECT_EQ(fitted({{{{0, 10}, {8, 10}, {0, 0}}}, Domain{8, 10}}, {1, 20}),
              (Rings{{{0, 20}, {1, 20}, {0, 0}}}));
    EXPECT_EQ(fitted({{{{0, 10}, {8, 10}, {0, 0}}}, {}}, {1, 20}),
              (Rings{{{0, 10}, {8, 10}, {0, 0}}}));
}

TEST(APath, OfLinesIsReadInEveryWayOfWritingThem) {
    const Rings square{{{1, 9}, {3, 9}, {3, 7}, {1, 7}}};
    for (const std::string_view data :
         {"M1 1 3 1 3 3 1 3z", "M1,1L3,1L3,3L1,3", "m1 1h2v2h-2z", "M1 1H3V3H1V1Z",
          "m1,1,2,0,0,2-2,0z", "M+1.0 10e-1 l2 0 0 2 -2 0 0 -2", " M 1 1\n L 3 1 L 3 3 L 1 3 Z "})
        EXPECT_EQ(rings_of_svg("<path d='" + std::string(data) + "'/>"), square) << data;
}

TEST(APath, GoesOnWhereTheLastPieceBegan) {
    EXPECT_EQ(
        rings_of_svg("<path d='m1 1h2v2z h1v-1z m4 4h1v1z'/>"),
        (Rings{{{1, 9}, {3, 9}, {3, 7}}, {{1, 9}, {2, 9}, {2, 10}}, {{5, 5}, {6, 5}, {6, 4}}}));
}

TEST(APath, LeavesOutWhatEnclosesNothing) {
    EXPECT_EQ(rings_of_svg("<path d='M1 1L2 2M5 5M1 1h2v2M3 3z'/>"),
              (Rings{{{1, 9}, {3, 9}, {3, 7}}}));
}

// Each point of a circle's ring is on it, and the lines between them are close to it.
void expect_circle(const PolygonRing& ring, Point middle, double radius) {
    const double tolerance = 10 * 0x1p-20;
    ASSERT_GT(ring.size(), 100U);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = ring[(i + 1) % ring.size()];
        EXPECT_NEAR(std::hypot(a.x - middle.x, a.y - middle.y), radius, 1e-12);
        EXPECT_GE(std::hypot((a.x + b.x) / 2 - middle.x, (a.y + b.y) / 2 - middle.y),
                  radius - tolerance);
    }
}

TEST(ACurve, OfACircleIsCloseToIt) {
    for (const std::string_view shape :
         {"<circle cx='4' cy='3' r='2'/>", "<ellipse cx='4' cy='3' rx='2' ry='2'/>",
          "<rect x='2' y='1' width='4' height='4' rx='2'/>",
          "<rect x='2' y='1' width='4' height='4' ry='7'/>",
          "<path d='M2 3a2 2 0 1 1 4 0a2 2 0 1 1-4 0'/>",
          "<path d='M2 3a2 2 0 014 0A2,2 0 0,1 2 3'/>",
          // radii that are too small to reach grow
          "<path d='M2 3a1 1 0 1 1 4 0a.001.001 45 1 1-4 0'/>",
          // three quarters and one
          "<path d='M4 1A2 2 0 1 0 6 3A2 2 0 0 0 4 1'/>",
          "<path d='M4 1A2 2 0 0 1 6 3A2 2 0 1 1 4 1'/>",
          "<g transform='translate(4 3)scale(.5,1)'><ellipse rx='4' ry='2'/></g>"}) {
        const Rings rings = rings_of_svg(shape);
        ASSERT_EQ(rings.size(), 1U) << shape;
        SCOPED_TRACE(shape);
        expect_circle(rings[0], {4, 7}, 2);
        EXPECT_NEAR(std::abs(area_of(rings[0])), 4 * std::acos(-1.0), 1e-4);
    }
}

TEST(ACurve, OfAnArcTakesTheSideThatItsFlagsTell) {
    // A chord of a circle of radius 5, 3 from its middle: segments of these areas.
    const double small = 25 * std::acos(0.6) - 12;
    const double large = 25 * std::acos(-1.0) - small;
    const auto area = [](const std::string& flags) {
        const Rings rings = rings_of_svg("<path d='M10 10A5 5 0 " + flags + " 18 10'/>");
        return area_of(rings.at(0));
    };
    // From left to right on a page, whose y points down. With sweep the arc goes over the chord,
    // which is clockwise.
    EXPECT_NEAR(area("0 1"), -small, 1e-3);
    EXPECT_NEAR(area("1 1"), -large, 1e-3);
    EXPECT_NEAR(area("0 0"), small, 1e-3);
    EXPECT_NEAR(area("1 0"), large, 1e-3);
}

TEST(ACurve, OfATurnedEllipseIsTurned) {
    const Rings rings = rings_of_svg("<path d='M4 1A4 1 90 0 1 4 9A4 1 90 0 1 4 1'/>");
    ASSERT_EQ(rings.size(), 1U);
    EXPECT_NEAR(std::abs(area_of(rings[0])), 4 * std::acos(-1.0), 1e-4);
    for (const Point& point : rings[0]) {
        EXPECT_GE(point.x, 3 - 1e-12);
        EXPECT_LE(point.x, 5 + 1e-12);
    }
}

TEST(ACurve, OfBezierEnclosesWhatItShould) {
    // Area between a quadratic curve and its chord: two thirds of its triangle.
    const double third = 8.0 / 3;
    for (const std::string_view data : {"M0 5Q2 1 4 5", "M0 5q2-4 4 0",
                                        "M0 5C1.3333333333333333 2.3333333333333335 "
                                        "2.6666666666666665 2.3333333333333335 4 5"}) {
        const Rings rings = rings_of_svg("<path d='" + std::string(data) + "z'/>");
        ASSERT_EQ(rings.size(), 1U);
        EXPECT_NEAR(std::abs(area_of(rings[0])), 2 * third, 1e-4) << data;
    }
    // The same curve again, mirrored, by T and S.
    const Rings smooth = rings_of_svg("<path d='M0 5Q1 3 2 5T4 5'/>");
    EXPECT_NEAR(area_of(smooth.at(0)), 0, 1e-6);
    EXPECT_GT(smooth.at(0).size(), 100U);
    const Rings cubic = rings_of_svg("<path d='M0 5C0 3 2 3 2 5S4 7 4 5'/>");
    EXPECT_NEAR(area_of(cubic.at(0)), 0, 1e-6);
    EXPECT_GT(cubic.at(0).size(), 100U);
}

TEST(ATransform, IsOneAfterTheOther) {
    const auto moved = [](std::string_view transform) {
        return rings_of_svg("<g transform='" + std::string(transform) +
                            "'><path d='M0 0h1v2z'/></g>")
            .at(0);
    };
    EXPECT_EQ(moved("translate(3)"), (PolygonRing{{3, 10}, {4, 10}, {4, 8}}));
    EXPECT_EQ(moved("translate(1,2) scale(2)"), (PolygonRing{{1, 8}, {3, 8}, {3, 4}}));
    EXPECT_EQ(moved("scale(2) translate(1 2)"), (PolygonRing{{2, 6}, {4, 6}, {4, 2}}));
    EXPECT_EQ(moved("rotate(90)"), (PolygonRing{{0, 10}, {0, 9}, {-2, 9}}));
    EXPECT_EQ(moved("rotate(-630, 1, 1)"), (PolygonRing{{2, 10}, {2, 9}, {0, 9}}));
    EXPECT_EQ(moved("matrix(1 0 1 1 0 0)"), (PolygonRing{{0, 10}, {1, 10}, {3, 8}}));
    EXPECT_NEAR(moved("skewX(45)").at(2).x, 3, 1e-12);
    EXPECT_NEAR(moved("skewY(45)").at(2).y, 7, 1e-12);
    EXPECT_NEAR(moved("rotate(30)").at(1).x, std::sqrt(0.75), 1e-12);
}

TEST(AnSvg, ShowsWhatIsUsedAndHidesWhatIsOnlyDefined) {
    const PolygonRing triangle{{0, 10}, {1, 10}, {1, 8}};
    const PolygonRing moved{{3, 9}, {4, 9}, {4, 7}};
    const std::string defined = "<defs><g id='g'><path id='p' d='M0 0h1v2z'/></g></defs>";
    EXPECT_EQ(rings_of_svg(defined + "<use href='#p'/>"), (Rings{triangle}));
    EXPECT_EQ(rings_of_svg(defined + "<use xlink:href='#g' x='3' y='1'/>"), (Rings{moved}));
    EXPECT_EQ(rings_of_svg(defined + "<use href='#p'/><use href='#g' x='3' y='1'/>").size(), 2U);
    EXPECT_EQ(rings_of_svg("<clipPath><path d='M5 5h1v2z'/></clipPath><text>no</text>"
                           "<g display='none'><path d='M5 5h1v2z'/></g>"
                           "<path style='fill: red; display : none' d='M5 5h1v2z'/>"
                           "<path fill='none' stroke='red' d='M0 0h1v2z'/><circle r='0'/>"),
              (Rings{triangle}));
    EXPECT_EQ(rings_of("<s:svg xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 8 10' "
                       "fill-rule='evenodd'><s:path d='M0 0h1v2z'/></s:svg>"),
              (Rings{triangle}));
}

TEST(AnSvg, HidesWhatItsPropertiesHide) {
    const Rings shown{{{0, 10}, {1, 10}, {1, 8}}};
    const std::string path = "<path class='b' id='p' d='M0 0h1v2z'/>";
    const std::string other = "<path d='M5 5h1v2z'/>";
    for (const std::string_view hidden :
         {"visibility='hidden'", "style='visibility:collapse'", "style='display:none !important'",
          "opacity='0'", "style='fill:url(\"a;b\");DISPLAY : NONE'", "class='st0 x'", "id='layer'",
          "requiredExtensions='x'"}) {
        const std::string group = "<g " + std::string(hidden) + ">" + other + "</g>" + path;
        EXPECT_EQ(rings_of_svg("<style>/* {} */ .st0{display:none;} #layer , .y{visibility:hidden}"
                               "@font-face{src:url(a)} .z > g{stroke:red}</style>" +
                               group),
                  shown)
            << hidden;
    }
    // The more specific rule counts, and an attribute `style` over all but important ones.
    const auto is_shown = [&](const std::string& rules, const std::string& attributes) {
        try {
            rings_of_svg("<style><![CDATA[" + rules + "]]></style><path " + attributes +
                         " d='M0 0h1v2z'/>");
        } catch (const FileError&) {
            return false;
        }
        return true;
    };
    EXPECT_TRUE(is_shown(".a{display:none} #i{display:inline}", "class='a' id='i'"));
    EXPECT_TRUE(is_shown("path{display:inline}", "display='none'"));
    EXPECT_TRUE(is_shown("path.a{display:none}", "class='b'"));
    EXPECT_TRUE(is_shown(".a{display:none}", "class='a' style='display:inline'"));
    EXPECT_FALSE(is_shown(".a{display:none!important}", "class='a' style='display:inline'"));
    EXPECT_FALSE(is_shown("path.a{display:none}.a{display:inline}", "class='a'"));
    EXPECT_FALSE(is_shown("*{visibility:hidden}", ""));
    // What is visible in a hidden group is shown, but nothing in one that is not displayed. Of a
    // switch, the first that fits is shown.
    EXPECT_EQ(rings_of_svg("<g visibility='hidden'>" + other + "<g visibility='visible'>" + path +
                           "</g></g>"),
              shown);
    EXPECT_EQ(
        rings_of_svg("<g display='none'><path visibility='visible' d='M5 5h1v2z'/></g>" + path),
        shown);
    EXPECT_EQ(rings_of_svg("<switch><g requiredExtensions='x'/>" + path + other + "</switch>"),
              shown);
}

TEST(AnSvg, IsMovedByItsStyles) {
    const auto moved = [](const std::string& css) {
        return rings_of_svg("<style>.a{transform:" + css +
                            "}</style><path class='a' transform='scale(9)' d='M0 0h1v2z'/>")
            .at(0);
    };
    EXPECT_EQ(moved("translate(3px)"), (PolygonRing{{3, 10}, {4, 10}, {4, 8}}));
    EXPECT_EQ(moved("TranslateX(1px) translateY(2px) scale(2)"),
              (PolygonRing{{1, 8}, {3, 8}, {3, 4}}));
    EXPECT_EQ(moved("rotate(90deg)"), (PolygonRing{{0, 10}, {0, 9}, {-2, 9}}));
    EXPECT_EQ(moved("matrix(1, 0, 1, 1, 0, 0)"), (PolygonRing{{0, 10}, {1, 10}, {3, 8}}));
    EXPECT_EQ(moved("none"), (PolygonRing{{0, 10}, {1, 10}, {1, 8}}));
    EXPECT_EQ(rings_of_svg("<path style='transform: scalex(2)' d='M0 0h1v2z'/>").at(0),
              (PolygonRing{{0, 10}, {2, 10}, {2, 8}}));
}

// Nothing that changes where a shape is may be skipped.
TEST(AnSvg, IsRefusedWhereSomethingElseMovesOrCutsAShape) {
    const std::string path = "<path d='M0 0h1v2z'/>";
    const auto refused = [](const std::string& elements, std::string_view message) {
        EXPECT_EQ(refusal_of(svg(elements)), "file: " + std::string(message)) << elements;
    };
    const std::string why =
        " is not read, and changes where a shape is: cut or move the shape "
        "itself";
    for (const std::string property : {"clip-path", "mask", "filter", "transform-origin"})
        refused("<g id='a' " + property + "='url(#b)'>" + path + "</g>",
                "<g id=\"a\">: " + property + why);
    for (const std::string property : {"clip-path", "mask-image", "rotate", "offset-path", "all"})
        refused("<style>#a{" + property + ":x}</style><g id='a'>" + path + "</g>",
                "<g id=\"a\">: " + property + why);
    EXPECT_EQ(rings_of_svg("<g clip-path='url(#b)'><text>no shape</text></g>"
                           "<g clip-path='url(#b)' display='none'>" +
                           path + "</g>" + path)
                  .size(),
              1U);
    refused("<style id='s'>g path{display:none}</style>" + path,
            "<style id=\"s\">: the selector \"g path\" sets display: only elements, classes and "
            "ids are read, such as g, .hidden or #layer");
    refused("<style id='s'>@media print{.a{display:none}}</style>" + path,
            "<style id=\"s\">: \"@media print\": conditions of a style sheet are not read");
    refused("<style id='s'>@import url(a.css);</style>" + path,
            "<style id=\"s\">: \"@import url(a.css)\": other style sheets are not read");
    refused("<circle id='a' r='2' style='r:1px'/>",
            "<circle id=\"a\">: r \"1px\" of a style: must be an attribute");
    refused("<g id='a' style='transform:translate(1,2)'/>",
            "<g id=\"a\">: transform \"translate(1,2)\" of a style: must be matrix, translate, "
            "scale, rotate or skew with their numbers, lengths in px and angles in deg");
    refused("<g id='a' style='visibility:var(--v)'/>",
            "<g id=\"a\">: visibility \"var(--v)\": must be visible, hidden, collapse");
    refused("<path id='a' systemLanguage='de' d='M0 0h1v2z'/>",
            "<path id=\"a\">: systemLanguage: what depends on the reader's language is not read");
    EXPECT_EQ(refusal_of("<svg viewBox='0 0 1 1' transform='scale(2)'/>"),
              "file: byte 1: <svg>: transform \"scale(2)\" of the whole drawing: must stand in a "
              "group");
    EXPECT_EQ(refusal_of("<?xml-stylesheet href='a.css'?><svg viewBox='0 0 1 1'/>"),
              "file: <?xml-stylesheet?>: other files with styles are not read");
}

// A road that is drawn as a line has no inside.
TEST(AnSvg, IsRefusedWhereItHasLinesAndAnAreaIsWanted) {
    const std::string why =
        ": a line, which encloses nothing: it must be closed or filled, or be given to --avoid";
    for (const std::string line :
         {"<path id='a' fill='none' d='M0 0h1v2'/>", "<path id='a' class='n' d='M0 0h1'/>",
          "<polyline id='a' style='fill:none' points='0,0 1,0 1,2'/>",
          "<path id='a' fill='none' d='M0 0h1v2z M3 3h1v2'/>", "<line id='a' x2='1'/>"})
        EXPECT_EQ(refusal_of(svg("<style>.n{fill:none}</style><g>" + line + "</g>")),
                  "file: <" + line.substr(1, line.find(' ') - 1) + " id=\"a\">" + why);
    EXPECT_EQ(rings_of_svg("<g fill='none'><path d='M0 0h1v2z'/><path fill='red' d='M5 5h1v2'/>"
                           "</g>")
                  .size(),
              2U);
}

TEST(AnSvg, IsRefusedByElementAndValue) {
    const auto refused = [](std::string_view elements, std::string_view message) {
        EXPECT_EQ(refusal_of(svg(elements)), "file: " + std::string(message)) << elements;
    };
    refused(
        "<path id='a' d='L1 1'/>",
        R"(<path id="a">: M, which a path begins with is expected before "1 1", at character 1)");
    refused("<path id='a' d='M1 1 2 x'/>",
            R"(<path id="a">: a number is expected before "x", at character 7)");
    refused("<path id='a' d='M1 1 nan 1'/>", R"(<path id="a">: "n" is no command of a path)");
    refused("<path id='a' d='M1 1h1v1z5'/>",
            R"(<path id="a">: a command is expected before "5", at character 9)");
    refused("<path id='a' d='M1 1A1 1 0 2 0 4 4'/>",
            R"(<path id="a">: a number is expected before "2 0 4 4", at character 11)");
    refused("<path id='a' d='M1 1h1e99v1h1e99z M0 0h1e120'/>",
            R"(<path id="a">: reaches too far: coordinates must be finite numbers between -1e100 )"
            "and 1e100");
    refused("<polygon id='a' points='1 1 2'/>",
            R"(<polygon id="a">: a number is expected before the end among its points, at )"
            "character 5");
    refused("<circle id='a' r='-1'/>", R"(<circle id="a">: r is -1: must be at least 0)");
    refused("<rect id='a' width='50%' height='1'/>",
            R"(<rect id="a">: width is "50%": must be a number, of px, mm, cm, in, pt or pc)");
    refused(
        "<g id='a' transform='turn(3)'/>",
        "<g id=\"a\">: transform \"turn(3)\": must be matrix, translate, scale, rotate, skewX or "
        "skewY with their numbers");
    refused("<use id='a' href='b.svg#c'/>",
            R"(<use id="a">: uses "b.svg#c": must be # and the id of an element of this file)");
    refused("<g id='a'><use id='b' href='#a'/></g>",
            R"(<use id="b">: more than 200 elements within each other, or a use of itself)");
    refused("<svg id='a'/>",
            R"(<svg id="a">: is not read within another drawing: its outlines must stand in the )"
            "outer one, or in a group");
    refused("<path d='M1 1h'/>",
            "byte 80: <path>: a number is expected before the end, at character 5");
    refused("<path d='M1 1h1'/>",
            "no polygon: there must be at least one, of three points or more");
}

TEST(AnSvg, ThatIsBrokenIsRefused) {
    EXPECT_EQ(
        refusal_of(""),
        "file: byte 0: cannot be read as XML (No document element found); is the file whole?");
    EXPECT_EQ(refusal_of("<svg viewBox='0 0 1 1'><path"),
              "file: byte 27: cannot be read as XML (Error parsing start element tag); is the file "
              "whole?");
    EXPECT_EQ(refusal_of("<html/>"), "file: the outermost element is <\"html\">: must be <svg>");
}

TEST(AnSvg, ThatRepeatsItselfWithoutEndIsRefused) {
    std::string elements = "<circle id='u0' r='1'/>";
    for (int i = 1; i < 30; ++i) {
        const std::string last = std::to_string(i - 1);
        elements += "<g id='u" + std::to_string(i) + "'><use href='#u" + last + "'/><use href='#u" +
                    last + "'/></g>";
    }
    EXPECT_NE(refusal_of(svg(elements)).find("more than 20000000 points"), std::string::npos);
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<g>";
    for (int i = 0; i < 100'000; ++i) deep += "</g>";
    EXPECT_NE(refusal_of(svg(deep)).find("more than 200 elements within each other"),
              std::string::npos);
}

}  // namespace svg_test
