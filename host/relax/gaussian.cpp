// Builds the tables of the Gaussian energy, of products, quotients and square roots alone, which
// IEEE 754 defines to the last bit: the same tables on every machine.
#include "relax/gaussian.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "base/number_text.h"
#include "lattice/lattice.h"
#include "lattice/take_apart.h"

namespace lacuna::relaxing {
namespace {

constexpr std::uint32_t kMostBits = 24;
constexpr std::uint32_t kLeastBits = 13;
constexpr std::size_t kMostSamples = std::size_t{1} << 28;
constexpr double kMostUnitsOfSide = 2147483647;  // units
constexpr std::uint32_t kEntriesOfTable = GAUSSIAN_ENTRIES;
constexpr std::uint32_t kEntriesOfEdge = GAUSSIAN_EDGE_ENTRIES;
constexpr std::size_t kEntries = kEntriesOfTable;
constexpr std::size_t kEdgeEntries = kEntriesOfEdge;
constexpr double kOfWeight = 1 << GAUSSIAN_WEIGHT_BITS;

// Rows of cells in the reach, and columns: rows are tall, so that vectors hold many samples of one,
// and columns narrow, so that few samples beyond the reach are tried.
constexpr std::uint32_t kRowsInReach = 3;
constexpr std::uint32_t kColumnsInReach = 12;

// exp(-x) for x from 0 to about 20: the series of exp(x / 16), whose terms have one sign, squared
// four times.
double exp_of_minus(double x) {
    constexpr int kTerms = 24, kSquares = 4;
    const double part = x / (1 << kSquares);
    double sum = 1;
    for (int term = kTerms; term > 0; --term) sum = 1 + sum * part / term;
    for (int i = 0; i < kSquares; ++i) sum *= sum;
    return 1 / sum;
}

// The integral of exp(-q^2 / 2) from 0 to x: exp(-x^2 / 2) times the sum of x^(2k + 1) / (1 3 5 ...
// (2k + 1)), whose terms have one sign.
double area_to(double x) {
    constexpr int kLast = 181;  // the last term's 2k + 1
    double sum = 1;
    for (int odd = kLast; odd > 1; odd -= 2) sum = 1 + sum * (x * x) / odd;
    return exp_of_minus(x * x / 2) * x * sum;
}

std::int32_t weight_of(double value) {
    return static_cast<std::int32_t>(std::floor(value * kOfWeight + 0.5));
}

// The Gaussian, and below `least` mean spacings a term that pushes samples apart. The derivative of
// the energy over the distance, as it is multiplied by a difference of positions.
std::vector<std::int32_t> make_weights(double least) {
    constexpr double kStiffness = 0.5, kMostPush = 8;
    std::vector<std::int32_t> weights(kEntries + 2, 0);
    for (std::size_t i = 0; i < kEntries; ++i) {
        const double squared = static_cast<double>(i) / GAUSSIAN_ENTRIES_A_UNIT;
        const double distance = std::sqrt(squared);
        double push = 0;
        if (distance < least)
            push = i == 0 ? kMostPush : std::min(kMostPush, kStiffness * (least / distance - 1));
        weights[i] = weight_of(exp_of_minus(squared / 2) + push);
    }
    return weights;
}

template <typename Value>
std::vector<std::int32_t> along_edge(Value value) {
    std::vector<std::int32_t> table(kEdgeEntries + 2);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = weight_of(
            value(static_cast<double>(std::min(i, kEdgeEntries)) / GAUSSIAN_ENTRIES_A_UNIT));
    return table;
}

std::uint64_t root_above(std::uint64_t square) {
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(square)));
    while (root * root < square) ++root;
    return root;
}

// Cells that a distance reaches beyond the one where it begins.
std::uint32_t cells_in(std::uint64_t distance, std::uint32_t cells, std::uint32_t length) {
    return static_cast<std::uint32_t>((distance * cells + length - 1) / length);
}

void add_grid(GaussianField& field) {
    portable::GaussianDomain& domain = field.domain;
    const std::uint64_t reach = std::uint64_t{GAUSSIAN_REACH} << domain.bits;
    const auto cells = [&](std::uint32_t length, std::uint32_t in_reach) {
        return static_cast<std::uint32_t>(
            std::max<std::uint64_t>(1, std::uint64_t{length} * in_reach / reach));
    };
    domain.columns = cells(domain.width, kColumnsInReach);
    domain.rows = cells(domain.height, kRowsInReach);
    domain.row_reach = cells_in(reach, domain.rows, domain.height);
    for (std::uint32_t row = 0; row <= domain.row_reach; ++row) {
        const std::uint64_t gap =
            row == 0 ? 0 : std::uint64_t{row - 1} * domain.height / domain.rows;
        field.column_reaches.push_back(
            cells_in(root_above(reach * reach - std::min(gap, reach) * std::min(gap, reach)),
                     domain.columns, domain.width));
    }
}

