// The options that say how a stippled picture is drawn.
#pragma once

#include <lacuna/lacuna.h>

#include <optional>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/paper.h"
#include "drawing/picture.h"
#include "files/point_files.h"

namespace lacuna::cli {

struct DrawingOptions {
    std::optional<double> dot_size_mm;  // none: from the local radius
    std::optional<Paper> paper;
    double margin_mm = 0;
    double pixels_per_inch = drawing::Style{}.pixels_per_inch;
    std::vector<std::string> given;  // names of those that were
};

// --dot-size, --paper-size, --margin, --dpi; `options` must outlive the command.
void add_how_to_draw(CLI::App& command, DrawingOptions& options);

bool is_picture(const std::string& path);

// What can be checked before the picture is known. Throws BadRequest.
void check_drawing(const DrawingOptions& options, const std::string& output);

// The style for a domain of this shape, without the dots' sizes. Throws BadRequest where a png
// would have more pixels than cairo can draw.
drawing::Style style_of(const DrawingOptions& options, double width, double height);

// The picture's bytes, or those of another format that `output` names.
std::string encoded(const DrawingOptions& options, const std::string& output,
                    const files::PointSet& set, const Field& field, drawing::Style style);

}  // namespace lacuna::cli
