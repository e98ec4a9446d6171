// Scenes for single verbs: a plan, and a backend's memory before the verb.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "backends/backend.h"
#include "backends/columns.h"
#include "plan/make_plan.h"
#include "plan/plan.h"
#include "portable/column.h"
#include "portable/status.h"

namespace lacuna::tests {

struct Scene {
    std::string name;
    Plan plan;
    Snapshot memory;          // for restore()
    std::vector<Draw> draws;  // for locate()
};

inline Plan plan_of(double radius, std::uint32_t m, Boundary boundary, double width = 1,
                    double height = 1, Mode mode = Mode::lines) {
    Request request;
    request.mode = mode;
    request.domain.width = width;
    request.domain.height = height;
    request.radius = radius;
    request.paper2011.lines_per_radius = m;
    request.domain.boundary = boundary;
    return make_plan(request);
}

// Mode cells: the words of a line in Snapshot::bits, and whether a lattice point has importance.
inline std::uint32_t words_of_line(const Plan& plan) {
    return 2 * ((plan.height + 63) / 64);
}
inline bool has_importance(const Plan& plan, std::uint32_t x, std::uint32_t y) {
    return plan.cells().radii->radii[plan.cells().radii->pixel_at(x, y)] != 0;
}

// Every line is free from end to end; no candidates, no samples. In cells every point with
// importance is free.
inline Snapshot empty_memory(const Plan& plan) {
    Snapshot memory;
    if (plan.is_cells()) {
        const std::uint32_t words = words_of_line(plan);
        memory.bits.resize(std::size_t{plan.lines} * words);
        for (std::uint32_t x = 0; x < plan.lines; ++x)
            for (std::uint32_t y = 0; y < plan.height; ++y)
                if (has_importance(plan, x, y))
                    memory.bits[std::size_t{x} * words + y / 32] |= 1u << y % 32;
        return memory;
    }
    memory.capacity = first_capacity(plan);
    memory.spans.assign(plan.lines, {Span{0, plan.height}});
    if (plan.is_exact())
        memory.grid.assign(std::size_t{plan.grid().columns} * plan.grid().rows,
                           {NO_SAMPLE, NO_SAMPLE});
    return memory;
}

// Puts candidates in the order that locate gives them, all with this status.
inline void set_candidates(const Plan& plan, std::vector<Candidate> candidates, Snapshot& memory,
                           std::uint32_t status = STATUS_UNDECIDED) {
    const std::uint32_t columns = count_columns(plan);
    const auto key = [&](const Candidate& c) {
        return std::tuple(portable::column_of_line(c.home, plan.lines, columns), c.y, c.order);
    };
    std::sort(candidates.begin(), candidates.end(),
              [&](const Candidate& a, const Candidate& b) { return key(a) < key(b); });
    memory.statuses.assign(candidates.size(), status);
    memory.candidates = std::move(candidates);
}

class Chance {
public:
    explicit Chance(std::uint64_t seed) : random_(seed) {}
    std::uint32_t below(std::uint64_t end) { return static_cast<std::uint32_t>(random_() % end); }
    bool one_in(std::uint32_t n) { return below(n) == 0; }
    std::vector<std::uint32_t> orders(std::uint32_t count) {
        std::vector<std::uint32_t> all(count);
        std::iota(all.begin(), all.end(), 0u);
        std::shuffle(all.begin(), all.end(), random_);
        return all;
    }

private:
    std::mt19937_64 random_;
};

// Sorted, disjoint spans: often none, often one unit long, sometimes touching or at an end.
inline std::vector<Span> hostile_spans(Chance& chance, std::uint32_t height, std::uint32_t most) {
    if (chance.one_in(4)) return {};
    std::vector<std::uint32_t> ends = {0, height};
    const std::uint32_t count = chance.below(most) + 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        ends.push_back(chance.below(height));
        if (chance.one_in(3)) ends.push_back(std::min(ends.back() + 1, height));
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::vector<Span> spans;
    for (std::size_t i = 0; i + 1 < ends.size() && spans.size() < most; ++i)
        if (!chance.one_in(2)) spans.push_back({ends[i], ends[i + 1]});
    return spans;
}

inline void set_hostile_spans(const Plan& plan, Chance& chance, Snapshot& memory) {
    for (std::vector<Span>& spans : memory.spans)
        spans = hostile_spans(chance, plan.height, memory.capacity);
}

inline std::uint32_t length_of(const std::vector<Span>& spans) {
    std::uint32_t length = 0;
    for (const Span span : spans) length += span.end - span.begin;
    return length;
}

inline bool has_boxes(const Plan& plan, const Snapshot& memory) {
    return plan.has_radius_field() || memory.box_width != 0;
}

inline std::uint32_t count_bins(const Plan& plan, const Snapshot& memory) {
    return has_boxes(plan, memory) ? static_cast<std::uint32_t>(memory.boxes.size()) : plan.lines;
}

inline std::uint32_t free_length_of(const Plan& plan, const Snapshot& memory, std::uint32_t bin) {
    if (plan.is_cells()) {
        const std::uint32_t words = words_of_line(plan);
        return std::accumulate(&memory.bits[std::size_t{bin} * words],
                               &memory.bits[std::size_t{bin} * words] + words, 0u,
                               [](std::uint32_t sum, std::uint32_t word) {
                                   return sum + static_cast<std::uint32_t>(std::popcount(word));
                               });
    }
    if (!has_boxes(plan, memory)) return length_of(memory.spans[bin]);
    return memory.boxes[bin].end - memory.boxes[bin].begin;
}

// Draws on bins that have room, sorted by bin and rank, with their orders at random; some at the
// very ends of a bin's free length.
inline std::vector<Draw> random_draws(const Plan& plan, const Snapshot& memory, Chance& chance,
                                      std::uint32_t count) {
    std::vector<Draw> draws;
    const std::vector<std::uint32_t> orders = chance.orders(count);
    for (std::uint32_t tries = 0; draws.size() < count && tries < 100 * count; ++tries) {
        if (count_bins(plan, memory) == 0) break;
        const std::uint32_t bin = chance.below(count_bins(plan, memory));
        const std::uint32_t free = free_length_of(plan, memory, bin);
        if (free == 0) continue;
        std::uint32_t rank = chance.below(free);
        if (chance.one_in(8)) rank = chance.one_in(2) ? 0 : free - 1;
        const std::uint32_t width =
            has_boxes(plan, memory) ? memory.boxes[bin].width : plan.strip_width;
        draws.push_back({bin, rank, chance.below(width), orders[draws.size()]});
    }
    // If no bin has room, there are fewer draws. Orders must not have gaps.
    if (draws.size() < count)
        for (std::uint32_t i = 0; i < draws.size(); ++i) draws[i].order = i;
    std::stable_sort(draws.begin(), draws.end(), [](const Draw& a, const Draw& b) {
        return a.bin != b.bin ? a.bin < b.bin : a.rank < b.rank;
    });
    return draws;
}

// Candidates anywhere, also in the corners of the domain. In cells: where there is importance.
inline std::vector<Candidate> random_candidates(const Plan& plan, Chance& chance,
                                                std::uint32_t count) {
    std::vector<Candidate> candidates;
    for (const std::uint32_t order : chance.orders(count)) {
        std::uint32_t x = 0;
        std::uint32_t y = 0;
        do {
            x = chance.below(plan.width);
            y = chance.below(plan.height);
            if (chance.one_in(16)) x = chance.one_in(2) ? 0 : plan.width - 1;
            if (chance.one_in(16)) y = chance.one_in(2) ? 0 : plan.height - 1;
        } while (plan.is_cells() && !has_importance(plan, x, y));
        candidates.push_back({x, y, x / plan.strip_width, order});
    }
    return candidates;
}

// Samples anywhere, at most one in a cell of the grid. They may be closer than the radius.
inline void set_random_samples(const Plan& plan, Chance& chance, Snapshot& memory) {
    for (std::uint32_t column = 0; column < plan.grid().columns; ++column) {
        for (std::uint32_t row = 0; row < plan.grid().rows; ++row) {
            if (!chance.one_in(4)) continue;
            const std::uint32_t x = column * plan.grid().side + chance.below(plan.grid().side);
            const std::uint32_t y = row * plan.grid().side + chance.below(plan.grid().side);
            memory.grid[std::size_t{column} * plan.grid().rows + row] = {
                std::min(x, plan.width - 1), std::min(y, plan.height - 1)};
        }
    }
}

// Boxes as wide as a strip, or narrower by a power of two; some are one unit high. They are sorted
// by line, and none crosses the border of a row of cells.
inline void set_hostile_boxes(const Plan& plan, Chance& chance, Snapshot& memory) {
    memory.box_width = std::max(1u, plan.strip_width >> chance.below(12));
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        for (const Span span : hostile_spans(chance, plan.height, 12)) {
            const std::uint32_t row_end =
                span.begin - span.begin % plan.grid().side + plan.grid().side;
            const std::uint32_t offset =
                chance.below(plan.strip_width / memory.box_width) * memory.box_width;
            memory.boxes.push_back({line * plan.strip_width + offset, memory.box_width, span.begin,
                                    std::min(span.end, row_end)});
        }
    }
    memory.spans.clear();
}

