// The options of `lacuna verify`, and what it prints.
#include "cli/verify.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/check_failed.h"
#include "cli/options.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "verify/verify.h"

namespace lacuna::cli {
namespace {

constexpr const char* kDescription =
    R"(Proves or refutes, from the coordinates alone, that points are a maximal Poisson-disk set.

Examples:
  lacuna verify points.txt --radius 0.01            are all far enough apart, and is no room left?
  lacuna verify a.npy --radius 0.01 --torus         where the edges wrap
  lacuna verify a.csv --radius 0.02 --domain 2x1    in another domain than the unit square
  lacuna sample --radius 0.05 | lacuna verify - --radius 0.05     what another program has made
  lacuna verify a.ply --radius 0.01 --tolerance 0.001     no gap wider by more than a tenth

Two promises are checked. No two points are closer than R. No spot of the domain, edges and corners
included, is farther than R + T from every point. The closest two points and the emptiest spot are
printed; points are numbered from 0, in the order of the file. Distances are in double, as you would
compute them: sqrt(dx * dx + dy * dy). The default T is more than a sampler may lose by rounding R
up to whole units of a grid, 2^30 or more of them along the longer side; T = 0 forgives no more than
1e-12 of that side.

Exit code: 0 both hold, 1 one does not, 2 bad usage, 3 the file cannot be read.
)";

struct Options {
    std::string file;
    std::optional<double> radius;
    std::optional<double> tolerance;
    double width = 1;
    double height = 1;
    bool torus = false;
};

std::string text(const Point& point) {
    return fmt::format("({}, {})", point.x, point.y);
}

// What one proof is about.
struct Claim {
    const Options& options;
    const std::vector<Point>& points;
    const verify::Verdict& verdict;
    double radius;
    double tolerance;

    std::string numbered(std::size_t index) const {
        return fmt::format("{} at {}", index, text(points[index]));
    }

    std::string closest() const {
        if (points.size() < 2) return "none, for want of two points";
        const verify::Pair& pair = verdict.closest;
        return fmt::format("{} (points {} and {})", pair.distance, pair.first, pair.second);
    }

    std::string emptiest() const {
        if (points.empty()) return "anywhere, for want of a point";
        return fmt::format("{} from a point, at {}", verdict.emptiest.distance,
                           text(verdict.emptiest.at));
    }

    std::string conclusion() const {
        if (verdict.outside)
            return fmt::format("refused: point {} lies outside the domain [0, {}) x [0, {})",
                               numbered(*verdict.outside), options.width, options.height);
        if (verdict.is_maximal())
            return fmt::format("a maximal Poisson-disk set of radius {}", radius);
        std::string faults;
        if (!verdict.kept)
            faults =
                fmt::format("points {} and {} are closer than {}", numbered(verdict.closest.first),
                            numbered(verdict.closest.second), radius);
        if (!verdict.kept && !verdict.covered) faults += ", and ";
        if (!verdict.covered)
            faults += fmt::format("there is room for a point at {}", text(verdict.emptiest.at));
        return fmt::format("{}: {}", verdict.kept ? "not maximal" : "not a Poisson-disk set",
                           faults);
    }

    std::string report() const {
        constexpr std::string_view kRow = "{:<18}{}\n";
        constexpr std::string_view kVerdictRow = "{:<18}{:<{}}   {}\n";
        std::string lines = fmt::format(kRow, "points", points.size());
        lines += fmt::format(kRow, "radius", radius);
        lines += fmt::format(kRow, "tolerance", tolerance);
        if (!verdict.outside) {
            const std::string pair = closest();
            const std::string spot = emptiest();
            const std::size_t width = std::max(pair.size(), spot.size());
            lines += fmt::format(kVerdictRow, "least distance", pair, width,
                                 verdict.kept ? "kept" : "too close");
            lines += fmt::format(kVerdictRow, "farthest spot", spot, width,
                                 verdict.covered ? "covered" : "not covered");
        }
        return lines + fmt::format(kRow, "verdict", conclusion());
    }
};

void run(const Options& options) {
    if (!options.radius)
        throw BadRequest("radius", "missing", "give the radius that the points should have");
    const double tolerance =
        options.tolerance.value_or(verify::default_tolerance(options.width, options.height));
    const auto check = [&](const std::vector<Point>& points) {
        return verify::check(points, options.width, options.height, options.torus, *options.radius,
                             tolerance);
    };
    check({});  // refuses bad options before a large file is read
    const std::vector<Point> points = files::read_points(options.file);
    const verify::Verdict verdict = check(points);
    const Claim claim{options, points, verdict, *options.radius, tolerance};
    files::write_whole("-", claim.report());
    if (verdict.outside || !verdict.is_maximal()) throw CheckFailed();
}

}  // namespace

void add_verify(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("verify", kDescription);
    const auto options = std::make_shared<Options>();
    command
        .add_option("FILE", options->file,
                    "By extension: " + files::read_extensions() + "; - is standard input, as .txt")
        ->type_name("")
        ->required();
    add_number(command, "radius", "R", options->radius, "The least distance promised");
    command
        .add_option_function<std::string>(
            "--domain",
            [options](const std::string& text) {
                read_domain("domain", text, options->width, options->height);
            },
            "Width and height of the domain (default 1x1)")
        ->type_name("WxH");
    command.add_flag("--torus", options->torus, "The edges wrap")->disable_flag_override();
    add_number(command, "tolerance", "T", options->tolerance,
               "How far over R a gap may be (default 2^-28 of the longer side)");
    command.callback([options] { run(*options); });
}

}  // namespace lacuna::cli
