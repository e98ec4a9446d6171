// Options of a picture, and its field.
#include "cli/options/picture_field.h"

#include <CLI/App.hpp>
#include <algorithm>
#include <utility>

#include "cli/options/options.h"
#include "pictures/image.h"

namespace lacuna::cli {
namespace {

void read_metric(const std::string& text, Metric& metric) {
    for (const Metric known : {Metric::min, Metric::mean, Metric::max}) {
        if (text != name_of(known)) continue;
        metric = known;
        return;
    }
    throw BadRequest("metric", shown(text), "must be min, mean or max");
}

}  // namespace

CLI::Option* add_picture(CLI::App& command, Picture& picture, Request& request) {
    CLI::Option* const image =
        command.add_option("IMAGE", picture.path, "The picture; - is standard input")
            ->type_name("");
    add_number(command, "scale", "G", request.scale,
               "The radius where the picture is black, its longer side being 1; this or --count");
    command
        .add_option_function<std::string>(
            "--metric",
            [&picture, &request](const std::string& text) {
                read_metric(text, request.metric);
                picture.has_metric = true;
            },
            "What two dots of different radii keep apart: min of the two, mean or max")
        ->type_name("METRIC");
    add_importance(command, picture);
    return image;
}

void add_importance(CLI::App& command, Picture& picture) {
    command.add_flag("--invert", picture.importance.invert, "Bright is dense")
        ->disable_flag_override();
    add_number(command, "black", "L", picture.importance.black,
               "Luminance, 0 to 1, that counts as black, and all under it (default 0)");
    add_number(command, "white", "L", picture.importance.white,
               "Luminance that counts as white, and all over it (default 1)");
    command
        .add_flag("--auto-levels", picture.importance.auto_levels,
                  "Black and white such that half a percent of the pixels are beyond each")
        ->disable_flag_override();
    add_number(command, "gamma", "X", picture.importance.gamma,
               "Importance is raised to this power: over 1 lightens middle tones (default 1)");
    add_number(command, "min-importance", "I", picture.importance.min_importance,
               "Importance is nowhere less, so that white has dots too (default 0)");
}

Field read_field(const Picture& picture, Request& request) {
    pictures::Image image = pictures::read_image(picture.path, kLargestAspect);
    const double longer = std::max(image.columns, image.rows);
    request.width = image.columns / longer;
    request.height = image.rows / longer;
    return pictures::importance_of(std::move(image), picture.importance);
}

}  // namespace lacuna::cli
