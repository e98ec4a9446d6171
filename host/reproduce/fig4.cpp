// Figure 4: the effect of m on the spectrum. r = 0.01 on the torus, means of 10 runs.
//
// The paper's top row is dart throwing that stopped at 6,400 samples, whose spectrum differs from a
// maximal set's. To separate this from the effect of m, sets of mode lines are compared with mode
// exact, which equals dart throwing until no room is left. The distance from exact's spectrum is
// the root mean square of P / P of exact - 1 over all frequencies with |k| r <= 1.6; P is the mean
// power of an annulus. The distance of two groups of exact sets is chance, and is taken off.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reproduce/picture.h"
#include "reproduce/reproduce.h"
#include "reproduce/sets.h"

namespace lacuna::reproduce {
namespace {

constexpr double kFig4Radius = 0.01;
constexpr std::uint64_t kDarts = 6400;
constexpr std::uint32_t kFig4Runs = 10;
constexpr std::array<std::uint32_t, 5> kLines{30, 10, 5, 2, 1};

struct Row {
    std::string name;
    analysis::Analysis analysis;
};

// The rows of the figure, in its order.
struct Rows {
    Row darts;
    Row exact;
    Row again;  // exact with other seeds: their distance is chance
    std::vector<Row> lines;
};

Rows make(const Setting& setting) {
    const std::uint32_t runs = setting.runs.value_or(kFig4Runs);
    Work work(setting, runs * (3.0 + kLines.size()));
    const auto analysed = [&](const Sets& sets) {
        return analyse_on_torus(sets.points, kFig4Radius, work);
    };
    Request request;
    request.radius = kFig4Radius;
    request.domain.boundary = Boundary::torus;
    request.run_on.backend = "cpu";
    Rows rows;
    rows.darts = {fmt::format("Dart throwing, {}", kDarts),
                  analysed(throw_sets(request, kDarts, runs, work))};
    rows.exact = {"Exact", analysed(make_sets(request, runs, work))};
    request.seed = runs;
    rows.again = {"Exact, other seeds", analysed(make_sets(request, runs, work))};
    // x is interpolated, as section 4.1 says.
    request.seed = 0;
    request.mode = Mode::lines;
    for (const std::uint32_t m : kLines) {
        request.paper2011.lines_per_radius = m;
        rows.lines.push_back({fmt::format("m = {}", m), analysed(make_sets(request, runs, work))});
    }
    return rows;
}

double distance(const analysis::Analysis& a, const analysis::Analysis& reference) {
    constexpr double kReach = 1.6 / kFig4Radius;
    double sum = 0;
    double modes = 0;
    const std::size_t annuli =
        std::min({a.radial.annuli.size(), reference.radial.annuli.size(),
                  static_cast<std::size_t>(kReach / analysis::kAnnulusWidth)});
    for (std::size_t i = 0; i < annuli; ++i) {
        const analysis::Annulus& annulus = a.radial.annuli[i];
        const double off = annulus.power / reference.radial.annuli[i].power - 1;
        sum += static_cast<double>(annulus.modes) * off * off;
        modes += static_cast<double>(annulus.modes);
    }
    return std::sqrt(sum / modes);
}

void draw_row(Canvas& canvas, double top, const Row& row, Colour colour) {
    const Rectangle square{20, top, 100, 100};
    draw_title(canvas, square, row.name);
    draw_periodogram(canvas, square, row.analysis.spectrum, 1.4, 2);
    draw_radial_power(canvas, {190, top, 190, 100}, "Radial power", row.analysis.radial, colour);
    draw_anisotropy(canvas, {430, top, 190, 100}, "Anisotropy", row.analysis, colour);
}

std::string draw(const Rows& rows, files::Medium medium) {
    constexpr double kStep = 148;
    const auto canvas =
        drawing::make_canvas(medium, 640, 20 + kStep * static_cast<double>(2 + rows.lines.size()));
    double top = 24;
    const auto next = [&](const Row& row, Colour colour) {
        draw_row(*canvas, top, row, colour);
        top += kStep;
    };
    next(rows.darts, kInk);
    next(rows.exact, kInk);
    for (const Row& row : rows.lines) next(row, kColours[0]);
    return canvas->finish();
}

// The part of a distance that chance does not explain.
double degradation(const Row& row, const Rows& rows, double chance) {
    const double all = distance(row.analysis, rows.exact.analysis);
    return std::sqrt(std::max(0.0, all * all - chance * chance));
}

// The anisotropy converted to 10 runs: if no direction is preferred, it is -10 log10(runs).
double anisotropy_of(const Row& row) {
    return *row.analysis.radial.mean_anisotropy_db() +
           10 * std::log10(static_cast<double>(row.analysis.sets) / kFig4Runs);
}

std::vector<Number> numbers_of(const Rows& rows, double chance) {
    // "These are similar to dart-throwing for values of m as low as 10" (5.1); "the quality is
    // reasonable until m = 10, but degrades when m is too small". The limit is ours.
    constexpr double kReasonable = 0.05;
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    std::vector<Number> numbers;
    for (const Row& row : rows.lines) {
        const bool is_reasonable = &row - rows.lines.data() < 2;
        numbers.push_back(
            in_words(row.name + ": power off exact's by", is_reasonable ? "reasonable" : "degrades",
                     degradation(row, rows, chance),
                     is_reasonable ? Band{0, kReasonable} : Band{kReasonable, kInfinite}));
    }
    // "a radial anisotropy of -10dB indicates perfect radial symmetry"
    for (const Row* row : {&rows.darts, &rows.lines[0], &rows.lines[1]})
        numbers.push_back(
            printed_about(row->name + ": anisotropy, dB", -10, anisotropy_of(*row), 0.3));
    // "our method generates 6,900 samples"
    numbers.push_back(printed("m = 30: samples", 6900, rows.lines[0].analysis.counts.mean, 0.5));
    return numbers;
}

}  // namespace

Reproduction fig4(const Setting& setting) {
    const Rows rows = make(setting);
    const double chance = distance(rows.again.analysis, rows.exact.analysis);
    Reproduction made;
    made.data = {{"distance_by_chance", chance}};
    const auto add = [&](const Row& row) {
        nlohmann::ordered_json json = json_of(row.analysis, 2);
        json["distance_to_exact"] = distance(row.analysis, rows.exact.analysis);
        made.data[row.name] = std::move(json);
    };
    add(rows.darts);
    add(rows.exact);
    for (const Row& row : rows.lines) add(row);
    made.numbers = numbers_of(rows, chance);
    made.medium = files::Medium::svg;
    made.picture = draw(rows, made.medium);
    return made;
}

}  // namespace lacuna::reproduce
