// The layout of a plan of mode cells on a device.
#include "backends/device/cells_layout.h"

#include <algorithm>

#include "portable/bits.h"
#include "portable/column.h"

namespace lacuna::device {

std::uint32_t words_per_line(const Plan& plan) {
    return 2 * ((plan.height + 63) / 64);
}

std::vector<std::uint32_t> first_bits(const Plan& plan, std::uint32_t first_line,
                                      std::uint32_t end_line) {
    const RadiusMap& radii = *plan.radii;
    const std::size_t words = words_per_line(plan);
    std::vector<std::uint32_t> bits(words * (end_line - first_line));
    for (std::uint32_t line = first_line; line < end_line; ++line) {
        std::uint32_t* const of_line = &bits[words * (line - first_line)];
        // Lines above one column of pixels are alike.
        if (line > first_line && radii.column_of[line] == radii.column_of[line - 1]) {
            std::copy(of_line - words, of_line, of_line);
            continue;
        }
        for (std::uint32_t row = 0; row < radii.rows; ++row) {
            const std::uint32_t begin = radii.row_begins[row];
            const std::uint32_t end = radii.row_begins[row + 1];
            if (begin == end ||
                radii.radii[std::size_t{radii.column_of[line]} * radii.rows + row] == 0)
                continue;
            for (std::uint32_t word = begin / 32; word <= (end - 1) / 32; ++word)
                of_line[word] |= portable::word_mask(word, begin, end);
        }
    }
    return bits;
}

std::uint64_t turns_of_line(const Plan& plan, std::uint32_t reach) {
    // A turn a run, and one a word of it; a few more for roots, and for what begins and ends runs.
    constexpr std::uint64_t kOthers = 16;
    const std::uint64_t points = std::min(2 * std::uint64_t{reach} + 1, std::uint64_t{plan.height});
    const std::uint64_t pixels = points * plan.radii->rows / plan.height + 2;
    return 2 * std::min(points, pixels) + points / 32 + kOthers;
}

std::uint64_t turns_of_sample(const Plan& plan, std::uint32_t reach) {
    const std::uint64_t lines = std::min(2 * std::uint64_t{reach} + 1, std::uint64_t{plan.lines});
    return lines * turns_of_line(plan, reach);
}

std::uint32_t slices_of_sample(const Plan& plan, std::uint64_t most) {
    const std::vector<std::uint32_t>& reaches = plan.radii->reaches;
    const std::uint32_t widest = *std::max_element(reaches.begin(), reaches.end());
    const std::uint64_t lines_of_slice =
        std::max<std::uint64_t>(most / turns_of_line(plan, widest), 1);
    const std::uint64_t lines = std::min(2 * std::uint64_t{widest} + 1, std::uint64_t{plan.lines});
    return static_cast<std::uint32_t>((lines + lines_of_slice - 1) / lines_of_slice);
}

}  // namespace lacuna::device
