// The options of `lacuna stipple`, and what it does besides sampling and relaxing: the pen's path
// and the report.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/commands/relaxation.h"
#include "cli/options/common_options.h"
#include "cli/options/drawing.h"
#include "cli/options/ink_options.h"
#include "cli/options/picture_field.h"
#include "cli/reports/json.h"
#include "drawing/picture.h"
#include "files/point_files.h"
#include "recipes/settle.h"

namespace lacuna::cli {

struct StippleCommand {
    CommonOptions common;
    Picture picture;
    DrawingOptions drawing;
    InkOptions inks;
    double size_by_tone = 0;
    bool keep_inside = false;
    bool pen_path = false;
    bool ellipse_columns = false;
    recipes::Given given{.is_picture = true};
    std::uint32_t relax = 0;  // as `given` says
};

// What `lacuna stipple` has done besides sampling. Lengths are in the domain's units.
struct Work {
    double read_seconds = 0;
    double path_seconds = 0;
    double admitted_length = 0;  // of a pen's path through the dots in order of admission
    double path_length = 0;      // of the short path
    std::optional<Relaxation> relaxation;
};

// Orders the dots of each layer, or all dots if there is none, along a path of their own.
void order_for_a_pen(const StippleCommand& options, std::span<const files::Layer> layers,
                     Made& made, Work& work);

// The options that decide the dots, for files and the report.
Json json_of(const StippleCommand& options);

// What the report has besides the set: the picture's size, its options, and times.
Json report_of_the_rest(const StippleCommand& options, const std::vector<Output>& outputs,
                        const Field& field, const drawing::Style& style, const Work& work);

// The length of the pen's path, for the summary at the end.
std::string path_text(const StippleCommand& options, const std::vector<Output>& outputs,
                      const files::PointSet& set, const drawing::Style& style, const Work& work);

}  // namespace lacuna::cli
