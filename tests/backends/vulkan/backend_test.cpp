// Tests of the vulkan backend alone: its shaders do the work; its slabs and its messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/cells_requests.h"
#include "backends/columns.h"
#include "backends/vulkan/vulkan_backend.h"
#include "portable/status.h"
#include "sampling/generate.h"

namespace {

using namespace lacuna;

Request torus(double radius, Mode mode = Mode::exact) {
    Request request;
    request.mode = mode;
    request.radius = radius;
    request.domain.boundary = Boundary::torus;
    return request;
}

std::vector<Sample> samples_of(const Plan& plan, Backend& backend) {
    Observer nobody;
    return generate(plan, backend, nobody).samples;
}

std::vector<Sample> samples_of_cpu(const Plan& plan) {
    return samples_of(plan, *cpu::make_backend(plan, {}));
}

template <typename Thrown, typename Work>
std::string message_of(Work work) {
    try {
        work();
    } catch (const Thrown& error) {
        return error.what();
    }
    return "nothing was thrown";
}

class VulkanBackend : public testing::Test {
protected:
    void SetUp() override { tests::skip_or_fail_without("vulkan"); }
};

TEST_F(VulkanBackend, ServesSpansBeyondTheLargestBufferOfManyDevices) {
    Request request = torus(0.001, Mode::lines);
    request.paper2011.lines_per_radius = 52;
    request.limit = 200'000;
    const Plan plan = make_plan(request);
    constexpr std::uint64_t kSmallestRange = std::uint64_t{128} << 20;
    ASSERT_GT(std::uint64_t{plan.lines} * first_capacity(plan) * sizeof(Span), kSmallestRange);

    EXPECT_EQ(samples_of(plan, *vulkan::make_backend(plan, {}, {kSmallestRange})),
              samples_of_cpu(plan));
}

// No samples anywhere: every box is halved, and both halves are kept whole.
TEST_F(VulkanBackend, MakesRoomForMoreBoxesThanThereWere) {
    const Plan plan = make_plan(torus(0.02));
    Snapshot scene;
    scene.capacity = 1;
    scene.grid.assign(std::size_t{plan.grid().columns} * plan.grid().rows, {NO_SAMPLE, NO_SAMPLE});
    scene.box_width = plan.strip_width;
    for (std::uint32_t line = 0; line < plan.lines; ++line)
        for (std::uint32_t y = 0; y < 20; ++y)
            scene.boxes.push_back({line * plan.strip_width, plan.strip_width, 2 * y, 2 * y + 1});
    const auto backend = vulkan::make_backend(plan, {});
    backend->restore(scene);

    backend->refine(true);

    const std::vector<Box> boxes = backend->snapshot().boxes;
    ASSERT_EQ(boxes.size(), 2 * scene.boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        Box half = scene.boxes[i / 2];
        half.width /= 2;
        half.x += i % 2 == 0 ? 0 : half.width;
        ASSERT_EQ(boxes[i], half) << "box " << i;
    }
    EXPECT_EQ(backend->finish_round().free_lengths.size(), boxes.size());
}

TEST_F(VulkanBackend, ListsADeviceThatItCanUse) {
    const std::vector<DeviceEntry> devices = vulkan::list_devices();
    const auto usable = std::find_if(devices.begin(), devices.end(),
                                     [](const DeviceEntry& e) { return e.unusable.empty(); });
    ASSERT_NE(usable, devices.end());
    EXPECT_FALSE(usable->name.empty());
    EXPECT_TRUE(usable->has_int64);
    EXPECT_GE(usable->largest_buffer_bytes, std::uint64_t{128} << 20);
    EXPECT_GT(usable->memory_bytes, 0u);
}

TEST_F(VulkanBackend, NamesTheDevicesWhenTheOneAskedForIsMissing) {
    const Plan plan = make_plan(torus(0.05));
    const std::string message = message_of<Unavailable>([&] {
        vulkan::make_backend(plan, Placement{"no such device", 0});
    });
    EXPECT_NE(message.find("no such device"), std::string::npos) << message;
    EXPECT_NE(message.find(vulkan::list_devices().front().name), std::string::npos) << message;
}

// In its own process, because a driver that was once loaded is kept.
void expect_no_driver_told() {
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
        setenv(name, "/no/such/driver.json", 1);
    const std::string message =
        message_of<Unavailable>([] { vulkan::make_backend(make_plan(torus(0.05)), {}); });
    bool are_unusable = true;
    for (const DeviceEntry& entry : vulkan::list_devices())
        are_unusable = are_unusable && !entry.unusable.empty();
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(message.find("driver") != std::string::npos && are_unusable ? 0 : 1);
}

TEST(VulkanStart, SaysThatNoDriverIsInstalled) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(expect_no_driver_told(), testing::ExitedWithCode(0), "driver");
}

TEST_F(VulkanBackend, NamesTheCallAndTheResultWhenTheDeviceFails) {
    const auto queue = vulkan::open_queue({});
    const std::string message =
        message_of<DeviceError>([&] { queue->make(std::uint64_t{1} << 50); });
    EXPECT_NE(message.find(queue->device().name), std::string::npos) << message;
    // Vulkan's headers name a call vkCreateBuffer or, newer ones, Device::createBuffer.
    EXPECT_TRUE(message.find(": vk") != std::string::npos ||
                message.find(": Device::") != std::string::npos)
        << message;
    EXPECT_NE(message.find("Error"), std::string::npos) << message;
}

TEST_F(VulkanBackend, RefusesLatticesBeyondTheLargestBuffer) {
    const std::uint64_t largest = vulkan::open_queue({})->device().largest_buffer_bytes;
    const Field field = tests::constant_field(1, 1);
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale = 20.0 / (1 << 17);
    request.paper2011.lines_per_radius = 20;
    const Plan plan = make_plan(request);
    if (largest >= std::uint64_t{1} << 31) GTEST_SKIP() << "the largest lattice has 2 GiB";
    const std::string message = message_of<Unavailable>([&] { vulkan::make_backend(plan, {}); });
    EXPECT_NE(message.find("the request needs a buffer of 2.15 GB, and its largest has"),
              std::string::npos)
        << message;
}

TEST_F(VulkanBackend, RefusesRoundsBeyondTheLargestBuffer) {
    Request request = torus(0.05);
    request.paper2011.round_size = std::uint64_t{1} << 40;
    const std::string message =
        message_of<BadRequest>([&] { vulkan::make_backend(make_plan(request), {}); });
    EXPECT_NE(message.find("round-size 1099511627776: must be at most"), std::string::npos)
        << message;
}

}  // namespace
