// Neighbour lists: with a radius field, the samples that reach each block of first boxes
// (plan/first_boxes.h).
//
// A sample reaches a block if it is closer to the block than both its own radius and the greatest
// radius under the block. A tree of the blocks, with the greatest radius under each node, leads to
// the blocks that a sample reaches, whatever the range of radii.
//
// With classes a sample may reach thousands of blocks, because it may keep a far larger distance
// from another class than samples of that class would need short blocks for. But it covers nearly
// all of these: every candidate in them is too close to it. A covered block is closed. So each
// block gets few samples, and samples skip the nodes of the tree of which all blocks are closed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "backends/backend.h"
#include "backends/cpu/done_nodes.h"
#include "backends/cpu/sized.h"
#include "backends/cpu/vectors.h"
#include "base/large_pages.h"
#include "plan/first_boxes.h"
#include "plan/pixels.h"
#include "plan/plan.h"
#include "plan/radius_field.h"

namespace lacuna::cpu {

// An active box, and the block of first boxes that it is a part of.
struct BlockBox {
    Box at;
    std::uint32_t block;
};

class NeighbourLists {
public:
    explicit NeighbourLists(const Plan& plan);

    using Active = BlockBox;
    static Active active(const Box& box, std::uint32_t block) { return {box, block}; }
    static const Box& box_of(const Active& active) { return active.at; }
    // The block of a box or position, which is what Candidate::line holds, and the region that the
    // block lies in.
    static std::uint32_t line_of(const Active& active) { return active.block; }
    std::uint32_t line_at(std::uint32_t x, std::uint32_t y) const;
    std::uint32_t column_of(std::uint32_t block) const;

    const Plan& plan() const { return plan_; }
    const FirstBoxes& first() const { return first_; }
    const RadiusField& radius_field() const { return radius_field_; }
    Sized sized(const Candidate& candidate) const {
        return {candidate.x, candidate.y, radius_field_.radius_at(candidate.x, candidate.y)};
    }

    // The samples that may cut a part of a block, some perhaps twice; `latest` leaves out samples
    // that were listed before the last note_cuts(). Valid until the next call with the same
    // scratch.
    enum class Which { all, latest };
    SizedSpan of_part(std::uint32_t block, const Box& part, Which which, SizedList& scratch) const {
        const Few& few = few_[block];
        if (few.is_long) return of_long_part(block, part, which, scratch);
        return few.span().from(which == Which::latest ? few.cuts : 0);
    }

    // Whether of_part may return different samples for different parts of the block.
    bool is_split(std::uint32_t block) const {
        return few_[block].is_long && long_[block]->split != nullptr;
    }
    // Whether a sample was listed since note_cuts(): call that after all listed samples cut boxes.
    bool has_latest(std::uint32_t block) const { return (states_[block] & kLatest) != 0; }
    void note_cuts(std::uint32_t block);
    // The block has no boxes any more: no more samples are listed for it. May run in parallel.
    void close(std::uint32_t block);

    // Whether a sample conflicts with the candidate, or no sample may lie there: two samples keep
    // the smaller of their radii.
    bool is_covered(const Candidate& candidate) const {
        const auto [x, y, radius] = sized(candidate);
        const Few& few = few_[candidate.home];
        const SizedSpan near = few.is_long ? long_part(candidate.home, {x, y}) : few.span();
        if (radius == 0) return true;
        if (copies_.are_several()) return is_any_seen_closer(near, {x, y}, radius);
        if (radius_field_.has_ellipses()) return is_any_ellipse_closer(near, {x, y}, radius);
        return vectors_.is_any_sized_closer(near, {x, y}, radius, {plan_.period_x, plan_.period_y});
    }

    // Prefetch what is_covered and insert read about a candidate: its list and the index of the
    // tree node that insert begins with, then the node.
    void fetch(const Candidate& later) const {
        fetch_list(later.home);
        __builtin_prefetch(&first_.blocks[later.home].node);
    }
    void fetch_sooner(const Candidate& later) const {
        const FirstBoxes::Node* const node = &first_.nodes[first_.blocks[later.home].node];
        __builtin_prefetch(node - 2);
        __builtin_prefetch(node);
        __builtin_prefetch(node + 2);
    }
    void fetch_list(std::uint32_t block) const {
        const Few& few = few_[block];
        __builtin_prefetch(few.x);
        __builtin_prefetch(few.y);
        __builtin_prefetch(few.radius);
        __builtin_prefetch(&few.count);
    }
    // Lists a sample that lies in `block` for all blocks that it reaches, except closed ones. May
    // run in parallel for samples that reach nothing outside of their zone (FirstBoxes::Zone),
    // which then is `within`.
    void insert(const Sized& sample, std::uint32_t block, const FirstBoxes::Zone* within);
    void insert(const Candidate& candidate) { insert(sized(candidate), candidate.home, nullptr); }
    // Marks the blocks of a zone that the candidate reaches; may run in parallel for different
    // zones. All share one mark of the block, because in a crowded round they are thousands.
    void mark(const Sized& candidate, std::uint32_t zone);
    bool has_mark_near(const Candidate& at) const { return is_marked(at.home); }
    void unmark_all(std::span<const Candidate>, std::span<const std::uint32_t>);

