// What becomes of a round's candidates near a strip's borders, where it depends on the neighbours'.
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

namespace lacuna {

// Each round, before its draws are located for good, those near the borders are located alone. Of
// their candidates that no earlier sample covers, the ones within a radius of a border go to the
// neighbour there. A candidate's status depends on the earlier ones within its radius, on this side
// or on the other: each rank decides what it can, tells the other, and so on, pass by pass, until
// all statuses are known. The neighbours' samples then join the round as draws in the halo, guests,
// ahead of the rank's own, so that the backend rejects what they cover: that is not admitted in any
// case, for no two samples conflict.
class Border {
public:
    // Looks so many columns (backends/columns.h) of the plan into the strip: what decides a status
    // lies one or two columns away. Where it does not, the strip is looked at as a whole, which
    // takes time and memory, in that round alone.
    static constexpr std::uint32_t kDepth = 9;
    Border(const Strip& strip, Ranks& ranks, std::uint32_t depth = kDepth);

    // The round's draws in the backend's places: the guests, then `own`, the marginal's last.
    // Valid until the next call.
    std::span<const Draw> settle(Backend& backend, const Marginal& marginal,
                                 std::span<const Draw> own);
    // The first orders of these draws are the guests', so many.
    std::uint32_t guests() const { return guests_; }

    // What the round came to, and whether its places are boxes.
    void note(const Round& round, bool are_boxes);
    // The free lengths of the strip's own places, of all places'.
    std::span<const std::uint32_t> own_lengths(std::span<const std::uint32_t> lengths) const;

    // Over all rounds.
    struct Tally {
        std::uint64_t samples = 0;        // own ones within a radius of a border
        std::uint64_t sent = 0;           // candidates
        std::uint64_t messages = 0;       // to both neighbours
        std::uint64_t most_messages = 0;  // in a round
        std::uint64_t whole_looks = 0;    // rounds in which the strip was looked at as a whole
    };
    const Tally& tally() const { return tally_; }

private:
    // A candidate on its way: how far from the border that it is sent across.
    struct Sent {
        std::uint32_t distance;
        std::uint32_t y;
        std::uint32_t number;
    };

    std::size_t low_places() const;  // in the halo
    std::size_t high_places() const;
    // Of x in the strip: whether something there may conflict with something across the border.
    bool is_near_low(std::uint32_t x) const {
        return strip_.has_low_neighbour() && x - own_.begin < strip_.plan.radius;
    }
    bool is_near_high(std::uint32_t x) const {
        return strip_.has_high_neighbour() && own_.end - x < strip_.plan.radius;
    }
    Span unseen() const;
    Draw draw_of(const Rival& guest) const;

    void look(Backend& backend, const Marginal& marginal, std::span<const Draw> own);
    void look_at_all(Backend& backend, const Marginal& marginal, std::span<const Draw> own);
    template <typename IsCovered>
    void take(Backend& backend, const Marginal& marginal, IsCovered is_covered);
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
    Span own_;                                // x
    std::vector<std::uint32_t> first_lines_;  // of each column
    std::vector<std::uint32_t> bin_begins_;
    bool are_boxes_ = false;
    // So many columns at either end are looked at; low_depth_ is all of them where that is most.
    std::uint32_t low_depth_, high_depth_;
    std::unique_ptr<BorderGrid> low_grid_, high_grid_;

    std::vector<Draw> near_;  // those looked at; then with orders of their own
    std::vector<std::uint32_t> near_numbers_;
    Rivals rivals_;
    std::vector<std::uint32_t> low_sent_, high_sent_;  // among the rivals, by number
    std::vector<std::uint32_t> low_received_, high_received_;
    Sides received_;
    std::vector<Draw> draws_;
    std::uint32_t guests_ = 0;
    std::uint64_t messages_ = 0;  // of the round
    Tally tally_;
};

}  // namespace lacuna
