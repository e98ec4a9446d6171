// Prefix sums on devices, against sums on the host. A wrong sum is an index out of range, so a
// fault is planted in them here, where nothing is written by such an index.
#include "backends/device/scan.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "backends/device/altered.h"
#include "backends/scenes.h"
#include "portable/report.h"

namespace lacuna::device {
namespace {

class Scan : public tests::OnFaultyBackend {
protected:
    // Whether the device's sums of the numbers before each of `count` numbers, and of all, are the
    // host's.
    static bool sums_are_right(Queue& queue, std::uint32_t count) {
        RoundMemory round(tests::plan_of(0.1, 2, Boundary::box), queue);
        std::mt19937 random(count);
        std::vector<std::uint32_t> numbers(count);
        for (std::uint32_t& number : numbers) number = random() % 4;
        make_room_to_scan(round, count);
        queue.fill(round.memory.sums, 0, round.memory.sums.words());
        queue.fill(round.memory.tops, 0, round.memory.tops.words());
        round.put_in_room<std::uint32_t>(round.memory.counts, numbers);
        scan(queue, round.memory, count);
        std::vector<std::uint32_t> before(count);
        std::vector<std::uint32_t> sums(round.memory.sums.words());
        std::vector<std::uint32_t> tops(round.memory.tops.words());
        round.get<std::uint32_t>(round.memory.counts, before);
        round.get<std::uint32_t>(round.memory.sums, sums);
        round.get<std::uint32_t>(round.memory.tops, tops);
        round.start_download();
        queue.wait();
        const std::uint32_t bits = block_bits_of_scan(count);
        std::uint32_t sum = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            // As in kernels/bodies/common/sums.h.
            if (before[i] + sums[i >> bits] + tops[i >> 2 * bits] != sum) return false;
            sum += numbers[i];
        }
        return round.report[TOTAL_WORD] == sum;
    }
};

INSTANTIATE_TEST_SUITE_P(Device, Scan, tests::kDeviceBackends, tests::name_of_parameter);

TEST_P(Scan, GivesTheSumsOfTheHostAndAFaultInItIsNoticed) {
    const tests::Fault none{"bodies/common/scan.h", "sum += value;", "sum += value;"};
    const tests::Fault fault{"bodies/common/scan.h", "sum += value;", "sum += value & ~1u;"};
    const auto right = tests::open_faulty_queue(GetParam(), none);
    const auto wrong = tests::open_faulty_queue(GetParam(), fault);
    for (const std::uint32_t count : {1u, 2u, 63u, 64u, 65u, 4095u, 4096u, 4097u, 300'001u}) {
        EXPECT_TRUE(sums_are_right(*right, count)) << count;
        EXPECT_FALSE(sums_are_right(*wrong, count)) << count;
    }
}

}  // namespace
}  // namespace lacuna::device
