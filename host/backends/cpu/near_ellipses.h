// Cuts boxes by samples with ellipses. Keeps the ellipses of the samples near a block, and of eight
// of its boxes at a time, in whole numbers and in floats.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "backends/cpu/float_ellipse.h"
#include "backends/cpu/vectors.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "portable/conflict.h"

namespace lacuna::cpu {

class NearEllipses {
public:
    explicit NearEllipses(const Plan& plan) : plan_(plan) {}

    void set_samples(const SizedSpan& near) {
        near_ = near;
        of_samples_.clear();
        in_floats_.clear();
        for (std::size_t k = 0; k < near.count; ++k) {
            of_samples_.push_back(plan_.field().radius_field->ellipse_at(near.x[k], near.y[k]));
            in_floats_.push_back(in_floats(of_samples_.back()));
        }
    }
    // All boxes have this ellipse, or the i-th has it.
    void set_boxes(const portable::Ellipse& ellipse) {
        of_boxes_.fill(ellipse);
        boxes_in_floats_.fill(in_floats(ellipse));
    }
    void set_box(std::size_t i, const portable::Ellipse& ellipse) {
        of_boxes_[i] = ellipse;
        boxes_in_floats_[i] = in_floats(ellipse);
    }

    unsigned find_touching(const Vectors& vectors, const Box* boxes, std::uint8_t* touching) const {
        return vectors.find_touching_ellipses(near_, in_floats_.data(), boxes,
                                              boxes_in_floats_.data(), touching);
    }

    // Writes the chord that the k-th sample cuts from the i-th box after the first `count` chords,
    // and returns how many there are then; kAll if it covers the box. A chord that wraps around an
    // edge of a torus may be written as up to three.
    std::size_t add_chord(std::size_t k, const Box& box, std::size_t i, bool wraps, Span* chords,
                          std::size_t count) const {
        const portable::Interval chord = portable::ellipse_chord(
            near_.x[k], of_samples_[k], box.x, box.width, of_boxes_[i], wraps ? plan_.period_x : 0);
        if (chord.begin >= chord.end) return count;
        const std::int64_t y = near_.y[k];
        for (std::uint32_t window = 0; window < (wraps ? 3U : 1U); ++window) {
            const Span there{portable::height_in_window(window, y + chord.begin, plan_.height),
                             portable::height_in_window(window, y + chord.end, plan_.height)};
            if (there.begin <= box.begin && there.end >= box.end) return Vectors::kAll;
            if (there.begin < there.end) chords[count++] = there;
        }
        return count;
    }

private:
    const Plan& plan_;
    SizedSpan near_{};
    std::vector<portable::Ellipse> of_samples_;
    std::vector<FloatEllipse> in_floats_;
    std::array<portable::Ellipse, Vectors::kBoxes> of_boxes_{};
    std::array<FloatEllipse, Vectors::kBoxes> boxes_in_floats_{};
};

}  // namespace lacuna::cpu
