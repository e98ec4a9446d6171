// Distances from the outlines of polygons, from lines and from points: kept to the last digit, or
// not exceeded where samples lie near, and the rest is full, as a proof and a judge of this file's
// own say.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace lacuna {
namespace {

using Random = std::mt19937_64;

double share(Random& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

double to_segment(Point p, Point a, Point b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double squared = dx * dx + dy * dy;
    const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    const double t = squared > 0 ? std::clamp(along / squared, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double to_rings(Point p, const std::vector<PolygonRing>& rings) {
    double least = std::numeric_limits<double>::infinity();
    for (const PolygonRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
    return least;
}

bool is_inside(Point p, const std::vector<PolygonRing>& rings) {
    bool inside = false;
    for (const PolygonRing& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if ((a.y > p.y) == (b.y > p.y)) continue;
            inside ^= p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
        }
    return inside;
}

// A triangle or rectangle, a line of some points, or a single point. Some reach beyond the domain.
PolygonRing random_ring(Random& random, bool is_polygon) {
    const auto anywhere = [&] {
        return Point{1.4 * share(random) - 0.2, 1.4 * share(random) - 0.2};
    };
    if (!is_polygon && random() % 3 == 0) return {anywhere()};
    if (!is_polygon) {
        const Point a = anywhere(), b = anywhere(), c = anywhere();
        return random() % 2 == 0 ? PolygonRing{a, b} : PolygonRing{a, b, c, b};
    }
    const Point middle = anywhere();
    const double size = 0.2 + 0.4 * share(random), turn = 7 * share(random);
    const std::size_t corners = 3 + random() % 2;
    PolygonRing ring;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle =
            turn + 6.2831853 * static_cast<double>(i) / static_cast<double>(corners);
        ring.push_back({middle.x + size * std::cos(angle), middle.y + size * std::sin(angle)});
    }
    return ring;
}

struct Shapes {
    std::vector<std::vector<PolygonRing>> rings;
    std::vector<PolygonSet> sets;

    explicit Shapes(Random& random) {
        const std::size_t allowed = random() % 3, forbidden = random() % 2, near = random() % 3,
                          lines = 1 + random() % 3;
        for (std::size_t i = 0; i < allowed + forbidden + near + lines; ++i)
            rings.push_back({random_ring(random, i < allowed + forbidden)});
        for (std::size_t i = 0; i < rings.size(); ++i) {
            sets.push_back({rings[i], i >= allowed,
                            random() % 4 == 0 && i < allowed ? 0 : 0.01 + 0.08 * share(random)});
            if (i < allowed + forbidden || i >= allowed + forbidden + near) continue;
            sets.back().near = true;
            sets.back().distance *= 5;
        }
    }

    // How deep a place lies where samples may lie, beyond the distances that they keep.
    double depth(Point p) const {
        double depth = -std::numeric_limits<double>::infinity();
        bool is_anywhere = true;
        for (std::size_t i = 0; i < sets.size(); ++i) {
            if (sets[i].forbidden || sets[i].near) continue;
            is_anywhere = false;
            const double edge = to_rings(p, rings[i]);
            depth = std::max(depth, (is_inside(p, rings[i]) ? edge : -edge) - sets[i].distance);
        }
        if (is_anywhere) depth = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < sets.size(); ++i) {
            if (!sets[i].forbidden || sets[i].near) continue;
            const double edge = to_rings(p, rings[i]);
            depth = std::min(depth, (is_inside(p, rings[i]) ? -edge : edge) - sets[i].distance);
        }
        std::optional<double> within;
        for (std::size_t i = 0; i < sets.size(); ++i)
            if (sets[i].near)
                within = std::max(within.value_or(-1), sets[i].distance - to_rings(p, rings[i]));
        return std::min(depth, within.value_or(depth));
    }
};

TEST(DistancesFromOutlines, AreKeptAndTheRestIsFull) {
    Random random(11);
    int proven = 0, refuted = 0, covered = 0;
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        const Shapes shapes(random);
        Request request;
        request.radius = 0.05;
        request.seed = random();
        const double edge = *request.radius / 16;
        Mask mask;
        try {
            mask = draw_mask(shapes.sets, {1, 1}, edge);
        } catch (const BadRequest&) {
            continue;
        }
        request.mask = &mask;
        std::vector<Point> points = sample(request).points;
        for (const Point& point : points) ASSERT_GE(shapes.depth(point), 0);
        for (int k = 0; k < 300; ++k) {
            const Point spot{share(random), share(random)};
            if (shapes.depth(spot) <= edge + 1e-7) continue;
            ++covered;
            ASSERT_TRUE(std::any_of(points.begin(), points.end(), [&](Point p) {
                return std::hypot(p.x - spot.x, p.y - spot.y) <= *request.radius + 1e-8;
            }));
        }
        Claim claim;
        claim.radius = *request.radius;
        claim.polygons = shapes.sets;
        claim.edge_tolerance = edge;
        const Proof proof = prove(points, claim);
        ASSERT_FALSE(proof.forbidden);
        ASSERT_TRUE(proof.maximal)
            << "gap at " << proof.largest_gap.x << " " << proof.largest_gap.y;
        ++proven;
        // A point within an obstacle is refused.
        if (!points.empty()) {
            points.back() = shapes.rings.back().front().front();
            const bool is_outside = points.back().x < 0 || points.back().x > 1 ||
                                    points.back().y < 0 || points.back().y > 1;
            const Proof wrong = prove(points, claim);
            ASSERT_TRUE(is_outside ? wrong.outside.has_value() : wrong.forbidden.has_value());
            ++refuted;
        }
    }
    EXPECT_GE(proven, 100);
    EXPECT_GE(refuted, 100);
    EXPECT_GE(covered, 5000);
}

// The places nearer than the distance are a disk, a band, or the inside with a rim.
TEST(DistancesFromOutlines, AreDrawnAroundPointsLinesAndPolygons) {
    const auto open_share = [](const std::vector<PolygonRing>& rings) {
        const PolygonSet set{rings, true, 0.1};
        const Mask mask = draw_mask(std::span(&set, 1), {1, 1}, 0.0005);
        return static_cast<double>(
                   std::count(mask.allowed.begin(), mask.allowed.end(), std::uint8_t{1})) /
               static_cast<double>(mask.allowed.size());
    };
    constexpr double kDisk = 3.14159265 * 0.01;
    EXPECT_NEAR(open_share({{{0.5, 0.5}}}), 1 - kDisk, 0.002);
    EXPECT_NEAR(open_share({{{0.3, 0.5}, {0.7, 0.5}}}), 1 - kDisk - 0.4 * 0.2, 0.002);
    EXPECT_NEAR(open_share({{{0.3, 0.3}, {0.6, 0.7}}}), 1 - kDisk - 0.5 * 0.2, 0.002);
    EXPECT_NEAR(open_share({{{0.3, 0.3}, {0.6, 0.3}, {0.6, 0.6}, {0.3, 0.6}}}),
                1 - kDisk - 4 * 0.3 * 0.1 - 0.09, 0.003);
    EXPECT_NEAR(open_share({{{-0.05, 0.5}}}), 1 - 0.01 * (1.0472 - 0.5 * 0.8660), 0.002);
}

// Samples that lie near to a disk of a file of disks lie near to one of them all.
TEST(DistancesFromOutlines, WithinWhichSamplesLieAreJoined) {
    const std::vector<PolygonRing> here{{{0.3, 0.5}}}, there{{{0.8, 0.5}}};
    const std::vector<PolygonSet> near{{.rings = here, .distance = 0.2, .near = true},
                                       {.rings = there, .distance = 0.1, .near = true}};
    const Mask mask = draw_mask(near, {1, 1}, 0.001);
    const auto open = std::count(mask.allowed.begin(), mask.allowed.end(), std::uint8_t{1});
    EXPECT_NEAR(static_cast<double>(open) / static_cast<double>(mask.allowed.size()),
                3.14159265 * (0.04 + 0.01), 0.003);
    const PolygonSet far{.rings = here, .distance = 1e-9, .near = true};
    const Mask none = draw_mask(std::span(&far, 1), {1, 1}, 0.001);
    EXPECT_EQ(std::count(none.allowed.begin(), none.allowed.end(), std::uint8_t{1}), 0);
}

TEST(Lines, AreReadFromEveryFormat) {
    const PolygonRing there_and_back{{1, 1}, {3, 1}, {3, 2}, {3, 1}};
    EXPECT_EQ(decode_lines("1 1\n3 1\n\n5 5\n", "txt", "a.txt").rings,
              (std::vector<PolygonRing>{{{1, 1}, {3, 1}}, {{5, 5}}}));
    // A ring of a .txt is closed, as it is inside of polygons, and its inside is not avoided.
    const PolygonRing around_and_back{{1, 1}, {3, 1}, {3, 2}, {1, 1}, {3, 2}, {3, 1}};
    for (const char* text : {"1 1\n3 1\n3 2\n", "1 1\n3 1\n3 2\n1 1\n"})
        EXPECT_EQ(decode_lines(text, "txt", "a.txt").rings,
                  (std::vector<PolygonRing>{around_and_back}));
    EXPECT_EQ(decode_lines(R"({"type":"GeometryCollection","geometries":[
                  {"type":"LineString","coordinates":[[1,1],[3,1],[3,2]]},
                  {"type":"Point","coordinates":[5,5]},
                  {"type":"MultiPoint","coordinates":[[6,6]]},
                  {"type":"MultiLineString","coordinates":[[[1,1],[2,2]]]},
                  {"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}]})",
                           "geojson", "a.geojson")
                  .rings,
              (std::vector<PolygonRing>{there_and_back,
                                        {{5, 5}},
                                        {{6, 6}},
                                        {{1, 1}, {2, 2}},
                                        {{0, 0}, {1, 0}, {0, 1}, {0, 0}, {0, 1}, {1, 0}}}));
    const auto of_svg = [](const std::string& inner) {
        return decode_lines("<svg viewBox='0 0 10 10'>" + inner + "</svg>", "svg", "a.svg").rings;
    };
    const std::vector<PolygonRing> upright{{{1, 9}, {3, 9}, {3, 8}, {3, 9}}};
    EXPECT_EQ(of_svg("<polyline points='1,1 3,1 3,2'/>"), upright);
    EXPECT_EQ(of_svg("<path d='M1 1 H3 V2'/>"), upright);
    const std::vector<PolygonRing> closed{{{1, 9}, {3, 9}, {3, 8}, {1, 9}, {3, 8}, {3, 9}}};
    EXPECT_EQ(of_svg("<polygon points='1,1 3,1 3,2'/>"), closed);
    EXPECT_EQ(of_svg("<path d='M1 1 H3 V2 Z'/>"), closed);
    EXPECT_EQ(of_svg("<line x1='1' y1='1' x2='3' y2='1'/>"),
              (std::vector<PolygonRing>{{{1, 9}, {3, 9}}}));
    // Outlines are closed where their inside is asked for.
    EXPECT_EQ(decode_polygons(
                  "<svg viewBox='0 0 10 10' fill-rule='evenodd'><polyline points='1,1 3,1 3,2'/>"
                  "</svg>",
                  "svg", "a.svg")
                  .rings,
              (std::vector<PolygonRing>{{{1, 9}, {3, 9}, {3, 8}}}));
}

}  // namespace
}  // namespace lacuna
