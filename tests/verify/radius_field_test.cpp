// Given masks, polygons, borders and points to keep, the proof finds what geometry says.
#include <gtest/gtest.h>
#include <lacuna/domains.h>
#include <lacuna/verify.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "judge/places_of.h"

namespace {

using namespace lacuna;

Claim unit_claim(double radius) {
    Claim claim;
    claim.radius = radius;
    return claim;
}

PolygonRing square(double low, double high) {
    return {{low, low}, {high, low}, {high, high}, {low, high}};
}

TEST(AMask, HasNoPointWhereItIsZeroAndNeedsNoneThere) {
    const Mask right_is_closed{2, 1, {7, 0}};
    Claim claim = unit_claim(0.56);
    claim.places.mask = &right_is_closed;
    EXPECT_TRUE(prove(std::vector<Point>{{0.25, 0.5}}, claim).maximal);
    const Proof proof = prove(std::vector<Point>{{0.25, 0.5}, {0.75, 0.5}}, claim);
    EXPECT_EQ(proof.forbidden, 1U);
    EXPECT_EQ(proof.forbidden_by, Proof::Closed::mask);
    // A point on the border may be on either pixel.
    EXPECT_FALSE(prove(std::vector<Point>{{0.5 + 0x1p-29, 0.5}}, claim).forbidden);
    claim.radius = 0.55;
    const Proof proof_of_gap = prove(std::vector<Point>{{0.25, 0.5}}, claim);
    EXPECT_FALSE(proof_of_gap.covered);
    EXPECT_NEAR(proof_of_gap.largest_gap_distance, std::hypot(0.25, 0.5), 1e-7);
    EXPECT_EQ(proof_of_gap.largest_gap_limit, 0.55);
}

TEST(AMasksRows, LieFromTheTopDown) {
    const Mask top_is_open{1, 2, {1, 0}};
    Claim claim = unit_claim(2);
    claim.places.mask = &top_is_open;
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.9}}, claim).maximal);
    EXPECT_EQ(prove(std::vector<Point>{{0.5, 0.1}}, claim).forbidden, 0U);
}

// The domains are thin, have a hole along their middle, and a tolerance larger than their height.
// Their right end is far from all edges, and no point is near. Halving such cells rounds.
TEST(Polygons, LeaveAThinDomainBareWhereItIsFarFromTheirEdges) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 300; ++i) {
        const double height = std::uniform_real_distribution<double>(0.04, 0.06)(random);
        const std::vector<PolygonRing> rings{square(-9, 9),
                                             {{1.01, 0.4 * height},
                                              {2.94, 0.4 * height},
                                              {2.94, 0.6 * height},
                                              {1.01, 0.6 * height}}};
        Claim claim = unit_claim(0.33);
        claim.domain.width = 3.16;
        claim.domain.height = height;
        claim.places = tests::places_of(rings);
        claim.places.edge = 1.7 * height;
        claim.places.border = std::uniform_real_distribution<double>(0.2, 0.25)(random) * height;
        const std::vector<Point> points{{0.32, 0.7 * height}, {0.75, 0.26 * height}};
        const Proof proof = prove(points, claim);
        ASSERT_FALSE(proof.covered) << "height " << height << ", border " << claim.places.border;
        ASSERT_GT(proof.largest_gap_distance, 2.3);
    }
}

// A random search found this set, from which a point is removed. Its largest gap is a corner of the
// region that the tolerance of the polygons leaves open, on the border of two pixels of different
// radii. Rounding takes the radius of the right pixel, but the spot is a gap only with the radius
// of the left one.
TEST(TheLargestGap, OnTheBorderOfTwoPixelsHasTheRadiusOfItsOwn) {
    const Field field{
        2,
        4,
        {0.028346520423628493, 0.44465125638244218, 0.5860780187163902, 0.46800308668215068,
         0.082640200544060696, 0.012321018429127409, 0.80813086434415005, 0.092045216582603132}};
    const std::vector<PolygonRing> rings{{{20.056026015478047, -0.6},
                                          {-0.6, -0.6},
                                          {-0.6, 25.262595494027226},
                                          {18.769732270695686, 25.262595494027226},
                                          {18.769732270695686, 1.8980313417909066},
                                          {36.939464541391372, 1.8980313417909066}}};
    Claim claim;
    claim.domain.width = 20.056026015478047;
    claim.domain.height = 25.960626835818132;
    claim.field = &field;
    claim.scale = 5.8205682657952513;
    claim.places = tests::places_of(rings);
    claim.places.edge = 2.1141443558913072;
    claim.places.border = 1.0028013007739024e-08;
    const std::vector<Point> points{
        {10.69488433251901, 13.05564567412701},    {1.915294664401761, 12.510053977451616},
        {19.440596037321889, 1.7611170067574429},  {14.453382790772306, 23.086867671499796},
        {2.3086457761438548, 0.98339832942953664}, {5.7180312622448435, 19.27044636829239},
        {5.7313153224727236, 6.4892638016575983}};

    const Proof proof = prove(points, claim);

    EXPECT_FALSE(proof.covered);
    EXPECT_NEAR(proof.largest_gap_distance - proof.largest_gap_limit, 0.0989, 1e-4);
}

