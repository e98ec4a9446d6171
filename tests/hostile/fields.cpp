// hostile_fields: makes random sets of mode exact with radius fields. The proof of lacuna/verify.h
// must accept each set, and must refute it with one point removed.
//
//     hostile_fields [--sets N] [--seconds S] [--seed N] [--skip K] [--backend B]
//
// It makes N sets (800), or as many as S seconds allow, on backend B (cpu), and prints the seed,
// which is a new one each time unless it is given; --skip goes to set K of the seed. Ends with 1 at
// the first wrong set, and names its request.
#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hostile/options.h"
#include "hostile/random_field.h"

namespace {

using namespace lacuna;
using tests::HostileField;
using verify::FieldCase;

constexpr std::array<std::string_view, 5> kOptions{"--sets", "--seconds", "--seed", "--skip",
                                                   "--backend"};
constexpr std::uint64_t kSets = 800;

struct Counts {
    std::uint64_t points = 0;
    std::uint64_t with_mask = 0, with_polygons = 0, with_border = 0, with_kept = 0;
    std::uint64_t empty = 0;  // sets of kept points only, none of which is removed
    std::uint64_t refuted = 0, spared = 0;
    std::uint64_t refuted_by_polygons = 0, spared_by_polygons = 0;
};

void demand(bool is_so, const std::string& otherwise) {
    if (!is_so) throw std::runtime_error(otherwise);
}

std::string told(Point at) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << at.x << ", " << at.y << ")";
    return out.str();
}

void demand_proof(const Proof& proof, const std::string& by) {
    std::ostringstream out;
    out.precision(17);
    out << "a set is refuted by " << by << ": ";
    if (proof.outside)
        out << "point " << *proof.outside << " is outside";
    else if (proof.moved)
        out << "kept point " << *proof.moved << " has moved";
    else if (proof.forbidden)
        out << "point " << *proof.forbidden << " is forbidden by "
            << static_cast<int>(proof.forbidden_by);
    else if (!proof.kept)
        out << "points " << proof.first << " and " << proof.second << " are "
            << proof.least_distance << " apart, not " << proof.least_limit;
    else
        out << told(proof.largest_gap) << " is " << proof.largest_gap_distance
            << " from a point, not " << proof.largest_gap_limit;
    demand(proof.maximal, out.str());
}

// The most by which a spot near `gone` exceeds its limit: first among random spots, then by ever
// smaller steps from the largest gap found.
double most_over_near(const FieldCase& seen, const std::vector<Point>& points, Point gone,
                      std::mt19937_64& random) {
    constexpr int kPlaces = 4000;
    double most = -std::numeric_limits<double>::infinity();
    Point barest = gone;
    const auto look_at = [&](Point spot) {
        const auto wrapped = [&](double at, double side) {
            return seen.domain.torus ? at - side * std::floor(at / side) : at;
        };
        spot = {wrapped(spot.x, seen.domain.width), wrapped(spot.y, seen.domain.height)};
        if (!seen.domain.contains(spot)) return;
        const auto over = seen.over(points, spot);
        if (!over || !(*over > most)) return;
        most = *over;
        barest = spot;
    };
    look_at(gone);
    const double radius = seen.most_radius_near(gone).value();
    double reach = std::min(radius, seen.domain.longer_side());
    for (int i = 0; i < kPlaces; ++i, reach *= 0.996)
        look_at({barest.x + verify::any_in(random, -reach, reach),
                 barest.y + verify::any_in(random, -reach, reach)});
    return most;
}

// A point on the border of pixels of different radii, such as a kept point, covers spots with the
// larger radius, and its distances are checked with the smaller one.
bool has_two_radii(const FieldCase& seen, Point at) {
    const double blur = seen.domain.longer_side() * 0x1p-28;
    const auto around = [&](double along, double side, double by) {
        const double there = along + by;
        return seen.domain.torus ? there - side * std::floor(there / side) : there;
    };
    for (const double dx : {0.0, blur, -blur})
        for (const double dy : {0.0, blur, -blur})
            if (seen.radius_at({around(at.x, seen.domain.width, dx),
                                around(at.y, seen.domain.height, dy)}) != seen.radius_at(at))
                return true;
    return false;
}

// Without one of its own points a set is refuted: a spot that this point alone covered, such as its
// own, is then uncovered. There may be no such spot for two reasons. Spots near the edges of
// polygons need not be covered. And a point on the border of two pixels may cover by one radius a
// spot for which it leaves room by the other.
bool is_refuted_without(const FieldCase& seen, const Claim& claim, std::vector<Point> points,
                        std::size_t index, std::mt19937_64& random) {
    const Point gone = points[index];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
    const Proof bare = prove(points, claim);
    const std::string without = "without point " + std::to_string(index) + " at " + told(gone);
    demand(!bare.forbidden && !bare.outside && !bare.moved && bare.kept,
           without + " what is left is refuted");
    if (bare.covered) {
        const double over = most_over_near(seen, points, gone, random);
        demand(over <= seen.tolerance() * (1 + 1e-6),
               without + " a place is bare by " + std::to_string(over) + ", and not found");
        const auto lies_on_two = [&](Point at) { return has_two_radii(seen, at); };
        demand(!seen.rings.empty() || lies_on_two(gone) ||
                   std::any_of(points.begin(), points.end(), lies_on_two),
               without + " what is left is as good");
        return false;
    }
    demand(!bare.maximal, without + " the proof says two things");
    if (points.empty()) return true;
    const double found = bare.largest_gap_distance - bare.largest_gap_limit;
    demand(found > seen.tolerance(), without + " the bare spot is not bare");
    // The gap may lie on the border of two pixels. Then its radius is either pixel's.
    std::optional<double> over;
    const double near = seen.domain.longer_side() * 0x1p-40;
    for (const double dx : {0.0, near, -near})
        for (const double dy : {0.0, near, -near})
            if (const auto one =
                    seen.over(points, {bare.largest_gap.x + dx, bare.largest_gap.y + dy}))
                over = std::max(over.value_or(*one), *one);
    demand(over.has_value(), without + " the bare spot " + told(bare.largest_gap) + " is closed");
    demand(std::abs(*over - found) <= 1e-9 * seen.domain.longer_side(),
           without + " the bare spot " + told(bare.largest_gap) + " is over by another length");
    demand(seen.domain.distance(bare.largest_gap, gone) < seen.most_radius_near(gone).value(),
           without + " a spot is bare that it did not cover");
    return true;
}