    // Sets Snapshot::samples, without `left_out`.
    void snapshot(Snapshot& snapshot, std::span<const Sample> left_out) const;
    void restore(const Snapshot& snapshot);

private:
    // Entries. Seven of eight lists never grow longer, and Few then fills seven cache lines.
    static constexpr std::size_t kFew = 36;
    struct alignas(64) Few {
        std::uint32_t x[kFew];
        std::uint32_t y[kFew];
        std::uint32_t radius[kFew];
        std::uint32_t count;
        std::uint32_t cuts;  // the count at the last note_cuts()
        bool is_long;        // the samples are in long_ instead

        SizedSpan span() const { return {x, y, radius, count}; }
    };
    static_assert(sizeof(Few) == 448);
    static constexpr std::uint8_t kMarked = 1, kLatest = 2, kClosed = 4;

    // A block beside one of far smaller radii may have thousands of samples near it. A list of more
    // than `most` samples is therefore split in two, one for each half of the block.
    struct Split;
    struct List {
        SizedList near;
        std::size_t cuts = 0;
        std::unique_ptr<Split> split;
        std::size_t most = 64;
    };
    struct Half {
        Box box;
        std::uint32_t greatest;  // the greatest radius under it
        List list;
    };
    struct Split {
        Half low;
        Half high;
        const List& part_at(Sample at) const {
            return at.x >= high.box.x && at.y >= high.box.begin ? high.list : low.list;
        }
    };
    SizedSpan of_long_part(std::uint32_t block, const Box& part, Which which,
                           SizedList& scratch) const;
    SizedSpan long_part(std::uint32_t block, Sample at) const;
    bool is_any_seen_closer(const SizedSpan& near, Sample at, std::uint32_t radius) const;
    bool is_any_ellipse_closer(const SizedSpan& near, Sample at, std::uint32_t radius) const;
    bool reaches(const Sized& sample, const Box& box, std::uint32_t greatest) const;
    void push(const Sized& sample, std::uint32_t block);
    void push_long(const Sized& sample, std::uint32_t block);
    void add(List& list, const Box& box, const Sized& sample);
    void split(List& list, const Box& box);
    static void note_cuts(List& list);
    static void gather(const List& list, const Box& part, Which which, SizedList& found);
    const Box& box_of(std::uint32_t block) const {
        return first_.nodes[first_.blocks[block].node].box;
    }
    // Replaces all samples by these.
    void put(std::span<const Sized> samples);

    // A sample on a copy: with the x that it has there, and the factor that its radius and the
    // radii under blocks get there.
    struct There {
        Sized sample;
        std::uint64_t factor;
        std::uint32_t reach;               // of the sample: its radius times the factor
        const portable::Ellipse* ellipse;  // null where there are none
        bool is_own;                       // whether it is the sample's own copy
    };
    // Whether the sample's ellipse misses the box; the sample must have one. May return false
    // although the ellipse misses the box.
    bool misses(const There& there, const Box& box, bool wraps) const;
    There there(const Sized& sample, std::uint32_t copy) const;
    // For disks that cross no edge of a torus: whether the node holds all blocks that they reach on
    // the copy that has this root.
    bool is_within(const There& there, std::uint32_t node, std::uint32_t root) const;
    bool sticks_out(const There& there, std::uint32_t root) const;
    // Skips nodes of which all blocks are `done`, but not the sample's own block.
    template <typename Visit>
    void for_each_reached(const There& there, std::uint32_t root, bool wraps, const DoneNodes& done,
                          Visit visit) const;
    bool is_marked(std::uint32_t block) const { return (states_[block] & kMarked) != 0; }
    bool is_closed(std::uint32_t block) const { return (states_[block] & kClosed) != 0; }
    // Whether the block lies in the sample's disk, which then conflicts with every candidate there.
    bool covers(const There& there, std::uint32_t block) const;
    void push(const There& there, const Sized& sample, std::uint32_t block);

    const Plan& plan_;
    const FirstBoxes& first_;
    const ClassCopies& copies_;
    const RadiusField& radius_field_;
    const Vectors& vectors_;
    ZeroedArray<Few> few_;
    std::vector<std::unique_ptr<List>> long_;
    std::vector<std::uint8_t> states_;
    DoneNodes closed_;                                // with several classes
    DoneNodes all_marked_;                            // the same
    std::vector<std::vector<std::uint32_t>> marked_;  // the marked blocks of each zone
};

}  // namespace lacuna::cpu
