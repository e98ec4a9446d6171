// All capabilities of sample(), and of relax() on its points, and which two of them exclude each
// other. Rows of levels, one for each capability, in which each pair that is allowed occurs.
#pragma once

#include <algorithm>
#include <array>
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

enum Capability : std::size_t {
    kMode,
    kRadii,
    kClasses,
    kMask,
    kInside,
    kOutside,
    kAvoid,
    kBorder,
    kKeep,
    kEdges,
    kDomain,
    kSize,
    kOrder,
    kLimit,
    kSeeds,
    kThreads,
    kRounds,
    kLines,
    kMetric,
    kPlacing,
    kRelax,
    kGaussian,
    kCapabilities
};

// The first level of a capability is the plain one.
struct Levels {
    std::string_view capability;
    std::vector<std::string_view> names;
};

inline const std::array<Levels, kCapabilities> kLevels{{
    {"mode", {"exact", "lines", "cells", "stratified", "pixels"}},
    {"radii", {"one", "field", "ellipses"}},
    {"classes", {"none", "sum", "union", "given"}},
    {"mask", {"no", "yes"}},
    {"inside", {"no", "yes"}},
    {"outside", {"no", "yes"}},
    {"avoid", {"no", "yes"}},
    {"border", {"no", "yes"}},
    {"keep", {"no", "yes", "outside"}},
    {"edges", {"box", "torus"}},
    {"domain", {"near square", "long"}},
    {"size", {"given", "count", "of classes"}},
    {"order", {"random", "progressive"}},
    {"limit", {"no", "yes"}},
    {"seeds", {"one", "several"}},
    {"threads", {"one", "several"}},
    {"rounds", {"automatic", "of one", "small", "large"}},
    {"lines", {"default", "given"}},
    {"metric", {"min", "mean", "max"}},
    {"placing", {"plain", "snap", "uniform-x"}},
    {"relax", {"no", "evenly", "on a picture"}},
    {"gaussian", {"no", "yes"}},
}};

// Two levels that a request cannot have together. "!no" stands for all levels except "no".
// sample() refuses such a request, or relax() its points, and names one of `options`; without
// options a Request cannot express the two, or one has no effect.
struct Refused {
    Capability first;
    std::string_view level;
    Capability second;
    std::string_view other;
    std::vector<std::string_view> options;
};

inline const std::vector<Refused> kRefused{
    {kMode, "lines", kRadii, "!one", {"field"}},
    {kMode, "cells", kRadii, "one", {"field"}},
    {kMode, "cells", kRadii, "ellipses", {"stretches"}},
    {kMode, "stratified", kRadii, "ellipses", {"stretches"}},
    {kMode, "pixels", kRadii, "ellipses", {"stretches"}},
    {kMode, "!exact", kClasses, "!none", {"class"}},
    {kMode, "lines", kMask, "yes", {"mask"}},
    {kMode, "lines", kInside, "yes", {"mask"}},
    {kMode, "lines", kOutside, "yes", {"mask"}},
    {kMode, "lines", kAvoid, "yes", {"mask"}},
    {kMode, "cells", kMask, "yes", {"mask"}},
    {kMode, "cells", kInside, "yes", {"mask"}},
    {kMode, "cells", kOutside, "yes", {"mask"}},
    {kMode, "cells", kAvoid, "yes", {"mask"}},
    {kMode, "stratified", kMask, "yes", {"mask"}},
    {kMode, "stratified", kInside, "yes", {"mask"}},
    {kMode, "stratified", kOutside, "yes", {"mask"}},
    {kMode, "stratified", kAvoid, "yes", {"mask"}},
    {kMode, "!exact", kBorder, "yes", {"border"}},
    {kMode, "!exact", kKeep, "!no", {"keep"}},
    {kKeep, "outside", kRadii, "!one", {"keep"}},
    {kKeep, "outside", kEdges, "torus", {"keep"}},
    {kKeep, "outside", kOrder, "progressive", {"keep"}},
    {kMode, "!exact", kOrder, "progressive", {"progressive"}},
    {kMode, "stratified", kSize, "given", {"radius", "scale"}},
    {kMode, "stratified", kSize, "of classes", {"count"}},
    {kMode, "stratified", kLimit, "yes", {"limit"}},
    {kMode, "stratified", kLines, "given", {"lines-per-radius"}},
    {kMode, "stratified", kRounds, "!automatic", {"round-size"}},
    {kMode, "stratified", kMetric, "!min", {"metric"}},
    {kMode, "pixels", kSize, "given", {"radius", "scale"}},
    {kMode, "pixels", kSize, "of classes", {"count"}},
    {kMode, "pixels", kLimit, "yes", {"limit"}},
    {kMode, "pixels", kLines, "given", {"lines-per-radius"}},
    {kMode, "pixels", kRounds, "!automatic", {"round-size"}},
    {kMode, "pixels", kMetric, "!min", {"metric"}},
    {kMode, "exact", kMetric, "!min", {"metric"}},
    {kMode, "lines", kMetric, "!min", {}},
    {kRadii, "one", kMetric, "!min", {}},
    {kMode, "!lines", kPlacing, "!plain", {"snap", "uniform-x"}},
    {kPlacing, "uniform-x", kRounds, "small", {"round-size"}},
    {kPlacing, "uniform-x", kRounds, "large", {"round-size"}},
    {kClasses, "!none", kRadii, "ellipses", {"class"}},
    {kEdges, "torus", kBorder, "yes", {"border"}},
    {kMask, "yes", kInside, "yes", {}},  // the command refuses these; a Request has one mask
    {kMask, "yes", kOutside, "yes", {}},
    {kMask, "yes", kAvoid, "yes", {}},
    {kSize, "of classes", kClasses, "none", {"radius", "scale"}},
    {kRelax, "on a picture", kGaussian, "yes", {"gaussian"}},
};