TEST(Polygons, NeedNoPointsNearTheirEdgesAndLetNoneLieOutside) {
    const std::vector<PolygonRing> rings{square(0.25, 0.75)};
    Claim claim = unit_claim(0.36);  // the middle of the square is 0.354 from a corner
    claim.places = tests::places_of(rings);
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, claim).maximal);
    EXPECT_FALSE(prove(std::vector<Point>{}, claim).covered);
    const Proof outside = prove(std::vector<Point>{{0.76, 0.5}}, claim);
    EXPECT_EQ(outside.forbidden, 0U);
    EXPECT_EQ(outside.forbidden_by, Proof::Closed::polygons);
    claim.places.edge = 0.011;
    EXPECT_EQ(prove(std::vector<Point>{{0.750001, 0.5}}, claim).forbidden, 0U);
    EXPECT_FALSE(prove(std::vector<Point>{{0.75, 0.5}}, claim).forbidden);
    // Spots that are inside by no more than the tolerance need not be covered.
    claim.radius = 0.34;
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, claim).maximal);
    claim.places.edge = 0.009;
    const Proof proof_of_gap = prove(std::vector<Point>{{0.5, 0.5}}, claim);
    EXPECT_FALSE(proof_of_gap.covered);
    EXPECT_NEAR(proof_of_gap.largest_gap_distance, std::sqrt(2) * 0.241, 1e-6);
}

TEST(APolygonInAPolygon, IsAHole) {
    const std::vector<PolygonRing> rings{square(0, 1), square(0.25, 0.75)};
    Claim claim = unit_claim(1.5);
    claim.places = tests::places_of(rings);
    EXPECT_EQ(prove(std::vector<Point>{{0.5, 0.5}}, claim).forbidden, 0U);
    EXPECT_TRUE(prove(std::vector<Point>{{0.1, 0.1}}, claim).maximal);
    // Rings that coincide enclose nothing.
    const std::vector<PolygonRing> twice{square(0.25, 0.75), square(0.25, 0.75)};
    claim.places = tests::places_of(twice);
    EXPECT_TRUE(prove(std::vector<Point>{}, claim).maximal);
    EXPECT_EQ(prove(std::vector<Point>{{0.5, 0.5}}, claim).forbidden, 0U);
}

TEST(SeveralSetsOfPolygons, AllowPointsInAnyAndInNoneThatIsForbidden) {
    const std::vector<PolygonRing> low{square(0, 0.6)}, high{square(0.4, 1)},
        hole{square(0.45, 0.55)};
    const std::vector<PolygonSet> both{{low}, {high}};
    Claim claim = unit_claim(0.3);
    claim.places = tests::places_of(both, 0);
    const auto forbidden = [&](Point point) {
        return prove(std::vector<Point>{point}, claim).forbidden.has_value();
    };
    EXPECT_FALSE(forbidden({0.1, 0.1}));
    EXPECT_FALSE(forbidden({0.5, 0.5}));  // in both
    EXPECT_FALSE(forbidden({0.9, 0.9}));
    EXPECT_TRUE(forbidden({0.1, 0.9}));
    // These leave a gap in the overlap only.
    const std::vector<Point> around{{0.1, 0.1}, {0.1, 0.4}, {0.4, 0.1},  {0.9, 0.9},
                                    {0.9, 0.6}, {0.6, 0.9}, {0.25, 0.25}};
    const Proof proof = prove(around, claim);
    EXPECT_FALSE(proof.covered);
    EXPECT_NEAR(proof.largest_gap.x, 0.55, 0.06);
    EXPECT_NEAR(proof.largest_gap.y, 0.55, 0.06);

    const std::vector<PolygonSet> three{{low}, {high}, {hole, Role::outside}};
    claim.places = tests::places_of(three, 0);
    EXPECT_TRUE(forbidden({0.5, 0.5}));
    EXPECT_FALSE(forbidden({0.42, 0.5}));
    const std::vector<PolygonSet> only_hole{{hole, Role::outside}};
    claim.places = tests::places_of(only_hole, 0);
    EXPECT_TRUE(forbidden({0.5, 0.5}));
    EXPECT_FALSE(forbidden({0.1, 0.9}));
    // All but the hole lies within 0.72 of these.
    claim.radius = 0.72;
    EXPECT_TRUE(prove(std::vector<Point>{{0, 0}, {1, 1}}, claim).covered == false);
    claim.radius = 1.001;
    EXPECT_TRUE(prove(std::vector<Point>{{0, 0}, {1, 1}}, claim).maximal);
}

