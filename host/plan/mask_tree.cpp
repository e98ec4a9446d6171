// Builds the tree of a mask, and merges its values.
#include "plan/mask_tree.h"

#include <algorithm>
#include <bit>

namespace lacuna {

MaskTree::MaskTree(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {
    while ((std::uint64_t{4} << root_) < std::max(columns, rows)) root_ += 2;
}

MaskTree::MaskTree(const Mask& mask, const Poll& poll) : MaskTree(mask.columns, mask.rows) {
    const auto value_of = [&](std::uint32_t column, std::uint32_t row, std::uint32_t side) {
        if (side > 1) return ALLOWED_SOME;
        const std::size_t pixel = std::size_t{rows_ - 1 - row} * columns_ + column;
        return mask.allowed[pixel] != 0 ? ALLOWED_ALL : ALLOWED_NONE;
    };
    set_root(build(root_, 0, 0, value_of, poll));
}

namespace {

// The pixels of a tree before it was padded.
struct Unpadded {
    PixelRange pixels;
    bool are_any;
    bool are_all;  // no other pixels are among them
};
Unpadded unpadded(std::uint32_t begin, std::uint32_t end, std::uint32_t inner,
                  const MaskTree::Padding& padding) {
    const std::uint32_t low = padding.before, high = padding.before + inner * padding.split;
    const std::uint32_t first = std::max(begin, low), last = std::min(end, high);
    if (first >= last) return {{0, 0}, false, false};
    return {{(first - low) / padding.split, (last - 1 - low) / padding.split},
            true,
            begin >= low && end <= high};
}

std::uint32_t padded(std::uint32_t inner, const MaskTree::Padding& padding) {
    return padding.before + inner * padding.split + padding.behind;
}

}  // namespace

MaskTree::MaskTree(const MaskTree& inner, const Padding& across, const Padding& up,
                   const Poll& poll)
    : MaskTree(padded(inner.columns(), across), padded(inner.rows(), up)) {
    const auto value_of = [&](std::uint32_t column, std::uint32_t row, std::uint32_t side) {
        const auto [columns, has_columns, only_columns] =
            unpadded(column, std::min(column + side, columns_), inner.columns(), across);
        const auto [rows, has_rows, only_rows] =
            unpadded(row, std::min(row + side, rows_), inner.rows(), up);
        if (!has_columns || !has_rows) return ALLOWED_NONE;
        const std::uint32_t value = inner.over(columns, rows);
        return value == ALLOWED_ALL && !(only_columns && only_rows) ? ALLOWED_SOME : value;
    };
    set_root(build(root_, 0, 0, value_of, poll));
}

template <class ValueOf>
MaskTree::Piece MaskTree::build(unsigned shift, std::uint32_t column, std::uint32_t row,
                                const ValueOf& value_of, const Poll& poll) {
    constexpr std::size_t kNodesBetweenPolls = kBetweenPolls / kSlots;
    if (++joined_ % kNodesBetweenPolls == 0) poll();
    std::array<Piece, kSlots> slots;
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::uint32_t i = column + (x << shift);
            const std::uint32_t j = row + (y << shift);
            if (i >= columns_ || j >= rows_) continue;
            Piece& slot = slots[portable::slot_of(x, y, 0)];
            slot.value = value_of(i, j, 1U << shift);
            if (slot.value == ALLOWED_SOME) slot = build(shift - 2, i, j, value_of, poll);
        }
    return join(shift, column, row, slots);
}

// A slot beyond the mask gets a value that changes no merged value of its quadrant: that of another
// slot, or none if samples are allowed on some pixels of the quadrant in any case.
MaskTree::Piece MaskTree::join(unsigned shift, std::uint32_t column, std::uint32_t row,
                               std::array<Piece, kSlots>& slots) {
    std::uint32_t seen = 0;
    std::array<bool, kSlots> is_within{};
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::uint32_t slot = portable::slot_of(x, y, 0);
            is_within[slot] = column + (std::uint64_t{x} << shift) < columns_ &&
                              row + (std::uint64_t{y} << shift) < rows_;
            if (is_within[slot]) seen |= 1U << slots[slot].value;
        }
    if (seen == 1U << ALLOWED_NONE) return {ALLOWED_NONE, {}};
    if (seen == 1U << ALLOWED_ALL) return {ALLOWED_ALL, {}};
    Piece piece{ALLOWED_SOME, {0, static_cast<std::uint32_t>(nodes_.size())}};
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
        const std::size_t quadrant = slot & ~std::size_t{3};
        std::uint32_t value = slots[slot].value;
        if (!is_within[slot]) value = is_within[quadrant] ? slots[quadrant].value : ALLOWED_NONE;
        if (!is_within[slot] && value == ALLOWED_SOME) value = ALLOWED_NONE;
        piece.node.values |= value << 2 * slot;
        if (value == ALLOWED_SOME) nodes_.push_back(slots[slot].node);
    }
    return piece;
}