using Row = std::array<std::uint8_t, kCapabilities>;

inline bool is_level(const Row& row, Capability capability, std::string_view name) {
    const std::vector<std::string_view>& names = kLevels[capability].names;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::logic_error("no level " + std::string(name));
    return row[capability] == found - names.begin();
}

inline std::string describe(const Row& row) {
    std::string text;
    for (std::size_t i = 0; i < kCapabilities; ++i)
        if (row[i] != 0)
            text.append(text.empty() ? "" : ", ")
                .append(kLevels[i].capability)
                .append(" ")
                .append(kLevels[i].names[row[i]]);
    return text.empty() ? "plain" : text;
}

// Pairs of levels, and rows that have them. A level has a number among all levels.
class Pairs {
public:
    Pairs() {
        for (std::size_t i = 0; i < kCapabilities; ++i) {
            first_[i] = count_;
            for (std::size_t k = 0; k < kLevels[i].names.size(); ++k) of_.push_back({i, k});
            count_ += kLevels[i].names.size();
        }
        state_.assign(count_ * count_, kFree);
        for (std::size_t k = 0; k < kRefused.size(); ++k) refuse(k);
        std::mt19937_64 random(1);
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (of_[a].first != of_[b].first && is_allowed(a, b) && !completed(a, b, random))
                    at(a, b) = at(b, a) = kRefusedByOthers;
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b)
                allowed_ += of_[a].first != of_[b].first && at(a, b) == kFree ? 1U : 0U;
    }

    std::size_t allowed() const { return allowed_; }
    std::size_t covered() const { return covered_; }

    void cover(const Row& row) {
        for (std::size_t i = 0; i < kCapabilities; ++i)
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
        if (missing.empty()) return *complete({}, random, {});
        const auto [a, b] = missing[random() % missing.size()];
        return *completed(a, b, random);
    }

    // For each line of kRefused that has options, rows that break this line alone.
    std::vector<std::pair<Row, const Refused*>> refused_rows(std::mt19937_64& random) const {
        std::vector<std::pair<Row, const Refused*>> rows;
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < a; ++b) {
                if (at(a, b) < kFirstRefused) continue;
                const std::size_t line = at(a, b) - kFirstRefused;
                if (kRefused[line].options.empty()) continue;
                Partial some;
                some[of_[a].first] = of_[a].second;
                some[of_[b].first] = of_[b].second;
                if (const auto row = complete(some, random, line))
                    rows.push_back({*row, &kRefused[line]});
            }
        return rows;
    }

private:
    static constexpr std::uint16_t kFree = 0, kCovered = 1, kRefusedByOthers = 2, kFirstRefused = 3;
    using Partial = std::array<std::optional<std::size_t>, kCapabilities>;

    std::uint16_t& at(std::size_t a, std::size_t b) { return state_[a * count_ + b]; }
    std::uint16_t at(std::size_t a, std::size_t b) const { return state_[a * count_ + b]; }
    bool is_allowed(std::size_t a, std::size_t b) const { return at(a, b) < kRefusedByOthers; }

    void refuse(std::size_t line) {
        const auto fits = [](std::string_view wanted, std::string_view name) {
            return wanted.starts_with('!') ? wanted.substr(1) != name : wanted == name;
        };
        const Refused& refused = kRefused[line];
        for (std::size_t a = 0; a < count_; ++a)
            for (std::size_t b = 0; b < count_; ++b)
                if (of_[a].first == refused.first && of_[b].first == refused.second &&
                    fits(refused.level, kLevels[of_[a].first].names[of_[a].second]) &&
                    fits(refused.other, kLevels[of_[b].first].names[of_[b].second]))
                    at(a, b) = at(b, a) = static_cast<std::uint16_t>(kFirstRefused + line);
    }

    std::optional<Row> completed(std::size_t a, std::size_t b, std::mt19937_64& random) const {
        Partial some;
        some[of_[a].first] = of_[a].second;
        some[of_[b].first] = of_[b].second;
        return complete(some, random, {});
    }

    // A row with the levels of `some`. It may break line `broken` of kRefused.
    std::optional<Row> complete(const Partial& some, std::mt19937_64& random,
                                std::optional<std::size_t> broken) const {
        std::vector<std::size_t> open(kCapabilities);
        std::iota(open.begin(), open.end(), std::size_t{0});
        std::shuffle(open.begin(), open.end(), random);
        std::stable_partition(open.begin(), open.end(), [&](auto i) { return some[i]; });
        Row row{};
        return fill(some, open, 0, random, broken, row) ? std::optional(row) : std::nullopt;
    }

    // Chooses the levels of order[done] and the capabilities after it, so that all fit together.
    bool fill(const Partial& some, std::span<const std::size_t> order, std::size_t done,
              std::mt19937_64& random, std::optional<std::size_t> broken, Row& row) const {
        if (done == order.size()) return true;
        const std::size_t i = order[done];
        std::vector<std::pair<std::size_t, std::size_t>> choices;  // rank, level
        for (std::size_t level = 0; level < kLevels[i].names.size(); ++level) {
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
            if (fits) choices.push_back({kCapabilities - fresh, level});
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

    std::size_t count_ = 0;  // of all levels
    std::array<std::size_t, kCapabilities> first_{};
    std::vector<std::pair<std::size_t, std::size_t>> of_;  // capability and level
    std::vector<std::uint16_t> state_;
    std::size_t allowed_ = 0;
    std::size_t covered_ = 0;
};

}  // namespace lacuna::tests
