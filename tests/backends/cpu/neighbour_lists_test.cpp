// Given samples of classes whose distances differ much, the neighbour lists know what covers a
// candidate, as if each candidate were compared with all samples; and they stay short.
#include "backends/cpu/neighbour_lists.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "backends/field_snapshot.h"
#include "backends/radius_field_requests.h"
#include "checks/classes.h"
#include "plan/first_boxes.h"
#include "plan/make_plan.h"
#include "plan/radius_field.h"
#include "portable/conflict.h"

namespace {

using namespace lacuna;
using tests::FieldRequest;

// Positions at random on all copies, where samples may lie, in the order of draws.
std::vector<Sized> positions(const Plan& plan, std::size_t count, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const FieldPlan& field = plan.field();
    std::vector<Sized> all;
    while (all.size() < count) {
        const auto copy = static_cast<std::uint32_t>(random() % field.copies.count());
        const std::uint32_t x =
            field.copies.x_on(copy, static_cast<std::uint32_t>(random() % plan.width));
        const auto y = static_cast<std::uint32_t>(random() % plan.height);
        const std::uint32_t radius = field.radius_field->radius_at(x, y);
        if (radius != 0) all.push_back({x, y, radius});
    }
    return all;
}

bool conflict(const Plan& plan, const Sized& sample, const Sized& candidate) {
    const ClassCopies& copies = plan.field().copies;
    const Sized here{copies.x_on_copy(sample.x), sample.y, sample.radius};
    const Sized there{copies.x_on_copy(candidate.x), candidate.y, candidate.radius};
    return portable::conflicts(here, there,
                               copies.factor(copies.of(sample.x), copies.of(candidate.x)),
                               plan.period_x, plan.period_y);
}

// Throws candidates at the lists one after another; those that nothing covers become samples.
// Returns the number of entries in all lists.
std::size_t entries_after(const FieldRequest& made, std::size_t draws, std::size_t& samples) {
    const Plan plan = make_plan(made.request);
    const FirstBoxes& first = *plan.field().first_boxes;
    cpu::NeighbourLists lists(plan);
    std::vector<Sized> admitted;
    for (const Sized& candidate : positions(plan, draws, 3)) {
        const std::uint32_t block = block_at(first, candidate.x, candidate.y);
        bool is_covered = false;
        for (const Sized& sample : admitted)
            is_covered = is_covered || conflict(plan, sample, candidate);
        EXPECT_EQ(lists.is_covered({candidate.x, candidate.y, block, 0}), is_covered)
            << made.name << ", after " << admitted.size();
        if (is_covered) continue;
        admitted.push_back(candidate);
        lists.insert(candidate, block, nullptr);
    }
    samples = admitted.size();
    std::size_t entries = 0;
    cpu::SizedList scratch;
    for (std::uint32_t block = 0; block < first.block_count(); ++block)
        entries += lists
                       .of_part(block, first.nodes[first.blocks[block].node].box,
                                cpu::NeighbourLists::Which::all, scratch)
                       .count;
    return entries;
}

TEST(NeighbourLists, KnowWhatCoversACandidateHoweverMuchDistancesDiffer) {
    for (const FieldRequest& made : tests::class_requests()) {
        // Positions outside of a border or a mask have no block.
        if (made.keep || made.request.places.border > 0 || has_own_places(made.request.places))
            continue;
        std::size_t samples = 0;
        entries_after(made, 1500, samples);
        EXPECT_GT(samples, 0u);
    }
}

TEST(NeighbourLists, OfDistancesThatDifferMuchAreInProportionToSamplesAndBlocks) {
    for (const double least : {0.004, 0.001}) {
        const FieldRequest made =
            tests::with_classes(tests::uniform("far apart", 1, Boundary::torus),
                                distances_by_sum(std::vector{0.4, least}), {1, 1});
        const std::size_t blocks = make_plan(made.request).field().first_boxes->block_count();
        std::size_t samples = 0;
        const std::size_t entries = entries_after(made, 3000, samples);
        EXPECT_GT(samples, 1000u);
        // Each sample used to be in the lists of half of all blocks: 50 million entries.
        EXPECT_LT(entries, 4 * (samples + blocks)) << least;
    }
}

TEST(FirstBoxes, OfTwoSparseClassesThatMayLieCloseToEachOtherAreFew) {
    // Twice the factor of 2049 does not fit into 32 bits.
    const FieldRequest made =
        tests::with_classes(tests::uniform("close to each other", 1, Boundary::box),
                            {0.2049, 0.0001, 0.0001, 0.2049}, {1, 1});
    EXPECT_LT(make_plan(made.request).field().first_boxes->boxes.size(), 200u);
}

}  // namespace
