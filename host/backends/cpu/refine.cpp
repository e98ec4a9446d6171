// refine: cuts the bins by all samples near them into boxes (docs/design.md, section 4, "exact").
#include "backends/cpu/refine.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "backends/cpu/chords.h"
#include "backends/cpu/field_cut.h"
#include "backends/cpu/vectors.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/status.h"

namespace lacuna::cpu {
namespace {

class GridCut {
public:
    GridCut(const SampleGrid& grid, bool halve)
        : grid_(grid),
          plan_(grid.plan()),
          vectors_(vectors_for(plan_.radius)),
          halve_(halve),
          own_(plan_.own_x()) {}

    // Cuts a box, or its halves, and appends the pieces. A box in the halo stays as it is.
    void cut(Box box, std::vector<Box>& left) {
        if (box.x - own_.begin >= own_.end - own_.begin) return left.push_back(box);
        near_count_ = 0;
        width_ = box.width >> (halve_ ? 1 : 0);
        // Every cell is written, but only samples raise the count, so that there is no branch.
        grid_.for_each_cell_near(box.x, box.x + box.width, box.begin, box.end, [&](Sample cell) {
            near_[near_count_] = cell;
            near_count_ += cell.x != NO_SAMPLE;
        });
        for (std::uint32_t x = box.x; x < box.x + box.width; x += width_)
            cut_strip({x, width_, box.begin, box.end}, left);
    }

private:
    // The distance in x to the far edge of the strip around `centre`.
    std::uint32_t distance_to(Sample sample, std::uint32_t centre) const {
        return portable::axis_distance(sample.x, centre, plan_.period_x) + width_ / 2;
    }

    // Most strips are covered by one sample, and most samples near a strip do not touch it. Squared
    // distances show both, so that square roots are taken for the rest only.
    void cut_strip(const Box& box, std::vector<Box>& left) {
        const std::uint64_t radius_squared = plan_.radius_squared;
        const std::uint32_t centre = box.x + width_ / 2;
        std::size_t count = 0;
        bool is_covered = false;
        for (const Sample sample : std::span(near_).first(near_count_)) {
            const std::uint32_t dx = distance_to(sample, centre);
            const std::uint32_t y = sample.y;
            is_covered |= portable::squared_length(dx, portable::farthest_distance(
                                                           y, box.begin, box.end)) < radius_squared;
            touching_[count] = {dx, y};
            count += portable::squared_length(
                         dx, portable::nearest_distance(y, box.begin, box.end)) < radius_squared;
        }
        if (is_covered) return;
        sort_chords(box, count);
        for_each_piece({box.begin, box.end}, std::span(chords_).first(chord_count_),
                       [&](std::uint32_t begin, std::uint32_t end) {
                           left.push_back({box.x, width_, begin, end});
                       });
    }

    // Finds and sorts the chords of the first `count` samples in touching_.
    void sort_chords(const Box& strip, std::size_t count) {
        vectors_.find_chords(std::span(touching_).first(count), plan_.radius_squared, plan_.height,
                             found_.data());
        chord_count_ = 0;
        for (const Span chord : std::span(found_).first(count)) add_chord(chord);
        if (plan_.period_y != 0 &&
            (strip.begin < plan_.radius || strip.end + plan_.radius > plan_.height))
            add_wrapped_chords(strip.x + width_ / 2);
    }

    // A chord that sticks out at one end of a torus is cut at the other end.
    void add_wrapped_chords(std::uint32_t centre) {
        Span bottom{0, 0};
        Span top{plan_.height, plan_.height};
        for (const Sample sample : std::span(near_).first(near_count_)) {
            const std::uint32_t y = sample.y;
            const std::uint32_t reach =
                portable::chord_reach(distance_to(sample, centre), plan_.radius_squared);
            bottom.end = std::max(bottom.end, portable::window_end(2, y, reach, plan_.height));
            top.begin = std::min(top.begin, portable::window_begin(1, y, reach, plan_.height));
        }
        add_chord(bottom);
        add_chord(top);
    }

    void add_chord(Span chord) {
        chords_[chord_count_++] = chord;
        sort_in_last(chords_.data(), chord_count_);
    }

    // Room for the samples near a box. A box and a radius around it reach over at most 7 x 6 cells,
    // where cells at the edge of a torus may count twice.
    static constexpr std::size_t kMost = 64;

    const SampleGrid& grid_;
    const Plan& plan_;
    const Vectors& vectors_;
    bool halve_;
    std::uint32_t width_ = 0;  // of the boxes' halves
    Span own_;                 // the interval of x outside the halo
    std::array<Sample, kMost> near_;
    std::size_t near_count_ = 0;
    std::array<Seen, kMost + kVectorPadding> touching_;
    std::array<Span, kMost + kVectorPadding> found_;
    std::array<Span, kMost + 2> chords_;  // two more for a torus
    std::size_t chord_count_ = 0;
};

constexpr std::size_t kBoxesAhead = 4;  // prefetch distance; 4 to 8 are equally fast

// How many boxes ahead their lists are prefetched.
constexpr std::size_t kFieldBoxesAhead = 8;

}  // namespace

void refine(const SampleGrid& grid, std::span<const Box> boxes, bool halve,
            std::vector<Box>& left) {
    GridCut cut(grid, halve);
    for (std::size_t k = 0; k < boxes.size(); ++k) {
        const Box& later = boxes[std::min(k + kBoxesAhead, boxes.size() - 1)];
        grid.fetch_near(later.x, later.begin);
        cut.cut(boxes[k], left);
    }
}

void refine(NeighbourLists& lists, std::span<const BlockBox> boxes, bool halve,
            std::vector<BlockBox>& left) {
    SizedList scratch;
    FieldCut cut(lists, left);
    // Boxes that are not halved are cut only by samples that have not cut them yet.
    const auto which = halve ? NeighbourLists::Which::all : NeighbourLists::Which::latest;
    for (std::size_t i = 0, end; i < boxes.size(); i = end) {
        const std::uint32_t block = boxes[i].block;
        for (end = i + 1; end < boxes.size() && boxes[end].block == block;) ++end;
        const std::span<const BlockBox> of_block = boxes.subspan(i, end - i);
        const std::uint32_t later = boxes[std::min(i + kFieldBoxesAhead, boxes.size() - 1)].block;
        if (halve || lists.has_latest(later)) lists.fetch_list(later);
        if (!halve && !lists.has_latest(block)) {
            left.insert(left.end(), of_block.begin(), of_block.end());
            continue;
        }
        const std::size_t before = left.size();
        cut.begin(block);
        if (cut.can_append_all(halve) && !lists.is_long(block)) {
            cut.cut_by(lists.of_part(block, boxes[i].at, which, scratch));
            cut.append_all(of_block, halve);
        } else {
            for (const auto& [at, same] : of_block) {
                cut.cut_by(lists.of_part(block, at, which, scratch));
                halve ? cut.append_halves(at) : cut.append(at);
                cut.finish();
            }
        }
        lists.note_cuts(block);
        if (left.size() == before) lists.close(block);
    }
}

}  // namespace lacuna::cpu
