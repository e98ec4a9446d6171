// The options of `lacuna verify`, and what it prints.
#include "cli/commands/commands.h"
#include "cli/commands/verify_space.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "checks/classes.h"
#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/given_files.h"
#include "cli/reports/verify_report.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "files/read_whole.h"
#include "options/claim.h"
#include "pictures/importance.h"
#include "places/sets.h"
#include "plan/kept.h"
#include "verify/verify.h"

namespace lacuna::cli {
namespace {

constexpr const char* kVerifyDescription =
    R"(Proves or refutes, from the coordinates alone, that points are a maximal Poisson-disk set.

Examples:
  lacuna verify points.txt --radius 0.01            are all far enough apart, and is no room left?
  lacuna verify a.npy --radius 0.01 --torus         where the edges wrap
  lacuna verify a.csv --radius 0.02 --domain 2x1    in another domain than the unit square
  lacuna sample --radius 0.05 | lacuna verify - --radius 0.05     points from standard input
  lacuna verify a.json b.json --quiet               with each file's radius; only an exit code
  lacuna verify bridson.csv --radius 0.01 --distances-only    not meant to be maximal
  lacuna verify dots.npy --field photo.jpg --scale 0.002      radii that follow a picture
  lacuna verify wood.csv --class trees:0.03 --class grass:0.006   points of several kinds
  lacuna verify trees.csv --radius 4 --inside park.svg --keep old.csv    in polygons, around others
  lacuna verify points.ply --on bunny.ply --radius 0.01       on the surface of a mesh
  lacuna verify volume.npy --domain 1x1x1 --torus --radius 0.02     in a volume

Two promises are checked. No two points are closer than R. No spot of the domain, edges and corners
included, is farther than R + T from every point. The closest two points and the largest gap are
printed; points are numbered from 0, in the order of the file. Distances are in double, as you would
compute them: sqrt(dx * dx + dy * dy). The default T is more than a sampler may lose by rounding R
up to whole units of a grid, 2^30 or more of them along the longer side; T = 0 forgives no more than
1e-12 of that side. A T over 1 % of R proves no maximal set, and the verdict says what it does prove.
The radius, domain and boundary in a .json are used unless an option gives them. A domain that does
not begin at 0, 0 is given by its lower left corner, too: --domain 448000,5411000+2000x1500.

With --field, R is the smaller radius of two places: of two points, or of a spot and the point that
is to cover it. The pair and the spot that are printed are the worst ones, compared with their R.
No point may lie, and no spot need be covered, where the field is white, where --mask is black,
outside of --inside, and within --border of an edge. The outline of --inside may be off by --edge
either way. With any of these the default T is twice as large. Pictures, polygons and the domain are
read as by lacuna sample. The points of --keep must be the first of the set, to the last bit. Those
outside of the domain are its neighbours: distances to them are checked, and they cover spots.

Exit code: 0 all that was asked holds, 1 not, 2 bad usage, 3 the file cannot be read, 4 the system
makes no threads.
)";

struct VerifyCommand {
    std::vector<std::string> files;
    std::optional<double> tolerance;
    // The options that `lacuna sample` has, too: the radius or scale, the domain and its border.
    Request request;
    options::InSpace space{request};
    DomainOptions domain;
    bool torus = false;
    bool distances_only = false;
    bool json = false;
    bool quiet = false;
};

// What the options say about all sets: the request, and the contents of the files that they name.
struct ForAllSets {
    Request request;
    DomainFiles files;
};

// The request for one set. If an option is not given, the set's file gives its value.
Request request_of(const CommandLine& line, const VerifyCommand& options, const ForAllSets& given,
                   const files::PointsOfFile& file, const std::string& name, SetClaim& claim) {
    if (file.origin.mode == Mode::cells && !options.distances_only)
        throw BadUsage(name +
                       ": made in mode cells, where radii follow a picture: give "
                       "--distances-only, for the least of them");
    if (file.origin.mode == Mode::stratified && !options.distances_only)
        throw BadUsage(name +
                       ": made in mode stratified and relaxed, which promises no radius: "
                       "give --distances-only, for the least distance");
    if (file.origin.mode == Mode::pixels && !options.distances_only)
        throw BadUsage(name +
                       ": made on pixels, of which none has two points: give --distances-only");
    Request request = given.request;
    ask_for_files(line, options.domain, options.distances_only, file.origin, name);
    claim.own_field = use_values(line, file.origin, request, claim.options);
    // The outlines of a chunk lie in the plane.
    if (file.origin.values.contains("chunk"))
        for (Outline& outline : request.places.outlines) outline.polygons.page.reset();
    if (!line.has("domain") && file.domain) take_shape(*file.domain, request);
    if (file.boundary == Boundary::torus) request.domain.boundary = Boundary::torus;
    if (given.files.extent) {
        claim.own_field = std::make_shared<const Field>(field_in(request.domain, given.files));
        request.field = claim.own_field.get();
    }
    if (request.field != nullptr && !request.scale && request.classes.names.empty())
        throw BadRequest("scale", "missing",
                         "give the radius that points should have where the field is black");
    if (request.field != nullptr) {
        if (!request.scale) request.scale = least_distance_of(request.classes);
        return request;
    }
    if (!request.radius) request.radius = file.radius;
    if (!request.radius && request.classes.names.empty() && !file.classes.names.empty())
        throw BadUsage(name +
                       ": its points have classes, but it does not hold their distances: "
                       "give --class for each, or --radius for all points alike");
    if (!request.radius)
        throw BadRequest("radius", "missing",
                         "give the radius that the points should have, or a .json that holds it");
    return request;
}

// The smallest and the largest radius that the request asks for.
Extremes radii_of(const Request& request) {
    if (request.field == nullptr) return {*request.radius, *request.radius};
    Extremes radii{std::numeric_limits<double>::infinity(), 0};
    for (const double importance : request.field->importance) {
        if (importance == 0) continue;
        const double radius = *request.scale / std::sqrt(importance);
        radii = {std::min(radii.least, radius), std::max(radii.most, radius)};
    }
    return radii;
}

// The classes of the points to keep. They were not read yet if the classes are those of a .json,
// and matter only to neighbours.
std::vector<std::uint8_t> classes_of_keep(const Request& request, const DomainFiles& files,
                                          const std::string& path) {
    if (!files.keep_classes.empty() || Members(request).are_all()) return files.keep_classes;
    return classes_in(files::read_points(path), request.classes, files::name_of(path));
}

SetClaim claim_of(const CommandLine& line, const VerifyCommand& options, ForAllSets& given,
                  const files::PointsOfFile& file, const std::string& name) {
    SetClaim claim;
    claim.options = options.domain;
    Request request = request_of(line, options, given, file, name, claim);
    options::take_borders(claim.options.borders, request);
    take_masks(request.classes.names, given.files, request);
    static_cast<Claim&>(claim) = options::claim_of(request);
    claim.points = file.points;
    claim.name = name;
    claim.meant_to_be_maximal = file.origin.maximal.value_or(true);
    claim.radii = radii_of(request);
    // What a .json says that it kept comes first in it.
    claim.keep = request.keep.empty() ? claim.points.first(kept_in(file)) : request.keep;
    if (!claim.classes.names.empty()) {
        claim.own_classes = classes_in(file, claim.classes, name);
        claim.classes_of_keep = classes_of_keep(request, given.files, options.domain.keep);
    }
    claim.places.edge = claim.options.edge;
    claim.places.border_by_radius = claim.options.inside_by_radius;
    if (const auto settled = places::settled(claim)) {
        claim.places.edge = settled->places.edge;
        claim.places.border = settled->places.border;
        claim.places.borders = settled->places.borders;
    }
    request.places.border = claim.places.border;
    request.places.borders = claim.places.borders;
    given.files.edge = claim.places.edge.value_or(0);
    claim.given = json_of(options.domain, request, given.files);
    claim.tolerance = options.tolerance;
    claim.tolerance = verify::tolerance_of(claim);
    claim.distances_only = options.distances_only || !has_open_class(claim.classes);
    // A progressive order that was cut is judged by its levels.
    if (!options.distances_only && !options.request.radius) claim.levels = file.origin.levels;
    if (!claim.levels.empty() && !claim.meant_to_be_maximal) claim.distances_only = true;
    return claim;
}

// Refuses bad options before it takes time to read a large file.
void check(const CommandLine& line, const VerifyCommand& options) {
    check_given_files(files_read(line), std::vector<GivenFile>{});
    if (options.space.is_asked_for()) return;
    pictures::check(options.domain.field.importance);
    const Request& request = options.request;
    const auto is_json = [](const std::string& file) { return file.ends_with(".json"); };
    if (!options.domain.field.path.empty() && !request.scale &&
        options.domain.classes.given.empty() &&
        std::none_of(options.files.begin(), options.files.end(), is_json))
        throw BadRequest("scale", "missing",
                         "give the radius that points should have where the field is black");
    if (!request.radius) return;
    Claim claim;
    claim.radius = *request.radius;
    claim.domain = request.domain;
    claim.tolerance = options.tolerance;
    prove({}, claim);
}

// Proves for each level that its points are a maximal set of its radius. Returns an empty text, or
// what is wrong with the first level that is not.
std::string fault_in_levels(const SetClaim& claim) {
    SetClaim one = claim;
    one.distances_only = false;
    one.meant_to_be_maximal = true;
    for (const Level& level : claim.levels) {
        one.points = claim.points.first(level.points);
        if (!claim.own_classes.empty())
            one.class_of_points = claim.class_of_points.first(level.points);
        (claim.field != nullptr ? one.scale : one.radius) = level.size;
        one.proof = prove(one.points, one);
        if (!one.holds())
            return fmt::format("the first {} points, at {} {}, are {}", level.points,
                               claim.field != nullptr ? "scale" : "radius", level.size,
                               one.conclusion());
    }
    return "";
}

// Prints the verdicts. Throws CheckFailed if one of them does not hold.
void conclude(const VerifyCommand& options, const std::string& report, bool all_hold) {
    if (!options.quiet) files::write_whole("-", report);
    if (!all_hold) throw CheckFailed();
}

void run_in_space(const CommandLine& line, const VerifyCommand& options,
                  const std::vector<files::PointsOfFile>& all) {
    Request request = options.request;
    if (options.torus) request.domain.boundary = Boundary::torus;
    const options::InSpace space{request, options.space.mesh, options.space.volume};
    const auto [report, all_hold] =
        verified_in_space(line, {space, options.tolerance, options.distances_only, options.json,
                                 options.domain.keep, options.files, all});
    conclude(options, report, all_hold);
}

void run(const CommandLine& line, const VerifyCommand& options) {
    check(line, options);
    ForAllSets given{options.request, {}};
    if (options.torus) given.request.domain.boundary = Boundary::torus;
    const bool is_in_space = options.space.is_asked_for();
    std::vector<files::PointsOfFile> all;
    for (const std::string& path : options.files)
        all.push_back(files::read_points(
            path, is_in_space ? files::Lie::in_space : files::Lie::as_file_says));
    if (is_in_space || std::any_of(all.begin(), all.end(), [](const files::PointsOfFile& file) {
            return file.is_said_to_be_in_space();
        }))
        return run_in_space(line, options, all);
    DomainOptions domain = options.domain;
    if (domain.classes.given.empty()) domain.known_classes = all.front().origin.classes.names;
    read_given_files(line, domain, given.request, given.files);
    std::vector<SetClaim> claims;
    for (std::size_t i = 0; i < all.size(); ++i)
        claims.push_back(claim_of(line, options, given, all[i], files::name_of(options.files[i])));
    bool all_hold = true;
    for (SetClaim& claim : claims) {
        // Now that `claims` does not move its elements any more.
        claim.class_of_points = claim.own_classes;
        claim.keep_classes = claim.classes_of_keep;
        claim.proof = prove(claim.points, claim);
        if (claim.holds()) claim.fault = fault_in_levels(claim);
        all_hold = all_hold && claim.holds();
    }
    conclude(options, options.json ? json_of(claims) : text_of(claims), all_hold);
}

// Where the value of each option goes.
Targets targets_of(VerifyCommand& all) {
    Targets targets{{"FILE", &all.files},          {"torus", &all.torus},
                    {"tolerance", &all.tolerance}, {"distances-only", &all.distances_only},
                    {"json", &all.json},           {"quiet", &all.quiet}};
    // merge() keeps the first target of a name: --border is read as texts, which may be NAME:D, and
    // --domain may have three sides.
    targets.merge(options::targets_of(all.space));
    targets.merge(targets_of(all.domain));
    targets.merge(options::targets_of(all.request));
    return targets;
}

}  // namespace

void add_verify(CLI::App& app) {
    const auto all = std::make_shared<VerifyCommand>();
    add_command(app, options::kVerify, kVerifyDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
