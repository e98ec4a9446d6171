// The options of `lacuna analyze`, and its run.
#include "base/number_text.h"
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/analyse.h"
#include "analysis/sheet.h"
#include "checks/domain.h"
#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/reports/output.h"
#include "cli/reports/report.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/progress_bar.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "options/read.h"
#include "verify/domain.h"

namespace lacuna::cli {
namespace {

constexpr const char* kAnalyzeDescription =
    R"(Prints the spectrum and statistics of point sets. Several sets are averaged.

Examples:
  lacuna analyze points.txt --torus                 numbers on standard output
  lacuna analyze a.json -o sheet.pdf -o a-numbers.json   a plot sheet, and all numbers
  lacuna analyze a.json --json                      all numbers on standard output
  lacuna analyze set*.txt --radius 0.01 --torus     the mean of many sets
  lacuna sample --radius 0.01 | lacuna analyze - --radius 0.01

Power is P(k) = |sum of exp(-2 pi i k.x)|^2 / count at whole numbers k, or at (kx / W, ky / H) if
the domain is not the unit square. Its mean is taken over rings of width 2, for |k| up to 2
sqrt(count), or up to --max-frequency times sqrt(count); time and memory grow with the square of
that factor. The relative radius is the least distance divided by that of the hexagonal lattice. For
the effective Nyquist frequency, in units of sqrt(count) / 2, and oscillations see Heck, Schloemer &
Deussen 2013; for the bond order of the six nearest neighbours see Nelson & Halperin 1979. A million
points take seconds and about 400 MB.

A .txt has `x y` on each line; its first line may be the count, as in files of PSA. The domain,
boundary and radius in a .json are used unless an option gives them.

Exit code: 0 done, 2 bad usage, 3 a file cannot be read or written, 4 the system refuses threads,
130 interrupted (143 by SIGTERM).
)";

struct AnalyzeCommand {
    std::vector<std::string> files;
    OutputOptions output;
    std::optional<Domain> sides;
    std::optional<double> radius;
    std::optional<Ellipse> ellipse;
    analysis::Effort effort;
    bool torus = false;
    bool json = false;
    bool quiet = false;
};

// All sets of all files, and the domain and boundary that the files give.
struct Input {
    std::vector<std::vector<Point>> sets;
    std::vector<std::optional<double>> radii;  // one for each set
    std::vector<std::string> names;            // one for each set, for messages
    std::optional<Domain> sides;
    std::string sides_from;  // the file that gives them
    std::optional<Boundary> boundary;
    std::string boundary_from;
};

// Checks the options and files before the work starts.
std::vector<Output> check(const CommandLine& line, const AnalyzeCommand& options) {
    if (options.sides) check_domain(*options.sides);
    if (options.radius) analysis::check_radius(*options.radius);
    analysis::check_effort(options.effort);
    OutputOptions asked = options.output;
    if (options.json) asked.paths.emplace_back("-");
    std::vector<Output> outputs = outputs_of(asked, ".json " + files::picture_extensions(), "json");
    std::vector<GivenFile> written = given_files(outputs);
    if (!has_standard_output(outputs)) written.push_back({"--output", "-"});
    check_given_files(files_read(line), written);
    return outputs;
}

void add_sides(Input& input, const files::PointsOfFile& file, const std::string& name) {
    if (!file.domain) return;
    const Domain& sides = *file.domain;
    try {
        check_domain(sides);
    } catch (const BadRequest& error) {
        throw files::FileError(name + ": " + error.what());
    }
    if (input.sides && *input.sides != sides)
        throw files::FileError(
            fmt::format("{}: its domain is {}, but {} has {}: analyse them separately, or give "
                        "--domain",
                        name, text_of(sides), input.sides_from, text_of(*input.sides)));
    input.sides = sides;
    input.sides_from = name;
}

void add_boundary(Input& input, const files::PointsOfFile& file, const std::string& name) {
    if (!file.boundary) return;
    if (input.boundary && *input.boundary != *file.boundary)
        throw files::FileError(fmt::format(
            "{}: its boundary differs from {}: analyse them separately, or give --torus", name,
            input.boundary_from));
    input.boundary = file.boundary;
    input.boundary_from = name;
}

// Without this check, files that give no domain would be analysed on the domain of another file.
void check_told(const Input& input, const std::vector<std::string>& silent) {
    const bool is_usual = !input.sides || *input.sides == Domain{};
    if (is_usual || silent.empty()) return;
    throw files::FileError(fmt::format("{}: gives no domain, but {} gives {}: give --domain",
                                       silent.front(), input.sides_from, text_of(*input.sides)));
}

Input read_input(const AnalyzeCommand& options) {
    Input input;
    std::vector<std::string> silent;  // files that give no domain
    for (const std::string& path : options.files) {
        files::PointsOfFile file = files::read_points(path);
        const std::string name = path == "-" ? "standard input" : path;
        if (!options.sides) add_sides(input, file, name);
        if (!options.sides && !file.domain) silent.push_back(name);
        if (!options.torus) add_boundary(input, file, name);
        if (file.points.empty()) files::refuse(name, "there is no point to analyse");
        input.names.push_back(name);
        input.radii.push_back(options.radius ? options.radius : file.radius);
        input.sets.push_back(std::move(file.points));
    }
    check_told(input, silent);
    return input;
}

// Refuses points outside of the domain. The upper edges are allowed: programs that write float32
// may round up to them.
void check_inside(const Input& input, const Domain& domain) {
    for (std::size_t i = 0; i < input.sets.size(); ++i) {
        const std::vector<Point>& points = input.sets[i];
        const auto outside = std::find_if_not(points.begin(), points.end(),
                                              [&](const Point& p) { return domain.holds(p); });
        if (outside == points.end()) continue;
        throw files::FileError(
            fmt::format("{}: point {} at ({}, {}) lies outside the domain {}: give --domain",
                        input.names[i], std::distance(points.begin(), outside), outside->x,
                        outside->y, extent_of(domain, ']')));
    }
}

// The ellipse must lie along a side of the domain, so that compressing leaves a rectangle.
Ellipse upright_ellipse_from(const std::string& text) {
    const Ellipse ellipse = ellipse_from(text);
    constexpr double kRounding = 1e-9;
    if (std::abs(std::sin(2 * ellipse.angle)) > kRounding)
        throw BadRequest("stretch", shown(text),
                         "the angle must be a multiple of 90 degrees: compressed along other "
                         "axes, the domain would be no rectangle");
    return ellipse;
}

// Compresses the sets and the domain so that the ellipse becomes a disk of its area.
void compress(const Ellipse& ellipse, Input& input, analysis::Domain& domain) {
    const double root = std::sqrt(ellipse.a / ellipse.b);
    const double x = std::abs(std::cos(ellipse.angle)) > 0.5 ? root : 1 / root;
    domain.width /= x;
    domain.height *= x;
    domain.x0 /= x;
    domain.y0 *= x;
    for (std::vector<Point>& points : input.sets)
        for (Point& point : points) point = {point.x / x, point.y * x};
    for (std::optional<double>& radius : input.radii)
        if (!radius) radius = std::sqrt(ellipse.a * ellipse.b);
}

analysis::Analysis analyse(const Input& input, const analysis::Domain& domain,
                           const AnalyzeCommand& options) {
    ProgressBar bar(options.quiet);
    const std::string words =
        fmt::format("analysing {} set{}", input.sets.size(), input.sets.size() == 1 ? "" : "s");
    const auto keep_going = [&](double share) {
        bar.show_time_to_go(share, words);
        return true;
    };
    return analysis::analyse(input.sets, domain, input.radii, keep_going, options.effort);
}

void run(const CommandLine& line, const AnalyzeCommand& options) {
    const std::vector<Output> outputs = check(line, options);
    Interruption interruption;
    Input input = read_input(options);
    const Domain sides = options.sides.value_or(input.sides.value_or(Domain{}));
    check_inside(input, sides);
    analysis::Domain domain = verify::domain_of(sides);
    domain.torus = options.torus || input.boundary == Boundary::torus;
    if (options.ellipse) compress(*options.ellipse, input, domain);
    const analysis::Analysis analysis = analyse(input, domain, options);

    Writing writing(interruption);
    for (const Output& output : outputs)
        writing.add(output.path, [&] {
            return output.format.medium
                       ? analysis::draw_sheet(analysis, input.sets.front(), *output.format.medium)
                       : json_of(analysis, options.files);
        });
    if (!has_standard_output(outputs)) writing.add("-", [&] { return text_of(analysis); });
    writing.write();
}

void take_sides(const std::string& text, std::optional<Domain>& sides) {
    options::read_domain("domain", text, sides.emplace());
}

void take_ellipse(const std::string& text, std::optional<Ellipse>& ellipse) {
    ellipse = upright_ellipse_from(text);
}

// Where the value of each option goes.
Targets targets_of(AnalyzeCommand& all) {
    Targets targets{{"FILE", &all.files},
                    {"domain", take_by<take_sides>(all.sides)},
                    {"torus", &all.torus},
                    {"radius", &all.radius},
                    {"stretch", take_by<take_ellipse>(all.ellipse)},
                    {"max-frequency", &all.effort.max_frequency},
                    {"threads", &all.effort.threads},
                    {"json", &all.json},
                    {"quiet", &all.quiet}};
    targets.merge(targets_of(all.output));
    return targets;
}

}  // namespace

void add_analyze(CLI::App& app) {
    const auto all = std::make_shared<AnalyzeCommand>();
    add_command(app, options::kAnalyze, kAnalyzeDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
