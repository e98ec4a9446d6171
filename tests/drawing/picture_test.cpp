// Pictures: dots where the points are, the domain's shape, the same bytes each time.
#include <cairo.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drawing/picture.h"
#include "files/point_files.h"
#include "files/sets.h"
#include "pdf_text.h"
#include "text.h"

namespace lacuna::files {
namespace {

using files::Medium;
using tests::contains;
using tests::occurrences;

// A decoded PNG.
class Image {
public:
    explicit Image(std::string bytes)
        : bytes_(std::move(bytes)),
          surface_(cairo_image_surface_create_from_png_stream(read, this), cairo_surface_destroy) {
        EXPECT_EQ(cairo_surface_status(surface_.get()), CAIRO_STATUS_SUCCESS);
    }
    int width() const { return cairo_image_surface_get_width(surface_.get()); }
    int height() const { return cairo_image_surface_get_height(surface_.get()); }
    // 0 is black, 255 is white; row 0 is the top one.
    int grey(int column, int row) const {
        const std::uint32_t pixel = colour(column, row);
        EXPECT_EQ((pixel >> 16U) & 0xffU, pixel & 0xffU) << "not grey";
        return static_cast<int>(pixel & 0xffU);
    }
    // Red, green and blue, 0xrrggbb.
    std::uint32_t colour(int column, int row) const {
        const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface_.get());
        const unsigned char* line = cairo_image_surface_get_data(surface_.get()) + row * stride;
        std::uint32_t pixel = 0;
        std::memcpy(&pixel, line + std::ptrdiff_t{4} * column, sizeof pixel);
        return pixel & 0xffffffU;
    }

private:
    static cairo_status_t read(void* closure, unsigned char* data, unsigned int length) {
        auto& image = *static_cast<Image*>(closure);
        if (image.bytes_.size() - image.read_ < length) return CAIRO_STATUS_READ_ERROR;
        std::memcpy(data, image.bytes_.data() + image.read_, length);
        image.read_ += length;
        return CAIRO_STATUS_SUCCESS;
    }

    std::string bytes_;
    std::size_t read_ = 0;
    std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface_;
};

std::string picture(const std::vector<Point>& points, Medium medium, double radius = 0.1,
                    double width = 1, double height = 1) {
    return drawing::draw({points, {width, height}, radius}, medium);
}

// How many pixels are darker than half.
int dark_pixels(const Image& image) {
    int count = 0;
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column)
            if (image.grey(column, row) < 128) ++count;
    return count;
}

TEST(Png, GivenOnePointLowOnTheLeftThenThereIsADotAndWhiteElsewhere) {
    const Image image(picture({{0.25, 0.125}}, Medium::png));
    ASSERT_EQ(image.width(), 1024);
    ASSERT_EQ(image.height(), 1024);
    EXPECT_EQ(image.grey(256, 1024 - 128), 0);
    EXPECT_EQ(image.grey(256, 128), 255) << "upside down";
    EXPECT_EQ(image.grey(1024 - 128, 256), 255) << "x and y swapped";
    EXPECT_EQ(image.grey(0, 0), 255);
    EXPECT_EQ(image.grey(1023, 1023), 255);
}

TEST(Png, GivenARadiusThenADotsRadiusIsAThirdOfIt) {
    const Image image(picture({{0.5, 0.5}}, Medium::png, 0.3));
    const double dot_radius = 0.1 * 1024;
    EXPECT_EQ(image.grey(512 + 100, 512), 0);
    EXPECT_EQ(image.grey(512 + 105, 512), 255);
    EXPECT_EQ(image.grey(512, 512 - 100), 0);
    EXPECT_EQ(image.grey(512, 512 - 105), 255);
    EXPECT_NEAR(dark_pixels(image), 3.14159 * dot_radius * dot_radius, 200);
}

// The picture of one dot whose disk would have a radius of 0.1, in an ellipse of ratio 4.
std::string stretched_dot(Medium medium, double angle) {
    const std::vector<Point> points{{0.5, 0.5}};
    const std::vector<Ellipse> ellipses{{0.6, 0.15, angle}};
    PointSet set{points, {1, 1}, 0.3};
    set.ellipses = ellipses;
    return drawing::draw(set, medium);
}