// A plan, hostile bins, random candidates and draws. In exact also random samples, and boxes for
// bins if the seed is odd.
inline Scene random_scene(std::string name, const Plan& plan, std::uint32_t count,
                          std::uint64_t seed) {
    Chance chance(seed);
    Scene scene{std::move(name), plan, empty_memory(plan), {}};
    if (plan.is_exact()) set_random_samples(plan, chance, scene.memory);
    if (plan.is_exact() && seed % 2 == 1)
        set_hostile_boxes(plan, chance, scene.memory);
    else
        set_hostile_spans(plan, chance, scene.memory);
    set_candidates(plan, random_candidates(plan, chance, count), scene.memory);
    scene.draws = random_draws(plan, scene.memory, chance, count);
    return scene;
}

// Each scene has one special case. All scenes go through each verb.
inline std::vector<Scene> random_scenes(Mode mode) {
    const Boundary box = Boundary::box;
    const Boundary torus = Boundary::torus;
    const auto plan = [mode](double radius, std::uint32_t m, Boundary boundary, double width = 1,
                             double height = 1) {
        return plan_of(radius, m, boundary, width, height, mode);
    };
    std::vector<Scene> scenes = {
        random_scene("one line", plan(1.2, 1, box), 40, 1),
        random_scene("a radius larger than the box", plan(1.3, 20, box), 70, 2),
        random_scene("chords that wrap at both ends", plan(1, 6, torus), 50, 3),
        random_scene("one column of a torus", plan(0.6, 9, torus), 90, 4),
        random_scene("two columns of a torus", plan(0.45, 9, torus), 90, 5),
        random_scene("three columns of a torus", plan(0.3, 9, torus), 90, 6),
        random_scene("two columns of a box", plan(0.45, 9, box), 90, 7),
        random_scene("three columns of a box", plan(0.3, 9, box), 90, 8),
        random_scene("a wide torus", plan(0.9, 2, torus, 1000, 1), 700, 9),
        random_scene("a high torus", plan(0.9, 2, torus, 1, 1000), 500, 10),
        random_scene("a high box", plan(0.9, 1, box, 1, 1000), 500, 11),
    };
    // Numbers of draws around the sizes of chunks and work groups.
    for (const std::uint32_t count : {1u, 2u, 63u, 64u, 65u, 127u, 129u, 255u, 257u, 1000u})
        scenes.push_back(random_scene("draws: " + std::to_string(count), plan(0.04, 5, torus),
                                      count, 100 + count));
    for (std::uint64_t seed = 0; seed < 24; ++seed)
        scenes.push_back(random_scene(
            "random box or torus, seed " + std::to_string(seed),
            plan(0.02 + 0.03 * static_cast<double>(seed % 7),
                 1 + static_cast<std::uint32_t>(seed) * 2, seed / 2 % 2 == 0 ? box : torus, 1, 0.7),
            300, 1000 + seed));
    return scenes;
}

}  // namespace lacuna::tests
