// Computes ink by ink what dot_size, dot_count and keep_inside compute for one field.
#include "drawing/tones.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "drawing/dot_count.h"
#include "drawing/page.h"

namespace lacuna::drawing {
namespace {

// The diameters that the tones ask for, whether dots overhang an edge or not.
std::vector<double> toned_diameters(const Tones& tones, const files::PointSet& set,
                                    const Style& style) {
    const double scale = millimetres_per_unit(set, style);
    std::vector<double> all;
    files::PointSet dots = set;
    dots.layers = tones.layers;
    for_each_layer(dots, Style{}, [&](std::size_t k, const auto& part, const Style&) {
        const Field& field = tones.fields[k];
        const std::vector<double> diameters =
            tones.sizing.pens
                ? pen_diameters(part.points, field, set.domain, *tones.sizing.pens, scale)
                : dot_diameters(part.points, field, set.domain, tones.spread, tones.sizing);
        all.insert(all.end(), diameters.begin(), diameters.end());
    });
    return all;
}

}  // namespace

void set_fields(Tones& tones, std::vector<Field> fields, std::span<const Ink> inks) {
    tones.fields = std::move(fields);
    tones.sizing.solid_black = tones.keep_inside;
    if (tones.sizing.varies())
        for (const Field& field : tones.fields)
            tones.varied.push_back(density_of(field, tones.sizing));
    if (inks.empty()) return;
    for (const Ink& ink : inks) tones.layers.push_back({ink, 0});
    tones.sum = tones.fields.front();
    std::vector<double>& sum = tones.sum.importance;
    for (const Field& field : std::span(tones.fields).subspan(1))
        std::transform(sum.begin(), sum.end(), field.importance.begin(), sum.begin(), std::plus());
}

std::uint64_t suiting_count(const Tones& tones, const Domain& domain, const Style& style) {
    const auto count_of = [&](const Field& field) {
        return default_count(field, domain, tones.sizing.pens, style);
    };
    if (!tones.sizing.pens) return count_of(tones.all());
    std::uint64_t all = 0;
    for (const Field& field : tones.fields) all += count_of(field);
    return all;
}

void share_dots(Tones& tones, std::uint64_t dots) {
    const std::vector<std::uint64_t> shares = dots_by_ink(dots, tones.densities());
    for (std::size_t k = 0; k < shares.size(); ++k) tones.layers[k].dots = shares[k];
}

std::vector<InkPart> parts_of(const Tones& tones) {
    std::vector<InkPart> parts;
    for (std::size_t k = 0; k < tones.layers.size(); ++k)
        if (tones.layers[k].dots != 0)
            parts.push_back({&tones.densities()[k], tones.layers[k].dots});
    return parts;
}

std::vector<double> diameters_of(const Tones& tones, const files::PointSet& set,
                                 const Style& style) {
    std::vector<double> diameters = toned_diameters(tones, set, style);
    if (!tones.keep_inside) return diameters;
    const double least = tones.sizing.pens ? tones.sizing.pens->least_mm : 0;
    fit_inside(set.points, diameters, {tones.all(), set.domain},
               least / millimetres_per_unit(set, style));
    return diameters;
}

void pull_inside(const Tones& tones, const files::PointSet& set, const Style& style,
                 std::span<Point> points) {
    if (tones.keep_inside)
        pull_inside(points, toned_diameters(tones, set, style), {tones.all(), set.domain});
}

}  // namespace lacuna::drawing
