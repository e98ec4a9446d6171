// The host's memory for transfers: it is used again, by later queues, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "backends/available.h"
#include "backends/device/queue.h"
#ifdef LACUNA_OPENCL
#include "backends/opencl/opencl_backend.h"
#endif
#ifdef LACUNA_VULKAN
#include "backends/vulkan/vulkan_backend.h"
#endif

namespace lacuna::device {
namespace {

class HostMemoryPools : public testing::Test {
protected:
    HostMemory take(std::uint64_t bytes) {
        return HostMemoryPool::take(pool_, bytes, [&] {
            ++made_;
            auto memory = std::make_shared<std::vector<std::byte>>(bytes);
            return HostMemory(memory, *memory);
        });
    }

    std::shared_ptr<HostMemoryPool> pool_ = std::make_shared<HostMemoryPool>();
    int made_ = 0;
};

TEST_F(HostMemoryPools, GiveTheSmallestMemoryThatFitsAgain) {
    const std::byte* small = nullptr;
    const std::byte* large = nullptr;
    {
        const HostMemory one = take(5000), other = take(1000);
        large = one.values<std::byte>(1).data();
        small = other.values<std::byte>(1).data();
    }
    const HostMemory again = take(900), more = take(900);
    EXPECT_EQ(again.values<std::byte>(1).data(), small);
    EXPECT_EQ(more.values<std::byte>(1).data(), large);
    EXPECT_EQ(made_, 2);
    EXPECT_EQ(take(900).bytes(), 900u);
    EXPECT_EQ(made_, 3);
}

TEST_F(HostMemoryPools, GiveNoMemoryTwiceWhileACopyIsInUse) {
    const HostMemory first = take(100);
    const HostMemory copy = first;
    EXPECT_TRUE(first.has_copies());
    EXPECT_NE(take(100).values<std::byte>(1).data(), first.values<std::byte>(1).data());
}

TEST_F(HostMemoryPools, KeepNoMoreThanAQuarterOfAGibibyte) {
    {
        const HostMemory one = take(std::uint64_t{150} << 20),
                         other = take(std::uint64_t{120} << 20);
    }
    EXPECT_EQ(made_, 2);
    { const HostMemory larger = take(std::uint64_t{130} << 20); }
    EXPECT_EQ(made_, 2) << "the larger one was kept";
    { const HostMemory both = take(1), made_again = take(1); }
    EXPECT_EQ(made_, 3) << "the smaller one was not";
}

TEST_F(HostMemoryPools, OutliveTheirOwners) {
    HostMemory memory = take(64);
    pool_.reset();
    memory.values<std::uint32_t>(16)[15] = 7;
    EXPECT_EQ(memory.values<std::uint32_t>(1, 60)[0], 7u);
}

TEST(HostMemory, ContainsWhatLiesWithinIt) {
    auto bytes = std::make_shared<std::vector<std::byte>>(64);
    const std::span<std::byte> all(*bytes);
    const HostMemory memory(bytes, all.subspan(16, 32));
    EXPECT_TRUE(memory.contains(all.subspan(16, 32)));
    EXPECT_TRUE(memory.contains(all.subspan(47, 1)));
    EXPECT_FALSE(memory.contains(all.subspan(15, 2)));
    EXPECT_FALSE(memory.contains(all.subspan(40, 9)));
    EXPECT_FALSE(memory.contains(all.subspan(56, 8)));
}

class HostMemoryOfADevice : public tests::OnBackend {};
INSTANTIATE_TEST_SUITE_P(Device, HostMemoryOfADevice, tests::kDeviceBackends,
                         tests::name_of_parameter);

std::unique_ptr<Queue> queue_of(const std::string& backend) {
#ifdef LACUNA_OPENCL
    if (backend == "opencl") return opencl::open_queue({});
#endif
#ifdef LACUNA_VULKAN
    if (backend == "vulkan") return vulkan::open_queue({});
#endif
    throw Unavailable("backend " + backend + ": this build was made without it");
}

// Beside other memory, and at any place in a block.
TEST_P(HostMemoryOfADevice, IsReadAndWrittenByTheDevice) {
    constexpr std::size_t kWords = 1000, kFirst = 4 * 77;
    const auto queue = queue_of(GetParam());
    const HostMemory up = queue->host_memory(8 * kWords), down = queue->host_memory(8 * kWords);
    const std::span<std::uint32_t> sent = up.values<std::uint32_t>(kWords, kFirst);
    std::iota(sent.begin(), sent.end(), 5u);
    const Buffer buffer = queue->make(4 * kWords);
    queue->upload(buffer, std::as_bytes(sent), 0);
    const std::span<std::uint32_t> received = down.values<std::uint32_t>(kWords, 2 * kFirst);
    std::vector<std::uint32_t> in_other_memory(kWords);
    queue->download(buffer, std::as_writable_bytes(received));
    queue->download(buffer, std::as_writable_bytes(std::span(in_other_memory)));
    queue->wait();
    EXPECT_TRUE(std::equal(sent.begin(), sent.end(), received.begin(), received.end()));
    EXPECT_TRUE(std::equal(sent.begin(), sent.end(), in_other_memory.begin()));
}

}  // namespace
}  // namespace lacuna::device