TEST(Png, GivenAnEllipseThenTheDotIsStretchedTurnedAndAsLargeAsADisk) {
    const Image flat(stretched_dot(Medium::png, 0));
    EXPECT_EQ(flat.grey(512 + 200, 512), 0);
    EXPECT_EQ(flat.grey(512 + 209, 512), 255);
    EXPECT_EQ(flat.grey(512, 512 - 48), 0);
    EXPECT_EQ(flat.grey(512, 512 - 55), 255);
    EXPECT_NEAR(dark_pixels(flat), 3.14159 * 102.4 * 102.4, 200);
    // Counterclockwise by 30 degrees: its end is to the right and above.
    const Image turned(stretched_dot(Medium::png, 3.14159 / 6));
    EXPECT_EQ(turned.grey(512 + 173, 512 - 100), 0);
    EXPECT_EQ(turned.grey(512 + 173, 512 + 100), 255);
}

TEST(Svg, GivenAnEllipseThenTheDotIsTwoArcsFromEndToEnd) {
    const std::string svg = stretched_dot(Medium::svg, 3.14159265358979 / 2);
    EXPECT_TRUE(
        contains(svg,
                 "<path fill=\"black\" stroke=\"none\" d=\"M256.0000 358.4000"
                 "a102.4 25.6 -90 1 0 0.0000 -204.8000a102.4 25.6 -90 1 0 -0.0000 204.8000"))
        << svg;
    EXPECT_FALSE(contains(svg, "stroke-width"));
}

TEST(Pdf, GivenAnEllipseThenItIsAnotherFileThanThatOfADisk) {
    EXPECT_NE(stretched_dot(Medium::pdf, 0), stretched_dot(Medium::pdf, 1));
}

TEST(Png, GivenMoreDotsThanOneStrokeHoldsThenEachIsDrawn) {
    const std::vector<Point> points = spread_points(10000);
    const Image image(picture(points, Medium::png, 0.008));
    for (const Point& point : points) {
        const int column = std::min(static_cast<int>(point.x * 1024), 1023);
        const int row = std::min(static_cast<int>((1 - point.y) * 1024), 1023);
        ASSERT_LT(image.grey(column, row), 128) << "at " << point.x << " " << point.y;
    }
}

TEST(Png, GivenNoPointsThenAllIsWhite) {
    const Image image(picture({}, Medium::png));
    for (int row = 0; row < image.height(); ++row)
        for (int column = 0; column < image.width(); ++column)
            ASSERT_EQ(image.grey(column, row), 255) << column << " " << row;
}

TEST(Png, GivenNoRadiusThenTheDotsAreSeenAndApart) {
    const Image image(picture({{0.25, 0.25}, {0.75, 0.75}}, Medium::png, 0));
    EXPECT_EQ(image.grey(256, 768), 0);
    EXPECT_EQ(image.grey(768, 256), 0);
    EXPECT_EQ(image.grey(512, 512), 255);
}

TEST(Png, GivenADomainOf3By1ThenThePictureIsThreeTimesAsWideAsHigh) {
    const Image image(picture({{2.25, 0.5}}, Medium::png, 0.2, 3, 1));
    EXPECT_EQ(image.width(), 1024);
    EXPECT_EQ(image.height(), 341);
    EXPECT_EQ(image.grey(768, 170), 0);
    EXPECT_EQ(image.grey(256, 170), 255);
}

TEST(Png, GivenADomainThinnerThanAPixelThenThePictureIsOnePixelWide) {
    const Image image(picture({{0.5, 5000}}, Medium::png, 2000, 1, 10000));
    EXPECT_EQ(image.width(), 1);
    EXPECT_EQ(image.height(), 1024);
}

