// Options of a picture, and how it becomes a field.
#include "cli/options/picture_field.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <utility>

#include "cli/options/options.h"
#include "pictures/image.h"

namespace lacuna::cli {
namespace {

void read_metric(const std::string& text, std::optional<Metric>& metric) {
    for (const Metric known : {Metric::min, Metric::mean, Metric::max}) {
        if (text != name_of(known)) continue;
        metric = known;
        return;
    }
    throw BadRequest("metric", shown(text), "must be min, mean or max");
}

void read_sharpen(const std::string& text, pictures::Importance& importance) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    read("sharpen", text.substr(0, colon), importance.sharpen);
    if (colon != text.size()) read("sharpen", text.substr(colon + 1), importance.sharpen_amount);
}

}  // namespace

CLI::Option* add_picture(CLI::App& command, Picture& picture, Request& request) {
    CLI::Option* const image =
        command.add_option("IMAGE", picture.path, "The picture; - is standard input")
            ->type_name("");
    add_number(command, "scale", "G", request.scale,
               "The radius where the picture is black, if its longer side is 1; this or --count");
    command
        .add_option_function<std::string>(
            "--metric", [&picture](const std::string& text) { read_metric(text, picture.metric); },
            "Least distance of two dots: the min, mean or max of their two radii")
        ->type_name("METRIC");
    add_importance(command, picture);
    return image;
}

void add_importance(CLI::App& command, Picture& picture, bool has_ellipses) {
    command.add_flag("--invert", picture.importance.invert, "Bright is dense instead of dark")
        ->disable_flag_override();
    add_number(command, "black", "L", picture.importance.black,
               "Luminance from 0 to L counts as black (default 0)");
    add_number(command, "white", "L", picture.importance.white,
               "Luminance from L to 1 counts as white (default 1)");
    command
        .add_flag("--auto-levels", picture.importance.auto_levels,
                  "Chooses --black and --white: half a percent of the pixels lie beyond each")
        ->disable_flag_override();
    add_text(
        command, "sharpen", "R[:X]",
        [&picture](const std::string& text) { read_sharpen(text, picture.importance); },
        "Sharpens edges of about R pixels, X times as much (default 1), by an unsharp mask: shows "
        "more with few dots");
    if (has_ellipses)
        add_number(command, "along", "RATIO", picture.importance.along,
                   "Ellipses instead of disks, up to RATIO times as long as wide, along the "
                   "picture's edges (default 1); in mode exact");
    add_number(command, "gamma", "X", picture.importance.gamma,
               "Importance is raised to this power: over 1 lightens middle tones (default 1)");
    add_number(command, "min-importance", "I", picture.importance.min_importance,
               "Least importance, so that white has dots too (default 0)");
}

Field read_field(const Picture& picture, Request& request) {
    pictures::Image image = pictures::read_image(picture.path, pictures::kLargestAspect);
    const double longer = std::max(image.columns, image.rows);
    request.width = image.columns / longer;
    request.height = image.rows / longer;
    return pictures::importance_of(std::move(image), picture.importance);
}

}  // namespace lacuna::cli
