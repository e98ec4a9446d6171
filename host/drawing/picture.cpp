// Pictures of point sets: pdf and png drawn by cairo, svg written here.
#include "drawing/picture.h"

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <string>

#include "drawing/cairo_surface.h"
#include "drawing/page.h"
#include "drawing/png.h"
#include "drawing/xml.h"

namespace lacuna::drawing {
namespace {

// A white page, and black to draw with.
Context make_context(cairo_surface_t* surface) {
    Context context(cairo_create(surface));
    check(cairo_status(context.get()));
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    cairo_set_source_rgb(context.get(), 0, 0, 0);
    return context;
}

std::string seed_text(const files::Origin& origin) {
    return fmt::format("seed {}", origin.seed);
}

std::string program_text(const files::Origin& origin) {
    return fmt::format("Lacuna {}", origin.version);
}

// In Dublin Core, which Inkscape and others show.
std::string svg_metadata(const files::Origin& origin) {
    return fmt::format(
        "<metadata>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
        "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<rdf:Description rdf:about=\"\">"
        "<dc:creator>{}</dc:creator><dc:source>{}</dc:source><dc:description>{}</dc:description>"
        "</rdf:Description>\n</rdf:RDF>\n</metadata>\n",
        program_text(origin), in_xml(origin.command), seed_text(origin));
}

std::string svg_head(const files::PointSet& set, const Page& page, bool is_sheet,
                     bool has_background) {
    std::string head = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.9g}{2}\" height=\"{1:.9g}{2}\" "
        "viewBox=\"0 0 {0:.9g} {1:.9g}\">\n",
        page.width, page.height, is_sheet ? "mm" : "pt");
    if (set.origin != nullptr) head += svg_metadata(*set.origin);
    if (has_background)
        head += fmt::format("<rect width=\"{:.9g}\" height=\"{:.9g}\" fill=\"white\"/>\n",
                            page.width, page.height);
    return head + "<g fill=\"none\" stroke=\"black\" stroke-linecap=\"round\">\n";
}

// Not by cairo: its SVG numbers the surfaces of the whole process, so that a second call gives
// other bytes, and it is twice as long. Dots are lines with round caps: a tenth of the bytes of
// circles.
std::string draw_svg(const files::PointSet& set, const Style& style) {
    // Programs for plotters drop lines of no length. A line so long, in mm or pt, and no longer
    // than this share of the diameter, looks as round as a point.
    constexpr double kLongestLine = 0.01, kLargestShare = 0.1;
    const bool is_sheet = style.sheet.has_value();
    const Page page = page_of(set, style, is_sheet ? kMillimetresPerInch / kPointsPerInch : 1);
    std::string bytes = svg_head(set, page, is_sheet, !is_sheet && !style.for_a_pen);
    for_each_stroke(set, style, [&](std::span<const Point> dots, double diameter) {
        const double width = diameter * page.scale;
        const std::string line =
            fmt::format("h{:.3g}", std::min(kLongestLine, kLargestShare * width));
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("<path stroke-width=\"{:.6g}\" d=\""),
                       width);
        for (const Point& point : dots)
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("M{:.4f} {:.4f}{}\n"),
                           page.x_of(point), page.y_of(point), line);
        bytes += "\"/>\n";
    });
    return bytes + "</g>\n</svg>\n";
}

// Circles, as some viewers draw lines of no length as ovals.
void fill_circles(cairo_t* context, const files::PointSet& set, const Style& style,
                  const Page& page) {
    // Of the radius. Cairo then makes every circle of four curves; a small one would have two.
    constexpr double kTolerance = 1e-3;
    for_each_stroke(set, style, [&](std::span<const Point> dots, double diameter) {
        const double radius = diameter * page.scale / 2;
        cairo_set_tolerance(context, kTolerance * radius);
        for (const Point& point : dots) {
            cairo_new_sub_path(context);
            cairo_arc(context, page.x_of(point), page.y_of(point), radius, 0, 2 * std::numbers::pi);
        }
        cairo_fill(context);
        check(cairo_status(context));
    });
}

std::string draw_pdf(const files::PointSet& set, const Style& style) {
    const Page page = page_of(set, style, 1);
    std::string bytes;
    const Surface surface = checked(
        cairo_pdf_surface_create_for_stream(append_to_string, &bytes, page.width, page.height));
    // Cairo would write the time of day, and no two files would be equal.
    cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "2000-01-01T00:00:00Z");
    if (set.origin != nullptr) {
        const auto tell = [&](cairo_pdf_metadata_t what, const std::string& text) {
            cairo_pdf_surface_set_metadata(surface.get(), what, in_utf8(text).c_str());
        };
        tell(CAIRO_PDF_METADATA_CREATOR, program_text(*set.origin));
        tell(CAIRO_PDF_METADATA_SUBJECT, set.origin->command);
        tell(CAIRO_PDF_METADATA_KEYWORDS, seed_text(*set.origin));
    }
    fill_circles(make_context(surface.get()).get(), set, style, page);
    // Cairo writes most of the document only now.
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
}

// Lines of no length with round caps, which cairo draws faster than circles.
void stroke_dots(cairo_t* context, const files::PointSet& set, const Style& style,
                 const Page& page) {
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    for_each_stroke(set, style, [&](std::span<const Point> dots, double diameter) {
        cairo_set_line_width(context, diameter * page.scale);
        for (const Point& point : dots) {
            cairo_move_to(context, page.x_of(point), page.y_of(point));
            cairo_line_to(context, page.x_of(point), page.y_of(point));
        }
        cairo_stroke(context);
        check(cairo_status(context));
    });
}

std::string draw_png(const files::PointSet& set, const Style& style) {
    const Page page = page_of(set, style, style.pixels_per_inch / kPointsPerInch);
    const auto pixels = [](double side) {
        return std::max(1, static_cast<int>(std::lround(side)));
    };
    // A surface of alpha alone becomes a grey PNG, a third of the size: opaque is white, and to
    // clear is to draw black.
    const Surface surface = checked(
        cairo_image_surface_create(CAIRO_FORMAT_A8, pixels(page.width), pixels(page.height)));
    const Context context = make_context(surface.get());
    cairo_set_operator(context.get(), CAIRO_OPERATOR_CLEAR);
    stroke_dots(context.get(), set, style, page);
    return png_of(surface.get(), style.pixels_per_inch);
}

}  // namespace

std::string draw(const files::PointSet& set, Medium medium, const Style& style) {
    if (medium == Medium::svg) return draw_svg(set, style);
    if (medium == Medium::pdf) return draw_pdf(set, style);
    return draw_png(set, style);
}

}  // namespace lacuna::drawing
