// Cuts a surface into its first bins.
#include "space/first_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/polling.h"
#include "space/vectors.h"

namespace lacuna::space {
namespace {

// The longest edge of the first bins, and the side of the cells that hold them, in radii. A sample
// covers a bin of this size at most; larger ones would only be split.
constexpr double kLongestEdge = 1.5;
constexpr double kCellSide = 1.6;
// The sum of all weights of a surface: below 2^63, so that it can be scaled by 64 random bits.
constexpr double kWeightOfAll = 0x1p62;

// A cell's position along z, y and x, 21 bits each, so that cells of one row follow each other.
using Key = std::uint64_t;
constexpr unsigned kKeyBits = 21;

Key key_of(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto part = [](std::int64_t at) { return static_cast<std::uint64_t>(at); };
    return part(z) << 2 * kKeyBits | part(y) << kKeyBits | part(x);
}

struct Extent {
    Position least{std::numeric_limits<std::int32_t>::max(),
                   std::numeric_limits<std::int32_t>::max(),
                   std::numeric_limits<std::int32_t>::max()};
    Position most{-1, -1, -1};

    void add(const Position& position) {
        least = {std::min(least.x, position.x), std::min(least.y, position.y),
                 std::min(least.z, position.z)};
        most = {std::max(most.x, position.x), std::max(most.y, position.y),
                std::max(most.z, position.z)};
    }
    bool is_closer(const Extent& other, std::uint64_t radius) const {
        const auto gap = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
            return static_cast<std::uint64_t>(std::max<std::int64_t>({a - d, c - b, 0}));
        };
        const std::uint64_t x = gap(least.x, most.x, other.least.x, other.most.x);
        const std::uint64_t y = gap(least.y, most.y, other.least.y, other.most.y);
        const std::uint64_t z = gap(least.z, most.z, other.least.z, other.most.z);
        return x * x + y * y + z * z < radius * radius;
    }
};

// The triangles of a mesh in units. Those that are long and thin for the radius are cut in two
// along their longest side, again and again, because splitting them in four would make as many bins
// as the square of their length.
class Triangles {
public:
    Triangles(const Mesh& mesh, const Units& units, double longest, FirstBins& made)
        : mesh_(mesh), units_(units), longest_(longest), made_(made) {}

    void add(std::uint32_t number) {
        number_ = number;
        add(kWhole, 0);
    }
    // Their weights, once all are there.
    void weigh() {
        for (const double area : areas_) {
            ask_after();
            const double share = area_ > 0 ? area / area_ : 0;
            made_.weights.push_back(
                std::max<std::uint64_t>(1, static_cast<std::uint64_t>(share * kWeightOfAll)));
        }
    }

private:
    using Shares = std::array<std::array<double, 2>, 3>;
    static constexpr Shares kWhole{{{0, 0}, {1, 0}, {0, 1}}};
    static constexpr double kThin = 8;    // times as long as high
    static constexpr int kMostCuts = 64;  // then sides are 2^-32 of what they were

    Point3 at(const std::array<double, 2>& shares) const {
        const auto& [i, j, k] = mesh_.triangles[number_];
        const Point3& a = mesh_.vertices[i];
        const Point3 u = mesh_.vertices[j] - a, v = mesh_.vertices[k] - a;
        return {a.x + shares[0] * u.x + shares[1] * v.x, a.y + shares[0] * u.y + shares[1] * v.y,
                a.z + shares[0] * u.z + shares[1] * v.z};
    }
    void add(const Shares& shares, int cuts) {
        ask_after();
        const std::array<Point3, 3> corners{at(shares[0]), at(shares[1]), at(shares[2])};
        const double area = area_of(corners);
        // The side after each corner.
        std::array<double, 3> sides{};
        for (std::size_t i = 0; i < 3; ++i) sides[i] = length_of(corners[(i + 1) % 3] - corners[i]);
        const auto longest =
            static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
        const double side = sides[longest];
        if (side > longest_ && side * side > kThin * 2 * area && cuts < kMostCuts) {
            const auto &a = shares[longest], &b = shares[(longest + 1) % 3],
                       &c = shares[(longest + 2) % 3];
            const std::array<double, 2> middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
            if (!is_cut_) made_.cut_from.resize(made_.triangles.size(), kWhole);
            is_cut_ = true;
            add({{a, middle, c}}, cuts + 1);
            add({{middle, b, c}}, cuts + 1);
            return;
        }
        made_.triangles.push_back({units_.position_of(corners[0]), units_.position_of(corners[1]),
                                   units_.position_of(corners[2])});
        made_.numbers.push_back(number_);
        if (is_cut_) made_.cut_from.push_back(shares);
        area_ += areas_.emplace_back(area);
    }

    const Mesh& mesh_;
    const Units& units_;
    double longest_;  // side of a triangle that need not be cut, in the user's unit
    FirstBins& made_;
    std::uint32_t number_ = 0;
    bool is_cut_ = false;
    std::vector<double> areas_;
    double area_ = 0;
};

// What has a place in a cell: a first bin, or a kept sample.
struct Placed {
    Key key;
    std::uint32_t index;
};

class SurfaceBlocks {
public:
    SurfaceBlocks(std::uint64_t radius, FirstBins& made)
        : radius_(radius),
          side_(std::max<std::int64_t>(std::llround(kCellSide * static_cast<double>(radius)),
                                       (std::int64_t{1} << 30) >> (kKeyBits - 1))),
          longest_(squared(kLongestEdge * static_cast<double>(radius))),
          made_(made) {}

