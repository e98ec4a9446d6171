// A round's memory on a device: no buffer is larger than the device allows.
#include "backends/device/round_memory.h"

#include <gtest/gtest.h>

#include <string>

#include "backends/scenes.h"

namespace lacuna::device {
namespace {

// Makes buffers without memory, and ignores all other commands.
class Toy : public Queue {
public:
    explicit Toy(std::uint64_t largest_buffer_bytes) {
        entry_.name = "Toy";
        entry_.memory_bytes = std::uint64_t{1} << 40;
        entry_.largest_buffer_bytes = largest_buffer_bytes;
    }

    const DeviceEntry& device() const override { return entry_; }
    Buffer make(std::uint64_t bytes) override { return {nullptr, bytes}; }
    void fill(const Buffer&, std::uint32_t, std::uint64_t) override {}
    std::uint32_t run_of(std::uint32_t) const override { return 1; }
    bool runs_in_lockstep() const override { return true; }
    void drain() noexcept override {}

protected:
    void enqueue_upload(const Buffer&, std::span<const std::byte>, std::uint64_t) override {}
    void enqueue_download(const Buffer&, std::span<std::byte>) override {}
    std::uint32_t group_size() const override { return 1; }
    std::uint64_t most_groups() const override { return 1; }
    void enqueue(const KernelShape&, std::span<const std::byte>, std::span<const Buffer>,
                 std::uint32_t, std::size_t) override {}
    void time_kernels() override {}
    void pause() override {}
    void finish() override {}

private:
    DeviceEntry entry_;
};

TEST(RoundMemory, GrowsUpToTheLargestBufferAndNoFurther) {
    Toy queue(1'000'000);
    RoundMemory round(tests::plan_of(0.1, 2, Boundary::box), queue);
    Buffer buffer;
    round.make_room(buffer, 100'000);
    round.make_room(buffer, 250'000);
    EXPECT_EQ(buffer.bytes(), 1'000'000u);
    try {
        round.make_room(buffer, 300'000);
        FAIL() << "made room for 1,200,000 bytes";
    } catch (const Unavailable& error) {
        EXPECT_EQ(std::string(error.what()),
                  "device Toy: the request needs a buffer of 0.0012 GB, and its largest has 0.001 "
                  "GB");
    }
}

}  // namespace
}  // namespace lacuna::device
