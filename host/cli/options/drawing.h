// The options that say how points are drawn as dots.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "cli/options/common_options.h"
#include "cli/reports/output.h"
#include "drawing/picture.h"
#include "files/point_files.h"
#include "stipple/dot_size.h"

namespace lacuna::cli {

struct DrawingOptions {
    // Unset: dots have as much ink as the picture or, without one, two thirds of the radius.
    std::optional<Pens> pens;
    std::optional<Paper> paper;
    std::optional<double> pixels_per_inch;  // unset: as many as show the dots
    bool are_given = false;                 // any of them, so that files have columns for dots
};

Targets targets_of(DrawingOptions& options);

// "radius", a diameter in mm, or two.
nlohmann::ordered_json json_of_pens(const std::optional<Pens>& pens);

bool has_picture(const std::vector<Output>& outputs);

// The options of a command line, checked before the picture is known. Throws BadRequest, also where
// a png would have more pixels than cairo can draw.
DrawingOptions checked_drawing(const CommandLine& line, DrawingOptions options,
                               const std::vector<Output>& outputs);

// The style for a domain of this shape, without the dots' sizes.
drawing::Style style_of(const DrawingOptions& options, const Domain& domain);

// Dots of pens, or lines through them.
struct Inked {
    std::size_t dots;
    double suits;  // how many dots would have the picture's ink; 0 if that is not known
    const Domain& domain;
    double widest_pen_mm;
    bool are_line = false;
    bool has_gamma = true;  // if not, and ink is short, a --gamma that keeps contrast is named
};

// Prints a line on standard error if the ink is less than half of the picture's, or more than twice
// as much, and what would suit: another number, pen or paper.
void warn_of_ink(const DrawingOptions& options, const Inked& inked);
// The same for dots of the picture `tone`; null: there is none.
void warn_of_ink(const DrawingOptions& options, const Request& request, const Field* tone,
                 std::size_t count, const drawing::Style& style);

// Returns the diameters of a set's dots in the domain's units; empty if all follow from its radius.
using FindDiameters = std::function<std::vector<double>()>;

// Writes the set to every output, together with the files that were added to `writing` before.
// find_diameters() is called if an output needs diameters and --dot-size does not give them.
void write_set(Writing& writing, const DrawingOptions& options, const std::vector<Output>& outputs,
               files::PointSet set, drawing::Style style, const FindDiameters& find_diameters);

// A set that a command has made.
struct Ready {
    const files::PointSet& set;
    const drawing::Style& style;
    FindDiameters find_diameters;
    std::function<std::string()> report;  // the content of --report, if it is given
    std::string words;                    // about the set, for the last line
};

// The end of every command that makes points: writes the report and the set, and says on standard
// error what was made, unless points or report went to the screen. A set without points is said to
// be one there, too.
void finish(Interruption& interruption, const CommonOptions& options, const DrawingOptions& drawing,
            const std::vector<Output>& outputs, const Ready& ready);

}  // namespace lacuna::cli
