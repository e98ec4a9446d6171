// Options that several commands have.
#include "cli/options/common_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <utility>

#include "checks/classes.h"
#include "cli/reports/output.h"
#include "cli/terminal/run_program.h"
#include "options/read.h"
#include "pictures/image.h"

namespace lacuna::cli {

Targets targets_of(OutputOptions& output) {
    return {{"output", &output.paths}, {"format", &output.format}};
}

Targets targets_of(CommonOptions& options) {
    Targets targets{{"report", &options.report}, {"quiet", &options.quiet}};
    targets.merge(options::targets_of(options.request));
    targets.merge(targets_of(options.output));
    return targets;
}

Targets targets_of(Picture& picture) {
    Targets targets{{"metric", &picture.metric}};
    targets.merge(options::targets_of(picture.importance));
    return targets;
}

Field read_field(const Picture& picture) {
    pictures::Image image =
        pictures::read_image(picture.path, pictures::kLargestAspect,
                             {.backdrop = pictures::backdrop_of(picture.importance)});
    return pictures::importance_of(std::move(image), picture.importance);
}

std::vector<Output> checked_outputs(const CommonOptions& options,
                                    const std::vector<GivenFile>& read) {
    OutputOptions output = options.output;
    if (output.paths.empty()) output.paths.emplace_back("-");
    const std::vector<Output> outputs = outputs_of(output, files::written_extensions(), "txt");
    std::vector<GivenFile> written = given_files(outputs);
    if (!options.report.empty()) {
        check_json("report", options.report);
        written.push_back({"--report", options.report});
    }
    check_given_files(read, written);
    return outputs;
}

Finished make(const CommonOptions& options, options::Moves moves) {
    Finished made{.stopwatch = Stopwatch(!options.report.empty())};
    moves.measure = !options.report.empty();
    options::Made set = watched(options, made, [&](Observer& observer) {
        return options::make(options.request, moves, observer);
    });
    made.result = std::move(set.result);
    made.relaxed = std::move(set.relaxed);
    return made;
}

std::string words_of(std::span<const files::Layer> layers) {
    std::string text;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string& name = layers[i].ink.name;
        std::uint64_t dots = layers[i].dots;  // of all sizes of a kind
        while (i + 1 < layers.size() && layers[i + 1].ink.name == name) dots += layers[++i].dots;
        text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", name, dots);
    }
    return text.empty() ? "" : text + ")";
}

std::string words_of(const CommonOptions& options, const Finished& made, const std::string& what,
                     const std::string& note, const std::string& more) {
    const Result& result = made.result;
    // The radius or scale that was chosen for --count or for stipple's default number of dots.
    // After relaxing the radius may be 0, which means not known.
    std::string size;
    if (!options.request.radius && !options.request.scale) {
        if (!options.request.classes.names.empty())
            size = fmt::format(", distances {:.4g} times those given",
                               distance_factor(options.request, result));
        else if (result.scale > 0)
            size = fmt::format(", scale {:.4g}", result.scale);
        else if (const auto& raster = options.request.on_pixels)
            size = fmt::format(" on {}x{} pixels", raster->columns, raster->rows);
        else if (result.radius > 0 && options.request.mode != Mode::stratified)
            size = fmt::format(", radius {:.4g}", result.radius);
    }
    if (what == "point" && !result.maximal && !options.request.on_pixels) size += ", not maximal";
    return words_of(result.points.size(), what, result.rounds, note + size, made.seconds,
                    result.backend) +
           more;
}

std::string words_of(std::size_t count, const std::string& what, std::uint64_t rounds,
                     const std::string& note, double seconds, const std::string& backend) {
    std::string of_rounds;
    if (rounds > 0) of_rounds = fmt::format(", {} round{}", rounds, rounds == 1 ? "" : "s");
    return fmt::format("{} {}{}{}{}, {:.3f} s, {}", count, what, count == 1 ? "" : "s", note,
                       of_rounds, seconds, backend);
}

}  // namespace lacuna::cli
