// Point sets as svg, written without cairo.
#include "drawing/picture_svg.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string>

#include "base/number_text.h"
#include "base/polling.h"
#include "drawing/page.h"
#include "drawing/xml.h"

namespace lacuna::drawing {
namespace {

// The set's origin in Dublin Core, which Inkscape and other programs show.
std::string svg_metadata(const files::Origin& origin) {
    return fmt::format(
        "<metadata>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
        "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<rdf:Description rdf:about=\"\">"
        "<dc:creator>{}</dc:creator><dc:source>{}</dc:source>{}<dc:description>{}</dc:description>"
        "</rdf:Description>\n</rdf:RDF>\n</metadata>\n",
        program_text(origin), in_xml(origin.command),
        origin.image_sha256.empty()
            ? ""
            : "<dc:relation>sha256:" + origin.image_sha256 + "</dc:relation>",
        seed_text(origin));
}

// Programs for plotters would take a rectangle for a shape to draw: on a sheet, and for a pen, the
// colour of the paper is a property that browsers show.
std::string svg_head(const files::PointSet& set, const Page& page, const Style& style) {
    const bool is_sheet = style.sheet.has_value();
    const bool is_shape = !is_sheet && !style.for_a_pen;
    const std::string colour =
        style.paper_colour == kWhitePaper ? "white" : files::hex_of(style.paper_colour);
    std::string head = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\"{3} width=\"{0:.9g}{2}\" height=\"{1:.9g}{2}\" "
        "viewBox=\"0 0 {0:.9g} {1:.9g}\"{4}>\n",
        page.width, page.height, is_sheet ? "mm" : "pt",
        set.layers.empty() ? "" : " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"",
        is_shape || style.paper_colour == kWhitePaper
            ? ""
            : fmt::format(" style=\"background:{}\"", colour));
    if (set.origin != nullptr) head += svg_metadata(*set.origin);
    if (is_shape)
        head += fmt::format("<rect width=\"{:.9g}\" height=\"{:.9g}\" fill=\"{}\"/>\n", page.width,
                            page.height, colour);
    return head;
}

// The group of a layer's dots. Programs for plotters take the number that begins a label for the
// layer's number. The layers of transparent inks are multiplied.
std::string group_head(std::span<const files::Layer> layers, std::size_t index,
                       const Colour& paper) {
    if (layers.empty()) return "<g fill=\"none\" stroke=\"black\" stroke-linecap=\"round\">\n";
    const files::Layer& layer = layers[index];
    return fmt::format(
        "<g inkscape:groupmode=\"layer\" inkscape:label=\"{} {}\" style=\"mix-blend-mode:"
        "{}\" fill=\"none\" stroke=\"{}\" stroke-linecap=\"round\">\n",
        index + 1, layer.ink.name, layer.ink.is_opaque_on(paper) ? "normal" : "multiply",
        files::hex_of(layer.ink.colour));
}

// What a plotter does for a layer, which programs show as its description.
std::string plot_text(const files::PointSet& set, std::size_t layer, const Style& style) {
    if (layer >= std::min(set.layers.size(), style.layer_plots.size())) return "";
    const auto& [path_length, seconds] = style.layer_plots[layer];
    return fmt::format("<desc>pen path {:.2f} m, about {}</desc>\n",
                       path_length * millimetres_per_unit(set, style) / 1000, time_text(seconds));
}

void append_line(std::string& bytes, std::span<const Point> points, double width,
                 const Page& page) {
    fmt::format_to(std::back_inserter(bytes),
                   FMT_COMPILE("<path stroke-linejoin=\"round\" stroke-width=\"{:.6g}\" d=\""),
                   width);
    ask_after(16 * points.size());
    char step = 'M';
    for (const Point& point : points) {
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("{}{:.4f} {:.4f}\n"), step,
                       page.x_of(point), page.y_of(point));
        step = 'L';
    }
    if (points.size() == 1) bytes += "h0.01\n";  // a line of length 0 is not drawn by all programs
    bytes += "\"/>\n";
}

}  // namespace

std::string seed_text(const files::Origin& origin) {
    return fmt::format("seed {}", origin.seed);
}

std::string program_text(const files::Origin& origin) {
    return fmt::format("Lacuna {}", origin.version);
}

// Cairo is not used: it numbers the surfaces of the whole process, so a second call gives other
// bytes, and its file is twice as long. Dots are lines with round caps: a tenth of the bytes of
// circles.
std::string draw_svg(const files::PointSet& set, const Style& style) {
    // Programs for plotters drop lines of length 0. A line of at most 0.01 mm or pt, and at most a
    // tenth of the diameter, still looks as round as a point.
    constexpr double kLongestLine = 0.01, kLargestShare = 0.1;
    const bool is_sheet = style.sheet.has_value();
    const Page page = page_of(set, style, is_sheet ? kMillimetresPerInch / kPointsPerInch : 1);
    std::string bytes = svg_head(set, page, style);
    const auto draw_dots = [&](std::span<const Point> dots, double diameter) {
        const double width = diameter * page.scale;
        const std::string line =
            fmt::format("h{:.3g}", std::min(kLongestLine, kLargestShare * width));
        fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("<path stroke-width=\"{:.6g}\" d=\""),
                       width);
        ask_after(16 * dots.size());
        for (const Point& point : dots)
            fmt::format_to(std::back_inserter(bytes), FMT_COMPILE("M{:.4f} {:.4f}{}\n"),
                           page.x_of(point), page.y_of(point), line);
        bytes += "\"/>\n";
    };
    for_each_layer(set, style, [&](std::size_t layer, const auto& part, const Style& its_style) {
        bytes += group_head(set.layers, layer, style.paper_colour) + plot_text(set, layer, style);
        if (style.line_width > 0)
            append_line(bytes, part.points, line_width_of(set, layer, style, page), page);
        else if (style.are_strokes)
            append_strokes(bytes, part, page);
        else if (style.pen_mm > 0)
            append_pen_dots(bytes, part, its_style, page);
        else if (part.ellipses.empty())
            for_each_stroke(part, its_style, draw_dots);
        else
            append_ovals(bytes, part, its_style, page);
        bytes += "</g>\n";
    });
    return bytes + "</svg>\n";
}

}  // namespace lacuna::drawing
