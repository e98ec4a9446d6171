// Writes reports about proofs.
#include "cli/reports/verify_report.h"

#include <lacuna/version.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "checks/classes.h"
#include "checks/domain.h"
#include "cli/reports/report.h"
#include "cli/terminal/run_program.h"
#include "verify/neighbours.h"
#include "verify/verify.h"

namespace lacuna::cli {
namespace {

bool is_torus(const Claim& claim) {
    return claim.domain.wraps();
}

std::string text(const Point& point) {
    return fmt::format("({}, {})", point.x, point.y);
}

// A point of the set, or of --keep outside of it, as in "point 3" and "point 5 of FILE".
std::string named(const SetClaim& claim, std::size_t index) {
    if (index < claim.points.size()) return fmt::format("{}", index);
    return fmt::format("{} of {}", index - claim.points.size(), printable(claim.options.keep));
}

std::string numbered(const SetClaim& claim, std::size_t index) {
    const std::size_t count = claim.points.size();
    const bool is_own = index < count;
    const std::string at =
        fmt::format("{} at {}", named(claim, index),
                    text(is_own ? claim.points[index] : claim.keep[index - count]));
    if (claim.own_classes.empty()) return at;
    const auto kind = is_own ? claim.own_classes[index] : claim.keep_classes[index - count];
    return fmt::format("{}, of class {},", at, claim.classes.names[kind]);
}

// The points of the set and its neighbours.
std::size_t all_points(const SetClaim& claim) {
    return claim.points.size() + verify::neighbours_of(claim).points.size();
}

// The border of each class, or that of all; empty if there is none.
std::string borders(const SetClaim& claim) {
    const std::vector<double>& own = claim.places.borders;
    const double border = claim.places.border;
    if (own.empty()) return border == 0 ? "" : fmt::format("{}", border);
    std::string text;
    for (std::size_t i = 0; i < own.size(); ++i)
        text += fmt::format("{}{} of {}", i == 0 ? "" : ", ", own[i], claim.classes.names[i]);
    return text;
}

// Whether distances have limits of their own.
bool has_limits(const Claim& claim) {
    return claim.field != nullptr || !claim.classes.names.empty();
}

std::string closest(const SetClaim& claim) {
    if (all_points(claim) < 2) return "none, for want of two points";
    const Proof& proof = claim.proof;
    return fmt::format("{}{} (points {} and {})", proof.least_distance,
                       has_limits(claim) ? fmt::format(" of {}", proof.least_limit) : "",
                       named(claim, proof.first), named(claim, proof.second));
}

std::string largest_gap(const SetClaim& claim) {
    const Proof& proof = claim.proof;
    if (all_points(claim) == 0)
        return proof.covered ? "none, since points may lie nowhere"
                             : "anywhere, for want of a point";
    // With a field, mask, polygons or border, the search ends when it knows that all spots are
    // covered. It does not know then which gap is the largest.
    if (!verify::is_uniform(claim) && proof.covered) return "none over its limit";
    return fmt::format("{} from a point{}, at {}", proof.largest_gap_distance,
                       has_limits(claim) ? fmt::format(" of {}", proof.largest_gap_limit) : "",
                       text(proof.largest_gap));
}

std::string radius(const SetClaim& claim) {
    if (claim.field == nullptr) return fmt::format("{}", claim.radius);
    const auto [least, most] = claim.radii;
    if (most == 0) return fmt::format("scale {}, and no place for a point", claim.scale);
    return fmt::format("{} to {}, at scale {}", least, most, claim.scale);
}

// The names of kinds, with the number of sizes where a kind has several.
std::vector<std::string> kinds(const Classes& classes) {
    std::vector<std::string> kinds;
    for (std::size_t i = 0; i < classes.names.size(); ++i) {
        const std::size_t last = kind_of(classes, i).last;
        kinds.push_back(classes.names[i] +
                        (last > i ? fmt::format(" in {} sizes", last - i + 1) : ""));
        i = last;
    }
    return kinds;
}

// How many of the kept points are neighbours.
std::string outside_of(const SetClaim& claim) {
    const verify::Outside outside(claim);
    const auto count = std::count_if(claim.keep.begin(), claim.keep.end(),
                                     [&](Point point) { return outside.has(point); });
    return count == 0 ? "" : fmt::format(", {} of them outside of the domain", count);
}

// The rows about where points may lie.
std::string places(const SetClaim& claim) {
    const DomainOptions& given = claim.options;
    std::string rows;
    const auto append = [&](std::string_view name, const std::string& value) {
        rows += fmt::format("{:<18}{}\n", name, value);
    };
    if (!given.field.path.empty()) append("field", printable(given.field.path));
    if (!claim.classes.names.empty())
        append("classes", printable(fmt::format("{}", fmt::join(kinds(claim.classes), ", "))));
    for (const std::string& path : given.mask) append("mask", printable(path));
    const auto append_polygons = [&](std::string_view name, const std::vector<std::string>& paths) {
        for (const std::string& path : paths)
            append(name, fmt::format("{}, to an edge of {}", printable(path), *claim.places.edge));
    };
    for (const auto& [role, paths] : given.outlines) append_polygons(name_of(role), paths);
    if (const std::string border = borders(claim); !border.empty()) append("border", border);
    if (!given.keep.empty())
        append("kept", fmt::format("{}, {} point{}", printable(given.keep), claim.keep.size(),
                                   claim.keep.size() == 1 ? "" : "s") +
                           outside_of(claim));
    return rows;
}

std::string reason(const SetClaim& claim) {
    const std::vector<Outline>& outlines = claim.places.outlines;
    const auto is_inside = [](const Outline& one) { return one.role == Role::inside; };
    switch (claim.proof.forbidden_by) {
        case Proof::Closed::importance:
            return "where the field has no importance";
        case Proof::Closed::mask:
            return "where the mask lets none lie";
        case Proof::Closed::polygons:
            return std::all_of(outlines.begin(), outlines.end(), is_inside) &&
                           borders(claim).empty()
                       ? "outside the polygons"
                       : "where the polygons let none lie";
        case Proof::Closed::border:
            break;
    }
    return fmt::format("nearer than {} to an edge of the domain",
                       claim.places.borders.empty()
                           ? claim.places.border
                           : claim.places.borders[claim.own_classes[*claim.proof.forbidden]]);
}

// Why the proof ended before distances and gaps were looked at. Empty if it did not.
std::string refusal(const SetClaim& claim) {
    const Proof& proof = claim.proof;
    if (proof.outside) {
        return fmt::format("refused: point {} lies outside the domain {}",
                           numbered(claim, *proof.outside),
                           extent_of(claim.domain, is_torus(claim) ? ')' : ']'));
    }
    if (proof.moved)
        return fmt::format("refused: the set does not have point {} of {}, at {}, in its place",
                           *proof.moved, printable(claim.options.keep),
                           text(claim.keep[*proof.moved]));
    if (proof.miscounted)
        return fmt::format(
            "refused: class {} has {} points in place of {}",
            claim.classes.names[*proof.miscounted],
            std::count(claim.own_classes.begin(), claim.own_classes.end(), *proof.miscounted),
            *claim.classes.counts[*proof.miscounted]);
    if (proof.forbidden)
        return fmt::format("refused: point {} lies {}", numbered(claim, *proof.forbidden),
                           reason(claim));
    return "";
}

// The words that follow "a Poisson-disk set" and describe the set.
std::string kind(const SetClaim& claim) {
    std::string kind = claim.field != nullptr
                           ? fmt::format(" that follows the field at scale {}", claim.scale)
                           : fmt::format(" of radius {}", claim.radius);
    if (!claim.classes.names.empty())
        kind = fmt::format(" of {} classes{}{}", kinds(claim.classes).size(),
                           claim.classes.by_priority ? ", each beside those before it" : "",
                           has_counts(claim.classes) ? " with their numbers of points" : "");
    if (claim.places.mask != nullptr || !claim.places.masks.empty() ||
        !claim.places.outlines.empty() || !borders(claim).empty())
        kind += " where points may lie";
    return kind;
}

std::string faults(const SetClaim& claim) {
    const Proof& proof = claim.proof;
    const bool has_room = !claim.distances_only && !proof.covered;
    std::string faults;
    if (!proof.kept)
        faults = fmt::format("points {} and {} are closer than {}", numbered(claim, proof.first),
                             numbered(claim, proof.second), proof.least_limit);
    if (!proof.kept && has_room) faults += ", and ";
    const std::string of_class =
        claim.classes.names.empty()
            ? ""
            : fmt::format(" of class {}", claim.classes.names[proof.largest_gap_class]);
    if (has_room)
        faults +=
            fmt::format("there is room for a point{} at {}", of_class, text(proof.largest_gap));
    return faults;
}

std::string text_of_one(const SetClaim& claim) {
    constexpr std::string_view kRow = "{:<18}{}\n";
    constexpr std::string_view kVerdictRow = "{:<18}{:<{}}   {}\n";
    std::string lines = fmt::format(kRow, "points", claim.points.size());
    lines += fmt::format(kRow, "domain",
                         fmt::format("{} x {}{}, {}", claim.domain.width, claim.domain.height,
                                     corner_text(claim.domain.x0, claim.domain.y0),
                                     is_torus(claim) ? "torus" : "box"));
    lines += fmt::format(kRow, "radius", radius(claim)) + places(claim);
    if (!claim.distances_only) lines += fmt::format(kRow, "tolerance", *claim.tolerance);
    if (refusal(claim).empty()) {
        const std::string pair = closest(claim);
        const std::string spot = claim.distances_only ? "" : largest_gap(claim);
        const std::size_t width = std::max(pair.size(), spot.size());
        lines += fmt::format(kVerdictRow, "least distance", pair, width,
                             claim.proof.kept ? "kept" : "too close");
        if (!claim.distances_only)
            lines += fmt::format(kVerdictRow, "largest gap", spot, width,
                                 claim.proof.covered ? "covered" : "not covered");
    }
    if (!claim.levels.empty())
        lines += fmt::format(kVerdictRow, "levels",
                             fmt::format("{}, of {} to {} points", claim.levels.size(),
                                         claim.levels.front().points, claim.levels.back().points),
                             0, claim.fault.empty() ? "each maximal" : "not all hold");
    return lines + fmt::format(kRow, "verdict", claim.conclusion());
}

std::string_view name_of(Proof::Closed by) {
    switch (by) {
        case Proof::Closed::importance:
            return "field";
        case Proof::Closed::mask:
            return "mask";
        case Proof::Closed::polygons:
            return "inside";
        case Proof::Closed::border:
            break;
    }
    return "border";
}

Json json_of(const Point& point) {
    return {point.x, point.y};
}

Json json_of_one(const SetClaim& claim) {
    const Proof& proof = claim.proof;
    Json json{{"file", claim.name},
              {"points", claim.points.size()},
              {"domain",
               {{"width", claim.domain.width},
                {"height", claim.domain.height},
                {"boundary", is_torus(claim) ? "torus" : "box"}}},
              {"radius", claim.field != nullptr ? Json(nullptr) : Json(claim.radius)},
              {"tolerance", claim.distances_only ? Json(nullptr) : Json(*claim.tolerance)},
              {"holds", claim.holds()},
              {"verdict", claim.conclusion()}};
    if (claim.domain.has_corner())
        json["domain"].update({{"x0", claim.domain.x0}, {"y0", claim.domain.y0}});
    if (claim.field != nullptr) {
        json["scale"] = claim.scale;
        json["least_radius"] = claim.radii.most > 0 ? Json(claim.radii.least) : Json(nullptr);
        json["largest_radius"] = claim.radii.most;
    }
    json.update(claim.given);
    if (!claim.levels.empty())
        json["levels"] = {{"count", claim.levels.size()}, {"hold", claim.fault.empty()}};
    if (proof.outside) {
        json["outside"] = {{"point", *proof.outside},
                           {"at", json_of(claim.points[*proof.outside])}};
        return json;
    }
    if (proof.moved) json["moved"] = *proof.moved;
    if (proof.forbidden)
        json["forbidden"] = {{"point", *proof.forbidden},
                             {"at", json_of(claim.points[*proof.forbidden])},
                             {"by", name_of(proof.forbidden_by)}};
    if (proof.miscounted) json["miscounted"] = claim.classes.names[*proof.miscounted];
    if (!refusal(claim).empty()) return json;
    json["distances_kept"] = proof.kept;
    json["closest_pair"] = nullptr;
    const std::size_t points = all_points(claim);
    if (points >= 2)
        json["closest_pair"] = {{"points", {proof.first, proof.second}},
                                {"distance", proof.least_distance}};
    if (points >= 2 && !verify::is_uniform(claim))
        json["closest_pair"]["limit"] = proof.least_limit;
    if (claim.distances_only) return json;
    json["covered"] = proof.covered;
    json["largest_gap"] = nullptr;
    if (points != 0 && (verify::is_uniform(claim) || !proof.covered))
        json["largest_gap"] = {{"at", json_of(proof.largest_gap)},
                               {"distance", proof.largest_gap_distance}};
    if (points != 0 && !verify::is_uniform(claim) && !proof.covered)
        json["largest_gap"]["limit"] = proof.largest_gap_limit;
    if (!claim.classes.names.empty() && json["largest_gap"].is_object())
        json["largest_gap"]["class"] = claim.classes.names[proof.largest_gap_class];
    // The key of the largest gap in older reports. Programs may still read it.
    json["emptiest_spot"] = json["largest_gap"];
    return json;
}

}  // namespace

bool SetClaim::holds() const {
    return refusal(*this).empty() && proof.kept && (distances_only || proof.covered) &&
           fault.empty();
}

std::string SetClaim::conclusion() const {
    if (const std::string refused = refusal(*this); !refused.empty()) return refused;
    if (!holds())
        return !fault.empty() && proof.kept && (distances_only || proof.covered)
                   ? fault
                   : fmt::format("{}: {}{}", proof.kept ? "not maximal" : "not a Poisson-disk set",
                                 faults(*this),
                                 proof.kept && !meant_to_be_maximal
                                     ? "; the file says that it is not: see --distances-only"
                                     : "");
    if (distances_only)
        return fmt::format("a Poisson-disk set{}; whether there is room for more was not asked",
                           kind(*this));
    if (!proof.maximal)
        return fmt::format(
            "a Poisson-disk set{}, and no spot is farther than {} from a point: not proven "
            "maximal, as the tolerance is over {:.0f} % of the {}radius",
            kind(*this),
            field != nullptr ? fmt::format("its limit and {}", *tolerance)
                             : fmt::format("{}", radius + *tolerance),
            100 * verify::kMostTolerance, field != nullptr ? "least " : "");
    return fmt::format("a maximal Poisson-disk set{}, to a tolerance of {}", kind(*this),
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
    // File names are bytes that need not be UTF-8.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna::cli
