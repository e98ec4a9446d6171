// The verbs of a round in space, on threads. A task serves a run of blocks.
#include "space/cpu_backend.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "portable/status.h"
#include "space/bins.h"
#include "space/samples.h"

namespace lacuna::space {
namespace {

// A draw that no sample of an earlier round covers.
struct Survivor {
    SpaceSample sample;
    std::uint32_t order;
    std::uint32_t block;
};

// The survivors of a round, block by block, and what became of them.
class Survivors {
public:
    explicit Survivors(std::size_t blocks) : firsts_(blocks), counts_(blocks) {}

    // Takes those of each run, whose blocks ascend.
    void take(std::vector<std::vector<Survivor>> runs) {
        for (const Survivor& old : all_) counts_[old.block] = 0;
        std::size_t count = 0;
        for (const std::vector<Survivor>& run : runs) count += run.size();
        std::vector<Survivor>().swap(all_);
        all_.reserve(count);
        ends_.clear();
        for (std::vector<Survivor>& run : runs) {
            for (const Survivor& one : run) {
                if (counts_[one.block]++ == 0)
                    firsts_[one.block] = static_cast<std::uint32_t>(all_.size());
                all_.push_back(one);
            }
            ends_.push_back(static_cast<std::uint32_t>(all_.size()));
            std::vector<Survivor>().swap(run);
        }
        statuses_ = std::vector<std::atomic<std::uint8_t>>(all_.size());
        for (auto& status : statuses_) status.store(STATUS_UNDECIDED, std::memory_order_relaxed);
    }
    std::size_t size() const { return all_.size(); }
    const Survivor& operator[](std::size_t i) const { return all_[i]; }
    bool is_admitted(std::size_t i) const { return status(i) == STATUS_ADMITTED; }

    // Admits each unless an earlier one that is closer than the radius is admitted. `draws`: of the
    // round. Where survivors crowd, the first few are decided first. They cover most of the others,
    // which are then compared with fewer.
    void decide(const FirstBins& all, std::uint64_t radius_squared, std::size_t draws,
                Workers& workers) {
        const auto runs = static_cast<std::uint32_t>(ends_.size());
        std::size_t begin = 0, end = first_part(draws);
        for (; begin < draws; begin = end, end = std::min(2 * end, draws)) {
            const Orders part{begin, end};
            if (begin > 0)
                workers.for_columns(runs, size(), [&](std::uint32_t run) {
                    reject_covered(all, radius_squared, part, of_run(run));
                });
            std::vector<Rivals> rivals(runs);
            workers.for_columns(runs, size(), [&](std::uint32_t run) {
                find_rivals(all, radius_squared, part, of_run(run), rivals[run]);
            });
            // The earliest of those that are undecided can always be decided.
            while (!workers.all_columns(runs, size(),
                                        [&](std::uint32_t run) { return decide(rivals[run]); })) {
            }
        }
    }

private:
    // Of undecided survivors, the earlier ones that are too close.
    struct Rivals {
        std::vector<std::uint32_t> undecided;
        std::vector<std::uint32_t> begins;  // of each undecided one; then the number of all
        std::vector<std::uint32_t> all;
    };

    // A position, and the number of its survivor.
    using Near = std::pair<Position, std::uint32_t>;
    // Draws [begin, end), by their order.
    struct Orders {
        std::size_t begin;
        std::size_t end;
        bool has(std::uint32_t order) const { return order >= begin && order < end; }
    };
    // So many draws that a block has about kFew survivors among them.
    std::size_t first_part(std::size_t draws) const {
        constexpr std::size_t kFew = 16;
        std::size_t blocks = 0;
        for (std::size_t i = 0; i < size(); ++i)
            blocks += i == 0 || all_[i].block != all_[i - 1].block ? 1U : 0U;
        if (size() <= kFew * blocks) return draws;
        return std::max<std::size_t>(1, draws * (kFew * blocks) / size());
    }

