// What the opencl backends of all modes do alike: they queue each verb and wait for it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "backends/device/layout.h"
#include "backends/opencl/errors.h"
#include "backends/opencl/program.h"

namespace lacuna::opencl {

// State is a RoundMemory with snapshot() and restore().
template <typename State>
class RoundBackend : public Backend {
public:
    template <typename... Settings>
    explicit RoundBackend(std::shared_ptr<Program> program, const Plan& plan,
                          const Settings&... settings)
        : state_(std::move(program), plan, settings...) {}

    // Transfers into this object's memory may be on their way when an error ends a run.
    ~RoundBackend() override {
        try {
            state_.queue.drain();
        } catch (const cl::Error&) {  // of the run, and told by it
        }
    }
    RoundBackend(const RoundBackend&) = delete;
    RoundBackend& operator=(const RoundBackend&) = delete;

    std::string device() const override { return state_.program->entry.name; }
    void watch(std::function<bool()> may_go_on) override {
        state_.queue.watch(std::move(may_go_on));
    }

    // Each verb waits, so that an observer can tell their times apart; it costs some 30 us a verb.
    void locate(std::span<const Draw> draws) override {
        run([&] {
            subtracting_ = false;
            queue_locate(draws);
        });
    }
    void admit() override {
        run([&] { queue_admit(); });
    }
    void subtract() override {
        run([&] {
            subtracting_ = true;
            queue_subtract();
        });
    }
    void refine(bool halve) override {
        run([&] { queue_refine(halve); });
    }
    Round finish_round() override {
        return guard([&] { return wait(); });
    }

    Snapshot snapshot() override {
        return guard([&] {
            wait();
            return state_.snapshot();
        });
    }
    void restore(const Snapshot& snapshot) override {
        guard([&] {
            state_.restore(snapshot);
            subtracting_ = false;
        });
    }

protected:
    virtual void queue_locate(std::span<const Draw> draws) = 0;
    virtual void queue_admit() = 0;
    virtual void queue_subtract() = 0;
    virtual void queue_refine(bool halve) = 0;
    // By the flags that were read: what else the round takes before subtract. False: nothing.
    virtual bool queue_rest() = 0;

private:
    template <typename Work>
    std::invoke_result_t<Work> guard(Work work) {
        return guarded(state_.program->entry.name, state_.program->log, work);
    }

    template <typename Verb>
    void run(Verb verb) {
        guard([&] {
            verb();
            state_.queue.finish();
        });
    }

    // Waits until the round is done, with what more it takes.
    Round wait() {
        by_order_.resize(state_.draw_count);
        free_lengths_.resize(state_.place_count);
        while (true) {
            state_.queue.template start_read<std::uint32_t>(state_.free_lengths, free_lengths_);
            state_.queue.template start_read<Sample>(state_.samples, by_order_);
            state_.read_flags();
            if (!queue_rest()) break;
            if (subtracting_) queue_subtract();
        }
        const std::uint64_t survivors = device::take_admitted(by_order_, samples_);
        return {samples_, survivors, free_lengths_, state_.place_width()};
    }

    // Reads end here: before the state, whose queue writes to it.
    std::vector<Sample> by_order_;
    std::vector<std::uint32_t> free_lengths_;
    std::vector<Sample> samples_;
    bool subtracting_ = false;  // the round's subtraction has been asked for

protected:
    State state_;
};

}  // namespace lacuna::opencl
