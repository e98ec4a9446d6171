// The host's memory for transfers: it is used again, by later queues, too.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "backends/device/queue.h"

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

}  // namespace
}  // namespace lacuna::device
