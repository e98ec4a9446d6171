// Writes the numbers of an analysis.
#include "cli/reports/report.h"

#include <lacuna/version.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "checks/domain.h"

namespace lacuna::cli {
namespace {

using analysis::Analysis;

constexpr std::array kFrequencies{0.5, 0.7, 0.9, 1.0, 1.1, 1.3, 1.5, 2.0};

// Lines of a name and a value.
class Rows {
public:
    template <class... Values>
    void add(std::string_view name, fmt::format_string<Values...> format, Values&&... values) {
        text_ +=
            fmt::format("{:<24}{}\n", name, fmt::format(format, std::forward<Values>(values)...));
    }
    void none(std::string_view name, std::string_view why) { add(name, "none: {}", why); }

    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void add_counts(Rows& rows, const Analysis& a) {
    rows.add("sets", "{}", a.sets);
    if (a.counts.least == a.counts.most) {
        rows.add("points a set", "{}", a.counts.most);
    } else {
        rows.add("points a set", "{} to {}, mean {:.6g}", a.counts.least, a.counts.most,
                 a.counts.mean);
    }
    rows.add("domain", "{} x {}{}, {}", a.domain.width, a.domain.height,
             corner_text(a.domain.x0, a.domain.y0), a.domain.torus ? "torus" : "box");
    if (!a.radius) return;
    rows.add("radius", "{:.6g}", *a.radius);
    rows.add("count * radius^2 / area", "{:.5f}", *a.count_times_squared_radius);
}

void add_distances(Rows& rows, const Analysis& a) {
    if (!a.distances) {
        rows.none("least distance", "a set has only one point");
        return;
    }
    rows.add("least distance", "{:.6g}", a.distances->least);
    rows.add("relative radius", "{:.4f}", a.distances->relative_radius);
    if (a.radius) {
        rows.add("mean nearest neighbour", "{:.6g}, {:.4f} radii", a.distances->mean,
                 a.distances->mean / *a.radius);
    } else {
        rows.add("mean nearest neighbour", "{:.6g}", a.distances->mean);
    }
    if (a.distances->contact)
        rows.add("pairs at contact", "{:.3f} (g from 1 to {} radii)", *a.distances->contact,
                 analysis::kContactEnd);
}

void add_line(Rows& rows, std::string_view name, const std::optional<analysis::LinePower>& line) {
    if (line) {
        rows.add(name, "{:.4f} of the rest", line->ratio);
    } else {
        rows.none(name, "no power");
    }
}

// The entries of kFrequencies up to `farthest`; also `farthest` if it is less or more than all.
std::vector<double> frequencies_up_to(double farthest) {
    std::vector<double> frequencies;
    for (const double frequency : kFrequencies)
        if (frequency <= farthest) frequencies.push_back(frequency);
    if (frequencies.empty() || farthest > kFrequencies.back()) frequencies.push_back(farthest);
    return frequencies;
}

void add_spectrum(Rows& rows, const Analysis& a) {
    std::string heads;
    std::string powers;
    for (const double frequency : frequencies_up_to(a.max_frequency)) {
        heads += fmt::format("{:<7g}", frequency);
        powers += fmt::format("{:<7.3f}", a.radial.at(frequency).power);
    }
    heads.erase(heads.find_last_not_of(' ') + 1);
    powers.erase(powers.find_last_not_of(' ') + 1);
    rows.add("k / sqrt(count)", "{}", heads);
    rows.add("radial power", "{}", powers);
    // Less than kRounded may be what rounding leaves.
    constexpr double kLow = 0.3, kRounded = 1e-12;
    const double below = std::min(kLow, a.max_frequency);
    if (const auto low = analysis::mean_power_below(a.spectrum, below))
        rows.add("low frequencies", "power {} below {:g}",
                 *low < kRounded ? "under 1e-12" : fmt::format("{:.2g}", *low), below);
    const analysis::Annulus& peak = a.radial.peak();
    rows.add("peak power", "{:.4g} at {:.3f}", peak.power, peak.frequency);
    if (const auto mean = a.radial.mean_anisotropy_db()) {
        rows.add("mean anisotropy", "{:.2f} dB", *mean);
    } else {
        rows.none("mean anisotropy", "no spread of power in any annulus");
    }
    add_line(rows, "power on line kx = 0", a.vertical_line);
    add_line(rows, "power on line ky = 0", a.horizontal_line);
}

void add_order(Rows& rows, const Analysis& a) {
    if (a.effective_nyquist) {
        rows.add("effective Nyquist", "{:.4f}", *a.effective_nyquist);
    } else {
        rows.none("effective Nyquist", "the power stays under 0.5");
    }
    if (a.oscillations) {
        rows.add("oscillations", "{:.4f}", *a.oscillations);
    } else {
        rows.none("oscillations", "too few points");
    }
    if (a.bond_order) {
        rows.add("bond order psi_6", "local {:.4f}, global {:.4f}", a.bond_order->local,
                 a.bond_order->global);
    } else {
        rows.none("bond order psi_6", "too few points");
    }
}

Json json_of_distances(const Analysis& a) {
    if (!a.distances) return nullptr;
    const analysis::Distances& d = *a.distances;
    return {{"least_distance", d.least},
            {"relative_radius", d.relative_radius},
            {"mean_distance", d.mean},
            {"mean_distance_over_radius", a.radius ? Json(d.mean / *a.radius) : Json(nullptr)},
            {"histogram",
             {{"bin_width_over_mean_spacing", analysis::kNearestBin},
              {"shares_of_points", d.nearest_shares},
              {"share_beyond", d.nearest_beyond}}}};
}

Json json_of_pairs(const Analysis& a) {
    if (!a.distances) return nullptr;
    const analysis::Distances& d = *a.distances;
    return {{"bin_width_over_mean_spacing", analysis::kReportedPairBin},
            {"g", d.pair_correlation},
            {"contact",
             {{"from_radii", 1}, {"to_radii", analysis::kContactEnd}, {"g", or_null(d.contact)}}}};
}

Json json_of_line(const std::optional<analysis::LinePower>& line) {
    if (!line) return nullptr;
    return {{"power_over_rest", line->ratio}, {"frequencies", line->modes}};
}

Json json_of_spectrum(const Analysis& a) {
    Json frequencies = Json::array();
    Json powers = Json::array();
    Json anisotropies = Json::array();
    Json modes = Json::array();
    for (const analysis::Annulus& annulus : a.radial.annuli) {
        frequencies.push_back(annulus.frequency);
        powers.push_back(annulus.power);
        anisotropies.push_back(or_null(annulus.anisotropy_db));
        modes.push_back(annulus.modes);
    }
    const analysis::Annulus& peak = a.radial.peak();
    return {{"max_k_over_sqrt_count", a.max_frequency},
            {"annulus_width_in_k", analysis::kAnnulusWidth},
            {"radial",
             {{"k_over_sqrt_count", frequencies},
              {"mean_power", powers},
              {"anisotropy_db", anisotropies},
              {"frequencies_of_half_plane", modes}}},
            {"peak", {{"k_over_sqrt_count", peak.frequency}, {"mean_power", peak.power}}},
            {"mean_anisotropy_db", or_null(a.radial.mean_anisotropy_db())},
            {"line_kx_0", json_of_line(a.vertical_line)},
            {"line_ky_0", json_of_line(a.horizontal_line)},
            {"effective_nyquist_over_half_sqrt_count", or_null(a.effective_nyquist)},
            {"oscillations", or_null(a.oscillations)}};
}

Json json_of_order(const Analysis& a) {
    if (!a.bond_order) return nullptr;
    return {{"mean_of_abs_psi_6", a.bond_order->local},
            {"abs_of_mean_psi_6", a.bond_order->global},
            {"points", a.bond_order->points}};
}

}  // namespace

std::string text_of(const Analysis& analysis) {
    Rows rows;
    add_counts(rows, analysis);
    add_distances(rows, analysis);
    add_spectrum(rows, analysis);
    add_order(rows, analysis);
    return rows.take();
}

std::string json_of(const Analysis& a, const std::vector<std::string>& files) {
    Json report = {{"program", "lacuna"},
                   {"version", LACUNA_VERSION},
                   {"files", files},
                   {"sets", a.sets},
                   {"points_a_set",
                    {{"least", a.counts.least}, {"mean", a.counts.mean}, {"most", a.counts.most}}},
                   {"domain",
                    {{"width", a.domain.width},
                     {"height", a.domain.height},
                     {"boundary", a.domain.torus ? "torus" : "box"}}},
                   {"radius", or_null(a.radius)},
                   {"count_times_squared_radius_over_area", or_null(a.count_times_squared_radius)},
                   {"nearest_neighbour", json_of_distances(a)},
                   {"pair_correlation", json_of_pairs(a)},
                   {"spectrum", json_of_spectrum(a)},
                   {"bond_orientational_order", json_of_order(a)}};
    if (a.domain.x0 != 0 || a.domain.y0 != 0)
        report["domain"].update({{"x0", a.domain.x0}, {"y0", a.domain.y0}});
    // File names are bytes, which need not be UTF-8.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna::cli
