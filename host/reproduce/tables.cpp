// Makes the sets of a table for each method, and compares them row by row.
#include "reproduce/tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "reproduce/picture.h"
#include "reproduce/sets.h"

namespace lacuna::reproduce {
namespace {

using Json = nlohmann::ordered_json;

// Runs by radius; the paper has 100 at each. At the smallest radius a count varies by under 0.03 %.
constexpr std::array<std::uint32_t, 4> kTableRuns{100, 100, 20, 2};

struct Measured {
    double samples;
    double seconds;
    std::uint32_t runs;
};

// For each way, the measurements by index in kRadii.
using Measurements = std::map<Way, std::vector<Measured>>;

std::string_view name_of(Way way) {
    if (way == Way::cdf) return "lines";
    return way == Way::uniform_x ? "lines, uniform-x" : "exact";
}

Request request_of(Way way, double radius, Boundary boundary) {
    Request request = lines_request(radius, boundary);
    request.paper2011.uniform_x = way == Way::uniform_x;
    // Uniform-x runs in rounds of one draw anyway, and the reference is the fastest at these.
    if (request.paper2011.uniform_x) request.run_on.backend = "reference";
    if (way == Way::exact) {
        request.mode = Mode::exact;
        request.paper2011.snap = false;
    }
    return request;
}

std::size_t radii_of(const Setting& setting) {
    const double smallest = setting.smallest_radius.value_or(0);
    return static_cast<std::size_t>(
        std::count_if(kRadii.begin(), kRadii.end(), [=](double r) { return r >= smallest; }));
}

// Approximate microseconds for a sample.
double cost_of(Way way) {
    return way == Way::uniform_x ? 30 : 2;
}

Measurements measure(const Setting& setting, Boundary boundary, std::size_t radii) {
    constexpr std::array kWays{Way::cdf, Way::uniform_x, Way::exact};
    const auto runs_of = [&](std::size_t i) { return setting.runs.value_or(kTableRuns[i]); };
    const auto cost_at = [&](Way way, std::size_t i) {
        return cost_of(way) * expected_count({1, 1, boundary}, kRadii[i]);
    };
    double total = 0;
    for (std::size_t i = 0; i < radii; ++i)
        for (const Way way : kWays) total += runs_of(i) * cost_at(way, i);
    Work work(setting, total);
    Measurements measurements;
    for (std::size_t i = 0; i < radii; ++i) {
        for (const Way way : kWays) {
            const Sets sets =
                make_sets(request_of(way, kRadii[i], boundary), runs_of(i), work, cost_at(way, i));
            measurements[way].push_back({sets.mean_count(), sets.mean_seconds(), runs_of(i)});
        }
    }
    return measurements;
}

Number count_of(const PublishedRow& row, std::size_t i, const Measured& here) {
    // docs/design.md, section 5: a count's standard deviation is 0.244 sqrt(N).
    const double error = 0.244 / std::sqrt(row.samples[i] * here.runs);
    return printed(fmt::format("r = {}, {}: samples", kRadii[i], row.name), row.samples[i],
                   here.samples, std::max(0.5, 300 * error));
}

void draw_counts(Canvas& canvas, const Rectangle& box, std::span<const PublishedRow> rows,
                 const Measurements& here, std::size_t radii) {
    Plot plot(canvas, box, {2, 6, "log\u2081\u2080 of samples"}, {-1, 1, "%"});
    plot.draw_axes("Samples here over the paper's, less 1");
    std::vector<Key> keys;
    for (const double level : {-0.5, 0.0, 0.5}) plot.draw_level(level, "");
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::vector<Point> curve;
        for (std::size_t i = 0; i < radii; ++i)
            curve.push_back({std::log10(rows[r].samples[i]),
                             100 * (here.at(rows[r].way)[i].samples / rows[r].samples[i] - 1)});
        const Pen pen{kColours[r], 1.2};
        plot.draw_curve(curve, pen);
        keys.push_back({fmt::format("{} ({})", rows[r].name, name_of(rows[r].way)), pen});
    }
    draw_legend(canvas, box, keys);
}

void draw_times(Canvas& canvas, const Rectangle& box, std::span<const PublishedRow> rows,
                const Measurements& here, std::size_t radii) {
    Plot plot(canvas, box, {2, 6, "log\u2081\u2080 of samples"},
              {-4, 4, "log\u2081\u2080 of seconds"});
    plot.draw_axes("Time: the paper's dashed, here solid");
    std::vector<Key> keys;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::vector<Point> curve;
        for (std::size_t i = 0; i < kRadii.size(); ++i)
            curve.push_back({std::log10(rows[r].samples[i]), std::log10(rows[r].seconds[i])});
        keys.push_back({rows[r].name, {kColours[r], 1, true}});
        plot.draw_curve(curve, keys.back().pen);
    }
    for (const auto& entry : here) {
        const Way way = entry.first;
        const std::vector<Measured>& measured = entry.second;
        std::vector<Point> curve;
        for (std::size_t i = 0; i < radii; ++i)
            curve.push_back({std::log10(measured[i].samples), std::log10(measured[i].seconds)});
        // The curve has the colour of the first row that it is compared with.
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const PublishedRow& p) { return p.way == way; });
        keys.push_back({std::string(name_of(way)),
                        {kColours[static_cast<std::size_t>(row - rows.begin())], 1.4}});
        plot.draw_curve(curve, keys.back().pen);
    }
    draw_legend(canvas, box, keys);
}

