// The tones of a picture that is drawn as dots: what each ink prints, how many dots it has, and how
// large and where they are drawn.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drawing/picture.h"
#include "files/point_files.h"
#include "stipple/dot_size.h"
#include "stipple/keep_inside.h"

namespace lacuna::stippling {

struct Tones {
    Sizing sizing{};
    bool keep_inside = false;                   // dots stay off white
    std::vector<Field> fields{};                // the importance of the picture, or of each ink
    std::vector<Field> varied{};                // how densely their dots lie, if sizes vary
    std::vector<std::vector<double>> shares{};  // of each field: see Sizing::shares
    Field sum{};                                // of the importance of all inks; empty without inks
    std::vector<files::Layer> layers{};         // the inks and their dots; empty without inks

    bool has_inks() const { return !layers.empty(); }
    // The sizes of dots of ink `k`, which its own pen decides if it has one.
    Sizing sizing_of(std::size_t k) const;
    // Whether pens decide how large dots are, in all inks.
    bool has_pens() const;
    const Field& all() const { return has_inks() ? sum : fields.front(); }
    std::span<const Field> densities() const { return varied.empty() ? fields : varied; }
};

// Sets the fields of `tones`: one field for each ink, or a single field if there are no inks. The
// sizing must be set before.
void set_fields(Tones& tones, std::vector<Field> fields, std::span<const Ink> inks = {});

// The layers of a set that pens of several widths draw: of each ink the dots of each pen, which are
// put in that order, narrow pens first. Empty if there is one pen for all dots of an ink.
std::vector<files::Layer> layers_of_pens(const Tones& tones, const Domain& domain,
                                         std::span<Point> points);

// At how many dots, in all, their areas sum to the picture's darkness; 0 without pens.
double dots_for_ink(const Tones& tones, const Domain& domain, const drawing::Style& style);

// The number of dots that suits the picture, in all. Pens need dots for each ink by itself.
std::uint64_t suiting_count(const Tones& tones, const Domain& domain, const drawing::Style& style);

// How many dots a plotter draws in this time, along the path of each ink, or as how many strokes
// it draws their ink: a few percent less than it would.
std::uint64_t plotted_count(const Tones& tones, const Domain& domain, const drawing::Style& style,
                            const Plotter& plotter, double seconds);
// The area of the ink of lines or strokes, which partly lie on themselves.
double ink_of(const Tones& tones, const Domain& domain);
// How many dots the lines of pens go through if their ink is as much as the picture is dark.
std::uint64_t count_of_line(const Tones& tones, const Domain& domain, const drawing::Style& style);
// Gives each ink its share of this number of dots.
void share_dots(Tones& tones, std::uint64_t dots);

// With keep_inside, and without pens: makes dots in shapes that are narrower than they are as much
// smaller, down to a third of their width, and as much denser, so that thin lines stay. `dots` is
// the number of all dots.
void suit_narrow_shapes(Tones& tones, const Domain& domain, std::uint64_t dots);

// The inks that have dots.
std::vector<InkPart> parts_of(const Tones& tones);

// The diameters, in the domain's units, of the dots of a set, which come ink by ink.
std::vector<double> diameters_of(const Tones& tones, const files::PointSet& set,
                                 const drawing::Style& style);

// With keep_inside: moves the dots of `set`, whose points these are, away from white.
void pull_inside(const Tones& tones, const files::PointSet& set, const drawing::Style& style,
                 std::span<Point> points);

}  // namespace lacuna::stippling
