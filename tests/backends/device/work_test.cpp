// What a device is asked to do: few waits and transfers a round, few bytes, short loops at any size
// (docs/speed.md, "What a graphics card is asked to do"). These counts predict a card's time on any
// device.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/device/altered.h"
#include "backends/device/scan.h"
#include "backends/radius_field_requests.h"
#include "backends/scenes.h"
#include "plan/first_free.h"
#include "portable/report.h"
#include "rounds/marginal.h"
#include "rounds/round_policy.h"
#include "space/backends.h"
#include "space/meshes.h"
#include "space/plan.h"
#include "space/portion.h"

namespace lacuna {
namespace {

// A set, what it took, and the number of bins after all rounds.
struct Made {
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    std::uint64_t samples = 0;
    std::uint64_t bins = 0;
    Work work;  // without what is done before the first round
};

// The loop of generate().
template <typename Placed>
Made make_set(const Plan& plan, BackendOf<Placed>& backend) {
    const Work before = backend.work();
    Made made;
    Marginal marginal(
        plan, backend.workers(), [] {},
        [&](std::size_t count) { return backend.room_for_draws(count); });
    RoundPolicy policy(plan);
    const FirstFree all_free(plan);
    marginal.rebuild(all_free.lengths, plan.strip_width, all_free.widths, all_free.copy_ends);
    while (marginal.total() > 0) {
        const std::span<const Draw> draws =
            marginal.invert(made.draws, static_cast<std::uint32_t>(policy.size()));
        backend.locate(draws);
        backend.admit();
        if (policy.refines())
            backend.refine(policy.halves());
        else
            backend.subtract();
        const RoundOf<Placed> round = backend.finish_round();
        ++made.rounds;
        made.draws += draws.size();
        made.samples += round.samples.size();
        made.bins += round.free_lengths.size();
        policy.note(round.survivors, round.samples.size(), round.free_lengths.size(),
                    round.bin_width);
        marginal.rebuild(round.free_lengths, round.bin_width, round.bin_widths, round.copy_ends);
    }
    made.work = backend.work();
    made.work.launches -= before.launches;
    made.work.waits -= before.waits;
    made.work.uploads -= before.uploads;
    made.work.downloads -= before.downloads;
    made.work.uploaded_bytes -= before.uploaded_bytes;
    made.work.downloaded_bytes -= before.downloaded_bytes;
    return made;
}

constexpr std::uint64_t kReportBytes = 4 * REPORT_WORDS;
constexpr std::uint64_t kDrawBytes = 16;
constexpr std::uint64_t kSampleBytes = 8;

class DeviceWork : public tests::OnBackend {
protected:
    Observer nobody_;