void check(const HostileField& made, const std::vector<Point>& points, Counts& counts,
           std::mt19937_64& random) {
    counts.points += points.size();
    counts.with_mask += made.asked.mask && made.rings.empty() ? 1U : 0U;
    counts.with_polygons += made.rings.empty() ? 0U : 1U;
    counts.with_border += made.asked.border > 0 ? 1U : 0U;
    counts.with_kept += made.keep.empty() ? 0U : 1U;
    std::vector<FieldCase> all{made.asked};
    if (!made.rings.empty()) all.push_back(made.drawn());
    const std::size_t own = points.size() - made.keep.size();
    counts.empty += own == 0 ? 1U : 0U;
    const std::size_t index = made.keep.size() + (own == 0 ? 0 : random() % own);
    for (const FieldCase& seen : all) {
        const bool by_polygons = !seen.rings.empty();
        const Claim claim = made.claim(seen);
        demand_proof(prove(points, claim), by_polygons ? "its polygons" : "its radius field");
        if (!points.empty())
            demand(seen.most_over_of_raster(points, 30) <= seen.tolerance(),
                   "a place of a raster is bare, and not found");
        if (own == 0) continue;
        const bool is_refuted = is_refuted_without(seen, claim, points, index, random);
        if (by_polygons)
            (is_refuted ? counts.refuted_by_polygons : counts.spared_by_polygons) += 1;
        else
            (is_refuted ? counts.refuted : counts.spared) += 1;
    }
}

void check_field(const tests::HostileOptions& options, std::uint64_t number, Counts& counts) {
    tests::RandomField radius_field(options.seed, number);
    HostileField made = radius_field.make();
    made.options.backend = options.backend;
    try {
        Result result = sample(made.request());
        demand(result.maximal, "a set is not maximal");
        check(made, result.points, counts, radius_field.random());
        // A set that was stopped, and is continued.
        if (!made.keep.empty() || number % 4 != 0) return;
        radius_field.resume(made, result.points);
        result = sample(made.request());
        check(made, result.points, counts, radius_field.random());
    } catch (const std::exception& error) {
        throw std::runtime_error(std::string(error.what()) + "\n  at --seed " +
                                 std::to_string(options.seed) + " --skip " +
                                 std::to_string(number) + ": " + tests::describe(made));
    }
}

void tell(std::uint64_t made, const Counts& counts) {
    std::cout << "hostile_fields: " << made << " radius fields, " << counts.points
              << " points; with mask " << counts.with_mask << ", polygons " << counts.with_polygons
              << ", border " << counts.with_border << ", kept points " << counts.with_kept << "\n"
              << "  with a point less refuted " << counts.refuted << ", as good " << counts.spared
              << "; by polygons refuted " << counts.refuted_by_polygons << ", as good "
              << counts.spared_by_polygons << "; none to lose " << counts.empty << "\n  failures 0"
              << std::endl;
}

// Throws an error about the first wrong set.
void run(const tests::HostileOptions& options) {
    std::cout << "hostile_fields: seed " << options.seed << ", backend " << options.backend
              << std::endl;
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const double seconds = options.seconds.value_or(std::numeric_limits<double>::infinity());
    const std::uint64_t sets =
        options.sets.value_or(options.seconds ? std::numeric_limits<std::uint64_t>::max() : kSets);
    Counts counts;
    std::uint64_t made = 0;
    for (; made < sets && std::chrono::duration<double>(Clock::now() - start).count() < seconds;
         ++made)
        check_field(options, options.skip + made, counts);
    tell(made, counts);
}

// Whether the backend is for devices and none of them can be used.
bool has_no_device(const std::string& backend) {
    const std::vector<Device> all = devices();
    return (backend == "opencl" || backend == "vulkan") &&
           std::none_of(all.begin(), all.end(), [&](const Device& device) {
               return device.backend == backend && device.unusable.empty();
           });
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const tests::HostileOptions options = tests::read_hostile_options(argc, argv, kOptions);
        if (has_no_device(options.backend))
            std::cout << "SKIPPED: " << options.backend << " has no device" << std::endl;
        else
            run(options);
    } catch (const std::exception& error) {
        std::cerr << "hostile_fields: " << error.what() << std::endl;
        return EXIT_FAILURE;
    }
}