// More samples in a square of two mean spacings would take very long, their sums might overflow,
// and some devices would end their loops early (portable/gaussian.h).
void refuse_crowds(std::span<const Point> points, const std::vector<Spot>& spots,
                   const portable::GaussianDomain& domain) {
    constexpr std::uint32_t kMostTogether = 1024;
    const std::uint32_t columns = std::max(1u, domain.width >> (domain.bits + 1));
    const std::uint32_t rows = std::max(1u, domain.height >> (domain.bits + 1));
    std::vector<std::uint32_t> counts(std::size_t{columns} * rows, 0);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const std::size_t cell =
            std::size_t{portable::gaussian_cell(spots[i].y, rows, domain.height)} * columns +
            portable::gaussian_cell(spots[i].x, columns, domain.width);
        if (++counts[cell] <= kMostTogether) continue;
        throw BadRequest("points", "(" + shortest(points[i].x) + ", " + shortest(points[i].y) + ")",
                         "over " + std::to_string(kMostTogether) +
                             " points lie in two by two mean spacings around it: gaussian needs "
                             "points that are spread, as iterations of relax spread them");
    }
}

}  // namespace

GaussianField make_gaussian(std::size_t points, const RelaxOptions& options) {
    const double area_of_one =
        options.domain.width * options.domain.height / static_cast<double>(points);
    const double spacing = std::sqrt(area_of_one);
    const double longer = options.domain.longer_side() / spacing;
    std::uint32_t bits = kMostBits;
    while (bits >= kLeastBits && longer * (1u << bits) > kMostUnitsOfSide) --bits;
    if (points > kMostSamples || bits < kLeastBits)
        throw BadRequest("gaussian", std::to_string(options.gaussian),
                         "is for at most 2^28 points, 2^18 mean spacings along a side");
    GaussianField field{};
    portable::GaussianDomain& domain = field.domain;
    domain.bits = bits;
    domain.samples = static_cast<std::uint32_t>(points);
    domain.width =
        static_cast<std::uint32_t>(std::floor(options.domain.width / spacing * (1u << bits)));
    domain.height =
        static_cast<std::uint32_t>(std::floor(options.domain.height / spacing * (1u << bits)));
    domain.wraps = options.domain.wraps() ? 1 : 0;
    field.weights = make_weights(options.gaussian_distance);
    field.edge_pulls = along_edge([](double x) { return exp_of_minus(x * x / 2); });
    field.edge_areas = along_edge(area_to);
    field.edge_pulls[kEdgeEntries] = field.edge_pulls.back() = 0;
    add_grid(field);
    return field;
}

std::vector<Spot> spots_of(std::span<const Point> points, const GaussianField& field,
                           const RelaxOptions& options, const Poll& poll) {
    const portable::GaussianDomain& domain = field.domain;
    const bool wraps = domain.wraps != 0;
    std::vector<Site> sites(points.size());
    for_each_polled(points.size(), poll, [&](std::size_t i) {
        check_in_domain(i, points[i], options);
        const Point point = options.domain.from_corner(points[i]);
        sites[i] = {unit_of(point.x, options.domain.width, domain.width, wraps),
                    unit_of(point.y, options.domain.height, domain.height, wraps), 0};
    });
    portable::RelaxLattice numbers{};
    numbers.columns = domain.width;
    numbers.rows = domain.height;
    numbers.step_x = numbers.step_y = 1;
    numbers.period_x = numbers.period_y = domain.wraps;
    take_apart(sites, numbers, poll);
    std::vector<Spot> spots(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) spots[i] = {sites[i].x, sites[i].y};
    refuse_crowds(points, spots, domain);
    return spots;
}

Force force_of_edges(const GaussianField& field, const Spot& spot) {
    const portable::GaussianDomain& domain = field.domain;
    if (domain.wraps != 0) return {0, 0};
    const auto look_up = [&](const std::vector<std::int32_t>& table, std::uint32_t distance) {
        const std::uint32_t entry = portable::gaussian_edge_entry(distance, domain.bits);
        return portable::gaussian_edge_value(table[entry], table[entry + 1], distance, domain.bits);
    };
    const std::uint32_t right = domain.width - spot.x, top = domain.height - spot.y;
    const auto pull = [&](std::uint32_t near, std::uint32_t far) {
        return look_up(field.edge_pulls, near) - look_up(field.edge_pulls, far);
    };
    const auto across = [&](std::uint32_t near, std::uint32_t far) {
        return look_up(field.edge_areas, near) + look_up(field.edge_areas, far);
    };
    return {portable::gaussian_edge_force(pull(spot.x, right), across(spot.y, top), domain.bits),
            portable::gaussian_edge_force(pull(spot.y, top), across(spot.x, right), domain.bits)};
}

}  // namespace lacuna::relaxing
