// Decides candidates whose statuses depend on each other.
#include "ranks/rivals.h"

#include <algorithm>
#include <numeric>

#include "portable/distance.h"
#include "portable/status.h"

namespace lacuna {

void Rivals::clear() {
    all_.clear();
}

std::uint32_t Rivals::add(const Rival& rival) {
    all_.push_back(rival);
    return static_cast<std::uint32_t>(all_.size() - 1);
}

// Cells are squares as wide as the radius, numbered column by column.
std::uint64_t Rivals::cell_of(std::uint32_t column, std::uint32_t y) const {
    return std::uint64_t{column} << 32 | y / plan_.radius;
}

void Rivals::sort_into_cells() {
    cells_.clear();
    for (std::uint32_t i = 0; i < all_.size(); ++i)
        cells_.emplace_back(cell_of(all_[i].x / plan_.radius, all_[i].y), i);
    std::sort(cells_.begin(), cells_.end());
}

template <typename Visit>
void Rivals::for_each_near(std::uint32_t index, Visit visit) const {
    const Rival& at = all_[index];
    const auto visit_rows = [&](std::uint32_t column, std::uint32_t low, std::uint32_t high) {
        const std::uint64_t last = cell_of(column, high);
        for (auto it = std::lower_bound(cells_.begin(), cells_.end(),
                                        std::pair(cell_of(column, low), std::uint32_t{0}));
             it != cells_.end() && it->first <= last; ++it) {
            const Rival& other = all_[it->second];
            if (it->second != index && portable::are_closer(at.x, at.y, other.x, other.y, 0,
                                                            plan_.period_y, plan_.radius_squared))
                visit(it->second);
        }
    };
    const std::uint32_t r = plan_.radius;
    const std::uint32_t height = plan_.height;
    const std::uint32_t column = at.x / r;
    for (std::uint32_t i = column - std::min(column, 1u); i <= column + 1; ++i) {
        visit_rows(i, at.y - std::min(at.y, r), std::min(at.y + r, height - 1));
        if (plan_.period_y == 0) continue;
        // On a torus the disk continues at the other end of the column. If the torus is low, a
        // candidate may be visited twice.
        if (at.y < r) visit_rows(i, height - std::min(height, r - at.y), height - 1);
        if (height - at.y <= r) visit_rows(i, 0, std::min(r - (height - at.y), height - 1));
    }
}

bool Rivals::find(std::span<const std::uint32_t> wanted, Span unseen) {
    sort_into_cells();
    is_found_.assign(all_.size(), 0);
    found_.clear();
    earlier_.clear();
    const auto note = [&](std::uint32_t index) {
        if (!all_[index].is_own || is_found_[index] != 0) return;
        is_found_[index] = 1;
        found_.push_back({index, 0});
    };
    const std::uint32_t r = plan_.radius;
    for (const std::uint32_t index : wanted) note(index);
    for (std::size_t k = 0; k < found_.size(); ++k) {
        const std::uint32_t index = found_[k].index;
        const Rival rival = all_[index];
        if (unseen.begin < unseen.end && rival.x + r > unseen.begin && rival.x < unseen.end + r)
            return false;
        found_[k].first_rival = static_cast<std::uint32_t>(earlier_.size());
        for_each_near(index, [&](std::uint32_t other) {
            if (all_[other].number > rival.number) return;
            earlier_.push_back(other);
            note(other);
        });
    }
    by_number_.resize(found_.size());
    std::iota(by_number_.begin(), by_number_.end(), 0u);
    std::sort(by_number_.begin(), by_number_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return all_[found_[a].index].number < all_[found_[b].index].number;
    });
    return true;
}

std::span<const std::uint32_t> Rivals::earlier_of(std::size_t found) const {
    const std::size_t end =
        found + 1 < found_.size() ? found_[found + 1].first_rival : earlier_.size();
    return std::span(earlier_).subspan(found_[found].first_rival, end - found_[found].first_rival);
}

// A single pass in the order of draws is enough, because no candidate depends on a later one.
void Rivals::decide() {
    for (const std::uint32_t found : by_number_) {
        Rival& rival = all_[found_[found].index];
        if (rival.status != STATUS_UNDECIDED) continue;
        bool waits = false;
        bool is_rejected = false;
        for (const std::uint32_t earlier : earlier_of(found)) {
            waits |= all_[earlier].status == STATUS_UNDECIDED;
            is_rejected |= all_[earlier].status == STATUS_ADMITTED;
        }
        if (is_rejected)
            rival.status = STATUS_REJECTED;
        else if (!waits)
            rival.status = STATUS_ADMITTED;
    }
}

}  // namespace lacuna
