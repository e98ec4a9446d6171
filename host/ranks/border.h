// Decides the candidates near a strip's borders, which depend on the neighbours' candidates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "ranks/border_grid.h"
#include "ranks/ranks.h"
#include "ranks/rivals.h"
#include "ranks/strip.h"
#include "rounds/marginal.h"
#include "sampling/timed_verbs.h"

namespace lacuna {

// In each round the draws near the borders are located first. A candidate within a radius of a
// border that no earlier sample covers is sent to the neighbour there. Its status depends on
// earlier candidates within its radius, on either side. Each rank decides what it can and sends the
// statuses, pass by pass, until all are known. The neighbours' samples then join the round as
// guests: draws in the halo, ahead of the rank's own draws. The backend rejects what guests cover,
// which would not be admitted anyway, because no two samples conflict.
class Border {
public:
    // Locates draws in this many columns (backends/columns.h) from each border: usually a status
    // depends on candidates one or two columns away. If one depends on more, all columns are
    // located, which takes time and memory in that round alone.
    static constexpr std::uint32_t kDepth = 9;
    Border(const Strip& strip, Ranks& ranks, std::uint32_t depth = kDepth);

    // Returns the round's draws for the backend: the guests, then `own`, the marginal's last draws,
    // with bins shifted by the halo. Valid until the next call.
    std::span<const Draw> draws_with_guests(TimedBackend<Backend>& backend,
                                            const Marginal& marginal, std::span<const Draw> own);
    // The number of guests. Guests have the first orders of the draws.
    std::uint32_t guests() const { return guests_; }

    // Takes the round's result, and whether its bins are boxes.
    void note(const Round& round, bool are_boxes);
    // The part of the free lengths that belongs to the strip without its halo.
    std::span<const std::uint32_t> own_lengths(std::span<const std::uint32_t> lengths) const;

    // Counts over all rounds.
    struct Tally {
        std::uint64_t samples = 0;        // own samples within a radius of a border
        std::uint64_t sent = 0;           // candidates that were sent
        std::uint64_t messages = 0;       // messages to both neighbours
        std::uint64_t most_messages = 0;  // most messages in one round
        std::uint64_t whole_looks = 0;    // rounds in which all columns were located
    };
    const Tally& tally() const { return tally_; }

private:
    // A candidate as it is sent; `distance` is its distance from the border.
    struct Sent {
        std::uint32_t distance;
        std::uint32_t y;
        std::uint32_t number;
    };

    std::size_t low_bins() const;  // bins in the halo
    std::size_t high_bins() const;
    // Whether a candidate at x in the strip may conflict with one across the border.
    bool is_near_low(std::uint32_t x) const {
        return strip_.has_low_neighbour() && x - own_.begin < strip_.plan.radius;
    }
    bool is_near_high(std::uint32_t x) const {
        return strip_.has_high_neighbour() && own_.end - x < strip_.plan.radius;
    }
    Span unseen() const;
    Draw draw_of(const Rival& guest) const;

    void look(TimedBackend<Backend>& backend, const Marginal& marginal, std::span<const Draw> own);
    void look_at_all(TimedBackend<Backend>& backend, const Marginal& marginal,
                     std::span<const Draw> own);
    template <typename IsCovered>
    void take(TimedBackend<Backend>& backend, const Marginal& marginal, IsCovered is_covered);
    bool find_rivals(Span unseen);
    std::vector<std::byte> pack(std::span<const std::uint32_t> candidates, bool is_low) const;
    void add_received(std::vector<std::uint32_t>& indices, std::span<const std::byte> bytes,
                      bool is_low);
    Sides exchange(const Sides& sides);
    void exchange_statuses();
    void list_sent();
    void make_draws(std::span<const std::uint32_t> low, std::span<const std::uint32_t> high,
                    std::span<const Draw> own);

    const Strip& strip_;
    Ranks& ranks_;
    Span own_;                                // an interval of x
    std::vector<std::uint32_t> first_lines_;  // first line of each column
    std::vector<std::uint32_t> bin_begins_;
    bool are_boxes_ = false;
    // Numbers of columns at either end that are located. If all are, low_depth_ counts all of them.
    std::uint32_t low_depth_, high_depth_;
    std::unique_ptr<BorderGrid> low_grid_, high_grid_;

    std::vector<Draw> near_;  // the located draws; take() replaces their orders by 0, 1, ...
    std::vector<std::uint32_t> near_numbers_;
    Rivals rivals_;
    std::vector<std::uint32_t> low_sent_, high_sent_;  // indices of rivals, ordered by number
    std::vector<std::uint32_t> low_received_, high_received_;
    Sides received_;
    std::vector<Draw> draws_;
    std::uint32_t guests_ = 0;
    std::uint64_t messages_ = 0;  // in this round
    Tally tally_;
};

}  // namespace lacuna