Json data_of(const Measurements& here, Boundary boundary) {
    Json ways = Json::array();
    for (const auto& [way, measured] : here)
        for (std::size_t i = 0; i < measured.size(); ++i)
            ways.push_back({{"way", name_of(way)},
                            {"radius", kRadii[i]},
                            {"mean_samples", measured[i].samples},
                            {"mean_seconds", measured[i].seconds},
                            {"runs", measured[i].runs}});
    return {{"boundary", boundary == Boundary::torus ? "torus" : "box"},
            {"threads_per_set", 1},
            {"means", std::move(ways)}};
}

void add_darts(Reproduction& made, const Setting& setting, Boundary boundary,
               const PublishedDarts& darts) {
    if (darts.radius < setting.smallest_radius.value_or(0)) return;
    constexpr std::uint32_t kDartRuns = 4;
    const std::uint32_t runs = setting.runs.value_or(kDartRuns);
    Work work(setting, runs);
    const double seconds =
        throw_sets(lines_request(darts.radius, boundary), darts.samples, runs, work).mean_seconds();
    made.data["dart_throwing"] = {{"radius", darts.radius},
                                  {"samples", darts.samples},
                                  {"mean_seconds", seconds},
                                  {"runs", runs}};
    if (darts.seconds)
        made.numbers.push_back(
            timing(fmt::format("r = {}, {} darts: s", darts.radius, darts.samples), *darts.seconds,
                   seconds));
}

}  // namespace

Reproduction reproduce_table(const Setting& setting, Boundary boundary,
                             std::span<const PublishedRow> rows, const PublishedDarts& darts) {
    const std::size_t radii = radii_of(setting);
    const Measurements here = measure(setting, boundary, radii);
    Reproduction made;
    made.data = data_of(here, boundary);
    for (std::size_t i = 0; i < radii; ++i)
        for (const PublishedRow& row : rows)
            made.numbers.push_back(count_of(row, i, here.at(row.way)[i]));
    for (std::size_t i = 0; i < radii; ++i)
        for (const PublishedRow& row : rows)
            made.numbers.push_back(timing(fmt::format("r = {}, {}: s", kRadii[i], row.name),
                                          row.seconds[i], here.at(row.way)[i].seconds));
    add_darts(made, setting, boundary, darts);

    made.medium = files::Medium::svg;
    const auto canvas = drawing::make_canvas(made.medium, 640, 300);
    draw_counts(*canvas, {52, 30, 250, 220}, rows, here, radii);
    draw_times(*canvas, {368, 30, 250, 220}, rows, here, radii);
    made.picture = canvas->finish();
    return made;
}

}  // namespace lacuna::reproduce
