// Each verb of each backend gives the reference's results, on hostile scenes, number for number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "relax/available.h"
#include "relax/hilbert.h"
#include "relax/scenes.h"

namespace lacuna::relaxing::tests {
namespace {

std::string text(const Site& site) {
    std::ostringstream out;
    out << "(" << site.x << ", " << site.y << ") weight " << site.weight;
    return out.str();
}

std::string text(const Share& share) {
    std::ostringstream out;
    out << share.points << " points, mass " << share.mass << ", moments " << share.moment_x << ", "
        << share.moment_y;
    return out.str();
}

std::string text(std::uint32_t owner) {
    return std::to_string(owner);
}

// Names the first value that differs; empty if none does.
template <typename Value>
std::string difference(const char* what, const std::vector<Value>& expected,
                       const std::vector<Value>& got) {
    if (expected.size() != got.size()) return std::string("another number of ") + what;
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!(expected[i] == got[i])) {
            std::ostringstream out;
            out << what << " " << i << ": " << text(got[i]) << " instead of " << text(expected[i]);
            return out.str();
        }
    return "";
}

// Compares the results of assign and accumulate.
std::string difference_of_looks(RelaxBackend& expected, RelaxBackend& got) {
    expected.assign();
    got.assign();
    const std::string owners = difference("owner", expected.owners(), got.owners());
    if (!owners.empty()) return owners;
    expected.accumulate();
    got.accumulate();
    return difference("share", expected.shares(), got.shares());
}

class Verbs : public OnBackend {};
INSTANTIATE_TEST_SUITE_P(All, Verbs, kRelaxBackends, name_of_parameter);

TEST_P(Verbs, leave_what_the_references_do) {
    for (const Scene& scene : scenes()) {
        const Lattice lattice = scene.lattice();
        const std::vector<Site> start = scene.sites(lattice);
        const auto reference = make_backend("reference", lattice, start);
        const auto backend = make_backend(GetParam(), lattice, start);
        for (int iteration = 0; iteration < 6; ++iteration) {
            ASSERT_EQ(difference_of_looks(*reference, *backend), "") << scene << ", " << iteration;
            // Calls rest() in each iteration; a run calls it only once.
            const std::vector<Site> before = reference->sites();
            reference->rest();
            backend->rest();
            ASSERT_EQ(difference("rested", reference->sites(), backend->sites()), "")
                << scene << ", " << iteration;
            reference->restore(before);
            backend->restore(before);
            difference_of_looks(*reference, *backend);
            const std::uint32_t way = iteration % 2 == 0 ? LONG_WAY : WHOLE_WAY;
            reference->move(way);
            backend->move(way);
            ASSERT_EQ(difference("site", reference->sites(), backend->sites()), "")
                << scene << ", " << iteration;
        }
    }
}

TEST_P(Verbs, do_the_same_from_extreme_weights) {
    for (const Scene& scene : scenes()) {
        const Lattice lattice = scene.lattice();
        std::vector<Site> start = scene.sites(lattice);
        std::mt19937_64 random(1);
        for (std::size_t i = 1; i < start.size(); ++i)
            start[i].weight = i % 3 == 0
                                  ? lattice.numbers.farthest
                                  : random() % ((lattice.numbers.farthest >> (random() % 20)) + 1);
        const auto reference = make_backend("reference", lattice, start);
        const auto backend = make_backend(GetParam(), lattice, start);
        for (int iteration = 0; iteration < 2; ++iteration) {
            ASSERT_EQ(difference_of_looks(*reference, *backend), "") << scene << ", " << iteration;
            const std::uint32_t way = iteration % 2 == 0 ? LONG_WAY : WHOLE_WAY;
            reference->move(way);
            backend->move(way);
            ASSERT_EQ(difference("site", reference->sites(), backend->sites()), "")
                << scene << ", " << iteration;
        }
    }
}

TEST_P(Verbs, do_the_same_where_samples_share_their_spot) {
    for (const Scene& scene : scenes()) {
        const Lattice lattice = scene.lattice();
        std::vector<Site> start = scene.sites(lattice);
        for (std::size_t i = 1; i < start.size(); i += 2) start[i] = start[i / 3];
        const auto reference = make_backend("reference", lattice, start);
        const auto backend = make_backend(GetParam(), lattice, start);
        ASSERT_EQ(difference_of_looks(*reference, *backend), "") << scene;
        reference->rest();
        backend->rest();
        ASSERT_EQ(difference("rested", reference->sites(), backend->sites()), "") << scene;
    }
}

// A search for many points far from importance takes long, so it must ask within the search, too.
TEST_P(Verbs, ask_whether_to_go_on_for_every_few_points_far_from_importance) {
    constexpr std::size_t kPoints = 20'000;
    const Scene scene{"", random_points(kPoints, 1, 1, 14), pixel_field(), RelaxOptions{}};
    const Lattice lattice = scene.lattice();
    const auto backend = make_backend(GetParam(), lattice, scene.sites(lattice), 1);
    backend->assign();
    backend->accumulate();
    std::size_t questions = 0;
    backend->watch([&] { return ++questions < kPoints / 1024; });
    EXPECT_THROW(backend->rest(), Cancelled);
}

TEST_P(Verbs, give_every_lattice_point_of_importance_to_somebody) {
    for (const Scene& scene : scenes()) {
        const Lattice lattice = scene.lattice();
        const auto backend = make_backend(GetParam(), lattice, scene.sites(lattice));
        backend->assign();
        backend->accumulate();
        std::uint64_t points = 0;
        for (const Share& share : backend->shares()) points += share.points;
        EXPECT_EQ(points, lattice.points) << scene;
    }
}

// The tests above must notice a backend that is off by little.
TEST(Difference, is_found_in_one_step_of_one_site) {
    const Scene scene = scenes()[6];
    const Lattice lattice = scene.lattice();
    const std::vector<Site> start = scene.sites(lattice);
    std::vector<Site> moved = start;
    moved[7].x += lattice.numbers.step_x;
    const auto reference = make_backend("reference", lattice, start);
    const auto backend = make_backend("cpu", lattice, moved);
    EXPECT_EQ(difference("site", reference->sites(), backend->sites()),
              std::string("site 7: ")
                  .append(text(moved[7]))
                  .append(" instead of ")
                  .append(text(start[7])));
    EXPECT_NE(difference_of_looks(*reference, *backend), "");
}

TEST(Ties, go_to_the_lowest_index) {
    const Scene scene = scenes()[6];
    const Lattice lattice = scene.lattice();
    const std::vector<Site> start(5, scene.sites(lattice)[0]);
    for (const char* const name : {"reference", "cpu"}) {
        const auto backend = make_backend(name, lattice, start);
        backend->assign();
        for (const std::uint32_t owner : backend->owners()) ASSERT_EQ(owner, 0u) << name;
    }
}

// Sites in rows are put onto a curve. Sites on a curve stay as they are, and so do the answers.
TEST(Order, of_sites_is_left_if_they_are_on_a_curve) {
    Scene scene{"a grid", {}, std::nullopt, on(1, 1, Boundary::box)};
    constexpr int kSide = 32;
    for (int i = 0; i < kSide * kSide; ++i)
        scene.points.push_back({(i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide});
    const Lattice lattice = scene.lattice();
    const std::vector<Site> rows = scene.sites(lattice);
    std::vector<Site> curve;
    for (const std::uint32_t index : hilbert_order(rows, nobody_asks)) curve.push_back(rows[index]);
    EXPECT_NE(difference("site", rows, curve), "");
    const std::vector<std::uint32_t> order = hilbert_order(curve, nobody_asks);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
    for (const std::vector<Site>& start : {rows, curve}) {
        const auto reference = make_backend("reference", lattice, start);
        const auto backend = make_backend("cpu", lattice, start);
        reference->assign();
        backend->assign();
        EXPECT_EQ(difference_of_looks(*reference, *backend), "");
    }
}

}  // namespace
}  // namespace lacuna::relaxing::tests
