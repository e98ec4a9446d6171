// Growing the three arrays of a SizedList together.
#include "backends/cpu/sized.h"

#include <algorithm>

#include "backends/cpu/vectors.h"

namespace lacuna::cpu {

void SizedList::make_room(std::size_t count) {
    if (count + kVectorPadding <= x_.size()) return;
    for (std::vector<std::uint32_t>* const words : {&x_, &y_, &radius_})
        words->resize(std::max(count + kVectorPadding, 2 * x_.size()));
}

void SizedList::push_back(const Sized& sample) {
    make_room(count_ + 1);
    x_[count_] = sample.x;
    y_[count_] = sample.y;
    radius_[count_++] = sample.radius;
}

void SizedList::append(const SizedSpan& samples) {
    make_room(count_ + samples.count);
    std::copy_n(samples.x, samples.count, &x_[count_]);
    std::copy_n(samples.y, samples.count, &y_[count_]);
    std::copy_n(samples.radius, samples.count, &radius_[count_]);
    count_ += samples.count;
}

void SizedList::see(const Sheets& sheets, std::uint32_t sheet, const SizedSpan& samples,
                    std::uint32_t radius) {
    make_room(samples.count);
    count_ = samples.count;
    const std::uint32_t begin = sheets.begin_of(sheet);
    for (std::size_t i = 0; i < samples.count; ++i) {
        x_[i] = sheets.x_on_sheet(samples.x[i]) + begin;
        y_[i] = samples.y[i];
        radius_[i] = portable::times_factor(std::min(samples.radius[i], radius),
                                            sheets.factor(sheet, sheets.of(samples.x[i])));
    }
}

}  // namespace lacuna::cpu
