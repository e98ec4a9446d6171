// Makes many sets under one progress bar, and writes each as soon as it is made.
#include "cli/options/sample_seeds.h"

#include <fmt/core.h>
#include <lacuna/many.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "cli/options/domain_options.h"
#include "cli/options/given_files.h"
#include "cli/reports/made_set.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/terminal/driver.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/observers.h"
#include "cli/terminal/progress_bar.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "options/read.h"

namespace lacuna::cli {
namespace {

constexpr std::string_view kPlace = "{seed}";
constexpr std::uint64_t kMostSeeds = 1'000'000;

std::string path_of(const std::string& path, std::uint64_t seed) {
    return with_name(path, kPlace, std::to_string(seed));
}

std::vector<Output> outputs_of_seed(const std::vector<Output>& outputs, std::uint64_t seed) {
    std::vector<Output> own;
    own.reserve(outputs.size());
    for (const Output& output : outputs) own.push_back({path_of(output.path, seed), output.format});
    return own;
}

// The files of all seeds, and the report.
WrittenFiles written_files(const CommonOptions& options, SeedRange seeds) {
    const std::vector<std::string>& paths = options.output.paths;
    const std::size_t sets = paths.size() * (seeds.last - seeds.first + 1);
    const auto at = [&options, &paths, seeds, sets](std::size_t index) {
        if (index == sets) return GivenFile{"--report", options.report};
        const std::uint64_t seed = seeds.first + index / paths.size();
        return GivenFile{"--output", path_of(paths[index % paths.size()], seed),
                         fmt::format(" (seed {})", seed)};
    };
    return {sets + (options.report.empty() ? 0 : 1), at};
}

// Checks each folder, and each file that is there. A folder is not checked again for the next seed.
void check_writable_files(const std::vector<std::string>& paths, SeedRange seeds) {
    for (const std::string& path : paths) {
        std::optional<std::filesystem::path> checked;
        for (std::uint64_t i = 0; i <= seeds.last - seeds.first; ++i) {
            const std::filesystem::path file = path_of(path, seeds.first + i);
            std::error_code error;
            const bool is_there = std::filesystem::exists(symlink_status(file, error));
            if (is_there || checked != file.parent_path()) check_writable(file.string());
            checked = file.parent_path();
        }
    }
}

class Sets : public Observer {
public:
    explicit Sets(bool quiet) : bar_(quiet) {}
    bool keep_going(const Progress& progress) override {
        const double share =
            static_cast<double>(progress.points) /
            static_cast<double>(std::max<std::uint64_t>(1, progress.expected_points));
        bar_.show_time_to_go(
            share, fmt::format("{} of {} sets", progress.points, progress.expected_points));
        return true;
    }

private:
    ProgressBar bar_;
};

void add(ManyMade& all, Result set) {
    const std::uint64_t count = set.points.size();
    all.least = all.sets == 0 ? count : std::min(all.least, count);
    all.most = std::max(all.most, count);
    all.points += count;
    all.maximal += set.maximal ? 1 : 0;
    ++all.sets;
    set.points.clear();
    all.last = std::move(set);
}

std::string words_of(const CommonOptions& options, const ManyMade& all, const Request& request) {
    const std::string counts = all.least == all.most ? fmt::format("{}", all.least)
                                                     : fmt::format("{} to {}", all.least, all.most);
    std::string maximal;
    if (all.maximal == 0 && !options.request.on_pixels)
        maximal = ", not maximal";
    else if (all.maximal != 0 && all.maximal < all.sets)
        maximal = fmt::format(", {} of them maximal", all.maximal);
    return fmt::format("{} set{} of {} points{}{}, {:.3f} s, {}", all.sets,
                       all.sets == 1 ? "" : "s", counts, words_of_places(request), maximal,
                       all.seconds, all.last.backend);
}

}  // namespace

SeedRange read_seeds(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos)
        throw BadRequest("seeds", shown(text), "must be FIRST..LAST, as in 0..99, both included");
    SeedRange seeds{};
    options::read("seeds", text.substr(0, dots), seeds.first);
    options::read("seeds", text.substr(dots + 2), seeds.last);
    if (seeds.last < seeds.first)
        throw BadRequest("seeds", shown(text), "the first must not be greater than the last");
    if (seeds.last - seeds.first >= kMostSeeds)
        throw BadRequest("seeds", shown(text), fmt::format("must be at most {}", kMostSeeds));
    return seeds;
}

