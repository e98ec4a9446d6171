// Blocks, radii and the order of samples, for snapshots with a radius field.
#include "backends/field_snapshot.h"

#include <algorithm>

#include "plan/radius_field.h"

namespace lacuna {

std::uint32_t block_at(const FirstBoxes& first, std::uint32_t x, std::uint32_t y) {
    std::uint32_t node = 0;
    while (first.nodes[node].next != node + 1) {
        ++node;
        const auto lies_in = [&](const Box& box) {
            return x - box.x < box.width && y >= box.begin && y < box.end;
        };
        while (!lies_in(first.nodes[node].box)) node = first.nodes[node].next;
    }
    return first.nodes[node].first;
}

std::vector<Sized> with_radii(const Plan& plan, std::span<const Sample> samples) {
    std::vector<Sized> all;
    const FieldPlan& field = plan.field();
    for (const Sample sample : samples) {
        const auto kept = std::find_if(
            field.kept.begin(), field.kept.end(),
            [&](const Sized& other) { return other.x == sample.x && other.y == sample.y; });
        all.push_back({sample.x, sample.y,
                       kept != field.kept.end()
                           ? kept->radius
                           : field.radius_field->radius_at(sample.x, sample.y)});
    }
    return all;
}

void sort_for_snapshot(std::vector<Sample>& samples) {
    const auto rank = [](Sample sample) { return std::uint64_t{sample.x} << 32 | sample.y; };
    std::sort(samples.begin(), samples.end(),
              [&](Sample a, Sample b) { return rank(a) < rank(b); });
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
}

}  // namespace lacuna
