// The kernels of the Gaussian energy's descent do the work, and nothing else does: faults planted
// in their bodies are noticed on OpenCL and on Vulkan.
#include <gtest/gtest.h>

#include <lacuna/lacuna.h>

#include <cstdint>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/device/altered.h"
#include "relax/device/gaussian.h"
#include "relax/relax_backends.h"
#include "relax/scenes.h"

namespace lacuna::relaxing {
namespace {

using lacuna::tests::Fault;

class GaussianFaults : public lacuna::tests::OnFaultyBackend {
protected:
    static std::vector<Spot> descended(GaussianBackend& backend) {
        constexpr std::uint32_t kSteps = 3;
        for (std::uint32_t step = 0; step < kSteps; ++step) backend.descend(gaussian_pace(step));
        return backend.spots();
    }

    // A fault is noticed if it changes where spots go, or causes an error. None here makes a kernel
    // leave its memory.
    static void expect_noticed(Boundary boundary, const std::vector<Fault>& faults) {
        RelaxOptions options = tests::on(1, 1, boundary);
        options.gaussian = 1;
        options.run_on.backend = "cpu";
        const std::vector<Point> points = tests::random_points(400, 1, 1, 1);
        const GaussianField field = make_gaussian(points.size(), options);
        const std::vector<Spot> start = spots_of(points, field, options, nobody_asks);
        const auto right = descended(*make_gaussian_backend(options.run_on, field, start).backend);
        for (const Fault& fault : faults) {
            try {
                const auto faulty = device::make_gaussian_backend(
                    lacuna::tests::open_faulty_queue(GetParam(), fault), field, start);
                EXPECT_TRUE((descended(*faulty) != right) == (fault.from != std::string(fault.to)))
                    << fault.file << ": " << fault.from << " became " << fault.to;
            } catch (const DeviceError&) {
            }
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Device, GaussianFaults, lacuna::tests::kDeviceBackends,
                         lacuna::tests::name_of_parameter);

TEST_P(GaussianFaults, OnATorusAreNoticed) {
    expect_noticed(
        Boundary::torus,
        {{"bodies/relax/descend.h", "u32 column", "u32 column"},  // none
         {"bodies/relax/descend.h", "image <= 2u * images", "image <= images"},
         {"bodies/relax/descend.h", "k <= 2u * reach", "k < 2u * reach"},
         {"bodies/relax/descend.h", "pull.y += weight * dy", "pull.y += weight"},
         {"bodies/relax/descend.h", "mover.momentum_x = gaussian",
          "mover.momentum_x = 0 * gaussian"},
         {"bodies/relax/descend.h", "AT(mover_ids, i) = AT(sorted_ids, i)", "AT(mover_ids, i) = i"},
         {"bodies/relax/cell_of.h", "a.domain.rows,", "a.domain.rows / 2u,"},
         {"bodies/relax/sort_into_cells.h", "= AT(mover_ids, i)", "= i"},
         {"portable/gaussian.h", "wide * (high - low)", "wide * 0"}});
}

TEST_P(GaussianFaults, InABoxAreNoticed) {
    expect_noticed(Boundary::box,
                   {{"bodies/relax/descend.h", "pull.x += edges.x", "pull.x += 0"},
                    {"bodies/relax/descend.h", "const u32 areas = GAUSSIAN_EDGE_ENTRIES + 2u",
                     "const u32 areas = GAUSSIAN_EDGE_ENTRIES"},
                    {"bodies/relax/descend.h", "a.domain.wraps == 0u && image > 0", "false"},
                    {"portable/gaussian.h", "to < 0 ? 0u", "to < 0 ? 7u"}});
}

// The result of a driver that ends loops early.
TEST_P(GaussianFaults, ThatEndLoopsEarlyAreAnErrorAndNeverASet) {
    RelaxOptions options = tests::on(1, 1, Boundary::torus);
    options.gaussian = 1;
    const std::vector<Point> points = tests::random_points(40, 1, 1, 1);
    const GaussianField field = make_gaussian(points.size(), options);
    const auto faulty = device::make_gaussian_backend(
        lacuna::tests::open_faulty_queue(
            GetParam(), {"bodies/relax/descend.h", "CHECK_TURNS(a.domain.samples, FAILED_DESCEND);",
                         "ATOMIC_OR(report, FAILURE_WORD, FAILED_DESCEND);"}),
        field, spots_of(points, field, options, nobody_asks));
    try {
        faulty->descend(gaussian_pace(0));
        ADD_FAILURE() << "went unnoticed";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string(error.what()).find(": descend: a loop was ended early by the driver"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace lacuna::relaxing
