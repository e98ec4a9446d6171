// The tones of a picture that is drawn as dots: what each ink prints, how many dots it has, and how
// large and where they are drawn.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/dot_size.h"
#include "drawing/keep_inside.h"
#include "drawing/picture.h"
#include "files/point_files.h"

namespace lacuna::drawing {

struct Tones {
    Sizing sizing{};
    bool keep_inside = false;            // dots stay off white
    Spread spread = Spread::even;        // of the dots
    std::vector<Field> fields{};         // the importance of the picture, or of each ink
    std::vector<Field> varied{};         // how densely their dots lie, if sizes vary
    Field sum{};                         // of the importance of all inks; empty without inks
    std::vector<files::Layer> layers{};  // the inks and their dots; empty without inks

    bool has_inks() const { return !layers.empty(); }
    const Field& all() const { return has_inks() ? sum : fields.front(); }
    std::span<const Field> densities() const { return varied.empty() ? fields : varied; }
};

// Sets the fields of `tones`: one field for each ink, or a single field if there are no inks. The
// sizing must be set before.
void set_fields(Tones& tones, std::vector<Field> fields, std::span<const Ink> inks = {});

// The number of dots that suits the picture, in all. Pens need dots for each ink by itself.
std::uint64_t suiting_count(const Tones& tones, const Domain& domain, const Style& style);

// Gives each ink its share of this number of dots.
void share_dots(Tones& tones, std::uint64_t dots);

// The inks that have dots.
std::vector<InkPart> parts_of(const Tones& tones);

// The diameters, in the domain's units, of the dots of a set, which come ink by ink.
std::vector<double> diameters_of(const Tones& tones, const files::PointSet& set,
                                 const Style& style);

// With keep_inside: moves the dots of `set`, whose points these are, away from white.
void pull_inside(const Tones& tones, const files::PointSet& set, const Style& style,
                 std::span<Point> points);

}  // namespace lacuna::drawing
