// Rows of levels, one level for each capability, in which each pair of levels occurs that is
// allowed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lacuna::tests {

// The first level of a capability is the plain one.
struct Levels {
    std::string_view capability;
    std::vector<std::string_view> names;
};

// Two levels that a request cannot have together. "!no" stands for all levels except "no". The
// library refuses such a request, and names one of `options`; without options a request cannot
// express the two, or one has no effect.
struct Refused {
    std::size_t first;
    std::string_view level;
    std::size_t second;
    std::string_view other;
    std::vector<std::string_view> options;
};

// What requests may have.
struct Tables {
    std::vector<Levels> levels;
    std::vector<Refused> refused;
};

using Row = std::vector<std::uint8_t>;

inline std::string describe(const Tables& tables, const Row& row) {
    std::string text;
    for (std::size_t i = 0; i < row.size(); ++i)
        if (row[i] != 0)
            text.append(text.empty() ? "" : ", ")
                .append(tables.levels[i].capability)
                .append(" ")
                .append(tables.levels[i].names[row[i]]);
    return text.empty() ? "plain" : text;
}

inline bool is_level(const Tables& tables, const Row& row, std::size_t capability,
                     std::string_view name) {
    const std::vector<std::string_view>& names = tables.levels[capability].names;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::logic_error("no level " + std::string(name));
    return row[capability] == found - names.begin();
}

// Pairs of levels, and rows that have them. A level has a number among all levels.
class Pairs {
public:
    // If `only` names a capability, all rows have another level of it than the plain one.
    Pairs(const Tables& tables, std::string_view only) : tables_(tables) {
        for (std::size_t i = 0; i < size(); ++i) {
            first_.push_back(of_.size());
            if (levels(i).capability == only) only_ = i;
            for (std::size_t k = 0; k < levels(i).names.size(); ++k) of_.push_back({i, k});
        }
        if (!only.empty() && !only_) throw std::invalid_argument(unknown(only));
        count_ = of_.size();
        state_.assign(count_ * count_, kFree);
        for (std::size_t k = 0; k < tables.refused.size(); ++k) refuse(k);
        std::mt19937_64 random(1);
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (of_[a].first != of_[b].first && is_allowed(a, b) && !completed(a, b, random))
                    at(a, b) = at(b, a) = kRefusedByOthers;
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                if (of_[a].first == of_[b].first || at(a, b) != kFree) continue;
                if (only_ && !is_of_only(a) && !is_of_only(b))
                    at(a, b) = at(b, a) = kCovered;
                else
                    ++allowed_;
            }
    }

    std::size_t allowed() const { return allowed_; }
    std::size_t covered() const { return covered_; }

    void cover(const Row& row) {
        for (std::size_t i = 0; i < size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                std::uint16_t& state = at(first_[i] + row[i], first_[k] + row[k]);
                if (state != kFree) continue;
                state = at(first_[k] + row[k], first_[i] + row[i]) = kCovered;
                ++covered_;
            }
    }

    // A row with a pair that no row had before, and with as many more of them as it can get; if
    // all are covered, a row at random, with about half of its levels plain.
    Row next(std::mt19937_64& random) const {
        std::vector<std::pair<std::size_t, std::size_t>> missing;
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (of_[a].first != of_[b].first && at(a, b) == kFree) missing.push_back({a, b});
        if (missing.empty()) return *complete(with_only(random), random, {});
        const auto [a, b] = missing[random() % missing.size()];
        return *completed(a, b, random);
    }

    // For each line of the table that has options, rows that break this line alone.
    std::vector<std::pair<Row, const Refused*>> refused_rows(std::mt19937_64& random) const {
        std::vector<std::pair<Row, const Refused*>> rows;
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                if (at(a, b) < kFirstRefused) continue;
                const std::size_t line = at(a, b) - kFirstRefused;
                if (tables_.refused[line].options.empty()) continue;
                if (only_ && !is_of_only(a) && !is_of_only(b)) continue;
                Partial some(size());
                some[of_[a].first] = of_[a].second;
                some[of_[b].first] = of_[b].second;
                if (const auto row = complete(some, random, line))
                    rows.push_back({*row, &tables_.refused[line]});
            }
        return rows;
    }