    // Splits the part until its edges are short enough.
    void add(const Portion& part) {
        const Solid& triangle = made_.triangles[part.third];
        const Position a = corner_of_triangle(triangle, part, 0);
        const Position b = corner_of_triangle(triangle, part, 1);
        const Position c = corner_of_triangle(triangle, part, 2);
        const std::uint64_t longest =
            std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
        if (longest > longest_ && !is_corner(part)) {
            for (std::uint32_t i = 0; i < 4; ++i) add(quarter(part, i));
            return;
        }
        ask_after();
        const auto middle = [](std::int64_t p, std::int64_t q, std::int64_t r) {
            return (p + q + r) / 3;
        };
        places_.push_back(
            {key_at(middle(a.x, b.x, c.x), middle(a.y, b.y, c.y), middle(a.z, b.z, c.z)),
             static_cast<std::uint32_t>(parts_.size())});
        parts_.push_back(part);
    }

    void make(std::span<const Position> kept) {
        std::vector<Placed> of_kept;
        for (const Position& position : kept)
            of_kept.push_back({key_at(position.x, position.y, position.z),
                               static_cast<std::uint32_t>(of_kept.size())});
        const auto less = [](const Placed& a, const Placed& b) {
            return a.key != b.key ? a.key < b.key : a.index < b.index;
        };
        std::sort(places_.begin(), places_.end(), less);
        std::sort(of_kept.begin(), of_kept.end(), less);
        made_.bins.reserve(parts_.size());
        auto next_kept = of_kept.begin();
        for (auto next = places_.begin(); next != places_.end() || next_kept != of_kept.end();) {
            const Key last = std::numeric_limits<Key>::max();
            const Key key = std::min(next == places_.end() ? last : next->key,
                                     next_kept == of_kept.end() ? last : next_kept->key);
            begin_block(key);
            for (; next != places_.end() && next->key == key; ++next) put(parts_[next->index]);
            for (; next_kept != of_kept.end() && next_kept->key == key; ++next_kept) {
                made_.kept.push_back(kept[next_kept->index]);
                extents_.back().add(made_.kept.back());
            }
        }
        made_.begins.push_back(static_cast<std::uint32_t>(made_.bins.size()));
        made_.kept_begins.push_back(static_cast<std::uint32_t>(made_.kept.size()));
        find_near();
    }

private:
    static std::uint64_t squared(double length) {
        return static_cast<std::uint64_t>(std::min(length * length, 0x1p63));
    }
    // Kept samples may lie beside the surface. All positions are moved by one cell.
    Key key_at(std::int64_t x, std::int64_t y, std::int64_t z) const {
        const auto along = [&](std::int64_t at) { return at / side_ + kSpare; };
        return key_of(along(x), along(y), along(z));
    }
    void begin_block(Key key) {
        keys_.push_back(key);
        extents_.emplace_back();
        made_.begins.push_back(static_cast<std::uint32_t>(made_.bins.size()));
        made_.kept_begins.push_back(static_cast<std::uint32_t>(made_.kept.size()));
    }
    void put(const Portion& part) {
        made_.bins.push_back(part);
        for (std::uint32_t corner = 0; corner < 3; ++corner)
            extents_.back().add(corner_of_triangle(made_.triangles[part.third], part, corner));
    }

    // Blocks that are near each other lie at most kSpare cells apart. Blocks ascend, and so do the
    // rows of cells beside them: each row has a mark that only moves on.
    void find_near() {
        std::array<std::size_t, kRows * kRows> marks{};
        for (std::size_t block = 0; block < keys_.size(); ++block) {
            ask_after(marks.size());
            made_.near_begins.push_back(static_cast<std::uint32_t>(made_.near.size()));
            std::size_t row = 0;
            for (int dz = -kSpare; dz <= kSpare; ++dz)
                for (int dy = -kSpare; dy <= kSpare; ++dy) find_near(block, dz, dy, marks[row++]);
        }
        made_.near_begins.push_back(static_cast<std::uint32_t>(made_.near.size()));
    }
    void find_near(std::size_t block, int dz, int dy, std::size_t& mark) {
        const Key middle = keys_[block] + key_of(0, 1, 0) * static_cast<Key>(dy) +
                           key_of(0, 0, 1) * static_cast<Key>(dz);
        while (mark < keys_.size() && keys_[mark] < middle - kSpare) ++mark;
        for (std::size_t i = mark; i < keys_.size() && keys_[i] <= middle + kSpare; ++i)
            if (extents_[block].is_closer(extents_[i], radius_))
                made_.near.push_back(static_cast<std::uint32_t>(i));
    }

    // A bin reaches beyond its cell by up to 2/3 of its longest edge.
    static constexpr int kSpare = 2;
    static_assert(1 + 2 * (2. / 3) * kLongestEdge < kSpare * kCellSide);
    static constexpr std::size_t kRows = 2 * kSpare + 1;

    std::uint64_t radius_;
    std::int64_t side_;  // of a cell
    std::uint64_t longest_;
    FirstBins& made_;
    std::vector<Portion> parts_;
    std::vector<Placed> places_;
    std::vector<Key> keys_;  // of each block
    std::vector<Extent> extents_;
};

}  // namespace

FirstBins bins_of_surface(const Mesh& mesh, std::span<const std::uint8_t> allowed,
                          const Units& units, std::uint64_t radius,
                          std::span<const Position> kept) {
    FirstBins made;
    Triangles triangles(mesh, units, kLongestEdge * static_cast<double>(radius) * units.unit.x,
                        made);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        if (allowed.empty() || allowed[i] != 0) triangles.add(i);
    triangles.weigh();
    SurfaceBlocks blocks(radius, made);
    for (std::uint32_t i = 0; i < made.triangles.size(); ++i) blocks.add({0, 0, i, 0});
    blocks.make(kept);
    return made;
}

}  // namespace lacuna::space