TEST(Svg, GivenPointsThenEachIsADotWithYUpwards) {
    const std::string svg = picture({{0.25, 0.125}, {0.5, 0.5}}, Medium::svg, 0.3);
    EXPECT_TRUE(svg.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "));
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
    EXPECT_TRUE(contains(svg, "M128.0000 448.0000h0.01\n")) << svg;
    EXPECT_TRUE(contains(svg, "M256.0000 256.0000h0.01\n")) << svg;
    EXPECT_TRUE(contains(svg, "stroke-width=\"102.4\"")) << svg;
}

TEST(Svg, GivenADomainOf3By1ThenThePictureIsThreeTimesAsWideAsHigh) {
    const std::string svg = picture({{2.25, 0.5}}, Medium::svg, 0.2, 3, 1);
    EXPECT_TRUE(contains(svg, "viewBox=\"0 0 512 170.666667\"")) << svg;
}

TEST(Svg, GivenManyPointsThenNoneIsLeftOutAndTheFileStaysSmall) {
    const std::string svg = picture(spread_points(10000), Medium::svg, 0.008);
    EXPECT_EQ(occurrences(svg, "h0.01\n"), 10000U);
    EXPECT_LT(svg.size(), 10000U * 27);
}

TEST(Svg, GivenATinyDotThenItsLineIsShorterThanItIsWide) {
    const std::string svg = picture({{0.5, 0.5}}, Medium::svg, 3.0 / 512 * 0.01);  // 0.02 pt wide
    EXPECT_TRUE(contains(svg, "M256.0000 256.0000h0.002\n")) << svg;
}

TEST(Svg, GivenAPenThenThereIsNoBackgroundThatAPlotterWouldDraw) {
    drawing::Style style;
    EXPECT_TRUE(contains(drawing::draw({{}, {1, 1}, 0.1}, Medium::svg, style), "<rect"));
    style.for_a_pen = true;
    EXPECT_FALSE(contains(drawing::draw({{}, {1, 1}, 0.1}, Medium::svg, style), "<rect"));
}

// The content of the chunk pHYs, which must stand before the first IDAT: pixels a metre, across and
// down, and the unit.
std::string resolution_of(const std::string& png) {
    const std::size_t at = png.find("pHYs");
    EXPECT_LT(at, png.find("IDAT"));
    return png.substr(at + 4, 9);
}

TEST(Png, GivenItsResolutionThenTheFileTellsIt) {
    using namespace std::string_literals;
    // 144 and 300 pixels an inch are 5,669 and 11,811 a metre.
    EXPECT_EQ(resolution_of(picture({}, Medium::png)), "\0\0\x16\x25\0\0\x16\x25\1"s);
    drawing::Style style;
    style.pixels_per_inch = 300;
    EXPECT_EQ(resolution_of(drawing::draw({{}, {1, 1}, 0.1}, Medium::png, style)),
              "\0\0\x2e\x23\0\0\x2e\x23\1"s);
}

TEST(Pdf, GivenADomainOf3By1ThenThePageIsThreeTimesAsWideAsHigh) {
    const std::string pdf = tests::pdf_text(picture({{2.25, 0.5}}, Medium::pdf, 0.2, 3, 1));
    EXPECT_TRUE(pdf.starts_with("%PDF-1."));
    EXPECT_TRUE(contains(pdf, "/MediaBox [ 0 0 512 170.66")) << pdf;
    EXPECT_TRUE(contains(pdf, "%%EOF"));
}

TEST(Pdf, GivenADateOfCreationThenItIsNotTheTimeOfDay) {
    const std::string pdf = tests::pdf_text(picture({{0.5, 0.5}}, Medium::pdf));
    EXPECT_TRUE(contains(pdf, "/CreationDate (20000101000000Z)")) << pdf;
    EXPECT_FALSE(contains(pdf, "/ModDate"));
}

TEST(Pdf, GivenManyPointsThenTheFileStaysSmall) {
    const std::string pdf = picture(spread_points(10000), Medium::pdf, 0.008);
    EXPECT_LT(pdf.size(), 10000U * 80);
}

// On a sheet of 100 mm x 80 mm with margins of 10 mm a domain of 2 x 1 is 80 mm x 40 mm large, and
// begins 10 mm from the left and 20 mm from the top.
std::string on_a_sheet(const std::vector<Point>& points, Medium medium,
                       const std::vector<double>& diameters = {}) {
    drawing::Style style;
    style.sheet = Paper{100, 80, 10};
    style.pixels_per_inch = 254;
    style.diameters = diameters;
    return drawing::draw({points, {2, 1}, 0.3}, medium, style);
}

TEST(ASheet, GivenSvgThenLengthsAreMillimetresAndTheDomainIsInTheMiddle) {
    const std::string svg = on_a_sheet({{0, 0}, {2, 1}, {0.5, 0.25}}, Medium::svg);
    EXPECT_TRUE(contains(svg, "width=\"100mm\" height=\"80mm\" viewBox=\"0 0 100 80\"")) << svg;
    EXPECT_TRUE(contains(svg, "M10.0000 60.0000h0.01\n")) << svg;
    EXPECT_TRUE(contains(svg, "M90.0000 20.0000h0.01\n")) << svg;
    EXPECT_TRUE(contains(svg, "M30.0000 50.0000h0.01\n")) << svg;
    EXPECT_TRUE(contains(svg, "stroke-width=\"8\"")) << svg;
    EXPECT_FALSE(contains(svg, "<rect")) << "a plotter would drawing::draw it";
}

TEST(ASheet, GivenPdfThenThePageIsAsLargeInPoints) {
    const std::string pdf = tests::pdf_text(on_a_sheet({{0, 0}}, Medium::pdf));
    EXPECT_TRUE(contains(pdf, "/MediaBox [ 0 0 283.46")) << pdf;
    EXPECT_TRUE(contains(pdf, " 226.77")) << pdf;
}

TEST(ASheet, GivenPngThenItHasAsManyPixelsAsTheResolutionSays) {
    const Image image(on_a_sheet({{0.5, 0.25}}, Medium::png));
    ASSERT_EQ(image.width(), 1000);
    ASSERT_EQ(image.height(), 800);
    EXPECT_EQ(image.grey(300, 500), 0);
    EXPECT_EQ(image.grey(300 + 38, 500), 0);
    EXPECT_EQ(image.grey(300 + 42, 500), 255);
    EXPECT_NEAR(dark_pixels(image), 3.14159 * 40 * 40, 100);
}

TEST(ASheet, GivenATallDomainThenTheHeightDecidesItsSize) {
    drawing::Style style;
    style.sheet = Paper{100, 80, 10};
    EXPECT_DOUBLE_EQ(drawing::millimetres_per_unit({{}, {2, 1}}, style), 40);
    EXPECT_DOUBLE_EQ(drawing::millimetres_per_unit({{}, {1, 4}}, style), 15);
}

TEST(Diameters, GivenPngThenEachDotHasItsOwn) {
    const Image image(on_a_sheet({{0.5, 0.5}, {1.5, 0.5}}, Medium::png, {0.1, 0.3}));
    EXPECT_EQ(image.grey(300 + 18, 400), 0);
    EXPECT_EQ(image.grey(300 + 22, 400), 255);
    EXPECT_EQ(image.grey(700 + 58, 400), 0);
    EXPECT_EQ(image.grey(700 + 62, 400), 255);
    EXPECT_NEAR(dark_pixels(image), 3.14159 * (20 * 20 + 60 * 60), 150);
}

TEST(Diameters, GivenSvgThenDotsOfASizeAreOnePathUnlessTheirOrderIsKept) {
    const std::vector<Point> points{{0, 0}, {1, 0}, {2, 0}, {0, 1}};
    const std::vector<double> diameters{0.2, 0.1, 0.2, 0.1};
    drawing::Style style;
    style.sheet = Paper{20, 10};
    style.diameters = diameters;
    const std::string sizes = drawing::draw({points, {2, 1}}, Medium::svg, style);
    EXPECT_TRUE(contains(sizes,
                         "<path stroke-width=\"1\" d=\"M10.0000 10.0000h0.01\nM0.0000 "
                         "0.0000h0.01\n\"/>\n<path stroke-width=\"2\" d=\"M0.0000 "
                         "10.0000h0.01\nM20.0000 10.0000h0.01\n\"/>"))
        << sizes;
    style.for_a_pen = true;
    const std::string ordered = drawing::draw({points, {2, 1}}, Medium::svg, style);
    EXPECT_EQ(occurrences(ordered, "<path"), 4U);
    EXPECT_LT(ordered.find("M0.0000 10.0000"), ordered.find("M10.0000 10.0000"));
    EXPECT_LT(ordered.find("M10.0000 10.0000"), ordered.find("M20.0000 10.0000"));
    EXPECT_LT(ordered.find("M20.0000 10.0000"), ordered.find("M0.0000 0.0000"));
}

// A yellow dot, a cyan one that overlaps it to the right, and a second cyan one on the first.
struct TwoInks {
    std::vector<Point> points{{0.4, 0.5}, {0.6, 0.5}, {0.6, 0.5}};
    std::vector<Layer> layers{{{"yellow", {255, 255, 0}}, 1}, {{"sea", {0, 255, 255}}, 2}};
    std::vector<double> diameters{0.3, 0.3, 0.2};

    std::string draw(Medium medium) const {
        PointSet set{points};
        set.layers = layers;
        drawing::Style style;
        style.diameters = diameters;
        return drawing::draw(set, medium, style);
    }
};

TEST(Layers, GivenPngThenInksAreMultipliedAndDotsOfOneInkAreNot) {
    const Image image(TwoInks().draw(Medium::png));
    const int middle = image.width() / 2;
    const auto at = [&](double x) {
        return image.colour(static_cast<int>(x * image.width()), middle);
    };
    EXPECT_EQ(at(0.1), 0xffffffU);
    EXPECT_EQ(at(0.3), 0xffff00U);
    EXPECT_EQ(at(0.5), 0x00ff00U);
    EXPECT_EQ(at(0.6), 0x00ffffU) << "two dots of one ink are no darker than one";
}

TEST(Layers, GivenSvgThenEachInkIsALayerOfInkscapesWithItsNumberAndName) {
    const std::string svg = TwoInks().draw(Medium::svg);
    EXPECT_EQ(occurrences(svg, "inkscape:groupmode=\"layer\""), 2U);
    const std::size_t first = svg.find("inkscape:label=\"1 yellow\"");
    const std::size_t second = svg.find("inkscape:label=\"2 sea\"");
    ASSERT_LT(first, second);
    ASSERT_LT(second, svg.size());
    EXPECT_EQ(occurrences(svg.substr(first, second - first), "M"), 1U);
    EXPECT_EQ(occurrences(svg.substr(second), "M"), 2U);
    EXPECT_TRUE(contains(svg, "stroke=\"#00ffff\""));
    EXPECT_EQ(occurrences(svg, "mix-blend-mode:multiply"), 2U);
}

TEST(Layers, GivenPdfThenBothInksAreThere) {
    const std::string pdf = TwoInks().draw(Medium::pdf);
    EXPECT_EQ(pdf, TwoInks().draw(Medium::pdf));
    EXPECT_TRUE(contains(pdf, "/BM /Multiply") || contains(pdf, "/BM/Multiply"));
}

class Picture : public testing::TestWithParam<Medium> {};

TEST_P(Picture, WhenDrawnTwiceThenTheBytesAreEqual) {
    const std::vector<Point> points = spread_points(5000);
    EXPECT_EQ(picture(points, GetParam()), picture(points, GetParam()));
}

TEST_P(Picture, WhenAPointMovesThenTheBytesDiffer) {
    EXPECT_NE(picture({{0.5, 0.5}}, GetParam()), picture({{0.5, 0.25}}, GetParam()));
}

TEST_P(Picture, WhenThereIsNoPointThenItIsNotThePictureOfOne) {
    EXPECT_FALSE(picture({}, GetParam()).empty());
    EXPECT_NE(picture({}, GetParam()), picture({{0.5, 0.5}}, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Formats, Picture, testing::Values(Medium::svg, Medium::pdf, Medium::png),
                         [](const testing::TestParamInfo<Medium>& medium) {
                             return medium.param == Medium::svg   ? "Svg"
                                    : medium.param == Medium::pdf ? "Pdf"
                                                                  : "Png";
                         });

}  // namespace
}  // namespace lacuna::files
