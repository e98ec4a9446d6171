// The kernels of relax do the work, and nothing else does: faults planted in their bodies are
// noticed on OpenCL and on Vulkan.
#include <gtest/gtest.h>

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/device/altered.h"
#include "fields.h"
#include "relax/device/device_relax.h"
#include "relax/relax_backends.h"
#include "relax/scenes.h"

namespace lacuna::relaxing {
namespace {

using lacuna::tests::Fault;

constexpr int kIterations = 3;

std::vector<Site> relaxed(RelaxBackend& backend) {
    for (int i = 0; i < kIterations; ++i) {
        backend.assign();
        backend.accumulate();
        backend.move(i == 1 ? WHOLE_WAY : LONG_WAY);
    }
    return backend.sites();
}

class RelaxFaults : public lacuna::tests::OnFaultyBackend {
protected:
    static std::vector<Site> on_cpu(const Lattice& lattice, const std::vector<Site>& start) {
        RelaxOptions options;
        options.run_on.backend = "cpu";
        return relaxed(*make_relax_backend(options.run_on, lattice, start).backend);
    }
    static std::vector<Site> on_cpu(const tests::Scene& scene) {
        const Lattice lattice = scene.lattice();
        return on_cpu(lattice, scene.sites(lattice));
    }

    // A fault is noticed if it changes where sites go, or causes an error.
    void expect_noticed(const tests::Scene& scene, const std::vector<Fault>& faults) {
        const std::vector<Site> right = on_cpu(scene);
        for (const Fault& fault : faults) {
            const Lattice lattice = scene.lattice();
            try {
                const auto faulty =
                    device::make_backend(lacuna::tests::open_faulty_queue(GetParam(), fault),
                                         lattice, scene.sites(lattice));
                EXPECT_TRUE(relaxed(*faulty) != right)
                    << fault.file << ": " << fault.from << " became " << fault.to;
            } catch (const DeviceError&) {
            }
        }
    }

