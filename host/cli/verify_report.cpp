// Writes what a proof came to.
#include "cli/verify_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/options.h"

namespace lacuna::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string text(const Point& point) {
    return fmt::format("({}, {})", point.x, point.y);
}

std::string numbered(const Claim& claim, std::size_t index) {
    return fmt::format("{} at {}", index, text(claim.points[index]));
}

std::string closest(const Claim& claim) {
    if (claim.points.size() < 2) return "none, for want of two points";
    const verify::Pair& pair = claim.verdict.closest;
    return fmt::format("{} (points {} and {})", pair.distance, pair.first, pair.second);
}

std::string emptiest(const Claim& claim) {
    if (claim.points.empty()) return "anywhere, for want of a point";
    const verify::Spot& spot = claim.verdict.emptiest;
    return fmt::format("{} from a point, at {}", spot.distance, text(spot.at));
}

std::string faults(const Claim& claim) {
    const verify::Verdict& verdict = claim.verdict;
    const bool has_room = !claim.distances_only && !verdict.covered;
    std::string faults;
    if (!verdict.kept)
        faults = fmt::format("points {} and {} are closer than {}",
                             numbered(claim, verdict.closest.first),
                             numbered(claim, verdict.closest.second), claim.radius);
    if (!verdict.kept && has_room) faults += ", and ";
    if (has_room)
        faults += fmt::format("there is room for a point at {}", text(verdict.emptiest.at));
    return faults;
}

std::string text_of_one(const Claim& claim) {
    constexpr std::string_view kRow = "{:<18}{}\n";
    constexpr std::string_view kVerdictRow = "{:<18}{:<{}}   {}\n";
    std::string lines = fmt::format(kRow, "points", claim.points.size());
    lines += fmt::format(
        kRow, "domain",
        fmt::format("{} x {}, {}", claim.width, claim.height, claim.torus ? "torus" : "box"));
    lines += fmt::format(kRow, "radius", claim.radius);
    if (!claim.distances_only) lines += fmt::format(kRow, "tolerance", claim.tolerance);
    if (!claim.verdict.outside) {
        const std::string pair = closest(claim);
        const std::string spot = claim.distances_only ? "" : emptiest(claim);
        const std::size_t width = std::max(pair.size(), spot.size());
        lines += fmt::format(kVerdictRow, "least distance", pair, width,
                             claim.verdict.kept ? "kept" : "too close");
        if (!claim.distances_only)
            lines += fmt::format(kVerdictRow, "farthest spot", spot, width,
                                 claim.verdict.covered ? "covered" : "not covered");
    }
    return lines + fmt::format(kRow, "verdict", claim.conclusion());
}

Json json_of(const Point& point) {
    return {point.x, point.y};
}

Json json_of_one(const Claim& claim) {
    const verify::Verdict& verdict = claim.verdict;
    Json json{{"file", claim.name},
              {"points", claim.points.size()},
              {"domain",
               {{"width", claim.width},
                {"height", claim.height},
                {"boundary", claim.torus ? "torus" : "box"}}},
              {"radius", claim.radius},
              {"tolerance", claim.distances_only ? Json(nullptr) : Json(claim.tolerance)},
              {"holds", claim.holds()},
              {"verdict", claim.conclusion()}};
    if (verdict.outside) {
        json["outside"] = {{"point", *verdict.outside},
                           {"at", json_of(claim.points[*verdict.outside])}};
        return json;
    }
    json["distances_kept"] = verdict.kept;
    json["closest_pair"] = nullptr;
    if (claim.points.size() >= 2)
        json["closest_pair"] = {{"points", {verdict.closest.first, verdict.closest.second}},
                                {"distance", verdict.closest.distance}};
    if (claim.distances_only) return json;
    json["covered"] = verdict.covered;
    json["emptiest_spot"] = nullptr;
    if (!claim.points.empty())
        json["emptiest_spot"] = {{"at", json_of(verdict.emptiest.at)},
                                 {"distance", verdict.emptiest.distance}};
    return json;
}

}  // namespace

bool Claim::holds() const {
    return !verdict.outside && verdict.kept && (distances_only || verdict.covered);
}

std::string Claim::conclusion() const {
    if (verdict.outside) {
        const char end = torus ? ')' : ']';
        return fmt::format("refused: point {} lies outside the domain [0, {}{} x [0, {}{}",
                           numbered(*this, *verdict.outside), width, end, height, end);
    }
    if (!holds())
        return fmt::format("{}: {}{}", verdict.kept ? "not maximal" : "not a Poisson-disk set",
                           faults(*this),
                           verdict.kept && !meant_to_be_maximal
                               ? "; the file says that it is not: see --distances-only"
                               : "");
    if (distances_only)
        return fmt::format(
            "a Poisson-disk set of radius {}; whether there is room for more was not asked",
            radius);
    if (tolerance > verify::kMostTolerance * radius)
        return fmt::format(
            "a Poisson-disk set of radius {}, and no spot is farther than {} from a point: not "
            "proven maximal, as the tolerance is over {:.0f} % of the radius",
            radius, radius + tolerance, 100 * verify::kMostTolerance);
    return fmt::format("a maximal Poisson-disk set of radius {}, to a tolerance of {}", radius,
                       tolerance);
}

std::string text_of(const std::vector<Claim>& claims) {
    if (claims.size() == 1) return text_of_one(claims.front());
    std::string lines;
    for (const Claim& claim : claims)
        lines += fmt::format("{}{:<18}{}\n{}", lines.empty() ? "" : "\n", "file",
                             printable(claim.name), text_of_one(claim));
    return lines;
}

std::string json_of(const std::vector<Claim>& claims) {
    Json report{{"program", "lacuna"},
                {"version", LACUNA_VERSION},
                {"all_hold", std::all_of(claims.begin(), claims.end(),
                                         [](const Claim& claim) { return claim.holds(); })},
                {"sets", Json::array()}};
    for (const Claim& claim : claims) report["sets"].push_back(json_of_one(claim));
    // File names are bytes, and need not be UTF-8.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna::cli
