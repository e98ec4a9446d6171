// The samples of earlier rounds on the cpu, block by block.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "space/first_bins.h"

namespace lacuna::space {

class Samples {
public:
    Samples(const FirstBins& all, std::uint64_t radius_squared)
        : all_(&all), radius_squared_(radius_squared), spots_(all.kept), begins_(all.kept_begins) {}

    // The samples that may be closer than the radius to a spot of the block.
    void find_near(std::uint32_t block, std::vector<Position>& near) const {
        near.clear();
        const Solid cell = all_->is_volume() ? all_->cell(block) : Solid{};
        all_->for_each_near(block, [&](std::uint32_t other, const Position& shift) {
            for (std::uint32_t i = begins_[other]; i < begins_[other + 1]; ++i) {
                const Position sample = moved(spots_[i], shift);
                if (!all_->is_volume() || squared_distance_to(sample, cell) < radius_squared_)
                    near.push_back(sample);
            }
        });
    }

    // Adds samples, whose blocks ascend: find(i) returns the block of sample i, and position(i)
    // where it is.
    template <typename Find, typename At>
    void add(std::size_t count, const Find& find, const At& position) {
        if (count == 0) return;
        std::vector<Position> spots;
        spots.reserve(spots_.size() + count);
        std::size_t next = 0;
        std::uint32_t begin = 0;
        for (std::uint32_t block = 0; block < all_->blocks(); ++block) {
            const std::uint32_t end = begins_[block + 1];
            spots.insert(spots.end(), spots_.begin() + begin, spots_.begin() + end);
            for (; next < count && find(next) == block; ++next) spots.push_back(position(next));
            begin = end;
            begins_[block + 1] = static_cast<std::uint32_t>(spots.size());
        }
        spots_ = std::move(spots);
    }

private:
    static std::uint64_t squared_distance_to(const Position& sample, const Solid& box) {
        return squared_distance(
            sample, {std::clamp(sample.x, box.a.x, box.b.x), std::clamp(sample.y, box.a.y, box.b.y),
                     std::clamp(sample.z, box.a.z, box.b.z)});
    }

    const FirstBins* all_;
    std::uint64_t radius_squared_;
    std::vector<Position> spots_;
    std::vector<std::uint32_t> begins_;  // of each block; then the number of all
};

}  // namespace lacuna::space
