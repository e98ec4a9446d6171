// Writes stippled pictures from C++.
#include <lacuna/stipple.h>

#include "drawing/picture.h"
#include "files/formats.h"
#include "files/point_files.h"

namespace lacuna {

void write_stippling(const std::string& path, const Stippling& stippling) {
    const files::Format& format = files::format_of(path);
    const Request& request = stippling.request;
    files::PointSet set{stippling.result.points, request.domain, stippling.result.radius};
    set.is_relaxed = stippling.iterations != 0;
    set.layers = stippling.layers;
    set.ellipses = stippling.ellipses;
    drawing::Style style;
    style.sheet = stippling.paper;
    style.diameters = stippling.diameters;
    style.are_strokes = stippling.are_strokes;
    style.line_width = stippling.line_width;
    style.paper_colour = stippling.paper_colour;
    style.for_a_pen = stippling.is_for_a_pen;
    files::write_whole(path, format.medium ? drawing::draw(set, *format.medium, style)
                                           : files::encode(set, format));
}

}  // namespace lacuna
