// The cpu backend: the order of the verbs, and the result of a round.
#include "backends/cpu/cpu_backend.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "backends/cpu/bins.h"
#include "base/workers.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

class CpuBackend : public Backend {
public:
    CpuBackend(const Plan& plan, std::uint32_t threads)
        : workers_(threads), bins_(make_bins(plan)), round_(bins_->round) {}

    std::string device() const override { return workers_.name(); }
    Workers& workers() override { return workers_; }
    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void locate(std::span<const Draw> draws) override {
        if (stage_ == Stage::none) bins_->set_free();
        round_.begin(draws, bins_->begins);
        bins_->locate(draws);
        stage_ = Stage::located;
    }

    void admit() override {
        expect(stage_ == Stage::restored || stage_ == Stage::located);
        if (stage_ == Stage::restored) bins_->screen();
        stage_ = bins_->admit() ? Stage::cut : Stage::admitted;
    }

    void subtract() override {
        expect(stage_ != Stage::none);
        if (stage_ == Stage::restored) bins_->insert();
        if (stage_ != Stage::cut) bins_->subtract();
        stage_ = Stage::cut;
    }

    void refine(bool halve) override {
        expect(stage_ != Stage::none && stage_ != Stage::cut);
        if (stage_ == Stage::restored) bins_->insert();
        bins_->refine(halve);
        stage_ = Stage::cut;
    }

    Round finish_round() override {
        find_samples();
        if (round_.plan.tells_orders) find_orders();
        return {samples_,        survivors(), bins_->free_lengths, bins_->width(),
                bins_->widths(), orders_,     bins_->begins,       bins_->copy_ends()};
    }
    std::vector<Candidate> located() override { return round_.candidates; }

    Snapshot snapshot() override {
        find_samples();
        const bool leaves_out = stage_ == Stage::admitted;
        Snapshot snapshot =
            bins_->snapshot(leaves_out ? std::span<const Sample>(samples_) : std::span<Sample>());
        // It does not show which candidates are covered before admit was called.
        if (stage_ == Stage::located)
            std::fill(snapshot.statuses.begin(), snapshot.statuses.end(), STATUS_UNDECIDED);
        return snapshot;
    }
    void restore(const Snapshot& snapshot) override {
        bins_->restore(snapshot);
        stage_ = Stage::restored;
    }

private:
    // How far the round has come, which decides what the next verb has to do.
    enum class Stage {
        none,      // there was no round yet, and the bins are not set free
        restored,  // candidates with any statuses
        located,   // undecided candidates; in exact, those that are covered are found
        admitted,  // decided candidates; in exact, the samples are in the neighbour index
        cut,       // the samples are cut from the bins
    };

    static void expect(bool may_follow) {
        if (!may_follow) throw std::logic_error("this verb may not follow the last one");
    }

    std::unique_ptr<Bins> make_bins(const Plan& plan) {
        if (plan.has_radius_field()) return make_field_boxes(plan, workers_);
        if (plan.is_cells()) return make_lattice(plan, workers_);
        return plan.has_grid() ? make_uniform_boxes(plan, workers_)
                               : make_line_bins(plan, workers_);
    }

    // Lists the admitted candidates in the order of their draws.
    void find_samples() {
        samples_.resize(round_.candidates.size());
        Sample* next = samples_.data();
        for (const std::uint32_t i : round_.by_order) {
            *next = {round_.candidates[i].x, round_.candidates[i].y};
            next += round_.statuses[i] == STATUS_ADMITTED;
        }
        samples_.resize(static_cast<std::size_t>(next - samples_.data()));
    }
    std::uint64_t survivors() const {
        const auto covered = std::count(round_.statuses.begin(), round_.statuses.end(),
                                        stage_ == Stage::located ? ~0U : STATUS_COVERED);
        return round_.statuses.size() - static_cast<std::size_t>(covered);
    }
    // Lists the orders of the samples' draws.
    void find_orders() {
        orders_.clear();
        for (std::uint32_t order = 0; order < round_.by_order.size(); ++order)
            if (round_.statuses[round_.by_order[order]] == STATUS_ADMITTED)
                orders_.push_back(order);
    }

    Workers workers_;
    std::unique_ptr<Bins> bins_;
    RoundMemory& round_;
    Stage stage_ = Stage::none;
    std::vector<Sample> samples_;
    std::vector<std::uint32_t> orders_;  // with plan.tells_orders
};

}  // namespace

std::unique_ptr<Backend> make_backend(const Plan& plan, const Placement& placement) {
    return std::make_unique<CpuBackend>(plan, placement.threads);
}

}  // namespace lacuna::cpu