std::vector<Output> checked_outputs(const CommonOptions& options, SeedRange seeds,
                                    const std::vector<GivenFile>& read) {
    const std::string range = fmt::format("{}..{}", seeds.first, seeds.last);
    if (options.output.paths.empty())
        throw BadRequest("seeds", range,
                         "needs an --output with {seed} in its name, such as 'tiles/{seed}.npy'");
    CommonOptions of_first = options;
    for (std::string& path : of_first.output.paths) {
        if (path.find(kPlace) == std::string::npos)
            throw BadRequest("output", shown(path),
                             "must have {seed} in its name, for --seeds: a file a set");
        path = path_of(path, seeds.first);
    }
    if (options.report.find(kPlace) != std::string::npos)
        throw BadRequest("report", shown(options.report),
                         "is one report of all sets, without {seed}: an --output of .json tells of "
                         "each set");
    // All sets have the formats of the first set's files.
    const std::vector<Output> checked = checked_outputs(of_first, read);
    check_writable_files(options.output.paths, seeds);
    check_given_files(read, written_files(options, seeds));
    std::vector<Output> outputs;
    for (std::size_t i = 0; i < checked.size(); ++i)
        outputs.push_back({options.output.paths[i], checked[i].format});
    return outputs;
}

void refuse_seed_in(const std::vector<std::string>& outputs, const std::string& report) {
    refuse_place(outputs, kPlace, "--seeds");
    refuse_place({report}, kPlace, "--seeds", "report");
}

void sample_seeds(const CommandLine& line, const CommonOptions& options,
                  const DrawingOptions& drawing, const std::vector<Output>& outputs,
                  SeedRange seeds, const AllSets& all_sets) {
    const drawing::Style style = style_of(drawing, options.request.domain);
    std::vector<std::uint64_t> all(seeds.last - seeds.first + 1);
    std::iota(all.begin(), all.end(), seeds.first);

    Interruption interruption;
    Request shared = options.request;
    nlohmann::ordered_json of_frame = nlohmann::ordered_json::object();
    TileRing frame;
    ManyMade made;
    made.first_seed = seeds.first;
    made.last_seed = seeds.last;
    Stopwatch stopwatch;
    {
        DriverAtWork driver(options.request.run_on.backend);
        Sets bar(options.quiet);
        Observers observers({driver, bar});
        if (all_sets.frame) {
            shared.seed = seeds.first;
            frame = tile_ring(shared, *all_sets.frame, driver);
            shared.keep = frame.points;
            shared.keep_classes = frame.classes;
            of_frame = {{"frame", *all_sets.frame}, {"kept", frame.points.size()}};
        }
        sample_many(
            shared, all,
            [&](std::uint64_t seed, Result set) {
                Request request = shared;
                request.seed = seed;
                nlohmann::ordered_json decides = all_sets.options(as_made(request, set));
                decides.update(of_frame);
                const files::Origin origin = origin_of(line, request, set, decides);
                Writing writing(interruption);
                const MadeSet files(request, set, origin, all_sets.showing);
                write_set(writing, drawing, outputs_of_seed(outputs, seed), files.points(), style,
                          [&] { return files.diameters(stippling::Spread::random); });
                add(made, std::move(set));
            },
            observers);
    }
    made.seconds = stopwatch.seconds_so_far();
    if (!options.quiet)
        warn_of_ink(drawing, options.request,
                    all_sets.showing.is_sized_by_radii ? nullptr : options.request.field,
                    made.points / made.sets, style);
    Writing writing(interruption);
    if (!options.report.empty())
        writing.add(options.report, [&] {
            nlohmann::ordered_json decides = all_sets.options(shared);
            decides.update(of_frame);
            return many_report(shared, made, decides);
        });
    writing.write();
    sum_up({outputs, options.report, options.quiet}, words_of(options, made, shared));
}

}  // namespace lacuna::cli
