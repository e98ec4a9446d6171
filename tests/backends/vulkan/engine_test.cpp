// Long work is done in parts, and may be cancelled in between.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>

#include "backends/available.h"
#include "backends/vulkan/engine.h"
#include "backends/vulkan/programs.h"

namespace {

using namespace lacuna;
using vulkan::Buffer;
using vulkan::Engine;

// Sums of blocks of one number each.
class Work : public testing::Test {
protected:
    void SetUp() override {
        tests::skip_or_fail_without("vulkan");
        if (IsSkipped() || HasFatalFailure()) return;
        engine_.emplace("", nullptr);
        scan_ = engine_->make_kernel(vulkan::embedded_programs().scan);
        values_ = engine_->allocate(Engine::Memory::device, kItems * sizeof(std::uint32_t));
        sums_ = engine_->allocate(Engine::Memory::download, kItems * sizeof(std::uint32_t));
        failure_ = engine_->allocate(Engine::Memory::device, sizeof(std::uint32_t));
        engine_->fill(sums_, 0, sums_.bytes());
        engine_->fill(failure_, 0, failure_.bytes());
        engine_->wait();
    }

    static constexpr std::uint32_t kItems = 1u << 14;
    static constexpr std::uint32_t kWork = 1u << 10;  // 16 times what one submission holds

    void start() {
        engine_->fill(values_, 7, values_.bytes());
        engine_->barrier();
        engine_->dispatch(scan_, {values_, sums_, failure_}, vulkan::ScanArguments{0, kItems, 1},
                          kItems, kWork);
    }

    std::optional<Engine> engine_;
    vulkan::Kernel scan_;
    Buffer values_, sums_, failure_;
};

TEST_F(Work, IsAskedNowAndThenWhetherToGoOn) {
    int asked = 0;
    engine_->watch([&] { return ++asked > 0; });
    start();
    engine_->wait();
    EXPECT_GE(asked, 16);
    for (const std::uint32_t sum : sums_.as<std::uint32_t>()) ASSERT_EQ(sum, 7u);
}

TEST_F(Work, StopsWhenItMayNotGoOnAndCanBeTakenUpAgain) {
    int asked = 0;
    engine_->watch([&] { return ++asked < 3; });
    EXPECT_THROW(start(), Cancelled);
    EXPECT_EQ(asked, 3);
    EXPECT_EQ(sums_.as<std::uint32_t>().back(), 0u) << "the last part has not been done";

    engine_->watch({});
    start();
    engine_->wait();
    EXPECT_EQ(sums_.as<std::uint32_t>().back(), 7u);
}

}  // namespace
