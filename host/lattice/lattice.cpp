// Chooses the lattice: pixels are cut so finely that each sample has enough lattice points.
#include "lattice/lattice.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "base/number_text.h"
#include "checks/domain.h"
#include "lattice/take_apart.h"

namespace lacuna::relaxing {
namespace {

// Least mean number of lattice points for a sample, counting points with importance only.
constexpr double kPointsOfField = 24;
constexpr double kPointsWithoutField = 64;
// Least number for a sample where samples are dense: of these lattice points many belong to samples
// of lighter parts. On light ground a mean of 24 leaves 3 or 4 for a sample on a line; lines then
// lose 3 % of their samples. A mean of 96 is enough for most drawings and takes twice the time.
constexpr double kPointsWhereDense = 8;
constexpr double kMostPointsOfField = 96;
constexpr double kDenseShare = 0.1;  // this part of the samples counts as dense

// Limits of portable/power.h.
constexpr double kMostPoints = 2147483648;  // 2^31
constexpr double kMostOfSide = 2097152;     // 2^21
constexpr double kMostPointsTimesSide = 0x1p46;
constexpr std::uint32_t kUnitsPerStep = 256;
constexpr double kMostMass = 0x1p48;           // half of what portable/power.h allows, because
constexpr double kMostMassTimesSide = 0x1p61;  // masses of at least 1 may add to the sum

struct Cut {
    double x;
    double y;
};

// Cuts pixels of `aspect`, width over height, into at least points_per_pixel pieces that are as
// square as possible.
Cut cut_of(double aspect, double points_per_pixel) {
    const double stretch = std::max(aspect, 1 / aspect);
    const auto longer_cut = [&](double shorter_cut) {
        return std::max(1.0, std::round(stretch * shorter_cut));
    };
    double cut = std::max(1.0, std::floor(std::sqrt(points_per_pixel / stretch)));
    while (cut * longer_cut(cut) < points_per_pixel) ++cut;
    return aspect >= 1 ? Cut{longer_cut(cut), cut} : Cut{cut, longer_cut(cut)};
}

// The length of a step in units; the shorter one of the two steps has 256.
std::uint32_t step_of(double step, double other) {
    return static_cast<std::uint32_t>(
        std::lround(std::max(1.0, step / other) * double{kUnitsPerStep}));
}

std::uint64_t pixels_of_importance(const Field& field) {
    return static_cast<std::uint64_t>(std::count_if(
        field.importance.begin(), field.importance.end(), [](double one) { return one > 0; }));
}

bool fits(const Field& field, const Cut& cut) {
    const double columns = field.columns * cut.x;
    const double rows = field.rows * cut.y;
    const double longer = std::max(columns, rows);
    return columns * rows <= kMostPoints && longer <= kMostOfSide &&
           columns * rows * longer <= kMostPointsTimesSide;
}

// The cut that is wanted, or the finest one that fits the limits.
Cut possible_cut(const Field& field, double aspect, double points_per_pixel) {
    for (double wanted = points_per_pixel;; wanted /= 2) {
        const Cut cut = cut_of(aspect, wanted);
        if (fits(field, cut)) return cut;
        if (wanted < 1)
            throw BadRequest("field",
                             std::to_string(field.columns) + "x" + std::to_string(field.rows),
                             "must have at most 2^31 pixels, 2^21 to a side, each as nearly "
                             "square as that allows");
    }
}

// The importance that a tenth of the samples have under them or exceed, over the mean importance of
// the pixels that have any. Rounded up to a 256th of the greatest importance.
double density_where_dense(const Field& field, double pixels) {
    constexpr std::size_t kSteps = 256;
    const double greatest = *std::max_element(field.importance.begin(), field.importance.end());
    std::array<double, kSteps> sums{};  // of importance, by its size
    for (const double one : field.importance) {
        const auto step = static_cast<std::size_t>(one / greatest * kSteps);
        sums[std::min(step, kSteps - 1)] += one / greatest;
    }
    const double all = std::accumulate(sums.begin(), sums.end(), 0.0);
    double denser = sums.back();
    std::size_t step = kSteps - 1;
    while (step > 0 && denser < kDenseShare * all) denser += sums[--step];
    return static_cast<double>(step + 1) / kSteps / (all / pixels);
}

// The mean number of lattice points for a sample.
double points_of_sample(const Field* field, double pixels) {
    if (field == nullptr) return kPointsWithoutField;
    return std::clamp(kPointsWhereDense * density_where_dense(*field, pixels), kPointsOfField,
                      kMostPointsOfField);
}

portable::RelaxLattice numbers_of(const Field& field, const Cut& cut, const RelaxOptions& options) {
    const double columns = field.columns * cut.x;
    const double rows = field.rows * cut.y;
    portable::RelaxLattice numbers{};
    numbers.columns = static_cast<std::uint32_t>(columns);
    numbers.rows = static_cast<std::uint32_t>(rows);
    numbers.step_x = step_of(options.domain.width / columns, options.domain.height / rows);
    numbers.step_y = step_of(options.domain.height / rows, options.domain.width / columns);
    const bool wraps = options.domain.wraps();
    numbers.period_x = wraps ? numbers.columns * numbers.step_x : 0;
    numbers.period_y = wraps ? numbers.rows * numbers.step_y : 0;
    numbers.cut_x = static_cast<std::uint32_t>(cut.x);
    numbers.cut_y = static_cast<std::uint32_t>(cut.y);
    numbers.pixel_columns = field.columns;
    numbers.pixel_rows = field.rows;
    numbers.farthest =
        portable::squared_length(numbers.columns * numbers.step_x, numbers.rows * numbers.step_y);
    return numbers;
}

// As portable/power.h says.
std::uint32_t stored(std::uint64_t mass) {
    const auto bits = static_cast<std::uint32_t>(std::bit_width(mass));
    const std::uint32_t exponent = bits > MASS_BITS ? bits - MASS_BITS : 0;
    return static_cast<std::uint32_t>(mass >> exponent) | exponent << MASS_EXPONENT_AT;
}

// The exponent of each leaf's masses, from those of its pixels.
void set_exponents(Lattice& lattice) {
    const portable::RelaxLattice& numbers = lattice.numbers;
    const std::uint32_t columns = leaves_in(numbers.columns);
    lattice.exponents.assign(std::size_t{columns} * leaves_in(numbers.rows), 0);
    const auto last = [](std::uint32_t pixel, std::uint32_t cut) {
        return ((pixel + 1) * cut - 1) / LEAF_SIDE;
    };
    for (std::size_t i = 0; i < lattice.masses.size(); ++i) {
        const auto exponent = static_cast<std::uint8_t>(lattice.masses[i] >> MASS_EXPONENT_AT);
        if (exponent == 0) continue;
        const auto x = static_cast<std::uint32_t>(i % numbers.pixel_columns);
        const auto y = static_cast<std::uint32_t>(i / numbers.pixel_columns);
        for (std::uint32_t v = y * numbers.cut_y / LEAF_SIDE; v <= last(y, numbers.cut_y); ++v)
            for (std::uint32_t u = x * numbers.cut_x / LEAF_SIDE; u <= last(x, numbers.cut_x);
                 ++u) {
                std::uint8_t& of_leaf = lattice.exponents[std::size_t{v} * columns + u];
                of_leaf = std::max(of_leaf, exponent);
            }
    }
}

}  // namespace

std::uint32_t unit_of(double coordinate, double side, std::uint32_t length, bool wraps) {
    const auto unit = static_cast<std::uint32_t>(coordinate / side * length);
    return unit < length ? unit : wraps ? 0 : length - 1;
}

void check_in_domain(std::size_t number, const Point& point, const RelaxOptions& options) {
    Domain with_edges = options.domain;  // upper edges are allowed on a torus, too
    with_edges.boundary = Boundary::box;
    if (!with_edges.holds(point))
        throw BadRequest("points",
                         "point " + std::to_string(number) + " at (" + shortest(point.x) + ", " +
                             shortest(point.y) + ")",
                         "must lie in the domain, " + extent_of(options.domain, ']'));
}

void check_options(const RelaxOptions& options) {
    check_domain(options.domain);
    if (options.iterations > kMostIterations)
        throw BadRequest("iterations", std::to_string(options.iterations),
                         "must be at most " + std::to_string(kMostIterations));
}

const Field& field_or_even(const Field* field) {
    static const Field even{1, 1, {1.0}};
    return field != nullptr ? *field : even;
}

std::vector<std::uint64_t> masses_of(const Field& field, double most, const Poll& poll) {
    double greatest = 0, least = std::numeric_limits<double>::infinity(), sum = 0;
    for_each_polled(field.importance.size(), poll, [&](std::size_t i) {
        const double one = field.importance[i];
        greatest = std::max(greatest, one);
        if (one > 0) least = std::min(least, one);
    });
    // The sum of the numbers themselves might be infinite.
    for_each_polled(field.importance.size(), poll,
                    [&](std::size_t i) { sum += field.importance[i] / greatest; });
    constexpr double kGreatest = 65535;
    constexpr int kMostBits = 36;  // that the greatest mass has more than 65535 has
    const double range = std::max(least / greatest, 0x1p-100);  // may be too small for a double
    int bits = std::clamp(-std::ilogb(range) - 7, 0, kMostBits);
    while (bits > 0 && std::ldexp(kGreatest * sum, bits) > most) --bits;
    const double unit = std::ldexp(kGreatest, bits);
    std::vector<std::uint64_t> masses;
    masses.reserve(field.importance.size());
    const auto add_row = [&](std::size_t from_above) {
        const std::size_t row = field.rows - 1 - from_above;
        for (std::uint32_t column = 0; column < field.columns; ++column) {
            const double one = field.importance[row * field.columns + column];
            const double exact = one / greatest * unit;
            auto mass = static_cast<std::uint64_t>(exact);
            mass += exact - static_cast<double>(mass) >= 0.5 ? 1 : 0;
            masses.push_back(mass + (one > 0 && mass == 0 ? 1 : 0));
        }
    };
    for_each_polled(field.rows, poll, add_row, field.columns);
    return masses;
}

Lattice make_lattice(std::size_t points, const Field* field, const RelaxOptions& options,
                     const Poll& poll) {
    const Field& importance = field_or_even(field);
    const double pixels = static_cast<double>(pixels_of_importance(importance));
    const double aspect =
        options.domain.width / importance.columns / (options.domain.height / importance.rows);
    const double wanted = points_of_sample(field, pixels);
    const Cut cut = possible_cut(importance, aspect, wanted * static_cast<double>(points) / pixels);

    Lattice lattice{numbers_of(importance, cut, options), 0, {}, {}, 0, options.domain, 0, 0};
    lattice.unit_x = options.domain.width / (lattice.numbers.columns * lattice.numbers.step_x);
    lattice.unit_y = options.domain.height / (lattice.numbers.rows * lattice.numbers.step_y);
    return with_field(std::move(lattice), points, importance, poll);
}

Lattice with_field(Lattice lattice, std::size_t points, const Field& field, const Poll& poll) {
    portable::RelaxLattice& numbers = lattice.numbers;
    const std::uint64_t points_per_pixel = std::uint64_t{numbers.cut_x} * numbers.cut_y;
    const double longer = std::max(numbers.columns, numbers.rows);
    const std::vector<std::uint64_t> masses = masses_of(
        field,
        std::min(kMostMass, kMostMassTimesSide / longer) / static_cast<double>(points_per_pixel),
        poll);
    lattice.masses.clear();
    lattice.greatest_mass = *std::max_element(masses.begin(), masses.end());
    for (const std::uint64_t mass : masses) lattice.masses.push_back(stored(mass));
    set_exponents(lattice);
    const std::uint64_t mass =
        std::reduce(masses.begin(), masses.end(), std::uint64_t{0}) * points_per_pixel;
    lattice.points = pixels_of_importance(field) * points_per_pixel;
    numbers.samples = static_cast<std::uint32_t>(points);
    numbers.mean_mass = mass / points;
    // A quarter of a site's mean area, the step of a site with much too little mass (eta / 2).
    numbers.lonely_step =
        lattice.points * numbers.step_x * numbers.step_y / (4 * std::uint64_t{points}) + 1;
    return lattice;
}

std::vector<Site> sites_of(std::span<const Point> points, const Lattice& lattice,
                           const RelaxOptions& options, const Poll& poll) {
    const portable::RelaxLattice& numbers = lattice.numbers;
    const bool wraps = options.domain.wraps();
    std::vector<Site> sites(points.size());
    for_each_polled(points.size(), poll, [&](std::size_t i) {
        check_in_domain(i, points[i], options);
        const Point point = options.domain.from_corner(points[i]);
        sites[i] = {unit_of(point.x, options.domain.width, numbers.columns * numbers.step_x, wraps),
                    unit_of(point.y, options.domain.height, numbers.rows * numbers.step_y, wraps),
                    portable::even_weight(numbers.farthest)};
    });
    take_apart(sites, numbers, poll);
    return sites;
}

}  // namespace lacuna::relaxing
