// The options of `lacuna compare`, and its run.
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/options/given_files.h"
#include "cli/reports/comparison.h"
#include "cli/reports/output.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/observers.h"
#include "cli/terminal/progress_bar.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "options/make.h"
#include "options/read.h"
#include "options/settle.h"
#include "stipple/dot_count.h"
#include "stipple/place_dots.h"

namespace lacuna::cli {
namespace {

constexpr const char* kCompareDescription =
    R"(Makes one set on every backend and device, compares the points, and measures the times.

Examples:
  lacuna compare --radius 0.005 --torus                 a table on standard output
  lacuna compare photo.jpg --count 20000 --relax 15     the same for dots of a picture, relaxed
  lacuna compare --radius 0.002 --runs 9 --backends cpu,opencl --json a.json -o chart.svg
  lacuna compare --radius 0.05 --backends reference,cpu

The other options are those of sample or, with a picture, of stipple, and give the same points. But
points are relaxed only if --relax is given. The host makes a stratified start by itself, so only
the relaxing is compared then. The backends take turns, so that a busy machine slows all of them
alike. The first run of each backend is not timed. It shows only in `first use`, which is its extra
time: finding devices, building kernels. `memory` is the growth of the program's peak memory in the
first run. The times of the steps of a round come from one more run, in which a device waits for
each step.

With --work tables come first that say what each device was asked to do in a round of placing
points: launches of kernels, waits of the host, transfers and their bytes, then the launches and
items of each kernel and its milliseconds in one run, by the device's clock. These counts are the
same on every device of a kind, so that they can be compared where times cannot.

Exit code: 0 all points are the same, 1 they differ, 2 bad usage, 3 a file cannot be read or
written, 4 a backend named with --backends is missing, or all are, or one failed at work, 130
interrupted (143 by SIGTERM).
)";

struct CompareCommand {
    Request request;
    Picture picture;
    std::vector<std::string> backends;
    std::uint32_t runs = 5;
    options::Choices given;
    std::uint32_t relax = 0;  // as `given` says
    bool work = false;
    std::string json;
    OutputOptions charts;
    bool quiet = false;
};

// Splits at commas and removes blanks. The caller refuses empty names.
std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> names;
    for (std::string& name : options::parts_of_list(text)) {
        name.erase(0, name.find_first_not_of(' '));
        name.erase(name.find_last_not_of(' ') + 1);
        names.push_back(std::move(name));
    }
    return names;
}

// Checks the options and files before the work starts.
std::vector<Output> check(const CommandLine& line, const CompareCommand& options) {
    constexpr std::uint32_t kMostRuns = 1000;
    if (options.runs < 1 || options.runs > kMostRuns)
        throw BadRequest("runs", std::to_string(options.runs),
                         fmt::format("must be between 1 and {}", kMostRuns));
    std::vector<Output> charts = outputs_of(options.charts, files::picture_extensions(), "svg");
    std::vector<GivenFile> written = given_files(charts);
    if (!options.json.empty()) {
        check_json("json", options.json);
        written.push_back({"--json", options.json});
    }
    if (!has_standard_output(charts) && !is_standard_output(options.json))
        written.push_back({"--output", "-"});
    check_given_files(files_read(line), written);
    return charts;
}

// Shows the progress of all runs together.
class Runs : public Observer {
public:
    Runs(std::size_t all, bool quiet) : bar_(quiet), all_(all) {}

    void start(const Request& request) {
        words_ = fmt::format("run {} of {}: {}", ++started_, all_, request.run_on.backend);
    }
    bool keep_going(const Progress& progress) override {
        const auto expected =
            static_cast<double>(std::max<std::uint64_t>(progress.expected_points, 1));
        const double share = std::min(1.0, static_cast<double>(progress.points) / expected);
        bar_.show((static_cast<double>(started_ - 1) + share) / static_cast<double>(all_), words_);
        return true;
    }

private:
    ProgressBar bar_;
    std::size_t all_;
    std::size_t started_ = 0;
    std::string words_;
};

Comparison compared(const CompareCommand& options, const Request& request, const Sampler& sampler) {
    const std::vector<Contestant> contestants = find_contestants(options.backends);
    Runs runs(contestants.size() * (options.runs + std::size_t{2}), options.quiet);
    const Sampler shown = [&](const Request& one, Observer& observer) {
        runs.start(one);
        if (options.relax == 0) return sampler(one, observer);
        const options::Moves moves{.iterations = options.relax};
        if (options.given.is_picture)
            return stippling::place_dots(one, {}, {}, moves, stippling::Edges::open, observer)
                .result;
        return options::move_on({.result = sampler(one, observer)}, one, moves, observer).result;
    };
    return compare(request, contestants, options.runs, shown, runs);
}

void write(const CompareCommand& options, const std::vector<Output>& charts, const Request& request,
           const Comparison& comparison, Interruption& interruption) {
    Writing writing(interruption);
    if (!options.json.empty())
        writing.add(options.json, [&] { return json_of(comparison, request); });
    for (const Output& chart : charts)
        writing.add(chart.path, [&] { return draw_chart(comparison, *chart.format.medium); });
    if (!has_standard_output(charts) && !is_standard_output(options.json))
        writing.add(
            "-", [&] { return (options.work ? work_text(comparison) : "") + text_of(comparison); });
    writing.write();
}

// Chooses the exit code. The tables have been printed.
void end(const CompareCommand& options, const Comparison& comparison) {
    if (!comparison.agree()) throw CheckFailed();
    for (const Entry& entry : comparison.entries)
        if (entry.broke_off ||
            (!entry.failure.empty() && (!options.backends.empty() || !comparison.yardstick())))
            throw Unavailable(entry.failure);
}

// Decides what was not given.
CompareCommand settled(CompareCommand options) {
    options.given.is_picture = !options.picture.path.empty();
    options.given.has_ellipses = options.picture.importance.along != 1;
    options.given.metric = options.picture.metric;
    options.given.relax = options.given.relax.value_or(0);
    options.relax = *options.given.relax;
    options::settle(options.given, options.request);
    return options;
}

void run(const CommandLine& line, const CompareCommand& given, const Sampler& sampler) {
    const CompareCommand options = settled(given);
    const std::vector<Output> charts = check(line, options);
    Request request = options.request;
    Field field;
    if (options.given.is_picture) {
        field = read_field(options.picture);
        request.field = &field;
        take_shape(domain_around({}, &field), request);
        if (!request.count && !request.scale)
            request.count = stippling::dot_count(field, request.domain);
    }
    Interruption interruption;
    const Comparison comparison = compared(options, request, sampler);
    write(options, charts, request, comparison, interruption);
    end(options, comparison);
}

void take_backends(const std::string& text, std::vector<std::string>& backends) {
    backends = split(text);
}

// Where the value of each option goes.
Targets targets_of(CompareCommand& all) {
    Targets targets{
        {"IMAGE", &all.picture.path}, {"backends", take_by<take_backends>(all.backends)},
        {"runs", &all.runs},          {"work", &all.work},
        {"json", &all.json},          {"mode", &all.given.mode},
        {"relax", &all.given.relax},  {"quiet", &all.quiet}};
    targets.merge(options::targets_of(all.request));
    targets.merge(targets_of(all.picture));
    targets.merge(targets_of(all.charts));
    return targets;
}

}  // namespace

void add_compare(CLI::App& app, const Sampler& sampler) {
    const auto all = std::make_shared<CompareCommand>();
    add_command(app, options::kCompare, kCompareDescription, targets_of(*all),
                [all, sampler](const CommandLine& line) { run(line, *all, sampler); });
}

}  // namespace lacuna::cli
