// The picture of `lacuna stipple` as tones, and the dots' sizes that follow from it.
#pragma once

#include <lacuna/lacuna.h>

#include <optional>
#include <vector>

#include "cli/commands/stipple_work.h"
#include "cli/options/ink_options.h"
#include "drawing/dot_size.h"
#include "drawing/picture.h"
#include "files/point_files.h"

namespace lacuna::cli {

// The picture as importance, and what follows from it.
struct Tones {
    drawing::Sizing sizing;
    Separation inks;                 // empty without --inks
    Field all;                       // the importance; with inks the sum of theirs
    std::optional<Field> density{};  // of dots, where it is not proportional to the importance

    bool has_inks() const { return !inks.fields.empty(); }
};

// Reads the picture, and sets the request's domain. The request's field must be set, too, once the
// result has its place.
Tones tones_of(const StippleCommand& options, Request& request);

// Moves the dots of the set, whose points these are, away from the picture's white parts.
void keep_inside(const StippleCommand& options, const Tones& tones, const Request& request,
                 const drawing::Style& style, std::vector<Point>& points);

// The dots' diameters in the domain's units.
std::vector<double> diameters_of(const StippleCommand& options, const Tones& tones,
                                 const Request& request, const drawing::Style& style,
                                 const files::PointSet& set);

}  // namespace lacuna::cli
