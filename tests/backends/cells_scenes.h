// Scenes of mode cells for single verbs: lattices with hostile bits.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "backends/scenes.h"
#include "fields.h"

namespace lacuna::tests {

// Its scale is such that the least radius is `least`.
inline Plan cells_plan(const Field& field, double least, std::uint32_t m, Metric metric,
                       Boundary boundary, double width = 1, double height = 1) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale =
        least * std::sqrt(*std::max_element(field.importance.begin(), field.importance.end()));
    request.paper2011.lines_per_radius = m;
    request.metric = metric;
    request.domain.boundary = boundary;
    request.domain.width = width;
    request.domain.height = height;
    return make_plan(request);
}

// Words with no bit set, all, one or some; only bits of points with importance.
inline void set_hostile_bits(const Plan& plan, Chance& chance, Snapshot& memory) {
    const auto random_word = [&] { return chance.below(std::uint64_t{1} << 32); };
    for (std::uint32_t line = 0; line < plan.lines; ++line) {
        const bool is_full = chance.one_in(4);
        const bool is_empty = chance.one_in(4);
        for (std::uint32_t i = 0; i < words_of_line(plan); ++i) {
            std::uint32_t& word = memory.bits[std::size_t{line} * words_of_line(plan) + i];
            if (is_full) continue;
            switch (is_empty ? 0 : chance.below(5)) {
                case 0:
                    word = 0;
                    break;
                case 1:
                    break;
                case 2:
                    word &= 1u << chance.below(32);
                    break;
                case 3:
                    word &= random_word();
                    break;
                default:
                    word &= ~(1u << chance.below(32));
            }
        }
    }
}

inline Scene random_cells_scene(std::string name, const Plan& plan, std::uint32_t count,
                                std::uint64_t seed) {
    Chance chance(seed);
    Scene scene{std::move(name) + ", cells", plan, empty_memory(plan), {}};
    set_hostile_bits(plan, chance, scene.memory);
    set_candidates(plan, random_candidates(plan, chance, count), scene.memory);
    scene.draws = random_draws(plan, scene.memory, chance, count);
    return scene;
}

// Each scene has one special case. All scenes go through each verb.
inline std::vector<Scene> random_cells_scenes() {
    const Boundary box = Boundary::box;
    const Boundary torus = Boundary::torus;
    const Metric min = Metric::min;
    const Metric mean = Metric::mean;
    const Metric max = Metric::max;
    const Field flat = constant_field(1, 1);
    const Field noise = noise_field(13, 9, 21);
    const Field fine = noise_field(150, 150, 22);
    const Field dark = one_dark_pixel_field(9, 9);
    const Field sizes = sizes_field(40, 30, 23);
    const Field holes = white_holes_field(30, 30);
    std::vector<Scene> scenes = {
        random_cells_scene("one lattice point", cells_plan(flat, 20, 3, min, box), 5, 1),
        random_cells_scene("a radius larger than the box", cells_plan(flat, 1.5, 40, min, box), 70,
                           2),
        random_cells_scene("disks that wrap at both ends", cells_plan(flat, 0.9, 40, max, torus),
                           50, 3),
        random_cells_scene("one column of a torus", cells_plan(noise, 0.6, 30, min, torus), 90, 4),
        random_cells_scene("two columns of a torus", cells_plan(noise, 0.4, 30, mean, torus), 90,
                           5),
        random_cells_scene("three columns of a torus", cells_plan(flat, 0.28, 20, min, torus), 90,
                           6),
        random_cells_scene("three columns of a box", cells_plan(noise, 0.28, 20, max, box), 90, 7),
        random_cells_scene("reaches longer than the torus", cells_plan(dark, 0.1, 10, max, torus),
                           200, 8),
        random_cells_scene("reaches longer than the box", cells_plan(dark, 0.1, 10, mean, box), 200,
                           9),
        random_cells_scene("some radii of twenty others", cells_plan(dark, 0.02, 4, mean, torus),
                           400, 10),
        random_cells_scene("radii of all sizes, mean", cells_plan(sizes, 0.02, 4, mean, torus), 400,
                           16),
        random_cells_scene("radii of all sizes, max", cells_plan(sizes, 0.02, 4, max, box), 400,
                           17),
        random_cells_scene("a wide torus", cells_plan(noise, 0.5, 3, max, torus, 300, 1), 500, 11),
        random_cells_scene("a high torus", cells_plan(noise, 0.5, 3, mean, torus, 1, 300), 500, 12),
        random_cells_scene("a high box", cells_plan(fine, 0.5, 3, min, box, 1, 300), 500, 13),
        random_cells_scene("more pixels than points", cells_plan(fine, 0.2, 8, max, torus), 90, 14),
        random_cells_scene("white holes", cells_plan(holes, 0.04, 5, min, torus), 500, 15),
    };
    // Heights around the words of a line, and lines of one word.
    for (const std::uint32_t height : {31u, 32u, 33u, 63u, 64u, 65u, 128u, 129u})
        scenes.push_back(random_cells_scene(
            "height " + std::to_string(height),
            cells_plan(noise, 10.0 / height, 10, mean, height % 2 == 0 ? torus : box), 100,
            100 + height));
    // Numbers of draws around the sizes of chunks and work groups.
    for (const std::uint32_t count : {1u, 2u, 63u, 64u, 65u, 127u, 129u, 255u, 257u, 1000u})
        scenes.push_back(random_cells_scene("draws: " + std::to_string(count),
                                            cells_plan(noise, 0.03, 4, min, torus), count,
                                            200 + count));
    for (std::uint64_t seed = 0; seed < 18; ++seed) {
        const std::vector<const Field*> fields = {&flat, &noise, &fine, &dark, &holes};
        scenes.push_back(random_cells_scene(
            "random box or torus, seed " + std::to_string(seed),
            cells_plan(*fields[seed % fields.size()], 0.03 + 0.02 * static_cast<double>(seed % 7),
                       3 + static_cast<std::uint32_t>(seed), static_cast<Metric>(seed % 3),
                       seed / 2 % 2 == 0 ? box : torus, 1, 0.7),
            200, 1000 + seed));
    }
    return scenes;
}

}  // namespace lacuna::tests
