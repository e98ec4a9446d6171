// Scenes of mode exact with a radius field: what the cpu backend leaves after a few rounds.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "backends/available.h"
#include "backends/radius_field_requests.h"
#include "backends/scenes.h"

namespace lacuna::tests {

inline Scene field_scene(const FieldRequest& made, std::uint32_t rounds, std::uint64_t seed) {
    Scene scene{made.name, make_plan(made.request), {}, {}};
    Chance chance(seed);
    const auto backend = make_backend("cpu", scene.plan);
    backend->locate({});
    const auto draws = [&](std::uint32_t count) {
        return random_draws(scene.plan, backend->snapshot(), chance, count);
    };
    for (std::uint32_t round = 0; round < rounds; ++round) {
        backend->locate(draws(20 + chance.below(200)));
        backend->admit();
        backend->refine(chance.one_in(2));
        backend->finish_round();
    }
    backend->locate(draws(1 + chance.below(300)));
    scene.memory = backend->snapshot();
    scene.draws = draws(static_cast<std::uint32_t>(scene.memory.candidates.size()));
    return scene;
}

inline std::vector<Scene> field_scenes() {
    constexpr std::uint64_t kMostSamples = 1000;  // of a plan: the larger ones are for threads
    std::vector<Scene> scenes;
    std::vector<FieldRequest> all = special_radius_field_requests();
    for (const FieldRequest& made : class_requests()) all.push_back(made);
    for (const FieldRequest& made : ellipse_requests()) all.push_back(made);
    for (const FieldRequest& made : all) {
        const auto number = static_cast<std::uint32_t>(scenes.size());
        Scene scene = field_scene(made, number % 5, number);
        if (scene.plan.expected_samples <= kMostSamples) scenes.push_back(std::move(scene));
    }
    return scenes;
}

}  // namespace lacuna::tests
