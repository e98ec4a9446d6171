// The options of a picture in several inks, and its separation.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/picture_field.h"
#include "cli/reports/json.h"
#include "drawing/tones.h"

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

// The tones of the picture, in inks if there are any. Sets the request's domain. `tones` has the
// sizing; the request's field must be set, too, once the tones have their place.
void read_tones(const Picture& picture, const InkOptions& options, drawing::Tones& tones,
                Request& request);

// Gives each ink its number of dots, of the request's count or as --ink-counts says, which sets the
// count. Throws BadRequest, also for what check_request() refuses.
void share_dots(drawing::Tones& tones, const InkOptions& options, Request& request);

// For reports and .json: the inks and what else decides the dots.
Json json_of(const InkOptions& options);

// Such as "cyan 5100, magenta 4800".
std::string counts_text(const drawing::Tones& tones);

}  // namespace lacuna::cli
