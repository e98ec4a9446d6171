// The options of `lacuna verify`, and what it prints.
#include "cli/verify.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/check_failed.h"
#include "cli/given_files.h"
#include "cli/options.h"
#include "cli/verify_report.h"
#include "files/point_files.h"
#include "files/read_sets.h"
#include "files/read_whole.h"
#include "verify/verify.h"

namespace lacuna::cli {
namespace {

constexpr const char* kVerifyDescription =
    R"(Proves or refutes, from the coordinates alone, that points are a maximal Poisson-disk set.

Examples:
  lacuna verify points.txt --radius 0.01            are all far enough apart, and is no room left?
  lacuna verify a.npy --radius 0.01 --torus         where the edges wrap
  lacuna verify a.csv --radius 0.02 --domain 2x1    in another domain than the unit square
  lacuna sample --radius 0.05 | lacuna verify - --radius 0.05     what another program has made
  lacuna verify a.json b.json --quiet               what the files say of themselves, by exit code
  lacuna verify bridson.csv --radius 0.01 --distances-only    not meant to be maximal

Two promises are checked. No two points are closer than R. No spot of the domain, edges and corners
included, is farther than R + T from every point. The closest two points and the emptiest spot are
printed; points are numbered from 0, in the order of the file. Distances are in double, as you would
compute them: sqrt(dx * dx + dy * dy). The default T is more than a sampler may lose by rounding R
up to whole units of a grid, 2^30 or more of them along the longer side; T = 0 forgives no more than
1e-12 of that side. A T over 1 % of R proves no maximal set, and the verdict says what it does prove.
Radius, domain and boundary that a .json tells hold where no option does.

Exit code: 0 all that was asked holds, 1 not, 2 bad usage, 3 the file cannot be read, 4 the system
makes no threads.
)";

struct Sides {
    double width = 1;
    double height = 1;
};

struct VerifyCommand {
    std::vector<std::string> files;
    std::optional<double> radius;
    std::optional<double> tolerance;
    std::optional<Sides> sides;
    bool torus = false;
    bool distances_only = false;
    bool json = false;
    bool quiet = false;
};

// What is claimed of one set of a file: options first, then what the file tells.
SetClaim claim_of(const VerifyCommand& options, const files::SetsOfFile& file,
                  const std::string& name, const std::vector<Point>& points) {
    const std::optional<double> radius = options.radius ? options.radius : file.radius;
    if (!radius)
        throw BadRequest("radius", "missing",
                         "give the radius that the points should have, or a .json that tells it");
    const bool is_cells = file.mode == name_of(Mode::cells);
    if (is_cells && !options.distances_only)
        throw files::FileError(name +
                               ": made in mode cells, where radii follow a picture: give "
                               "--distances-only, for the least of them");
    Sides sides = options.sides.value_or(Sides{});
    if (!options.sides && file.width) sides = {*file.width, *file.height};
    SetClaim claim{{}, name, points, file.maximal.value_or(true)};
    claim.radius = *radius;
    claim.width = sides.width;
    claim.height = sides.height;
    if (options.torus || file.boundary == Boundary::torus) claim.boundary = Boundary::torus;
    claim.tolerance =
        options.tolerance.value_or(verify::default_tolerance(sides.width, sides.height));
    claim.distances_only = options.distances_only;
    return claim;
}

// Refuses bad options before a large file is read.
void check(const VerifyCommand& options) {
    if (options.distances_only && options.tolerance)
        throw BadRequest("tolerance", fmt::format("{}", *options.tolerance),
                         "is for gaps, which --distances-only does not look for");
    std::vector<GivenFile> read;
    read.reserve(options.files.size());
    for (const std::string& file : options.files) read.push_back({"FILE", file});
    check_given_files(read, {});
    const Sides sides = options.sides.value_or(Sides{});
    if (options.radius)
        verify::check({}, sides.width, sides.height, options.torus, *options.radius,
                      options.tolerance.value_or(0));
}

void run(const VerifyCommand& options) {
    check(options);
    std::vector<files::SetsOfFile> all;
    for (const std::string& path : options.files) all.push_back(files::read_sets(path));
    std::vector<SetClaim> claims;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string name = files::name_of(options.files[i]);
        const auto& sets = all[i].sets;
        for (std::size_t k = 0; k < sets.size(); ++k)
            claims.push_back(claim_of(
                options, all[i], sets.size() == 1 ? name : fmt::format("{}: set {}", name, k + 1),
                sets[k]));
    }
    bool all_hold = true;
    for (SetClaim& claim : claims) {
        claim.proof = prove(claim.points, claim);
        all_hold = all_hold && claim.holds();
    }
    if (!options.quiet) files::write_whole("-", options.json ? json_of(claims) : text_of(claims));
    if (!all_hold) throw CheckFailed();
}

}  // namespace

void add_verify(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("verify", kVerifyDescription);
    const auto options = std::make_shared<VerifyCommand>();
    command
        .add_option("FILE", options->files,
                    "By extension: " + files::read_extensions() + "; - is standard input, as .txt")
        ->type_name("...")
        ->required();
    add_number(command, "radius", "R", options->radius,
               "The least distance promised (default: what a .json tells)");
    command
        .add_option_function<std::string>(
            "--domain",
            [options](const std::string& text) {
                Sides& sides = options->sides.emplace();
                read_domain("domain", text, sides.width, sides.height);
            },
            "Width and height of the domain (default 1x1, or what a .json tells)")
        ->type_name("WxH");
    command.add_flag("--torus", options->torus, "The edges wrap")->disable_flag_override();
    add_number(command, "tolerance", "T", options->tolerance,
               "How far over R a gap may be (default 2^-28 of the longer side)");
    command
        .add_flag("--distances-only", options->distances_only,
                  "Look for points too close only: for sets that are not meant to be maximal")
        ->disable_flag_override();
    command.add_flag("--json", options->json, "As JSON")->disable_flag_override();
    command.add_flag("--quiet", options->quiet, "Say nothing: the exit code tells")
        ->disable_flag_override();
    command.callback([options] { run(*options); });
}

}  // namespace lacuna::cli