    Span of_run(std::uint32_t run) const { return {run == 0 ? 0 : ends_[run - 1], ends_[run]}; }
    std::uint8_t status(std::size_t i) const {
        return statuses_[i].load(std::memory_order_relaxed);
    }
    void set(std::size_t i, std::uint32_t status) {
        statuses_[i].store(static_cast<std::uint8_t>(status), std::memory_order_relaxed);
    }

    // Of the survivors in this part, rejects those that an admitted one covers.
    void reject_covered(const FirstBins& all, std::uint64_t radius_squared, Orders part, Span own) {
        std::vector<Near> near;
        std::uint32_t block = ~std::uint32_t{0};
        for (std::uint32_t i = own.begin; i < own.end; ++i) {
            const Survivor& one = all_[i];
            if (!part.has(one.order)) continue;
            if (one.block != block)
                find_near(all, block = one.block, near, [&](std::uint32_t other) {
                    return all_[other].order < part.begin && is_admitted(other);
                });
            if (std::any_of(near.begin(), near.end(), [&](const Near& other) {
                    return squared_distance(other.first, one.sample.at) < radius_squared;
                }))
                set(i, STATUS_REJECTED);
        }
    }
    void find_rivals(const FirstBins& all, std::uint64_t radius_squared, Orders part, Span own,
                     Rivals& found) {
        std::vector<Near> near;
        std::uint32_t block = ~std::uint32_t{0};
        for (std::uint32_t i = own.begin; i < own.end; ++i) {
            const Survivor& one = all_[i];
            if (!part.has(one.order) || status(i) != STATUS_UNDECIDED) continue;
            if (one.block != block)
                find_near(all, block = one.block, near, [&](std::uint32_t other) {
                    return part.has(all_[other].order) && status(other) != STATUS_REJECTED;
                });
            const std::size_t begin = found.all.size();
            for (const auto& [at, other] : near)
                if (all_[other].order < one.order &&
                    squared_distance(at, one.sample.at) < radius_squared)
                    found.all.push_back(other);
            if (found.all.size() == begin) {
                set(i, STATUS_ADMITTED);
                continue;
            }
            found.undecided.push_back(i);
            found.begins.push_back(static_cast<std::uint32_t>(begin));
        }
        found.begins.push_back(static_cast<std::uint32_t>(found.all.size()));
    }
    template <typename IsWanted>
    void find_near(const FirstBins& all, std::uint32_t block, std::vector<Near>& near,
                   const IsWanted& is_wanted) const {
        near.clear();
        all.for_each_near(block, [&](std::uint32_t other, const Position& shift) {
            for (std::uint32_t k = 0; k < counts_[other]; ++k) {
                const std::uint32_t i = firsts_[other] + k;
                if (is_wanted(i)) near.emplace_back(moved(all_[i].sample.at, shift), i);
            }
        });
    }
    // Returns whether all are decided.
    bool decide(Rivals& rivals) {
        std::size_t left = 0;
        for (std::size_t i = 0; i < rivals.undecided.size(); ++i) {
            const std::uint32_t one = rivals.undecided[i];
            if (status(one) != STATUS_UNDECIDED) continue;
            std::uint32_t decided = STATUS_ADMITTED;
            for (std::uint32_t k = rivals.begins[i]; k < rivals.begins[i + 1]; ++k) {
                const std::uint8_t earlier = status(rivals.all[k]);
                if (earlier == STATUS_ADMITTED) {
                    decided = STATUS_REJECTED;
                    break;
                }
                if (earlier == STATUS_UNDECIDED) decided = STATUS_UNDECIDED;
            }
            if (decided == STATUS_UNDECIDED)
                ++left;
            else
                set(one, decided);
        }
        return left == 0;
    }