// A mask of which all or no pixels are allowed has a root of these.
void MaskTree::set_root(const Piece& root) {
    nodes_.front() = root.value == ALLOWED_SOME ? root.node : Node{root.value * 0x55555555U, 0};
}

std::uint8_t MaskTree::over(PixelRange columns, PixelRange rows) const {
    constexpr std::uint32_t kMost = 4;
    const std::uint32_t longer = std::max(columns.last - columns.first, rows.last - rows.first);
    // At a lower level the range would touch more than kMost squares in a row.
    unsigned level = static_cast<unsigned>(std::bit_width(longer / kMost));
    while ((columns.last >> level) - (columns.first >> level) >= kMost ||
           (rows.last >> level) - (rows.first >> level) >= kMost)
        ++level;
    Place at{0, root_};
    while (columns.first >> at.shift == columns.last >> at.shift &&
           rows.first >> at.shift == rows.last >> at.shift) {
        const std::uint32_t slot = portable::slot_of(columns.first, rows.first, at.shift);
        const std::uint32_t value = portable::value_of_slot(nodes_[at.node].values, slot);
        if (value != ALLOWED_SOME || at.shift <= level) return static_cast<std::uint8_t>(value);
        at = child(at, slot);
    }
    std::uint32_t seen = 0;  // a bit for each value
    add_values(at, level, columns, rows, seen);
    return seen == 1U << ALLOWED_NONE  ? ALLOWED_NONE
           : seen == 1U << ALLOWED_ALL ? ALLOWED_ALL
                                       : ALLOWED_SOME;
}

void MaskTree::add_values(Place at, unsigned level, PixelRange columns, PixelRange rows,
                          std::uint32_t& values) const {
    const Node node = nodes_[at.node];
    for (std::uint32_t j = rows.first >> at.shift; j <= rows.last >> at.shift; ++j)
        for (std::uint32_t i = columns.first >> at.shift; i <= columns.last >> at.shift; ++i) {
            const std::uint32_t slot = portable::slot_of(i, j, 0);
            const std::uint32_t value = portable::value_of_slot(node.values, slot);
            if (at.shift < level) {
                values |= 1U << portable::value_of_quadrant(node.values, slot);
            } else if (value != ALLOWED_SOME || at.shift == level) {
                values |= 1U << value;
            } else {
                const auto within = [&](PixelRange range, std::uint32_t place) {
                    const std::uint32_t first = place << at.shift;
                    return PixelRange{std::max(range.first, first),
                                      std::min(range.last, first + ((1U << at.shift) - 1))};
                };
                add_values(child(at, slot), level, within(columns, i), within(rows, j), values);
            }
            if ((values & (values - 1)) != 0) return;
        }
}

void MaskTree::for_each_allowed(const Visit& visit) const {
    visit_node({0, root_}, 0, 0, visit);
}

void MaskTree::visit_node(Place at, std::uint32_t column, std::uint32_t row,
                          const Visit& visit) const {
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            const std::uint32_t i = column + (x << at.shift);
            const std::uint32_t j = row + (y << at.shift);
            if (i >= columns_ || j >= rows_) continue;
            const std::uint32_t slot = portable::slot_of(x, y, 0);
            const std::uint32_t value = portable::value_of_slot(nodes_[at.node].values, slot);
            const std::uint32_t side = 1U << at.shift;
            if (value == ALLOWED_SOME)
                visit_node(child(at, slot), i, j, visit);
            else if (value == ALLOWED_ALL)
                visit(i, j, std::min(side, columns_ - i), std::min(side, rows_ - j));
        }
}

double MaskTree::allowed_share() const {
    double pixels = 0;
    for_each_allowed([&](std::uint32_t, std::uint32_t, std::uint32_t columns, std::uint32_t rows) {
        pixels += static_cast<double>(columns) * rows;
    });
    return pixels / columns_ / rows_;
}

}  // namespace lacuna
