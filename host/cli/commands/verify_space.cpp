// Makes claims in space of options and files, proves them, and reports in the words of
// host/cli/reports/verify_report.cpp.
#include "cli/commands/verify_space.h"

#include <fmt/format.h>
#include <lacuna/domains.h>
#include <lacuna/version.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/number_text.h"
#include "cli/commands/sample_space.h"
#include "cli/reports/report.h"
#include "cli/terminal/run_program.h"

namespace lacuna::cli {
namespace {

// One set, what is claimed of it, and what was found.
struct SpaceSetClaim : SpaceClaim {
    std::string name;       // of its file
    std::string mesh_name;  // of the file of its mesh; empty: it lies in the volume
    std::vector<Point3> points;
    bool meant_to_be_maximal = true;     // unless its file says that it is not
    std::string keep;                    // path of --keep, or empty
    std::optional<std::size_t> moved{};  // the first point that differs from that of --keep
    SpaceProof proof{};

    bool holds() const;
};

std::string text(const Point3& point) {
    return fmt::format("({}, {}, {})", point.x, point.y, point.z);
}

std::string numbered(const SpaceSetClaim& claim, std::size_t index) {
    return fmt::format("{} at {}", index, text(claim.points[index]));
}

// Why the proof ended before distances and gaps were looked at. Empty if it did not.
std::string refusal(const SpaceSetClaim& claim) {
    if (claim.moved)
        return fmt::format("refused: the set does not have point {} of {} in its place",
                           *claim.moved, printable(claim.keep));
    if (!claim.proof.outside) return "";
    const auto& [width, height, depth, boundary] = claim.volume;
    const char end = boundary == Boundary::torus ? ')' : ']';
    return fmt::format("refused: point {} lies {}", numbered(claim, *claim.proof.outside),
                       claim.mesh != nullptr
                           ? "off the mesh " + printable(claim.mesh_name)
                           : fmt::format("outside the volume [0, {}{} x [0, {}{} x [0, {}{}", width,
                                         end, height, end, depth, end));
}

std::string faults(const SpaceSetClaim& claim) {
    const SpaceProof& proof = claim.proof;
    const bool has_room = !claim.distances_only && !proof.covered;
    std::string faults;
    if (!proof.kept)
        faults = fmt::format("points {} and {} are closer than {}", numbered(claim, proof.first),
                             numbered(claim, proof.second), claim.radius);
    if (!proof.kept && has_room) faults += ", and ";
    if (has_room) faults += fmt::format("there is room for a point at {}", text(proof.largest_gap));
    return faults;
}

bool SpaceSetClaim::holds() const {
    return refusal(*this).empty() && proof.kept && (distances_only || proof.covered);
}

std::string conclusion_of(const SpaceSetClaim& claim) {
    if (const std::string refused = refusal(claim); !refused.empty()) return refused;
    if (!claim.holds())
        return fmt::format("{}: {}{}", claim.proof.kept ? "not maximal" : "not a Poisson-disk set",
                           faults(claim),
                           claim.proof.kept && !claim.meant_to_be_maximal
                               ? "; the file says that it is not: see --distances-only"
                               : "");
    const std::string kind = fmt::format("Poisson-disk set of radius {}", claim.radius);
    if (claim.distances_only)
        return fmt::format("a {}; whether there is room for more was not asked", kind);
    if (!claim.proof.maximal)
        return fmt::format(
            "a {}, and no spot is farther than {} from a point: not proven maximal, as the "
            "tolerance is over 1 % of the radius",
            kind, claim.radius + claim.proof.tolerance);
    return fmt::format("a maximal {}, to a tolerance of {}", kind, claim.proof.tolerance);
}

std::string text_of_one(const SpaceSetClaim& claim) {
    const SpaceProof& proof = claim.proof;
    std::string lines;
    const auto append = [&](std::string_view name, const std::string& value,
                            std::string_view verdict = "", std::size_t width = 0) {
        lines += verdict.empty() ? fmt::format("{:<18}{}\n", name, value)
                                 : fmt::format("{:<18}{:<{}}   {}\n", name, value, width, verdict);
    };
    append("points", fmt::format("{}", claim.points.size()));
    if (claim.mesh != nullptr)
        append("mesh", fmt::format("{}, {} triangles", printable(claim.mesh_name),
                                   claim.mesh->triangles.size()));
    else
        append("domain", fmt::format("{} x {} x {}, {}", claim.volume.width, claim.volume.height,
                                     claim.volume.depth,
                                     claim.volume.boundary == Boundary::torus ? "torus" : "box"));
    append("radius", fmt::format("{}", claim.radius));
    if (!claim.keep.empty()) append("kept", printable(claim.keep));
    if (!claim.distances_only) append("tolerance", fmt::format("{}", proof.tolerance));
    if (refusal(claim).empty()) {
        const std::string pair = claim.points.size() < 2
                                     ? "none, for want of two points"
                                     : fmt::format("{} (points {} and {})", proof.least_distance,
                                                   proof.first, proof.second);
        const std::string spot = claim.distances_only   ? ""
                                 : claim.points.empty() ? "anywhere, for want of a point"
                                                        : fmt::format("{} from a point, at {}",
                                                                      proof.largest_gap_distance,
                                                                      text(proof.largest_gap));
        const std::size_t width = std::max(pair.size(), spot.size());
        append("least distance", pair, proof.kept ? "kept" : "too close", width);
        if (!claim.distances_only)
            append("largest gap", spot, proof.covered ? "covered" : "not covered", width);
    }
    append("verdict", conclusion_of(claim));
    return lines;
}

Json json_of_one(const SpaceSetClaim& claim) {
    const SpaceProof& proof = claim.proof;
    const auto json_of_point = [](const Point3& at) { return Json{at.x, at.y, at.z}; };
    Json json{{"file", claim.name}, {"points", claim.points.size()}};
    if (claim.mesh != nullptr)
        json["on"] = claim.mesh_name;
    else
        json["domain"] = {{"width", claim.volume.width},
                          {"height", claim.volume.height},
                          {"depth", claim.volume.depth},
                          {"boundary", claim.volume.boundary == Boundary::torus ? "torus" : "box"}};
    json.update({{"radius", claim.radius},
                 {"tolerance", claim.distances_only ? Json(nullptr) : Json(proof.tolerance)},
                 {"holds", claim.holds()},
                 {"verdict", conclusion_of(claim)}});
    if (!claim.keep.empty()) json["keep"] = claim.keep;
    if (claim.moved) json["moved"] = *claim.moved;
    if (proof.outside)
        json["outside"] = {{"point", *proof.outside},
                           {"at", json_of_point(claim.points[*proof.outside])}};
    if (!refusal(claim).empty()) return json;
    json["distances_kept"] = proof.kept;
    json["closest_pair"] = nullptr;
    if (claim.points.size() >= 2)
        json["closest_pair"] = {{"points", {proof.first, proof.second}},
                                {"distance", proof.least_distance}};
    if (claim.distances_only) return json;
    json["covered"] = proof.covered;
    json["largest_gap"] = nullptr;
    if (!claim.points.empty())
        json["largest_gap"] = {{"at", json_of_point(proof.largest_gap)},
                               {"distance", proof.largest_gap_distance}};
    return json;
}

// Options come first, then what a .json says.
SpaceSetClaim claim_in_space(const SpaceVerification& options, const Mesh& mesh,
                             const files::PointsOfFile& file, const std::string& name) {
    SpaceSetClaim claim;
    const SpaceRequest asked = options::request_of(options.space);
    claim.name = name;
    if (file.z.size() != file.points.size())
        throw files::FileError(name + ": has two coordinates for each point, and is not in space");
    claim.points = file.in_space();
    claim.volume = asked.volume;
    const auto on = file.origin.values.find("on");
    if (!options.space.mesh.empty()) {
        claim.mesh = &mesh;
        claim.mesh_name = options.space.mesh;
    } else if (!options.space.volume && on != file.origin.values.end()) {
        throw BadUsage(
            fmt::format("{}: made with --on {}: give that too", name, shown(on->second)));
    } else if (!options.space.volume && file.domain && file.depth) {
        claim.volume = {file.domain->width, file.domain->height, *file.depth,
                        asked.volume.boundary};
    }
    if (file.boundary == Boundary::torus) claim.volume.boundary = Boundary::torus;
    const std::optional<double> radius = asked.radius ? asked.radius : file.radius;
    if (!radius)
        throw BadRequest("radius", "missing",
                         "give the radius that the points should have, or a .json that holds it");
    claim.radius = *radius;
    claim.tolerance = options.tolerance;
    claim.distances_only = options.distances_only;
    claim.meant_to_be_maximal = file.origin.maximal.value_or(true);
    return claim;
}

std::string text_of(const std::vector<SpaceSetClaim>& claims) {
    std::string lines;
    for (const SpaceSetClaim& claim : claims) {
        if (claims.size() > 1)
            lines += fmt::format("{}{:<18}{}\n", lines.empty() ? "" : "\n", "file",
                                 printable(claim.name));
        lines += text_of_one(claim);
    }
    return lines;
}

std::string json_of(const std::vector<SpaceSetClaim>& claims, bool all_hold) {
    Json report{{"program", "lacuna"},
                {"version", LACUNA_VERSION},
                {"all_hold", all_hold},
                {"sets", Json::array()}};
    for (const SpaceSetClaim& claim : claims) report["sets"].push_back(json_of_one(claim));
    // File names are bytes that need not be UTF-8.
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

SpaceVerdicts verified_in_space(const CommandLine& line, const SpaceVerification& asked) {
    options::refuse_options_of_plane(line, asked.space);
    const Mesh mesh = asked.space.mesh.empty() ? Mesh() : read_mesh(asked.space.mesh);
    std::vector<Point3> kept;
    if (!asked.keep.empty()) kept = files::read_points(asked.keep, files::Lie::in_space).in_space();
    std::vector<SpaceSetClaim> claims;
    for (std::size_t i = 0; i < asked.files.size(); ++i)
        claims.push_back(
            claim_in_space(asked, mesh, asked.files[i], files::name_of(asked.paths[i])));
    for (SpaceSetClaim& claim : claims) {
        claim.proof = naming_mesh(asked.space, [&] { return prove(claim.points, claim); });
        claim.keep = asked.keep;
        const auto [own, other] =
            std::mismatch(claim.points.begin(), claim.points.end(), kept.begin(), kept.end());
        if (other != kept.end()) claim.moved = static_cast<std::size_t>(other - kept.begin());
    }
    const bool all_hold =
        std::all_of(claims.begin(), claims.end(), [](const auto& claim) { return claim.holds(); });
    return {asked.json ? json_of(claims, all_hold) : text_of(claims), all_hold};
}

}  // namespace lacuna::cli
