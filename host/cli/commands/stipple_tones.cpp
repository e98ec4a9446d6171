// Reads the picture, and finds the dots' sizes.
#include "cli/commands/stipple_tones.h"

#include <utility>

#include "cli/options/picture_field.h"
#include "drawing/keep_inside.h"

namespace lacuna::cli {
namespace {

drawing::White white_of(const Tones& tones, const Request& request) {
    return {tones.all, request.width, request.height, request.boundary};
}

// The diameters that the tones ask for, whether dots overhang an edge or not.
std::vector<double> toned_diameters(const StippleCommand& options, const Tones& tones,
                                    const drawing::Style& style, const files::PointSet& set) {
    const double scale = drawing::millimetres_per_unit(set, style);
    if (tones.has_inks()) return dot_diameters(tones.inks, set, tones.sizing, scale);
    return dot_diameters(set.points, tones.all, set, tones.sizing, scale, options.relax != 0);
}

}  // namespace

Tones tones_of(const StippleCommand& options, Request& request) {
    Tones tones{{options.size_by_tone, options.drawing.pens, options.keep_inside}, {}, {}};
    if (options.inks.inks.empty()) {
        tones.all = read_field(options.picture, request);
    } else {
        tones.inks = read_separation(options.picture, options.inks, tones.sizing, request);
        tones.all = std::move(tones.inks.sum);
    }
    if (tones.sizing.varies()) tones.density = drawing::density_of(tones.all, tones.sizing);
    return tones;
}

void keep_inside(const StippleCommand& options, const Tones& tones, const Request& request,
                 const drawing::Style& style, std::vector<Point>& points) {
    files::PointSet set{points, request.width, request.height};
    set.layers = tones.inks.layers;
    drawing::pull_inside(points, toned_diameters(options, tones, style, set),
                         white_of(tones, request));
}

std::vector<double> diameters_of(const StippleCommand& options, const Tones& tones,
                                 const Request& request, const drawing::Style& style,
                                 const files::PointSet& set) {
    std::vector<double> diameters = toned_diameters(options, tones, style, set);
    if (!options.keep_inside) return diameters;
    const double least = tones.sizing.pens ? tones.sizing.pens->least_mm : 0;
    drawing::fit_inside(set.points, diameters, white_of(tones, request),
                        least / drawing::millimetres_per_unit(set, style));
    return diameters;
}

}  // namespace lacuna::cli
