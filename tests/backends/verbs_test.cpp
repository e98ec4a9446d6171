// Each verb alone, on each device backend: set the scene, call the verb, and compare the memory
// with the cpu backend's, number for number.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/field_scenes.h"
#include "backends/printing.h"
#include "backends/scenes.h"
#include "plan/radius_field.h"

namespace lacuna {
namespace verbs_test {

using tests::Scene;
using Verb = std::function<void(Backend&, const Scene&)>;

// The memory after a verb, without the capacity, which is a backend's own choice.
struct Left {
    Snapshot memory;
    std::vector<Sample> samples;
    std::uint64_t survivors;
    std::vector<std::uint32_t> free_lengths;
    std::uint32_t bin_width;
    std::vector<std::uint32_t> bin_widths;
};

Left after(Backend& backend, const Scene& scene, const Verb& verb) {
    backend.restore(scene.memory);
    verb(backend, scene);
    Left left{backend.snapshot(), {}, 0, {}, 0, {}};
    const Round round = backend.finish_round();
    left.survivors = round.survivors;
    left.bin_width = round.bin_width;
    left.samples.assign(round.samples.begin(), round.samples.end());
    left.free_lengths.assign(round.free_lengths.begin(), round.free_lengths.end());
    left.bin_widths.assign(round.bin_widths.begin(), round.bin_widths.end());
    return left;
}

// Names the first entry that differs.
template <typename T>
testing::AssertionResult same(const char* what, const std::vector<T>& expected,
                              const std::vector<T>& got) {
    for (std::size_t i = 0; i < std::min(expected.size(), got.size()); ++i)
        if (!(expected[i] == got[i]))
            return testing::AssertionFailure()
                   << what << " " << i << ": expected " << testing::PrintToString(expected[i])
                   << ", got " << testing::PrintToString(got[i]);
    if (expected.size() != got.size())
        return testing::AssertionFailure()
               << what << ": expected " << expected.size() << ", got " << got.size();
    return testing::AssertionSuccess();
}

void expect_same(const Left& expected, const Left& got) {
    EXPECT_TRUE(same("candidate", expected.memory.candidates, got.memory.candidates));
    EXPECT_TRUE(same("status", expected.memory.statuses, got.memory.statuses));
    EXPECT_TRUE(same("line", expected.memory.spans, got.memory.spans));
    EXPECT_TRUE(same("cell", expected.memory.grid, got.memory.grid));
    EXPECT_TRUE(same("box", expected.memory.boxes, got.memory.boxes));
    EXPECT_TRUE(same("earlier sample", expected.memory.samples, got.memory.samples));
    EXPECT_TRUE(same("word of bits", expected.memory.bits, got.memory.bits));
    EXPECT_EQ(expected.memory.box_width, got.memory.box_width);
    EXPECT_TRUE(same("sample", expected.samples, got.samples));
    EXPECT_EQ(expected.survivors, got.survivors);
    EXPECT_EQ(expected.bin_width, got.bin_width);
    EXPECT_TRUE(same("free length", expected.free_lengths, got.free_lengths));
    EXPECT_TRUE(same("width", expected.bin_widths, got.bin_widths));
}

void locate(Backend& backend, const Scene& scene) {
    backend.locate(scene.draws);
}
void admit(Backend& backend, const Scene&) {
    backend.admit();
}
void subtract(Backend& backend, const Scene&) {
    backend.subtract();
}
void refine(Backend& backend, const Scene&) {
    backend.refine(false);
}
void refine_by_halves(Backend& backend, const Scene&) {
    backend.refine(true);
}
bool has_boxes(const Scene& scene) {
    return tests::has_boxes(scene.plan, scene.memory);
}
bool can_halve(const Scene& scene) {
    return scene.memory.box_width > 1 || scene.plan.has_radius_field();
}
// Ends with the verb for the scene's bins.
void whole_round(Backend& backend, const Scene& scene) {
    backend.locate(scene.draws);
    backend.admit();
    if (has_boxes(scene))
        backend.refine(can_halve(scene));
    else
        backend.subtract();
}

class Verbs : public tests::OnBackend {
protected:
    Left on_device(const Scene& scene, const Verb& verb, device::Tuning tuning = {}) {
        return after(*tests::make_backend(GetParam(), scene.plan, tuning), scene, verb);
    }
    // The verb leaves the cpu backend's memory, in one slab and in many, of tiles; in cells, for
    // any number of work items that divide the lines near a sample.
    void expect_equal(const Scene& scene, const Verb& verb) {
        SCOPED_TRACE(scene.name);
        const Left expected = after(*tests::make_backend("cpu", scene.plan), scene, verb);
        expect_same(expected, on_device(scene, verb));
        if (has_boxes(scene)) return;
        SCOPED_TRACE("three lines a slab, 32 rows a tile, three slices");
        const std::uint64_t line_bytes = scene.plan.is_cells()
                                             ? 4 * tests::words_of_line(scene.plan)
                                             : scene.memory.capacity * sizeof(Span);
        expect_same(expected, on_device(scene, verb, {3 * line_bytes, 32, 3}));
    }
};

using tests::random_scenes;

std::vector<Scene> exact_scenes() {
    std::vector<Scene> all = tests::field_scenes();
    for (Scene& scene : random_scenes(Mode::exact)) {
        scene.name += ", exact";
        all.push_back(std::move(scene));
    }
    return all;
}

std::vector<Scene> all_scenes() {
    std::vector<Scene> all = random_scenes(Mode::lines);
    for (Scene& scene : exact_scenes()) all.push_back(std::move(scene));
    for (Scene& scene : tests::random_cells_scenes()) all.push_back(std::move(scene));
    return all;
}

TEST_P(Verbs, MemoryWithAFieldIsWhatWasRestored) {
    for (const Scene& scene : tests::field_scenes()) {
        SCOPED_TRACE(scene.name);
        Left left = on_device(scene, [](Backend&, const Scene&) {});
        EXPECT_EQ(left.memory.capacity, 0u);
        EXPECT_TRUE(left.memory == scene.memory);
        expect_equal(scene, [](Backend&, const Scene&) {});
    }
}

TEST_P(Verbs, LocateEqualsTheCpuInEveryScene) {
    for (const Scene& scene : all_scenes()) expect_equal(scene, locate);
}

TEST_P(Verbs, AdmitEqualsTheCpuInEveryScene) {
    for (const Scene& scene : all_scenes()) expect_equal(scene, admit);
}

TEST_P(Verbs, AdmitKeepsStatusesThatAreDecided) {
    tests::Chance chance(5);
    for (Scene& scene : all_scenes()) {
        // A third is rejected at random, and half of what the cpu backend then admits is admitted.
        std::vector<std::uint32_t>& statuses = scene.memory.statuses;
        for (std::uint32_t& status : statuses)
            if (chance.one_in(3)) status = STATUS_REJECTED;
        const Left left = after(*tests::make_backend("cpu", scene.plan), scene, admit);
        for (std::size_t i = 0; i < statuses.size(); ++i)
            if (left.memory.statuses[i] == STATUS_ADMITTED && chance.one_in(2))
                statuses[i] = STATUS_ADMITTED;
        expect_equal(scene, admit);
        EXPECT_TRUE(same("status", left.memory.statuses, on_device(scene, admit).memory.statuses));
    }
}

// No two samples of a round lie in the same cell, and none where a field has no samples.
void admit_one_a_cell(Scene& scene, tests::Chance& chance) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
    for (std::size_t i = 0; i < scene.memory.statuses.size(); ++i) {
        const Candidate& candidate = scene.memory.candidates[i];
        const std::uint32_t side = std::max(1u, device::grid_of(scene.plan).side);  // 0 in cells
        const bool is_first =
            taken.insert({candidate.x / side, candidate.y / side}).second &&
            (!scene.plan.has_radius_field() ||
             scene.plan.field().radius_field->radius_at(candidate.x, candidate.y) != 0);
        scene.memory.statuses[i] =
            is_first && chance.one_in(2) ? STATUS_ADMITTED : STATUS_REJECTED + chance.below(2);
    }
}

TEST_P(Verbs, SubtractEqualsTheCpuInEveryScene) {
    tests::Chance chance(6);
    for (Scene& scene : all_scenes()) {
        if (has_boxes(scene)) continue;
        admit_one_a_cell(scene, chance);
        expect_equal(scene, subtract);
    }
}

TEST_P(Verbs, RefineEqualsTheCpuInEveryScene) {
    tests::Chance chance(60);
    for (Scene& scene : exact_scenes()) {
        admit_one_a_cell(scene, chance);
        expect_equal(scene, refine);
        if (!has_boxes(scene) || can_halve(scene)) expect_equal(scene, refine_by_halves);
    }
}

TEST_P(Verbs, RefineGoesOnUntilBoxesAreOneUnitWide) {
    tests::Chance chance(61);
    for (Scene& scene : random_scenes(Mode::exact)) {
        admit_one_a_cell(scene, chance);
        // In scenes with few samples every refinement doubles the boxes, so they begin thin.
        if (has_boxes(scene)) {
            scene.memory.box_width = std::min(scene.memory.box_width, 8u);
            for (Box& box : scene.memory.boxes) box.width = scene.memory.box_width;
        }
        expect_equal(scene, [](Backend& backend, const Scene& start) {
            constexpr std::size_t kMostBoxes = 20'000;
            std::uint32_t width =
                has_boxes(start) ? start.memory.box_width : start.plan.strip_width;
            for (backend.refine(false);
                 width > 1 && backend.finish_round().free_lengths.size() < kMostBoxes; width /= 2) {
                backend.locate({});
                backend.admit();
                backend.refine(true);
            }
        });
    }
}

TEST_P(Verbs, NoBoxIsLeftWhereOneSampleCoversAll) {
    Scene scene{"one sample", tests::plan_of(0.9, 4, Boundary::torus, 1, 1, Mode::exact), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    tests::set_candidates(scene.plan, {{5, 5, 0, 0}}, scene.memory, STATUS_ADMITTED);
    const Left left = on_device(scene, refine_by_halves);
    EXPECT_TRUE(left.memory.boxes.empty());
    EXPECT_TRUE(left.free_lengths.empty());
    EXPECT_EQ(left.memory.grid[0], (Sample{5, 5}));
    expect_equal(scene, refine_by_halves);
}

// An image of such a sample is nearly 2^32 units away. The square of dx is 2^57 here, so the
// squared distance does not fit 64 bits.
TEST_P(Verbs, NothingIsTakenByTheFarImageOfASampleAtTheTop) {
    Scene scene{"far image", tests::plan_of(0.1269, 1, Boundary::torus, 1, 1, Mode::exact), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    for (std::vector<Span>& line : scene.memory.spans) line.clear();
    scene.memory.spans[4] = {{7'169'816, 120'866'211}};
    tests::set_candidates(scene.plan, {{1'435'314'147, scene.plan.height - 30'012, 5, 0}},
                          scene.memory, STATUS_ADMITTED);
    const std::uint32_t width = scene.plan.strip_width;
    const std::vector<Box> left_half = {{4 * width, width / 2, 7'169'816, 120'866'211}};
    EXPECT_TRUE(same("box", left_half, on_device(scene, refine_by_halves).memory.boxes));
    expect_equal(scene, refine_by_halves);
}

TEST_P(Verbs, CandidatesThatEarlierSamplesCoverAreNoSurvivors) {
    Scene scene{"covered", tests::plan_of(0.1, 4, Boundary::torus, 1, 1, Mode::exact), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    scene.memory.grid[0] = {0, 0};
    const std::uint32_t r = scene.plan.radius;
    const std::uint32_t top = scene.plan.height;
    // At the radius' distance a candidate is free, a unit closer it is not; across the edge too.
    tests::set_candidates(
        scene.plan, {{0, r, 0, 0}, {0, r - 1, 0, 1}, {0, top - r, 0, 2}, {0, top - r + 1, 0, 3}},
        scene.memory);
    const Left left = on_device(scene, admit);
    EXPECT_EQ(left.survivors, 2u);
    const std::vector<Sample> free = {{0, r}, {0, top - r}};
    EXPECT_TRUE(same("sample", free, left.samples));
    expect_equal(scene, admit);
}

TEST_P(Verbs, AWholeRoundEqualsTheCpuInEveryScene) {
    for (const Scene& scene : all_scenes()) expect_equal(scene, whole_round);
}

TEST_P(Verbs, ASecondRoundStartsFromWhatTheFirstLeft) {
    for (const Scene& scene : all_scenes()) {
        if (scene.draws.empty()) continue;
        expect_equal(scene, [](Backend& backend, const Scene& scene_of_first) {
            whole_round(backend, scene_of_first);
            backend.finish_round();
            tests::Chance chance(7);
            // More draws than before, so that buffers grow, then fewer.
            for (const std::uint32_t count : {400u, 3u}) {
                const Snapshot memory = backend.snapshot();
                const std::vector<Draw> draws =
                    tests::random_draws(scene_of_first.plan, memory, chance, count);
                backend.locate(draws);
                backend.admit();
                if (has_boxes(scene_of_first))
                    backend.refine(false);
                else
                    backend.subtract();
                if (count == 400)
                    backend.finish_round();
                else
                    backend.snapshot();  // waits: the draws end here
            }
        });
    }
}

TEST_P(Verbs, NoCandidatesLeaveEverythingAsItWas) {
    tests::Chance chance(8);
    Scene scene{"no candidates", tests::plan_of(0.1, 5, Boundary::torus), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    tests::set_hostile_spans(scene.plan, chance, scene.memory);
    const Left left = on_device(scene, [](Backend& backend, const Scene&) {
        backend.admit();
        backend.subtract();
    });
    EXPECT_TRUE(same("line", scene.memory.spans, left.memory.spans));
    EXPECT_TRUE(left.samples.empty());
}

TEST_P(Verbs, OfManyDrawsAtOnePlaceTheFirstIsAdmitted) {
    Scene scene{"one place", tests::plan_of(0.1, 5, Boundary::torus), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    for (std::uint32_t order = 0; order < 1000; ++order)
        scene.draws.push_back({7, 12345, 0, 999 - order});
    const Left left = on_device(scene, whole_round);
    const std::vector<Sample> first = {{7 * scene.plan.strip_width, 12345}};
    EXPECT_TRUE(same("sample", first, left.samples));
    expect_equal(scene, whole_round);
}

// A chain of candidates along one line, each in conflict with the two beside it only.
Scene chain(std::uint32_t length, bool upwards) {
    Scene scene{upwards ? "a chain upwards" : "a chain downwards",
                tests::plan_of(0.001, 1, Boundary::box, 0.1, 1),
                {},
                {}};
    scene.memory = tests::empty_memory(scene.plan);
    std::vector<Candidate> candidates;
    for (std::uint32_t i = 0; i < length; ++i)
        candidates.push_back({scene.plan.centre_of_line(0), i * (scene.plan.radius - 1), 0,
                              upwards ? i : length - 1 - i});
    tests::set_candidates(scene.plan, candidates, scene.memory);
    return scene;
}

TEST_P(Verbs, ChainsOfAnyDepthAreSettled) {
    constexpr std::uint32_t kLength = 999;
    for (const bool upwards : {true, false}) {
        const Scene scene = chain(kLength, upwards);
        const Left left = on_device(scene, [](Backend& backend, const Scene&) {
            backend.admit();
            backend.subtract();
        });
        // The first is admitted, the next is rejected, alternating; the number is odd, so both ends
        // stay.
        std::vector<std::uint32_t> alternating;
        for (std::uint32_t i = 0; i < kLength; ++i)
            alternating.push_back(i % 2 == 0 ? STATUS_ADMITTED : STATUS_REJECTED);
        EXPECT_TRUE(same("status", alternating, left.memory.statuses));
        EXPECT_EQ(left.samples.size(), (kLength + 1) / 2);
        expect_equal(scene, [](Backend& backend, const Scene&) {
            backend.admit();
            backend.subtract();
        });
    }
}

// The lowest tile of a line with `spans` spans and room for `capacity`; a sample cuts the last span
// in two.
Scene tight(std::uint32_t spans, std::uint32_t capacity) {
    Scene scene{"tight", tests::plan_of(0.01, 1, Boundary::box), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    scene.memory.capacity = capacity;
    std::vector<Span>& line = scene.memory.spans[0];
    line.clear();
    for (std::uint32_t i = 0; i + 1 < spans; ++i) line.push_back({10 * i, 10 * i + 1});
    const std::uint32_t middle = scene.plan.height / 10;
    line.push_back({middle - 2 * scene.plan.radius, middle + 2 * scene.plan.radius});
    tests::set_candidates(scene.plan, {{scene.plan.centre_of_line(0), middle, 0, 0}}, scene.memory,
                          STATUS_ADMITTED);
    return scene;
}

TEST_P(Verbs, RoomThatIsExactlyUsedUpDoesNotGrow) {
    const Scene scene = tight(11, 12);
    EXPECT_EQ(on_device(scene, subtract).memory.capacity, 12u);
    expect_equal(scene, subtract);
}

TEST_P(Verbs, RoomPassedByOneGrowsAndLosesNothing) {
    const Scene scene = tight(12, 12);
    const Left left = on_device(scene, subtract);
    EXPECT_EQ(left.memory.capacity, 24u);
    EXPECT_EQ(left.memory.spans[0].size(), 13u);
    expect_equal(scene, subtract);
}

TEST_P(Verbs, RoomGrowsAsOftenAsItTakes) {
    Scene scene{"room for one span", tests::plan_of(0.005, 3, Boundary::torus), {}, {}};
    scene.memory = tests::empty_memory(scene.plan);
    scene.memory.capacity = 1;
    tests::Chance chance(9);
    scene.draws = tests::random_draws(scene.plan, scene.memory, chance, 8000);
    EXPECT_GE(on_device(scene, whole_round).memory.capacity, 16u);
    expect_equal(scene, whole_round);
}

INSTANTIATE_TEST_SUITE_P(Backend, Verbs, tests::kDeviceBackends, tests::name_of_parameter);

}  // namespace verbs_test
}  // namespace lacuna