    // The set is made without an error if the loops of a kernel have at most `most` turns.
    bool has_short_loops(const Plan& plan, const char* file, const char* check, const char* turns,
                         std::uint32_t most) {
        const std::string flag = std::string(check).substr(std::string(check).find("FAILED_"));
        const std::string to = "if (" + std::string(turns) + " > " + std::to_string(most) +
                               "u) ATOMIC_OR(report, FAILURE_WORD, " + flag;
        const auto backend = tests::make_faulty(GetParam(), plan, {file, check, to.c_str()},
                                                {.rows_of_tile = device::kRowsOfTile});
        try {
            make_set(plan, *backend);
        } catch (const DeviceError&) {
            return false;
        }
        return true;
    }
};

INSTANTIATE_TEST_SUITE_P(Device, DeviceWork, tests::kDeviceBackends, tests::name_of_parameter);

TEST_P(DeviceWork, OfARoundInExactIsOneUploadTwoDownloadsAndTwoWaits) {
    const Plan plan = tests::plan_of(0.004, 6, Boundary::torus, 1, 1, Mode::exact);
    const auto backend = tests::make_backend(GetParam(), plan);
    const Made made = make_set(plan, *backend);
    EXPECT_EQ(made.work.uploads, made.rounds);
    EXPECT_EQ(made.work.uploaded_bytes, kDrawBytes * made.draws);
    // The first refinement waits once more, for the number of boxes.
    EXPECT_LE(made.work.waits, 2 * made.rounds + 1);
    EXPECT_LE(made.work.downloads, 2 * made.rounds + 1);
    EXPECT_EQ(made.work.downloaded_bytes, kSampleBytes * made.samples + 4 * made.bins +
                                              kReportBytes * (made.work.waits - made.rounds));
    EXPECT_LE(made.work.launches, 15 * made.rounds + 3);
}

TEST_P(DeviceWork, WithARadiusFieldBringsTwoWordsABoxAndTwoASampleDown) {
    const Field field = tests::noise_field(40, 30, 5);
    Request request;
    request.field = &field;
    request.scale = 0.01;
    const Plan plan = make_plan(request);
    const auto backend = tests::make_backend(GetParam(), plan);
    const Made made = make_set(plan, *backend);
    // Lists of samples that need more room are copied through the host, up as much as down.
    const std::uint64_t copied = made.work.uploaded_bytes - kDrawBytes * made.draws;
    EXPECT_LE(made.work.uploads, made.rounds + 4);
    EXPECT_LE(made.work.waits, 3 * made.rounds + 8);
    EXPECT_LE(made.work.downloaded_bytes, kSampleBytes * made.samples + 8 * made.bins + copied +
                                              kReportBytes * (made.work.waits - made.rounds));
}

TEST_P(DeviceWork, InSpaceBringsTwoWordsABinAndThreeASampleDown) {
    const Mesh mesh = tests::sphere(60);
    for (const SpaceRequest& request :
         {SpaceRequest{.mesh = &mesh, .radius = 0.03}, SpaceRequest{.radius = 0.05}}) {
        const Plan plan = space::CheckedRequest(request).plan(*request.radius, ~std::uint64_t{0});
        const auto backend =
            space::make_backend(GetParam(), plan, {.backend = GetParam()}, nobody_);
        const Made made = make_set(plan, *backend);
        const bool is_volume = request.mesh == nullptr;
        const std::uint64_t numbers = is_volume ? 4 : 0;  // the third one of each draw
        // The list of samples, if it needs more room, is copied through the host, up as much as
        // down.
        const std::uint64_t copied = made.work.uploaded_bytes - (kDrawBytes + numbers) * made.draws;
        EXPECT_LE(copied, 16 * made.samples);
        EXPECT_LE(made.work.uploads, (is_volume ? 2 : 1) * made.rounds + 2);
        // In volumes more draws of a round conflict, and some rounds need more passes.
        EXPECT_LE(made.work.waits, 2 * made.rounds + (is_volume ? 8 : 3));
        EXPECT_LE(made.work.launches, 18 * made.rounds);
        EXPECT_EQ(made.work.downloaded_bytes, 3 * 4 * made.samples + 8 * made.bins + copied +
                                                  kReportBytes * (made.work.waits - made.rounds));
    }
}

TEST_P(DeviceWork, IsThatOfItsKernelsWhichHaveTimesIfTheyAreAskedFor) {
    const Plan plan = tests::plan_of(0.01, 6, Boundary::torus, 1, 1, Mode::exact);
    for (const bool are_asked_for : {false, true}) {
        const auto backend = tests::make_backend(GetParam(), plan);
        if (are_asked_for) backend->time_verbs();
        make_set(plan, *backend);
        const Work work = backend->work();
        std::uint64_t launches = 0;
        double seconds = 0;
        for (const KernelWork& kernel : work.kernels) {
            launches += kernel.launches;
            seconds += kernel.seconds;
            EXPECT_GE(kernel.items, kernel.launches) << kernel.name;
            const bool is_before_it = kernel.name == "open_lines";
            EXPECT_EQ(kernel.seconds > 0, are_asked_for && !is_before_it) << kernel.name;
        }
        EXPECT_EQ(launches, work.launches);
        EXPECT_LT(seconds, 60);
    }
}

// A card has many items at once, and waits for the longest one.
TEST_P(DeviceWork, HasNoLoopThatGrowsWithTheSet) {
    // 2,800 rows of the sample grid: 22 tiles a line.
    const Plan plan = tests::plan_of(0.004, 6, Boundary::torus, 0.06, 8, Mode::exact);
    const struct {
        const char* file;
        const char* check;
        const char* turns;
    } loops[] = {
        {"bodies/lines/locate.h", "CHECK_TURNS(a.g.height, FAILED_LOCATE);",
         "slot - (tile == NO_SAMPLE ? slot : (tile - a.slab_begin) * a.g.capacity)"},
        {"bodies/lines/collect.h", "CHECK_TURNS(g.height, FAILED_COLLECT);",
         "(rows.count / 32u + 1u + count) * columns.count"},
        {"bodies/lines/subtract.h", "CHECK_TURNS(g.height, FAILED_SUBTRACT);",
         "gap.done - slot + near_end - list * a.near_room"},
    };
    for (const auto& loop : loops) {
        EXPECT_TRUE(has_short_loops(plan, loop.file, loop.check, loop.turns, 256)) << loop.file;
        EXPECT_FALSE(has_short_loops(plan, loop.file, loop.check, loop.turns, 3)) << loop.file;
    }
    EXPECT_LE(device::tiles_of(plan, device::kRowsOfTile).count, device::kMostTiles);
    EXPECT_LE(1u << device::block_bits_of_scan(1u << 23), 256u);
}

}  // namespace
}  // namespace lacuna
