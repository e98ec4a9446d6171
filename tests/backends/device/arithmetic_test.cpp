// The portable arithmetic as devices compute it, against C++: a million sets of numbers.
#include "backends/device/arithmetic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backends/available.h"
#include "backends/device/queue.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/device.h"
#endif

namespace lacuna::opencl {
std::span<const std::string_view> arithmetic_sources();  // arithmetic.cl, embedded
}

namespace arithmetic_test {

using namespace lacuna;
using namespace lacuna::portable;
using device::Buffer;

#ifdef LACUNA_VULKAN
#include "arithmetic.spv.h"
#endif

constexpr u32 kItems = 1u << 20;
constexpr u32 kLongestSide = 1u << 31;

struct Arguments {
    u32 first_item;
    u32 items;
};

// A random number of at most `most`; every number of bits is equally likely.
u32 any_size(std::mt19937_64& random, u32 most) {
    return std::min(static_cast<u32>((random() >> 32) >> (random() % 32)), most);
}

// A number beside a square, beside a power of two, at an end, or anything below 2^63.
u64 radicand(std::mt19937_64& random) {
    const u64 root = random() >> (33 + random() % 31);
    const u64 power = u64{1} << (random() % 63);
    constexpr u64 kLargest = (u64{1} << 63) - 1;
    switch (random() % 8) {
        case 0:
            return root * root;
        case 1:
            return root * root + 2 * root;
        case 2:
            return root > 0 ? root * root - 1 : 0;
        case 3:
            return power;
        case 4:
            return power - 1;
        case 5:
            return kLargest - random() % 3;
        case 6:
            return random() % 3;
        default:
            return random() >> (1 + random() % 63);
    }
}

Numbers any_numbers(std::mt19937_64& random) {
    Numbers q{};
    q.n = radicand(random);
    const u32 width = random() % 4 == 0 ? kLongestSide : 1 + any_size(random, kLongestSide - 1);
    q.height = random() % 4 == 0 ? kLongestSide : 1 + any_size(random, kLongestSide - 1);
    q.period_x = random() % 2 == 0 ? width : 0;
    q.period_y = random() % 2 == 0 ? q.height : 0;
    q.ax = random() % 8 == 0 ? 0 : any_size(random, width - 1);
    q.bx = random() % 8 == 0 ? width - 1 : any_size(random, width - 1);
    q.ay = random() % 8 == 0 ? q.height - 1 : any_size(random, q.height - 1);
    q.by = any_size(random, q.height - 1);
    q.radius = random() % 8 == 0 ? q.height : 1 + any_size(random, 0xc0000000u);
    const u64 squared = squared_length(axis_distance(q.ax, q.bx, q.period_x),
                                       axis_distance(q.ay, q.by, q.period_y));
    // The squared distance or one more, or any number.
    q.radius_squared = random() % 2 == 0 ? std::max<u64>(1, squared + random() % 2)
                                         : std::max<u64>(1, radicand(random));
    q.columns = 1 + any_size(random, 1u << 24);
    q.lines = q.columns + any_size(random, 1u << 24);
    q.line = any_size(random, q.lines - 1);
    q.side = 1 + any_size(random, kLongestSide - 1);
    return q;
}

// The queue of a device that has the kernel "arithmetic".
std::unique_ptr<device::Queue> queue_of(const std::string& backend, const std::string& prefix) {
#ifdef LACUNA_OPENCL
    if (backend == "opencl") {
        opencl::Trial trial;
        trial.sources.push_back(prefix + std::string(opencl::arithmetic_sources().front()));
        return opencl::open_queue({}, trial);
    }
#endif
#ifdef LACUNA_VULKAN
    vulkan::Trial trial;
    trial.shader_of = [](std::string_view) {
        return std::vector(std::begin(arithmetic_spirv), std::end(arithmetic_spirv));
    };
    return vulkan::open_queue({}, trial);
#endif
    throw Unavailable("backend " + backend + ": this build was made without it");
}

class Arithmetic : public tests::OnBackend {
protected:
    // Tests an OpenCL C source that begins with the prefix.
    static void expect_equal(const std::string& prefix) {
        std::mt19937_64 random(11);
        const auto queue = queue_of(GetParam(), prefix);
        std::vector<Numbers> questions(kItems);
        std::vector<Answers> replies(kItems);
        std::vector<u32> off_by(kItems);
        for (Numbers& q : questions) q = any_numbers(random);
        const std::vector<Buffer> buffers = {queue->make(kItems * sizeof(Numbers)),
                                             queue->make(kItems * sizeof(Answers)),
                                             queue->make(kItems * sizeof(u32))};

        Arguments arguments{0, kItems};
        queue->upload(buffers[0], std::as_bytes(std::span(questions)), 0);
        queue->launch({"arithmetic", 3, sizeof(Arguments)},
                      std::as_writable_bytes(std::span(&arguments, 1)), buffers, kItems, 1);
        queue->download(buffers[1], std::as_writable_bytes(std::span(replies)));
        queue->download(buffers[2], std::as_writable_bytes(std::span(off_by)));
        queue->wait();

        if (queue->device().kind == "cpu") {
            EXPECT_GT(queue->work().launches, 1u) << "so many items are served in parts";
        }
        for (u32 i = 0; i < kItems; ++i) {
            const Numbers& q = questions[i];
            const Answers expected = answer(q);
            const Answers& got = replies[i];
            ASSERT_EQ(got.root, expected.root) << "of " << q.n;
            ASSERT_EQ(got.reach, expected.reach) << got.distance << ", " << q.radius_squared;
            ASSERT_EQ(std::memcmp(&got, &expected, sizeof(Answers)), 0) << "set " << i;
            ASSERT_LE(off_by[i], 2u) << "the estimate of the root of " << q.n;
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Device, Arithmetic, tests::kDeviceBackends, tests::name_of_parameter);

TEST_P(Arithmetic, IsTheSameOnTheDeviceAsInCpp) {
    expect_equal("");
}

TEST_P(Arithmetic, IsTheSameOnOpenClDevicesThatHaveNoDoubles) {
    if (GetParam() != "opencl") GTEST_SKIP() << "GLSL has the root without doubles alone";
    expect_equal("#undef cl_khr_fp64\n");
}

}  // namespace arithmetic_test