    // Enough sites for a tree of three levels.
    const tests::Scene torus_{"random on a torus",
                              tests::random_points(600, 1, 1, 1),
                              {},
                              tests::on(1, 1, Boundary::torus)};
    // Many sites on few pixels: leaves with too many rivals, which are processed later.
    const tests::Scene crowd_{"a crowd", tests::random_points(600, 0.02, 0.02, 1),
                              lacuna::tests::ramp_field(30, 30), tests::on(1, 1, Boundary::box)};
};

INSTANTIATE_TEST_SUITE_P(Device, RelaxFaults, lacuna::tests::kDeviceBackends,
                         lacuna::tests::name_of_parameter);

TEST_P(RelaxFaults, InOwnAreNoticed) {
    expect_noticed(
        torus_,
        {{"bodies/relax/find_rivals.h", "image < 9u", "image < 5u"},
         {"bodies/relax/find_rivals.h", "<= search.bound &&", "< search.bound - 4000000u &&"},
         {"bodies/relax/assign.h", "to_i32(u) * near.along_x", "0"},
         {"bodies/relax/assign.h", "+ min(up, 0) > 0", "> 0"},
         {"bodies/relax/assign.h", "v < leaf.height) mass", "v < 7u) mass"},
         {"bodies/relax/assign.h", "AT(masses, pixel);", "AT(masses, pixel) & 0xfffu;"},
         {"portable/site_tree.h", "<= to_i64(wins * 2u)", "<= to_i64(wins)"}});
}

TEST_P(RelaxFaults, InTheOrderOfTiesAreNoticed) {
    const Lattice lattice = torus_.lattice();
    std::vector<Site> start = torus_.sites(lattice);
    for (std::size_t i = 1; i < start.size(); i += 2) start[i] = start[i - 1];
    const Fault fault{"bodies/relax/assign.h", "near.order < owner##v[u]",
                      "near.order > owner##v[u]"};
    const auto faulty =
        device::make_backend(lacuna::tests::open_faulty_queue(GetParam(), fault), lattice, start);
    EXPECT_TRUE(relaxed(*faulty) != on_cpu(lattice, start));
}

TEST_P(RelaxFaults, InGatherAreNoticed) {
    expect_noticed(torus_, {{"bodies/relax/assign.h", "k < kept; ++k) {\n        const u32 rival",
                             "k + 1u < kept; ++k) {\n        const u32 rival"},
                            {"bodies/relax/assign.h", "+= mass * u", "+= 0u"},
                            {"bodies/relax/assign.h", "above[u] += column[u]", "above[u] += 0u"},
                            {"bodies/relax/assign.h", "column / ONE_POINT", "1u"},
                            {"bodies/relax/assign.h", "image % 3u);", "1u);"}});
}

TEST_P(RelaxFaults, InWideMassesAreNoticed) {
    const tests::Scene powers{"powers of two", tests::random_points(200, 1, 1, 21),
                              tests::powers_field(37, 29), tests::on(1, 1, Boundary::torus)};
    expect_noticed(powers,
                   {{"portable/power.h", "significand >> (exponent -", "significand >> (0u *"},
                    {"portable/power.h", "mass == 0u && stored != 0u ? 1u", "false ? 1u"},
                    {"bodies/relax/assign.h", "if (exponent != 0u)", "if (false)"},
                    {"bodies/relax/assign.h", "moment_x << exponent", "moment_x"}});
    // Many sites on a bright pixel: some lose its lattice points, and have others, far lighter.
    const tests::Scene bright{
        "a bright pixel", crowd_.points,
        lacuna::tests::made_field(
            30, 30, [](double x, double y) { return std::max(x, y) < 0.04 ? 1e6 : 1; }),
        tests::on(1, 1, Boundary::box)};
    expect_noticed(bright, {{"bodies/relax/move.h", "!stays(mass, below)", "mass != 0u"}});
}

// Few samples with many lattice points each: their moments take more than 32 bits.
TEST_P(RelaxFaults, InTheCarryOfSumsAreNoticed) {
    const tests::Scene few{"few", tests::random_points(3, 1, 1, 1),
                           lacuna::tests::constant_field(64, 64), tests::on(1, 1, Boundary::torus)};
    expect_noticed(few, {{"bodies/relax/shares.h", "? 1u : 0u", "? 0u : 0u"}});
}

TEST_P(RelaxFaults, InMoveAreNoticed) {
    expect_noticed(torus_,
                   {{"bodies/relax/move.h", "with_weight(site, weight)", "with_weight(site, 0u)"},
                    {"bodies/relax/level_sites.h", "max(box.high_x, child.high_x)", "box.high_x"},
                    {"bodies/relax/level_sites.h", "weight < least ? weight :", "weight +"}});
}

TEST_P(RelaxFaults, InLimitsOfWeightsAreNoticed) {
    expect_noticed(torus_,
                   {{"bodies/relax/limit.h", "weight =\n            bounded_weight(",
                     "weight = weight_of(site) + 0u * bounded_weight("},
                    {"bodies/relax/limit.h", "j != i &&", "false &&"},
                    {"bodies/relax/limit.h", "min(straight, around)", "straight"},
                    {"bodies/relax/limit.h", "if (other != leaf)", "if (false)"},
                    {"bodies/relax/limit.h", "farthest = nearest > farthest", "farthest = false"},
                    {"bodies/relax/move.h", "x, a.way", "x, WHOLE_WAY"}});
}

TEST_P(RelaxFaults, InCrowdedLeavesAreNoticed) {
    ASSERT_TRUE(on_cpu(crowd_) != crowd_.sites(crowd_.lattice()));
    expect_noticed(crowd_,
                   {{"bodies/relax/owner_of.h", "power < least ||", "false ||"},
                    {"bodies/relax/owner_of.h", "if (power <= least)", "if (false)"},
                    {"bodies/relax/assign_crowded.h", "mass * moment_offset(", "moment_offset("},
                    {"bodies/relax/assign_crowded.h", "row % LEAF_SIDE", "0u"},
                    {"bodies/relax/late.h", "= leaf;", "= 0u;"}});
}

// The result of a driver that ends loops early.
TEST_P(RelaxFaults, ThatEndLoopsEarlyAreAnErrorAndNeverASet) {
    for (const char* const file :
         {"bodies/relax/find_hints.h", "bodies/relax/find_rivals.h", "bodies/relax/assign.h",
          "bodies/relax/assign_crowded.h", "bodies/relax/limit.h"}) {
        const Fault fault{file, "CHECK_TURNS(a.lattice.columns, FAILED_ASSIGN);",
                          "ATOMIC_OR(report, FAILURE_WORD, FAILED_ASSIGN);"};
        const Lattice lattice = crowd_.lattice();
        const auto faulty = device::make_backend(
            lacuna::tests::open_faulty_queue(GetParam(), fault), lattice, crowd_.sites(lattice));
        try {
            faulty->assign();
            ADD_FAILURE() << file << " went unnoticed";
        } catch (const DeviceError& error) {
            EXPECT_NE(
                std::string(error.what()).find(": assign: a loop was ended early by the driver"),
                std::string::npos)
                << error.what();
        }
    }
}

TEST_P(RelaxFaults, NoneInWhatIsMeantToBe) {
    for (const tests::Scene& scene : {torus_, crowd_}) {
        const Lattice lattice = scene.lattice();
        const Fault none{"bodies/relax/assign.h", "u32 kept", "u32 kept"};
        for (const std::uint32_t tiles : {0u, 1u, 7u}) {
            const auto backend =
                device::make_backend(lacuna::tests::open_faulty_queue(GetParam(), none), lattice,
                                     scene.sites(lattice), {tiles});
            EXPECT_TRUE(relaxed(*backend) == on_cpu(scene)) << scene << ", " << tiles;
        }
    }
}

}  // namespace
}  // namespace lacuna::relaxing
