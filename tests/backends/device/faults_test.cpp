// The kernels do the work, and nothing else does: faults planted in the bodies and in the portable
// arithmetic are noticed on OpenCL and on Vulkan.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/cells_scenes.h"
#include "backends/device/altered.h"
#include "backends/radius_field_requests.h"
#include "backends/scenes.h"
#include "space/cpu_backend.h"
#include "space/meshes.h"
#include "space/plan.h"
#include "space/portion.h"

namespace lacuna {
namespace {

using tests::Fault;

class Faults : public tests::OnFaultyBackend {
protected:
    // A fault is noticed if it changes the set, takes more rounds or causes an error. No fault may
    // leave a box unwritten or write it in another place, because the old content of memory would
    // be read as coordinates: scan_test has a fault in scan. Oclgrind names each access out of
    // range: oclgrind --build-options -cl-opt-disable device_test --gtest_filter='*Faults*/opencl'.
    void expect_noticed(const Plan& plan, const std::vector<Fault>& faults,
                        const device::Tuning& tuning = {}) {
        expect_noticed(plan, tests::run_on_cpu(plan), faults, [&](const Fault& fault) {
            return tests::make_faulty(GetParam(), plan, fault, tuning);
        });
    }
    void expect_noticed_in_space(const SpaceRequest& request, const std::vector<Fault>& faults) {
        const Plan plan = space::CheckedRequest(request).plan(*request.radius, *request.limit);
        const OutcomeOf<space::SpaceSample> on_cpu =
            tests::run_rounds(plan, *space::make_cpu_backend(plan, 1));
        expect_noticed(plan, on_cpu, faults, [&](const Fault& fault) {
            return tests::make_faulty_in_space(GetParam(), plan, fault);
        });
    }
    template <typename Placed, typename Make>
    void expect_noticed(const Plan& plan, const OutcomeOf<Placed>& on_cpu,
                        const std::vector<Fault>& faults, const Make& make_faulty) {
        ASSERT_LE(on_cpu.rounds, tests::kMostRounds);
        ASSERT_FALSE(on_cpu.samples.empty());
        for (const Fault& fault : faults) {
            const auto faulty = make_faulty(fault);
            try {
                EXPECT_TRUE(tests::run_rounds(plan, *faulty, on_cpu.rounds).samples !=
                            on_cpu.samples)
                    << fault.file << ": " << fault.from << " became " << fault.to;
            } catch (const DeviceError&) {
            } catch (const Unavailable&) {  // wrong sums ask for too much memory
            }
        }
    }

    void expect_ended_early(const Plan& plan, const Fault& fault, const std::string& job) {
        const auto faulty = tests::make_faulty(GetParam(), plan, fault);
        try {
            tests::run_rounds(plan, *faulty);
            ADD_FAILURE() << job << " went unnoticed";
        } catch (const DeviceError& error) {
            const std::string what = error.what();
            EXPECT_NE(what.find(": " + job + ": a loop was ended early by the driver"),
                      std::string::npos)
                << what;
        }
    }