    std::vector<Survivor> all_;
    std::vector<std::uint32_t> ends_;    // of each run
    std::vector<std::uint32_t> firsts_;  // of each block
    std::vector<std::uint32_t> counts_;
    std::vector<std::atomic<std::uint8_t>> statuses_;
};

class CpuBackend : public SpaceBackend {
public:
    CpuBackend(const Plan& plan, std::uint32_t threads)
        : plan_(plan),
          all_(*plan.space().first_bins),
          workers_(threads),
          bins_(all_, plan.radius_squared, workers_),
          samples_(all_, plan.radius_squared),
          survivors_(all_.blocks()),
          number_(plan.first_draw) {}

    std::string device() const override { return workers_.name(); }
    Workers& workers() override { return workers_; }
    void watch(std::function<bool()> may_go_on) override { workers_.watch(std::move(may_go_on)); }

    void locate(std::span<const Draw> draws) override {
        draws_ = draws.size();
        std::vector<std::vector<Survivor>> made(bins_.runs());
        workers_.for_columns(bins_.runs(), draws.size(),
                             [&](std::uint32_t run) { locate(draws, bins_.run(run), made[run]); });
        survivors_.take(std::move(made));
        number_ += draws.size();
    }
    void admit() override {
        survivors_.decide(all_, plan_.radius_squared, draws_, workers_);
        std::vector<std::uint32_t> admitted;
        std::vector<std::uint32_t> of_orders(draws_, kNone);
        for (std::uint32_t i = 0; i < survivors_.size(); ++i) {
            if (!survivors_.is_admitted(i)) continue;
            admitted.push_back(i);
            of_orders[survivors_[i].order] = i;
        }
        round_.clear();
        for (const std::uint32_t i : of_orders)
            if (i != kNone) round_.push_back(survivors_[i].sample);
        samples_.add(
            admitted.size(), [&](std::size_t i) { return survivors_[admitted[i]].block; },
            [&](std::size_t i) { return survivors_[admitted[i]].sample.at; });
    }
    void subtract() override { refine(false); }
    void refine(bool halve) override { bins_.refine(samples_, halve, workers_); }
    RoundOf<SpaceSample> finish_round() override {
        return {.samples = round_,
                .survivors = survivors_.size(),
                .free_lengths = bins_.lengths(),
                .bin_width = 0,
                .bin_widths = bins_.widths()};
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    // Draws are sorted by bin.
    void locate(std::span<const Draw> draws, Span blocks, std::vector<Survivor>& made) const {
        const auto first_of = [&](std::uint32_t bin) {
            return std::lower_bound(draws.begin(), draws.end(), bin,
                                    [](const Draw& draw, std::uint32_t b) { return draw.bin < b; });
        };
        auto draw = first_of(bins_.begin(blocks.begin));
        std::vector<Position> near;
        for (std::uint32_t i = blocks.begin; i < blocks.end; ++i) {
            if (draw == draws.end() || draw->bin >= bins_.begin(i + 1)) continue;
            const std::uint32_t block = bins_.block(i);
            samples_.find_near(block, near);
            for (; draw != draws.end() && draw->bin < bins_.begin(i + 1); ++draw) {
                const SpaceSample one = drawn(all_, bins_[draw->bin], block,
                                              {draw->rank, draw->offset, bits_of(draw->order)});
                if (std::none_of(near.begin(), near.end(), [&](const Position& sample) {
                        return squared_distance(sample, one.at) < plan_.radius_squared;
                    }))
                    made.push_back({one, draw->order, block});
            }
        }
    }
    // Surfaces need no third number.
    std::uint32_t bits_of(std::uint32_t order) const {
        return all_.is_volume() ? third_bits(plan_, number_ + order) : 0;
    }

    const Plan& plan_;
    const FirstBins& all_;
    Workers workers_;
    Bins bins_;
    Samples samples_;
    Survivors survivors_;
    std::uint64_t number_;  // of the round's first draw
    std::size_t draws_ = 0;
    std::vector<SpaceSample> round_;  // in the order of their draws
};

}  // namespace

std::unique_ptr<SpaceBackend> make_cpu_backend(const Plan& plan, std::uint32_t threads) {
    return std::make_unique<CpuBackend>(plan, threads);
}

}  // namespace lacuna::space
