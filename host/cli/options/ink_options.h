// The options of a picture in several inks, and its separation.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/picture_field.h"
#include "cli/reports/json.h"
#include "drawing/dot_size.h"
#include "files/point_files.h"

namespace lacuna::cli {

struct InkOptions {
    std::vector<Ink> inks;  // empty: the dots are black, and the picture is taken as grey
    std::optional<double> black_ink;
    std::vector<std::uint64_t> counts;  // one an ink; empty: shared by the inks' importance
};

// Adds --inks, --black-ink and --ink-counts; `options` must outlive the command.
void add_inks(CLI::App& command, InkOptions& options);

// Checks the options before the picture is read. `mode` is the one given, if any. Throws
// BadRequest.
void check_inks(const InkOptions& options, const Request& request, std::optional<Mode> mode);

// A picture in inks.
struct Separation {
    std::vector<Field> fields;         // the importance of each ink
    std::vector<Field> varied;         // how densely its dots lie, if sizes vary
    Field sum;                         // the sum of all importance
    std::vector<files::Layer> layers;  // each with its number of dots, once shared

    std::span<const Field> densities() const { return varied.empty() ? fields : varied; }
};

// Reads the picture, and sets the request's domain, as read_field() does.
Separation read_separation(const Picture& picture, const InkOptions& options,
                           const drawing::Sizing& sizing, Request& request);

// Gives each ink its number of dots, of the request's count or as --ink-counts says, which sets the
// count. Throws BadRequest, also for what check_request() refuses.
void share_dots(Separation& separation, const InkOptions& options, Request& request);

// The inks that have dots.
std::vector<InkPart> parts_of(const Separation& separation);

// The diameters of all dots, which come ink by ink, or of points with one tone.
std::vector<double> dot_diameters(const Separation& separation, const files::PointSet& set,
                                  const drawing::Sizing& sizing, double millimetres_per_unit);
std::vector<double> dot_diameters(std::span<const Point> points, const Field& tone,
                                  const files::PointSet& set, const drawing::Sizing& sizing,
                                  double millimetres_per_unit, bool is_relaxed);

// For reports and .json: the inks and what else decides the dots.
Json json_of(const InkOptions& options);

// Such as "cyan 5100, magenta 4800".
std::string counts_text(const Separation& separation);

}  // namespace lacuna::cli