TEST(ABorder, HasNoPointAndNeedsNone) {
    Claim claim = unit_claim(0.425);
    claim.places.border = 0.2;
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, claim).maximal);
    const Proof proof = prove(std::vector<Point>{{0.5, 0.19}}, claim);
    EXPECT_EQ(proof.forbidden, 0U);
    EXPECT_EQ(proof.forbidden_by, Proof::Closed::border);
    claim.radius = 0.424;
    const Proof proof_of_gap = prove(std::vector<Point>{{0.5, 0.5}}, claim);
    EXPECT_FALSE(proof_of_gap.covered);
    EXPECT_NEAR(proof_of_gap.largest_gap_distance, std::hypot(0.3, 0.3), 1e-7);
    EXPECT_NEAR(std::abs(proof_of_gap.largest_gap.x - 0.5), 0.3, 1e-7);
    claim.places.border = 0.5;
    EXPECT_TRUE(prove(std::vector<Point>{{0.5, 0.5}}, claim).maximal);
    claim.places.border = 0.6;
    EXPECT_TRUE(prove(std::vector<Point>{}, claim).covered);
}

// The search cuts the domain along lines. With a border, such a line may lie a rounding beside an
// edge of the mask, and then the search also looks at the narrow cells between the two.
TEST(TheLargestGap, AtTheEdgeOfAMaskHasItsRadiusOnTheSideThatIsOpen) {
    std::mt19937_64 random(5);
    const Mask left_is_open{2, 1, {1, 0}};
    for (int i = 0; i < 300; ++i) {
        Claim claim = unit_claim(0.1);
        claim.places.mask = &left_is_open;
        claim.places.border = std::pow(10, -std::uniform_real_distribution<double>(1, 12)(random));
        const Proof proof = prove(std::vector<Point>{{0.25, 0.5}}, claim);
        EXPECT_FALSE(proof.covered);
        EXPECT_EQ(proof.largest_gap_limit, 0.1);
        const double low = claim.places.border - 0.5;
        EXPECT_NEAR(proof.largest_gap_distance, std::hypot(0.25, low), 1e-6) << claim.places.border;
    }
}

TEST(PointsToKeep, MustComeFirstUnmoved) {
    const std::vector<Point> kept{{0.1, 0.1}, {0.9, 0.9}};
    Claim claim = unit_claim(0.95);
    claim.keep = kept;
    EXPECT_TRUE(prove(std::vector<Point>{{0.1, 0.1}, {0.9, 0.9}}, claim).maximal);
    EXPECT_EQ(prove(std::vector<Point>{{0.1, 0.1}}, claim).moved, 1U);
    EXPECT_EQ(prove(std::vector<Point>{{0.9, 0.9}, {0.1, 0.1}}, claim).moved, 0U);
    const Proof proof = prove(std::vector<Point>{{0.1, 0.1}, {0.9, std::nextafter(0.9, 1)}}, claim);
    EXPECT_EQ(proof.moved, 1U);
    EXPECT_FALSE(proof.kept || proof.covered || proof.maximal);
    claim.tolerance = -1;
    EXPECT_THROW(prove(std::vector<Point>{}, claim), BadRequest);
}

TEST(AClaim, OfPlacesThatMakeNoSenseIsABadRequestThatNamesTheOption) {
    const auto option_refused = [](auto change) {
        Claim claim = unit_claim(0.1);
        change(claim);
        try {
            prove(std::vector<Point>{}, claim);
        } catch (const BadRequest& error) {
            return error.option();
        }
        return std::string();
    };
    const Mask empty{};
    const Mask short_of_one{2, 1, {1}};
    const std::vector<PolygonRing> line{PolygonRing{{0, 0}, {1, 1}}};
    const std::vector<PolygonRing> broken{PolygonRing{{0, 0}, {1, 1}, {0, std::nan("")}}};
    const std::vector<PolygonRing> whole{square(0, 1)};
    EXPECT_EQ(option_refused([&](Claim& claim) { claim.places.mask = &empty; }), "mask");
    EXPECT_EQ(option_refused([&](Claim& claim) { claim.places.mask = &short_of_one; }), "mask");
    EXPECT_EQ(option_refused([&](Claim& claim) { claim.places = tests::places_of(line); }),
              "inside");
    EXPECT_EQ(option_refused([&](Claim& claim) { claim.places = tests::places_of(broken); }),
              "inside");
    for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(option_refused([&](Claim& claim) { claim.places.border = bad; }), "border");
        EXPECT_EQ(option_refused([&](Claim& claim) {
                      claim.places = tests::places_of(whole);
                      claim.places.edge = bad;
                  }),
                  "edge");
    }
    EXPECT_EQ(option_refused([](Claim& claim) {
                  claim.places.border = 0.1;
                  claim.domain.boundary = Boundary::torus;
              }),
              "border");
    EXPECT_EQ(option_refused([](Claim& claim) {
                  claim.places.border = 0.1;
                  claim.radius = 1e-12;
              }),
              "radius");
}

}  // namespace
