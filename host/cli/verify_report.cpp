// Writes what a proof came to.
#include "cli/verify_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/options.h"
#include "verify/verify.h"

namespace lacuna::cli {
namespace {

using Json = nlohmann::ordered_json;

bool is_torus(const Claim& claim) {
    return claim.boundary == Boundary::torus;
}

std::string text(const Point& point) {
    return fmt::format("({}, {})", point.x, point.y);
}

std::string numbered(const SetClaim& claim, std::size_t index) {
    return fmt::format("{} at {}", index, text(claim.points[index]));
}

std::string closest(const SetClaim& claim) {
    if (claim.points.size() < 2) return "none, for want of two points";
    const Proof& proof = claim.proof;
    return fmt::format("{} (points {} and {})", proof.least_distance, proof.first, proof.second);
}

std::string emptiest(const SetClaim& claim) {
    if (claim.points.empty()) return "anywhere, for want of a point";
    const Proof& proof = claim.proof;
    return fmt::format("{} from a point, at {}", proof.emptiest_distance, text(proof.emptiest));
}

std::string faults(const SetClaim& claim) {
    const Proof& proof = claim.proof;
    const bool has_room = !claim.distances_only && !proof.covered;
    std::string faults;
    if (!proof.kept)
        faults = fmt::format("points {} and {} are closer than {}", numbered(claim, proof.first),
                             numbered(claim, proof.second), claim.radius);
    if (!proof.kept && has_room) faults += ", and ";
    if (has_room) faults += fmt::format("there is room for a point at {}", text(proof.emptiest));
    return faults;
}

std::string text_of_one(const SetClaim& claim) {
    constexpr std::string_view kRow = "{:<18}{}\n";
    constexpr std::string_view kVerdictRow = "{:<18}{:<{}}   {}\n";
    std::string lines = fmt::format(kRow, "points", claim.points.size());
    lines += fmt::format(
        kRow, "domain",
        fmt::format("{} x {}, {}", claim.width, claim.height, is_torus(claim) ? "torus" : "box"));
    lines += fmt::format(kRow, "radius", claim.radius);
    if (!claim.distances_only) lines += fmt::format(kRow, "tolerance", *claim.tolerance);
    if (!claim.proof.outside) {
        const std::string pair = closest(claim);
        const std::string spot = claim.distances_only ? "" : emptiest(claim);
        const std::size_t width = std::max(pair.size(), spot.size());
        lines += fmt::format(kVerdictRow, "least distance", pair, width,
                             claim.proof.kept ? "kept" : "too close");
        if (!claim.distances_only)
            lines += fmt::format(kVerdictRow, "farthest spot", spot, width,
                                 claim.proof.covered ? "covered" : "not covered");
    }
    return lines + fmt::format(kRow, "verdict", claim.conclusion());
}

Json json_of(const Point& point) {
    return {point.x, point.y};
}

Json json_of_one(const SetClaim& claim) {
    const Proof& proof = claim.proof;
    Json json{{"file", claim.name},
              {"points", claim.points.size()},
              {"domain",
               {{"width", claim.width},
                {"height", claim.height},
                {"boundary", is_torus(claim) ? "torus" : "box"}}},
              {"radius", claim.radius},
              {"tolerance", claim.distances_only ? Json(nullptr) : Json(*claim.tolerance)},
              {"holds", claim.holds()},
              {"verdict", claim.conclusion()}};
    if (proof.outside) {
        json["outside"] = {{"point", *proof.outside},
                           {"at", json_of(claim.points[*proof.outside])}};
        return json;
    }
    json["distances_kept"] = proof.kept;
    json["closest_pair"] = nullptr;
    if (claim.points.size() >= 2)
        json["closest_pair"] = {{"points", {proof.first, proof.second}},
                                {"distance", proof.least_distance}};
    if (claim.distances_only) return json;
    json["covered"] = proof.covered;
    json["emptiest_spot"] = nullptr;
    if (!claim.points.empty())
        json["emptiest_spot"] = {{"at", json_of(proof.emptiest)},
                                 {"distance", proof.emptiest_distance}};
    return json;
}

}  // namespace

bool SetClaim::holds() const {
    return !proof.outside && proof.kept && (distances_only || proof.covered);
}

std::string SetClaim::conclusion() const {
    if (proof.outside) {
        const char end = is_torus(*this) ? ')' : ']';
        return fmt::format("refused: point {} lies outside the domain [0, {}{} x [0, {}{}",
                           numbered(*this, *proof.outside), width, end, height, end);
    }
    if (!holds())
        return fmt::format("{}: {}{}", proof.kept ? "not maximal" : "not a Poisson-disk set",
                           faults(*this),
                           proof.kept && !meant_to_be_maximal
                               ? "; the file says that it is not: see --distances-only"
                               : "");
    if (distances_only)
        return fmt::format(
            "a Poisson-disk set of radius {}; whether there is room for more was not asked",
            radius);
    if (!proof.maximal)
        return fmt::format(
            "a Poisson-disk set of radius {}, and no spot is farther than {} from a point: not "
            "proven maximal, as the tolerance is over {:.0f} % of the radius",
            radius, radius + *tolerance, 100 * verify::kMostTolerance);
    return fmt::format("a maximal Poisson-disk set of radius {}, to a tolerance of {}", radius,
                       *tolerance);
}

std::string text_of(const std::vector<SetClaim>& claims) {
    if (claims.size() == 1) return text_of_one(claims.front());
    std::string lines;
    for (const SetClaim& claim : claims)
        lines += fmt::format("{}{:<18}{}\n{}", lines.empty() ? "" : "\n", "file",
                             printable(claim.name), text_of_one(claim));
    return lines;
}

std::string json_of(const std::vector<SetClaim>& claims) {
    Json report{{"program", "lacuna"},
                {"version", LACUNA_VERSION},
                {"all_hold", std::all_of(claims.begin(), claims.end(),
                                         [](const SetClaim& claim) { return claim.holds(); })},
                {"sets", Json::array()}};
    for (const SetClaim& claim : claims) report["sets"].push_back(json_of_one(claim));
    // File names are bytes, and need not be UTF-8.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna::cli
