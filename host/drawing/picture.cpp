// Point sets as pdf and png, drawn by cairo, and the choice of the format.
#include "drawing/picture.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "base/polling.h"
#include "drawing/cairo_surface.h"
#include "drawing/page.h"
#include "drawing/picture_svg.h"
#include "drawing/png.h"
#include "drawing/xml.h"

namespace lacuna::drawing {
namespace {

// Gives the page the paper's colour and sets black as the colour to draw with.
Context make_context(cairo_surface_t* surface, const Style& style) {
    Context context(cairo_create(surface));
    check(cairo_status(context.get()));
    set_colour(context.get(), style.paper_colour);
    cairo_paint(context.get());
    cairo_set_source_rgb(context.get(), 0, 0, 0);
    return context;
}

void stroke_line(cairo_t* context, std::span<const Point> points, double width, const Page& page) {
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(context, width);
    // In pieces that overlap by a point, so that a long line can be cancelled.
    for (std::size_t begin = 0; begin < points.size(); begin += kDotsPerStroke) {
        const auto piece =
            points.subspan(begin, std::min(kDotsPerStroke + 1, points.size() - begin));
        ask_after(64 * piece.size());
        cairo_move_to(context, page.x_of(piece.front()), page.y_of(piece.front()));
        for (const Point& point : piece) cairo_line_to(context, page.x_of(point), page.y_of(point));
        cairo_stroke(context);
        check(cairo_status(context));
    }
}

// Calls draw(dots, style) for each layer, or draws its line. Each is drawn on its own, in its
// colour. Transparent inks multiply the colours on the page, and opaque ones cover them.
template <class Draw>
void draw_layers(cairo_t* context, const files::PointSet& set, const Style& style, const Page& page,
                 const Draw& draw_dots) {
    const auto draw = [&](std::size_t layer, const files::PointSet& part, const Style& its_style) {
        if (style.line_width == 0) return draw_dots(part, its_style);
        stroke_line(context, part.points, line_width_of(set, layer, style, page), page);
    };
    if (set.layers.empty()) return draw(0, set, style);
    for_each_layer(set, style, [&](std::size_t layer, const auto& part, const Style& its_style) {
        const Ink& ink = set.layers[layer].ink;
        cairo_push_group(context);
        set_colour(context, ink.colour);
        draw(layer, part, its_style);
        cairo_pop_group_to_source(context);
        if (!ink.is_opaque_on(style.paper_colour))
            cairo_set_operator(context, CAIRO_OPERATOR_MULTIPLY);
        cairo_paint(context);
        cairo_set_operator(context, CAIRO_OPERATOR_OVER);
        check(cairo_status(context));
    });
}

// Dots are circles here, because some viewers draw lines of length 0 as ovals.
void fill_circles(cairo_t* context, const files::PointSet& set, const Style& style,
                  const Page& page) {
    // In radii. With this tolerance cairo makes every circle of four curves, small circles too.
    constexpr double kTolerance = 1e-3;
    for_each_stroke(set, style, [&](std::span<const Point> dots, double diameter) {
        const double radius = diameter * page.scale / 2;
        ask_after(64 * dots.size());
        cairo_set_tolerance(context, kTolerance * radius);
        for (const Point& point : dots) {
            cairo_new_sub_path(context);
            cairo_arc(context, page.x_of(point), page.y_of(point), radius, 0, 2 * std::numbers::pi);
        }
        cairo_fill(context);
        check(cairo_status(context));
    });
}

void stroke_pen(cairo_t* context, const files::PointSet& set, const Page& page) {
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    std::size_t dots = 0;
    for_each_pen_stroke(set, page, [&](const PenStroke& stroke) {
        ask_after(64);
        cairo_set_line_width(context, stroke.width);
        cairo_move_to(context, stroke.x, stroke.y);
        cairo_rel_line_to(context, stroke.way_x, stroke.way_y);
        if (++dots % kDotsPerStroke == 0) cairo_stroke(context);
    });
    cairo_stroke(context);
    check(cairo_status(context));
}

void stroke_pen_dots(cairo_t* context, const files::PointSet& set, const Style& style,
                     const Page& page) {
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    for_each_pen_dot(set, style, page, [&](double x, double y, const PenDot& dot, double width) {
        ask_after(64 * (1 + static_cast<std::size_t>(dot.halves)));
        cairo_set_line_width(context, width);
        cairo_move_to(context, x + dot.begin(), y);
        cairo_line_to(context, x + dot.begin(), y);
        dot.for_each_half([&](double middle, double radius, bool is_above) {
            cairo_arc_negative(context, x + middle, y, radius, is_above ? 0 : std::numbers::pi,
                               is_above ? -std::numbers::pi : 0);
        });
        cairo_stroke(context);
    });
    check(cairo_status(context));
}

void fill_ovals(cairo_t* context, const files::PointSet& set, const Style& style,
                const Page& page) {
    std::size_t dots = 0;
    for_each_oval(set, style, page, [&](const Oval& oval) {
        ask_after(64);
        cairo_save(context);
        cairo_translate(context, oval.x, oval.y);
        cairo_rotate(context, -oval.turn);
        cairo_scale(context, oval.a, oval.b);
        cairo_new_sub_path(context);
        cairo_arc(context, 0, 0, 1, 0, 2 * std::numbers::pi);
        cairo_restore(context);
        if (++dots % kDotsPerStroke == 0) cairo_fill(context);
    });
    cairo_fill(context);
    check(cairo_status(context));
}

std::string draw_pdf(const files::PointSet& set, const Style& style) {
    const Page page = page_of(set, style, 1);
    std::string bytes;
    const Surface surface = checked(
        cairo_pdf_surface_create_for_stream(append_to_string, &bytes, page.width, page.height));
    // Otherwise cairo would write the time of day, and two files would never be equal.
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
    {
        const Context context = make_context(surface.get(), style);
        draw_layers(context.get(), set, style, page, [&](const auto& part, const Style& its_style) {
            if (style.are_strokes)
                stroke_pen(context.get(), part, page);
            else if (style.pen_mm > 0)
                stroke_pen_dots(context.get(), part, its_style, page);
            else if (part.ellipses.empty())
                fill_circles(context.get(), part, its_style, page);
            else
                fill_ovals(context.get(), part, its_style, page);
        });
    }
    // Checked after this call, because cairo writes most of the document only now.
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return bytes;
}

// Dots are lines of length 0 with round caps here: cairo draws them faster than circles.
void stroke_dots(cairo_t* context, const files::PointSet& set, const Style& style,
                 const Page& page) {
    cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
    for_each_stroke(set, style, [&](std::span<const Point> dots, double diameter) {
        ask_after(64 * dots.size());
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
    const double resolution = resolution_of(set, style);
    const Page page = page_of(set, style, resolution / kPointsPerInch);
    const auto pixels = [](double side) {
        return std::max(1, static_cast<int>(std::lround(side)));
    };
    // A surface that has only alpha becomes a grey PNG, which is a third as long. In it opaque is
    // white, and clearing draws black.
    const bool is_grey = set.layers.empty() && style.paper_colour == kWhitePaper;
    const Surface surface = checked(cairo_image_surface_create(
        is_grey ? CAIRO_FORMAT_A8 : CAIRO_FORMAT_RGB24, pixels(page.width), pixels(page.height)));
    const Context context = make_context(surface.get(), style);
    if (is_grey) cairo_set_operator(context.get(), CAIRO_OPERATOR_CLEAR);
    draw_layers(context.get(), set, style, page, [&](const auto& part, const Style& its_style) {
        if (style.are_strokes)
            stroke_pen(context.get(), part, page);
        else if (style.pen_mm > 0)
            stroke_pen_dots(context.get(), part, its_style, page);
        else if (part.ellipses.empty())
            stroke_dots(context.get(), part, its_style, page);
        else
            fill_ovals(context.get(), part, its_style, page);
    });
    return png_of(surface.get(), resolution);
}

// A pixel for each pixel that points may lie on: white with a point, black without.
std::string draw_pixels(const files::PointSet& set) {
    const lacuna::Raster& raster = *set.on_pixels;
    const Domain& domain = set.domain;
    std::vector<std::uint8_t> pixels(std::size_t{raster.columns} * raster.rows);
    const auto place = [](double way, double side, std::uint32_t count) {
        return static_cast<std::size_t>(std::clamp(way / side * count, 0.0, count - 1.0));
    };
    for (const Point& point : set.points) {
        const Point way = domain.from_corner(point);
        const std::size_t row = raster.rows - 1 - place(way.y, domain.height, raster.rows);
        pixels[row * raster.columns + place(way.x, domain.width, raster.columns)] = 255;
    }
    return encode_png(
        {.columns = raster.columns, .rows = raster.rows, .pixels_per_inch = kPointsPerInch},
        [&](std::size_t y, std::span<std::uint8_t> bytes) {
            std::copy_n(&pixels[y * bytes.size()], bytes.size(), bytes.begin());
        });
}

}  // namespace

double resolution_of(const files::PointSet& set, const Style& style) {
    constexpr double kUsual = 144, kApart = 4, kLongest = 8192;
    if (style.pixels_per_inch) return *style.pixels_per_inch;
    const Page page = page_of(set, style, 1);  // in points
    const double area = set.domain.width * set.domain.height * page.scale * page.scale;
    const auto count = static_cast<double>(std::max<std::size_t>(set.points.size(), 1));
    const double shown = kApart * kPointsPerInch / std::sqrt(area / count);
    const double most = kLongest * kPointsPerInch / std::max(page.width, page.height);
    return std::max(kUsual, std::floor(std::min(shown, most)));
}

std::string draw(const files::PointSet& set, Medium medium, const Style& style) {
    if (medium == Medium::svg) return draw_svg(set, style);
    if (medium == Medium::pdf) return draw_pdf(set, style);
    return set.on_pixels ? draw_pixels(set) : draw_png(set, style);
}

std::string encode(const files::PointSet& set, const files::Format& format, const Style& style) {
    return format.medium ? draw(set, *format.medium, style) : files::encode(set, format);
}

}  // namespace lacuna::drawing

// The rows of pictures in the table of files/formats.cpp.
namespace lacuna::files {

std::string encode_svg(const PointSet& set);
std::string encode_pdf(const PointSet& set);
std::string encode_png(const PointSet& set);

std::string encode_svg(const PointSet& set) {
    return drawing::draw(set, Medium::svg);
}

std::string encode_pdf(const PointSet& set) {
    return drawing::draw(set, Medium::pdf);
}

std::string encode_png(const PointSet& set) {
    return drawing::draw(set, Medium::png);
}

}  // namespace lacuna::files