    const Plan lines_ = tests::plan_of(0.03, 6, Boundary::torus);
    const Plan exact_ = tests::plan_of(0.03, 6, Boundary::torus, 1, 1, Mode::exact);
    const Plan cells_ =
        tests::cells_plan(tests::noise_field(40, 30, 5), 0.02, 5, Metric::mean, Boundary::torus);
};

INSTANTIATE_TEST_SUITE_P(Device, Faults, tests::kDeviceBackends, tests::name_of_parameter);

TEST_P(Faults, InLinesAreNoticed) {
    // Each line has twelve tiles.
    expect_noticed(
        tests::plan_of(0.03, 6, Boundary::torus, 0.2, 8),
        {{"bodies/lines/locate.h", "span.begin + (draw.rank - passed)", "span.begin"},
         {"bodies/lines/open_lines.h", "% a.tiles * a.tile_height",
          "% a.tiles / 2u * a.tile_height"},
         {"bodies/lines/sum_tiles.h", "AT(results, line) = sum;", "AT(results, line) = sum / 2u;"},
         {"bodies/lines/decide.h", "other.order >= order) continue;",
          "other.order <= order) continue;"},
         {"bodies/lines/decide.h", "(decided.waits ?", "(false ?"},
         {"bodies/lines/decide.h", "i = AT(next_candidates, i)", "i = NO_SAMPLE"},
         {"bodies/exact/covered_in_grid.h", "ATOMIC_SET(cell_heads, cell, i)", "NO_SAMPLE"},
         {"bodies/lines/insert_in_grid.h", "1u << row % 32u", "1u"},
         {"bodies/common/admit.h", "1u << candidate.order % 32u", "1u"},
         {"bodies/common/count_samples.h", "count_bits(AT(outcomes, i))", "1u"},
         {"bodies/common/list_samples.h", "count_bits(AT(outcomes, word) & below)", "0u"},
         {"bodies/lines/subtract.h", "? 3u : 1u;", "? 1u : 1u;"},
         {"bodies/lines/collect.h", "i += rows_end - row;", "i += 128u;"},
         {"bodies/lines/subtract.h", "gap.above.end > end;", "false;"},
         {"bodies/lines/place.h", "? candidate.x :", "? 0u : candidate.x + 0u *"},
         {"portable/chord.h", "y + 1u - cut;", "y + 1000u - cut;", "subtract"}},
        {.rows_of_tile = 32});
    // Only where a round has more than 64 words of draws do the sums of blocks count.
    expect_noticed(
        tests::plan_of(0.005, 2, Boundary::torus),
        {{"bodies/common/sums.h", "AT(sums, number >> block_bits)", "0u", "list_samples"}});
}

TEST_P(Faults, InExactAreNoticed) {
    // The last 5 % are left out: they take many refinements, and some faults add boxes in each.
    Plan nearly_all = exact_;
    nearly_all.limit = nearly_all.expected_samples * 19 / 20;
    expect_noticed(
        nearly_all,
        {{"bodies/exact/locate_in_boxes.h", "box.begin + draw.rank,", "box.begin,"},
         {"bodies/lines/place.h", "? candidate.x",
          "? candidate.x / a.g.strip_width * a.g.strip_width"},
         {"bodies/exact/covered_in_grid.h", "return covered != 0u;", "return false;"},
         {"bodies/exact/covered_in_grid.h", "k < columns.count", "k < 1u"},
         {"bodies/lines/insert_in_grid.h", "AT(grid_y, cell) = candidate.y",
          "AT(grid_y, cell) = candidate.x"},
         {"bodies/lines/subtract.h", "g.period_x) + g.chord_margin", "g.period_x)"},
         {"bodies/exact/unfold.h", "begin, end};", "begin, span.end};"},
         {"bodies/exact/grid.h", "i < near.columns.count", "i < 1u"},
         {"bodies/exact/pieces.h", "(is_at_edge || has_classes) ? 3u", "false ? 3u"},
         {"bodies/exact/pieces.h",
          "squared_length(cut_distance(a.g, strip, x_of(a, neighbour, strip)), dy) <", "0u <"},
         {"bodies/exact/strip.h", "g.period_x) + middle;", "g.period_x);"},
         {"bodies/exact/grid.h", "= box.end - box.begin;", "= 1u;"},
         {"portable/stretch.h", ": end + reach;", ": end;"}});
}

TEST_P(Faults, InCellsAreNoticed) {
    expect_noticed(
        cells_,
        {{"bodies/cells/locate_in_cells.h", "draw.rank - passed), line",
          "(draw.rank - passed) / 2u), line"},
         {"bodies/cells/locate_in_cells.h", "number * 32u +", "number * 31u +"},
         {"bodies/cells/look_up_radii.h", "+ AT(row_of, candidate.y)", ""},
         {"bodies/cells/decide_in_cells.h", "other.order >= candidate.order) continue;",
          "other.order <= candidate.order) continue;"},
         {"bodies/cells/decide_in_cells.h", "return waits ? STATUS_UNDECIDED",
          "return false ? STATUS_UNDECIDED"},
         {"bodies/cells/decide_in_cells.h", "k < columns.count", "k < 1u"},
         {"bodies/cells/decide_in_cells.h", "window < windows", "window < 1u"},
         {"bodies/cells/decide_in_cells.h", "candidate.y, a.g.period_x, a.g.period_y,",
          "candidate.y, 0u, 0u,"},
         {"bodies/cells/limit_in_cells.h", "AT(candidate_radii, j)", "AT(candidate_radii, i)"},
         {"bodies/cells/subtract_in_cells.h", "cut.radius, pixel)", "cut.radius, cut.radius)"},
         {"bodies/cells/subtract_in_cells.h", "(cut.dx, farthest) < limit",
          "(cut.dx, nearest) < limit"},
         {"bodies/cells/subtract_in_cells.h", "nearest) >= limit", "nearest) > limit + 20u"},
         {"bodies/cells/subtract_in_cells.h", "y - reach + 1)), ", "y - reach + 2)), "},
         {"bodies/cells/subtract_in_cells.h", "min(to_i64(end), y + reach)",
          "min(to_i64(end), y + reach - 1)"},
         {"bodies/cells/subtract_in_cells.h", "+ image * to_i64(a.g.height)", ""},
         {"bodies/cells/subtract_in_cells.h", "k < lines.count", "k < lines.count / 2u"},
         {"bodies/cells/subtract_in_cells.h", "any_set(ON a, cut.line, begin, end)",
          "any_set(ON a, cut.line, begin, begin)"},
         {"bodies/cells/subtract_in_cells.h", "class_bound(AT(pixel_radii, cut.pixel_begin + row))",
          "1u"},
         {"portable/bits.h", "lowest_bit(rest)", "lowest_bit(word)"}});
    // Only where columns are long do wrong orders show.
    expect_noticed(
        tests::cells_plan(tests::constant_field(1, 1), 0.01, 10, Metric::min, Boundary::torus),
        {{"bodies/cells/decide_in_cells.h", "return bucket > 0u ?",
          "return bucket > 1u ? end : bucket > 0u ?"},
         {"bodies/cells/sort_columns.h", "comes_before(moved,", "false && comes_before(moved,"}});
}

// A field of noise, a mask, and a sample that was there before.
Plan radius_field_plan(Boundary boundary, double part) {
    Field field = tests::noise_field(12, 9, 7);
    Mask mask;
    mask.columns = 7;
    mask.rows = 8;
    mask.allowed.assign(56, 1);
    for (const std::size_t i : {3u, 11u, 12u, 30u, 31u, 50u}) mask.allowed[i] = 0;
    const std::vector<Point> keep = {{0.3, 0.35}};
    Request request;
    request.domain.boundary = boundary;
    request.field = &field;
    request.scale = 0.025;
    request.places.mask = &mask;
    request.keep = keep;
    request.paper2011.round_size = 128;
    request.paper2011.lines_per_radius = 2;  // boxes are long, and many samples reach some of them
    Plan plan = make_plan(request);
    plan.limit = static_cast<std::uint64_t>(static_cast<double>(plan.expected_samples) * part);
    return plan;
}

TEST_P(Faults, WithARadiusFieldAreNoticed) {
    expect_noticed(
        radius_field_plan(Boundary::torus, 0.8),
        {{"bodies/exact/locate_with_field.h", "box.begin + draw.rank;", "box.begin;"},
         {"bodies/exact/locate_with_field.h", "(ON grids, x, y);", "(ON grids, x, box.begin);"},
         {"bodies/exact/covered_in_lists.h", "if (radius == 0u) return true;", ""},
         {"bodies/exact/covered_in_lists.h", "entry.y, entry.radius,", "entry.y, 0xffffffffu,"},
         {"bodies/exact/reach.h", "if (node != links.next)", "if (node == links.next)"},
         {"bodies/exact/reach.h", "(candidate.radius, greatest,",
          "(candidate.radius / 2u, greatest,"},
         {"bodies/exact/reach.h", "first == root ? a.g.period_y : 0u", "0u"},
         {"bodies/exact/reach.h", "root) : root;", "root) : LOAD(BlockNode, node_of, 0u).node;"},
         {"bodies/exact/decide_with_field.h", "other.order >= candidate.order",
          "other.order <= candidate.order"},
         {"bodies/exact/decide_with_field.h", "AT(candidate_radii, visitor.candidate);",
          "0xffffffffu;"},
         {"bodies/exact/enlist.h", "AT(lists, block) = next;", ""},
         {"portable/conflict.h", "radius_a < radius_b ? radius_a : radius_b", "radius_a",
          "admit_with_field"},
         {"bodies/exact/strip.h", "g.period_x) + middle", "g.period_x)"},
         {"bodies/exact/pieces.h", "window < windows;", "window < 1u;"},
         {"bodies/exact/pieces.h", "++pieces.insides;", ""},
         {"bodies/exact/lists.h", "walk.left - 1u,", "0u,"},
         {"bodies/exact/lists.h", "{number, rest.a,", "{number, number,"},
         {"portable/distance.h", "period - last + at :", "period - begin + at :", "reach"}});
}

// Classes on a field: each copy sees the others' samples.
TEST_P(Faults, WithClassesAreNoticed) {
    const Field field = tests::ramp_field(7, 5);
    Request request;
    request.field = &field;
    request.classes.names = {"one", "two", "three"};
    request.classes.distances = distances_by_union(std::vector{0.12, 0.06, 0.03});
    request.domain.boundary = Boundary::torus;
    request.paper2011.round_size = 128;
    Plan plan = make_plan(request);
    plan.limit = plan.expected_samples / 2;
    expect_noticed(
        plan,
        {{"portable/class_copies.h", " | (other_x >> copy_bits << copy_bits)", "",
          "admit_with_field"},
         {"portable/class_copies.h", ">> FACTOR_BITS", ">> (FACTOR_BITS + 1u)", "reach"},
         {"bodies/exact/factor.h", "copy_of(x_a, g.copy_bits) * MOST_CLASSES", "0u",
          "screen_with_field"},
         {"bodies/exact/pixels.h", "at & axis.last", "at & axis.last >> 1u", "locate_with_field"},
         {"bodies/exact/reach.h", "a.g.copy_bits == BITS_OF_ONE_COPY ? 0u : 1u", "0u"},
         {"bodies/exact/ellipses.h", "factor_of(ON g, x, one.x)", "FACTOR_ONE", "admit_with_field"},
         {"bodies/exact/lists.h", "factor_of(ON a.g, neighbour.x, strip.at.x)", "FACTOR_ONE"}});
}

TEST_P(Faults, WithEllipsesAreNoticed) {
    const Field field = tests::stretched_at_random(tests::ramp_field(5, 4), 6, 3);
    Request request;
    request.field = &field;
    request.scale = 0.05;
    request.domain.boundary = Boundary::torus;
    request.paper2011.round_size = 128;
    // Some faults leave boxes that nothing covers, and with them a set would never be full.
    Plan plan = make_plan(request);
    plan.limit = plan.expected_samples * 95 / 100;
    expect_noticed(
        plan, {{"portable/ellipse.h", "sign_extended(e.q) * dx + to_i64(e.s) * dy",
                "to_i64(e.s) * dy", "admit_with_field"},
               {"portable/ellipse.h", "-most - aside", "-most + aside"},
               {"portable/ellipse.h", "image == 1u ? to_i64(period) : 0", "0", "reach"},
               {"portable/ellipse.h", "(a < b ? a : b) + up * low", "(a < b ? b : a) + up * low",
                "reach"},
               {"portable/conflict.h", "period_x == 0u ? 1u : 9u", "1u", "reach"},
               {"portable/ellipse.h", "return way - around;", "return way;", "screen_with_field"},
               {"portable/conflict.h", "holds(of_a, dx, dy) && holds",
                "holds(of_a, dx, dy) || holds", "admit_with_field"},
               {"bodies/exact/ellipses.h", "field.rows.pixels + pixel_of(field.rows, y)",
                "field.rows.pixels", "admit_with_field"},
               {"bodies/exact/ellipses.h", "if (g.rule != RULE_OF_ELLIPSES)", "if (true)",
                "screen_with_field"},
               {"bodies/exact/lists.h", "if (strip.is_even)\n", "if (false)\n"},
               {"bodies/exact/pieces.h", "g.rule != RULE_OF_ELLIPSES", "true"}});
}

// Where a fine mask forbids a part of a box on one pixel, inner circles cut the box.
TEST_P(Faults, WithEllipsesOnAMaskAreNoticed) {
    const tests::FieldRequest made =
        tests::with_mask(tests::radius_field_request("ellipses on a fine mask",
                                                     tests::swirled(tests::constant_field(2, 2), 8),
                                                     60, Boundary::box),
                         tests::chess_mask(30, 30));
    expect_noticed(
        make_plan(made.request),
        {{"bodies/exact/radius_field.h", "return is_even ? all.greatest | IS_EVEN : all.least;",
          "return all.least == 0u ? 0u : all.greatest & ~HAS_ZEROS | (is_even ? IS_EVEN : 0u);"}});
}

// In the end boxes are halved before they are cut.
TEST_P(Faults, InHalvedBoxesWithARadiusFieldAreNoticed) {
    expect_noticed(
        radius_field_plan(Boundary::box, 2),
        {{"bodies/exact/split.h", "if (y == 0u)", "if (true)"},
         {"bodies/exact/split.h", "{x, left.y,", "{box.x + box.width, left.y,"},
         {"bodies/exact/split.h", "left.above, right.below", "left.below, right.below"},
         {"bodies/exact/strip.h", ": box.x + left;", ": box.x;"},
         {"bodies/exact/measure.h", ".radius != 0u)", ".radius == 0u)"},
         {"bodies/exact/pieces.h",
          "squared_length(cut_distance(a.g, strip, x_of(a, neighbour, strip)), dy) <", "0u <"},
         {"bodies/exact/cut.h", "total += count;", "total = count;"},
         {"bodies/exact/keep.h", "keep_piece(ON a, number, strip, piece, to)",
          "keep_piece(ON a, number, box.whole, piece, to)"},
         {"bodies/exact/lists.h", "is_below ? y : whole.end", "false ? y : whole.end"},
         {"bodies/exact/lists.h", "is_whole ? strip.radius : 0u", "is_whole ? 1u : 0u"},
         {"bodies/exact/lists.h", "if (k > 1u) strip", "if (false) strip"},
         {"bodies/exact/radius_field.h", "+ rank_of_slot(values, slot);", ";", "locate_with_field"},
         {"portable/mask_tree.h", "(y & 1u) << 1", "(y & 0u) << 1", "locate_with_field"},
         {"bodies/exact/radius_field.h", "i <= pixels.last_column >> level.shift",
          "i == pixels.first_column >> level.shift", "split"},
         {"portable/radius_field.h", "less_a < less_b", "less_a > less_b", "measure"}});
}

// Boxes on one large pixel are long, so more chords cut a box in the middle, into two pieces.
TEST_P(Faults, InPiecesOfBoxesWithARadiusFieldAreNoticed) {
    const Field field = tests::noise_field(2, 2, 3);
    Request request;
    request.field = &field;
    request.scale = 0.005;
    Plan plan = make_plan(request);
    plan.limit = 2 * plan.expected_samples;
    expect_noticed(plan,
                   {{"bodies/exact/pieces.h", "end = chord_begin > begin ? chord_begin : end;", ""},
                    {"bodies/exact/pieces.h", "begin = chord_begin <= begin ? chord_end :",
                     "begin = chord_begin <= begin ? pieces.high :"}});
}

// The last samples are left out, as in exact.
TEST_P(Faults, OnSurfacesAreNoticed) {
    const Mesh mesh = tests::soup(12, 2);
    expect_noticed_in_space(
        {.mesh = &mesh, .radius = 0.06, .limit = 180, .seed = 6},
        {{"bodies/space/around.h", "near_begins, block + 1u", "near_begins, block"},
         {"bodies/space/around.h", "around.begin + which", "around.begin"},
         {"bodies/space/covered_in_space.h", "return true;", "return false;"},
         {"bodies/space/covered_in_space.h", "ATOMIC_SET(cell_heads, block, i)", "NO_SAMPLE"},
         {"bodies/space/decide_in_space.h", "other.order >= candidate.order",
          "other.order <= candidate.order"},
         {"bodies/space/decide_in_space.h", "(waits ?", "(false ?"},
         {"bodies/space/insert_in_space.h", "to_i32(AT(heights, i))", "to_i32(candidate.x)"},
         {"bodies/space/solid.h", "low + (high << 32)", "low"},
         {"bodies/space/solid.h", "return quarter(part, which);", "return quarter(part, 0u);"},
         {"bodies/space/split_in_space.h", "covered | 8u", "covered | 7u"},
         {"bodies/space/split_in_space.h", ">= a.least_to_split", ">= 0u"},
         {"bodies/space/keep_in_space.h", "AT(new_blocks, to) = block", "AT(new_blocks, to) = 0u"},
         {"bodies/space/keep_in_space.h", "pieces + to) = size.across", "pieces + to) = 1u"},
         {"bodies/space/write_in_space.h", "third = drawn.v;", "third = drawn.u;"},
         {"portable/space.h", "drawn.u = is_flipped ?", "drawn.u = !is_flipped ?"},
         {"portable/space.h", "most - for_u : for_u", "for_u : for_u", "locate_in_space"},
         {"portable/space.h", "piece.shape ^ SHAPE_FLIPPED", "piece.shape"},
         {"portable/space.h", "32u - leading_zeros", "31u - leading_zeros"}});
}

TEST_P(Faults, InVolumesAreNoticed) {
    const std::vector<Point3> keep{{0.1, 0.1, 0.1}, {0.6, 0.5, 0.3}};
    expect_noticed_in_space(
        {.volume = {1, 0.8, 0.7, Boundary::torus},
         .radius = 0.2,
         .keep = keep,
         .limit = 42,
         .seed = 6},
        {{"bodies/space/locate_in_space.h", "AT(third_bits, i)", "draw.rank"},
         {"bodies/space/around.h", "moved(at, near.shift)", "at"},
         {"bodies/space/decide_in_space.h", "place_of(ON one, other), near.shift",
          "place_of(ON one, other), at"},
         {"bodies/space/split_in_space.h", "farthest(one, from, to)", "farthest(one, from, from)"},
         {"bodies/space/split_in_space.h", "? middle.y : s.a.y", "? s.a.y : s.a.y"},
         {"portable/space.h", "which / 9u", "which / 10u", "split_in_space"},
         {"portable/space.h", "number / columns % rows", "number % rows"},
         {"portable/space.h", "2u * part.third + (which >> 2)", "2u * part.third"},
         {"portable/space.h", "(length * bits) >> 32", "(length * bits) >> 33"}});
}

// A round of 3,000 draws in a few columns is admitted in parts.
TEST_P(Faults, InCrowdedRoundsAreNoticed) {
    const auto crowded = [](Plan plan) {
        plan.round_size = 3000;
        return plan;
    };
    expect_noticed(
        crowded(tests::plan_of(0.9, 2, Boundary::torus, 1, 1000, Mode::exact)),
        {{"bodies/common/screen.h", "a.first + item * a.chunk", "item * a.chunk + a.count"}});
    expect_noticed(
        crowded(tests::cells_plan(tests::noise_field(40, 30, 5), 0.1, 5, Metric::mean,
                                  Boundary::torus)),
        {{"bodies/cells/covered_in_cells.h", "& 1u) == 0u;", "& 1u) != 0u;"},
         {"bodies/common/screen.h", "a.first + item * a.chunk", "item * a.chunk + a.count"},
         {"bodies/cells/subtract_in_cells.h", "a.first + item / a.slices", "item / a.slices"}});
}

// Thin boxes near the rims of two disks, each of which takes a chord out of their middle.
Snapshot boxes_between_disks(const Plan& plan) {
    Snapshot scene = tests::empty_memory(plan);
    scene.spans.clear();
    scene.box_width = plan.strip_width / 64;
    const std::uint32_t row_begin = plan.grid().rows / 2 * plan.grid().side;
    const std::uint32_t middle = plan.width / 2;
    const auto put = [&](Sample sample) {
        scene.grid[std::size_t{sample.x / plan.grid().side} * plan.grid().rows +
                   sample.y / plan.grid().side] = sample;
    };
    put({middle, row_begin + plan.grid().side / 3});
    put({middle + plan.radius / 100 * 194, row_begin + plan.grid().side / 2});
    for (std::uint32_t percent = 940; percent < 1000; percent += 2) {
        const std::uint32_t x = middle + plan.radius / 1000 * percent;
        scene.boxes.push_back(
            {x - x % scene.box_width, scene.box_width, row_begin, row_begin + plan.grid().side});
    }
    return scene;
}

TEST_P(Faults, OfBoxesInSeveralPiecesAreNoticed) {
    const Snapshot scene = boxes_between_disks(exact_);
    const auto boxes_of = [&](Backend& backend) {
        backend.restore(scene);
        backend.refine(true);
        return backend.snapshot().boxes;
    };
    const std::vector<Box> right = boxes_of(*tests::make_backend("cpu", exact_));
    ASSERT_GT(right.size(), 2 * scene.boxes.size());
    ASSERT_TRUE(boxes_of(*tests::make_backend(GetParam(), exact_)) == right);
    const Fault faults[] = {
        {"bodies/exact/pieces.h", "end = chord_begin > begin ? chord_begin : end;", ""},
        {"bodies/exact/pieces.h", "begin = chord_begin <= begin ? chord_end :",
         "begin = chord_begin <= begin ? pieces.high :"},
        {"bodies/exact/cut.h", "count > 1u ? NO_SAMPLE :", "false ? NO_SAMPLE :"},
        {"bodies/exact/keep.h", "keep_piece(ON a, number, strip, piece, next)",
         "keep_piece(ON a, number, box.whole, piece, next)"},
    };
    for (const Fault& fault : faults)
        EXPECT_TRUE(boxes_of(*tests::make_faulty(GetParam(), exact_, fault)) != right)
            << fault.file << ": " << fault.from << " became " << fault.to;
}

// Sets each kernel's flag of failure, as it is set if a driver ends the kernel's loop early.
TEST_P(Faults, ThatEndLoopsEarlyAreAnErrorAndNeverASet) {
    const struct {
        const Plan& plan;
        const char* file;
        const char* number;
        const char* flag;
        const char* job;
    } checks[] = {
        {exact_, "bodies/lines/locate.h", "a.g.height", "FAILED_LOCATE", "locate"},
        {exact_, "bodies/common/admit.h", "a.g.height", "FAILED_ADMIT", "admit"},
        {exact_, "bodies/lines/collect.h", "g.height", "FAILED_COLLECT", "collect"},
        {exact_, "bodies/lines/subtract.h", "g.height", "FAILED_SUBTRACT", "subtract"},
        {exact_, "bodies/exact/unfold.h", "a.g.height", "FAILED_REFINE", "refine"},
        {exact_, "bodies/exact/cut.h", "a.g.height", "FAILED_REFINE", "refine"},
        {exact_, "bodies/exact/keep.h", "a.g.height", "FAILED_REFINE", "refine"},
        {exact_, "bodies/common/scan.h", "a.count", "FAILED_REFINE", "refine"},
        {cells_, "bodies/cells/locate_in_cells.h", "a.g.height", "FAILED_LOCATE", "locate"},
        {cells_, "bodies/cells/sort_columns.h", "a.g.height", "FAILED_SORT_COLUMNS",
         "sort_columns"},
        {cells_, "bodies/cells/subtract_in_cells.h", "a.g.height", "FAILED_SUBTRACT", "subtract"},
    };
    for (const auto& check : checks) {
        const std::string from =
            "CHECK_TURNS(" + std::string(check.number) + ", " + check.flag + ");";
        const std::string to = "ATOMIC_OR(report, FAILURE_WORD, " + std::string(check.flag) + ");";
        expect_ended_early(check.plan, {check.file, from.c_str(), to.c_str()}, check.job);
    }
}

TEST_P(Faults, OfADriverThatEndsAllLoopsEarlyAreAnError) {
    const Fault fault = {"portable/failure.h", "while (rest != 0u) rest = rest >> 16;",
                         "rest = rest >> 16;"};
    for (const Plan& plan : {lines_, exact_, cells_}) {
        const auto faulty = tests::make_faulty(GetParam(), plan, fault);
        EXPECT_THROW(tests::run_rounds(plan, *faulty), DeviceError);
    }
}

}  // namespace
}  // namespace lacuna
