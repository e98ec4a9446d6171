// Pictures of point sets: pdf and png drawn by cairo, svg written here.
#include "files/picture.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>

#include "files/cairo_surface.h"

namespace lacuna::files {
namespace {

constexpr double kLongerSideInPixels = 1024;
constexpr double kLongerSideInPoints = 512;
// In one stroke: keeps the working memory of cairo, and of viewers, small.
constexpr std::size_t kDotsPerStroke = 4096;

// The picture's sides, and the domain's units turned into the picture's, y upwards.
struct Page {
    double width;
    double height;
    double scale;
    double x_of(Point point) const { return point.x * scale; }
    double y_of(Point point) const { return height - point.y * scale; }
};

Page page_of(const PointSet& set, double longer_side) {
    const double longer = std::max(set.width, set.height);
    return {longer_side * (set.width / longer), longer_side * (set.height / longer),
            longer_side / longer};
}

double dot_radius(const PointSet& set) {
    if (set.radius > 0) return set.radius / 3;
    // The radius is not known: dots as large as those of a maximal set of as many points.
    constexpr double kMaximalCountTimesSquaredRadius = 0.69656;
    const auto count = static_cast<double>(std::max<std::size_t>(set.points.size(), 1));
    const double radius =
        std::sqrt(kMaximalCountTimesSquaredRadius * set.width * (set.height / count));
    return std::min({radius, set.width, set.height}) / 3;
}

// Calls `stroke` for the points, in order, a stroke's worth at a time.
template <class Stroke>
void for_each_stroke(std::span<const Point> points, const Stroke& stroke) {
    for (std::size_t begin = 0; begin < points.size(); begin += kDotsPerStroke)
        stroke(points.subspan(begin, std::min(kDotsPerStroke, points.size() - begin)));
}

// Dots are lines of no length with round caps: a tenth of the bytes of circles.
void draw_on(cairo_surface_t* surface, const PointSet& set, const Page& page,
             cairo_operator_t ink) {
    const Context context(cairo_create(surface));
    check(cairo_status(context.get()));
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());

    cairo_set_operator(context.get(), ink);
    cairo_set_source_rgb(context.get(), 0, 0, 0);
    cairo_set_line_cap(context.get(), CAIRO_LINE_CAP_ROUND);
    cairo_set_line_width(context.get(), 2 * dot_radius(set) * page.scale);
    for_each_stroke(set.points, [&](std::span<const Point> dots) {
        for (const Point& point : dots) {
            cairo_move_to(context.get(), page.x_of(point), page.y_of(point));
            cairo_line_to(context.get(), page.x_of(point), page.y_of(point));
        }
        cairo_stroke(context.get());
        check(cairo_status(context.get()));
    });
}

// Not by cairo: its SVG numbers the surfaces of the whole process, so that a second call gives
// other bytes, and it is twice as long.
std::string draw_svg(const PointSet& set) {
    const Page page = page_of(set, kLongerSideInPoints);
    std::string bytes = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.9g}pt\" height=\"{1:.9g}pt\" "
        "viewBox=\"0 0 {0:.9g} {1:.9g}\">\n"
        "<rect width=\"{0:.9g}\" height=\"{1:.9g}\" fill=\"white\"/>\n"
        "<g fill=\"none\" stroke=\"black\" stroke-linecap=\"round\" stroke-width=\"{2:.9g}\">\n",
        page.width, page.height, 2 * dot_radius(set) * page.scale);
    for_each_stroke(set.points, [&](std::span<const Point> dots) {
        bytes += "<path d=\"";
        for (const Point& point : dots)
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("M{:.4f} {:.4f}h0\n"),
                           page.x_of(point), page.y_of(point));
        bytes += "\"/>\n";
    });
    return bytes + "</g>\n</svg>\n";
}

std::string draw_pdf(const PointSet& set) {
    const Page page = page_of(set, kLongerSideInPoints);
    std::string bytes;
    const Surface surface = checked(
        cairo_pdf_surface_create_for_stream(append_to_string, &bytes, page.width, page.height));
    // Cairo would write the time of day, and no two files would be equal.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
    draw_on(surface.get(), set, page, CAIRO_OPERATOR_OVER);
    // Cairo writes most of the document only now.
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
}

std::string draw_png(const PointSet& set) {
    const Page page = page_of(set, kLongerSideInPixels);
    const auto pixels = [](double side) {
        return std::max(1, static_cast<int>(std::lround(side)));
    };
    std::string bytes;
    // A surface of alpha alone becomes a grey PNG, a third of the size: opaque is white, and to
    // clear is to draw black.
    const Surface surface = checked(
        cairo_image_surface_create(CAIRO_FORMAT_A8, pixels(page.width), pixels(page.height)));
    draw_on(surface.get(), set, page, CAIRO_OPERATOR_CLEAR);
    check(cairo_surface_write_to_png_stream(surface.get(), append_to_string, &bytes));
    return bytes;
}

}  // namespace

std::string draw(const PointSet& set, Format format) {
    if (format == Format::svg) return draw_svg(set);
    if (format == Format::pdf) return draw_pdf(set);
    return draw_png(set);
}

}  // namespace lacuna::files
