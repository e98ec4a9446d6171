// Reads points, their picture and their domain.
#include "cli/options/given_set.h"

#include <fmt/core.h>

#include <lacuna/pictures.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/number_text.h"
#include "cli/options/domain_options.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_whole.h"

namespace lacuna::cli {
namespace {

// The colours of a file's inks: as it says, or by their names; else such as classes have.
void colour(const files::LayersOfFile& inks, std::vector<files::Layer>& layers) {
    const std::vector<Ink> cmyk = inks_of("cmyk");
    const auto named = [&](const std::string& name) {
        const auto is_it = [&](const Ink& ink) { return ink.name == name; };
        return std::find_if(cmyk.begin(), cmyk.end(), is_it);
    };
    const bool are_cmyk = std::all_of(inks.names.begin(), inks.names.end(),
                                      [&](const auto& name) { return named(name) != cmyk.end(); });
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string& name = layers[i].ink.name;
        try {
            if (i < inks.colours.size())
                layers[i].ink.colour = inks_of(inks.colours[i]).front().colour;
            else
                layers[i].ink.colour =
                    are_cmyk ? named(name)->colour : inks_of(name).front().colour;
        } catch (const BadRequest&) {
            continue;  // a name of another program's
        }
    }
}

[[noreturn]] void refuse(const GivenSet& set, const std::string& why) {
    throw files::FileError(files::name_of(set.points) + ": " + why);
}

}  // namespace

Targets targets_of(GivenSet& set) {
    Targets targets{{"POINTS", &set.points}, {"IMAGE", &set.picture.path}};
    targets.merge(targets_of(set.picture));
    return targets;
}

SetAndField read_given_set(const CommandLine& line, const GivenSet& set, Request& request) {
    const bool has_domain = line.has("domain");
    SetAndField read{files::read_points(set.points), {}};
    const files::PointsOfFile& file = read.file;
    if (!set.picture.path.empty()) {
        read.field = read_field(set.picture);
        if (!has_domain) take_shape(domain_around({}, &*read.field), request);
    }
    if (!has_domain && file.domain) take_shape(*file.domain, request);
    if (file.boundary == Boundary::torus) request.domain.boundary = Boundary::torus;
    return read;
}

void refuse_points(const GivenSet& set, const BadRequest& error) {
    if (error.option() != "points") throw;
    refuse(set, error.value() + ": " + error.reason());
}

GivenColumns::GivenColumns(const GivenSet& set, const SetAndField& given,
                           const DrawingOptions& drawing, const std::vector<Output>& outputs,
                           bool can_have_ellipses)
    : ellipses_(given.file.ellipses) {
    constexpr std::array<std::string_view, 4> kOfDots{"radius", "x_mm", "y_mm", "radius_mm"};
    for (const std::string& name : given.file.other_columns) {
        const bool is_of_dots = std::find(kOfDots.begin(), kOfDots.end(), name) != kOfDots.end();
        if (is_of_dots && drawing.are_given) continue;
        refuse(set, fmt::format("the column {} would be lost: {}", shown(name),
                                is_of_dots ? "give --dot-size or --paper-size, which make the "
                                             "sizes of dots anew, or a file without it"
                                           : "give a file without it; x, y, class, ink, a, b and "
                                             "angle are written again"));
    }
    if (!given.file.radii.empty() && drawing.are_given)
        refuse(set,
               "the column radius would be lost: --dot-size and --paper-size write the radii "
               "of dots");
    if (!given.file.radii.empty()) more_.push_back({"radius", given.file.radii});
    if (!ellipses_.empty() && !can_have_ellipses)
        refuse(set,
               "the columns a, b and angle would be lost: relaxing has disks, because an "
               "ellipse belongs to the place of its point");
    const bool has_inks = !given.file.inks.of_point.empty();
    const files::LayersOfFile& layers = has_inks ? given.file.inks : given.file.classes;
    if (has_inks && !given.file.classes.of_point.empty())
        refuse(set, "has a class and an ink for each point: must have one of both");
    layers_ = files::layers_of_classes(layers.names, layers.of_point);
    layer_of_point_ = layers.of_point;
    if (has_inks) layers_are_ = files::LayersAre::inks;
    if (has_inks || !layers.colours.empty()) colour(layers, layers_);
    const bool has_columns = !layers_.empty() || !ellipses_.empty();
    if (const std::string loss = loss_of_columns(outputs); has_columns && !loss.empty())
        refuse(set, fmt::format("the {} of each point {}",
                                layers_.empty() ? "ellipse"
                                : has_inks      ? "ink"
                                                : "class",
                                loss));
}

void GivenColumns::put_in_order(std::span<const std::uint32_t> order) {
    const auto ordered = [&](auto& values) {
        auto given = std::exchange(values, {});
        for (const std::uint32_t index : order)
            if (!given.empty()) values.push_back(given[index]);
    };
    ordered(layer_of_point_);
    ordered(ellipses_);
    for (files::Column& column : more_) ordered(column.values);
}

void GivenColumns::add_to(files::PointSet& set) const {
    set.layers = layers_;
    set.layer_of_point = layer_of_point_;
    set.layers_are = layers_are_;
    set.ellipses = ellipses_;
    set.more = more_;
    set.writes_ellipses = !ellipses_.empty();
}

}  // namespace lacuna::cli