private:
    static constexpr std::uint16_t kFree = 0, kCovered = 1, kRefusedByOthers = 2, kFirstRefused = 3;
    using Partial = std::vector<std::optional<std::size_t>>;

    std::size_t size() const { return tables_.levels.size(); }
    const Levels& levels(std::size_t i) const { return tables_.levels[i]; }
    bool is_of_only(std::size_t level) const {
        return of_[level].first == *only_ && of_[level].second != 0;
    }
    // Rows of all pairs that are left have a level of `only_`, as one of each pair has.
    Partial with_only(std::mt19937_64& random) const {
        Partial some(size());
        if (only_) some[*only_] = 1 + random() % (levels(*only_).names.size() - 1);
        return some;
    }
    std::string unknown(std::string_view only) const {
        std::string text = "--only " + std::string(only) + ": must be one of";
        for (const Levels& one : tables_.levels) text.append(" ").append(one.capability);
        return text;
    }

    std::uint16_t& at(std::size_t a, std::size_t b) { return state_[a * count_ + b]; }
    std::uint16_t at(std::size_t a, std::size_t b) const { return state_[a * count_ + b]; }
    bool is_allowed(std::size_t a, std::size_t b) const { return at(a, b) < kRefusedByOthers; }

    void refuse(std::size_t line) {
        const auto fits = [](std::string_view wanted, std::string_view name) {
            return wanted.starts_with('!') ? wanted.substr(1) != name : wanted == name;
        };
        const Refused& refused = tables_.refused[line];
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < count_; ++b)
                if (of_[a].first == refused.first && of_[b].first == refused.second &&
                    fits(refused.level, levels(of_[a].first).names[of_[a].second]) &&
                    fits(refused.other, levels(of_[b].first).names[of_[b].second]))
                    at(a, b) = at(b, a) = static_cast<std::uint16_t>(kFirstRefused + line);
    }

    std::optional<Row> completed(std::size_t a, std::size_t b, std::mt19937_64& random) const {
        Partial some(size());
        some[of_[a].first] = of_[a].second;
        some[of_[b].first] = of_[b].second;
        return complete(some, random, {});
    }

    // A row with the levels of `some`. It may break line `broken` of the table.
    std::optional<Row> complete(const Partial& some, std::mt19937_64& random,
                                std::optional<std::size_t> broken) const {
        std::vector<std::size_t> open(size());
        std::iota(open.begin(), open.end(), std::size_t{0});
        std::shuffle(open.begin(), open.end(), random);
        std::stable_partition(open.begin(), open.end(), [&](auto i) { return some[i]; });
        Row row(size());
        return fill(some, open, 0, random, broken, row) ? std::optional(row) : std::nullopt;
    }

    // Chooses the levels of order[done] and the capabilities after it, so that all fit together.
    bool fill(const Partial& some, std::span<const std::size_t> order, std::size_t done,
              std::mt19937_64& random, std::optional<std::size_t> broken, Row& row) const {
        if (done == order.size()) return true;
        const std::size_t i = order[done];
        std::vector<std::pair<std::size_t, std::size_t>> choices;  // rank, level
        for (std::size_t level = 0; level < levels(i).names.size(); ++level) {
            if (some[i] && *some[i] != level) continue;
            std::size_t fresh = 0;
            const bool fits =
                std::all_of(order.begin(), order.begin() + signed_of(done), [&](auto k) {
                    const std::uint16_t state = at(first_[i] + level, first_[k] + row[k]);
                    fresh += state == kFree ? 1U : 0U;
                    return state < kRefusedByOthers ||
                           (broken && state == kFirstRefused + *broken) ||
                           (broken && state == kRefusedByOthers);
                });
            if (fits) choices.push_back({size() - fresh, level});
        }
        std::shuffle(choices.begin(), choices.end(), random);
        if (covered_ == allowed_ && random() % 2 == 0)
            std::sort(choices.begin(), choices.end(),
                      [](auto a, auto b) { return a.second < b.second; });
        std::stable_sort(choices.begin(), choices.end(),
                         [](auto a, auto b) { return a.first < b.first; });
        return std::any_of(choices.begin(), choices.end(), [&](auto choice) {
            row[i] = static_cast<std::uint8_t>(choice.second);
            return fill(some, order, done + 1, random, broken, row);
        });
    }

    static std::ptrdiff_t signed_of(std::size_t n) { return static_cast<std::ptrdiff_t>(n); }

    const Tables& tables_;
    std::optional<std::size_t> only_;
    std::size_t count_ = 0;  // of all levels
    std::vector<std::size_t> first_;
    std::vector<std::pair<std::size_t, std::size_t>> of_;  // capability and level
    std::vector<std::uint16_t> state_;
    std::size_t allowed_ = 0;
    std::size_t covered_ = 0;
};

}  // namespace lacuna::tests
