// The answers of all backends and numbers of threads to a request, which must be the same.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/many.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hostile/counts.h"
#include "hostile/made.h"

namespace lacuna::tests {

// The available backends, the reference first.
inline std::vector<std::string> backends() {
    std::vector<std::string> names = {"reference", "cpu"};
    for (const Device& device : devices())
        if (device.unusable.empty() && (device.backend == "opencl" || device.backend == "vulkan") &&
            names.back() != device.backend)
            names.push_back(device.backend);
    return names;
}

// A set for each seed, and points of the first one that were moved; or the reason why there are
// none, which must be the same on each backend.
struct Answer {
    std::vector<Result> sets;
    std::vector<Point> moved;
    TileRing frame;
    std::string refusal;
};

// The reference compares each point with the whole lattice of relax.
constexpr std::size_t kMostToMove = 200;

inline std::vector<Point> moved_some(const Made& made, const Request& request,
                                     std::span<const Point> points) {
    RelaxOptions options = made.moves;
    options.domain = request.domain;
    options.run_on = request.run_on;
    return relax(points.first(std::min(points.size(), kMostToMove)),
                 made.sparse.importance.empty() ? nullptr : &made.sparse, options)
        .points;
}

// sample() makes the sets of the reference, and sample_many() the others where there are several.
inline Answer answer_of(const Made& made, const std::string& backend, std::uint32_t threads) {
    Request request = made.request;
    request.run_on.backend = backend;
    request.run_on.threads = threads;
    Answer answer;
    try {
        if (made.frame > 0) {
            answer.frame = tile_ring(request, made.frame);
            request.keep = answer.frame.points;
            request.keep_classes = answer.frame.classes;
        }
        if (made.seeds.size() > 1 && backend != "reference") {
            sample_many(request, made.seeds,
                        [&](auto, Result set) { answer.sets.push_back(std::move(set)); });
        } else {
            for (const std::uint64_t seed : made.seeds) {
                request.seed = seed;
                answer.sets.push_back(sample(request));
            }
        }
        if (made.is_moved()) answer.moved = moved_some(made, request, answer.sets.front().points);
        return answer;
    } catch (const BadRequest& error) {
        return {{}, {}, {}, error.what()};
    }
}

inline bool are_same(const Result& a, const Result& b) {
    const auto same_level = [](const Level& one, const Level& other) {
        return one.size == other.size && one.points == other.points;
    };
    return a.points == b.points && a.classes == b.classes && a.rounds == b.rounds &&
           a.draws == b.draws && a.maximal == b.maximal && a.radius == b.radius &&
           a.scale == b.scale && a.lines_per_radius == b.lines_per_radius &&
           std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(),
                      same_level);
}

inline std::string told(const Answer& answer) {
    if (!answer.refusal.empty()) return answer.refusal;
    std::string text;
    for (const Result& set : answer.sets)
        text += std::to_string(set.points.size()) + " points, " + std::to_string(set.rounds) +
                " rounds, " + std::to_string(set.draws) + " draws; ";
    for (const Point point : answer.moved) text += told(point) + " ";
    return text;
}

// The reference's answer, after all others have been found to be the same.
inline Answer answer_of_all(const Made& made, const std::vector<std::string>& names,
                            Counts& counts) {
    const Answer expected = answer_of(made, names.front(), 1);
    const auto compare = [&](const std::string& name, std::uint32_t threads) {
        const Answer got = answer_of(made, name, threads);
        const bool is_same = expected.refusal == got.refusal &&
                             std::equal(expected.sets.begin(), expected.sets.end(),
                                        got.sets.begin(), got.sets.end(), are_same) &&
                             expected.moved == got.moved &&
                             expected.frame.points == got.frame.points &&
                             expected.frame.classes == got.frame.classes;
        demand(is_same, name + " with " + std::to_string(threads) + " threads answers: " +
                            told(got) + "\n  " + names.front() + " answers: " + told(expected));
        ++counts.comparisons;
    };
    for (std::size_t i = 1; i < names.size(); ++i) compare(names[i], made.request.run_on.threads);
    if (made.request.run_on.threads > 1) compare("cpu", 1);
    return expected;
}

}  // namespace lacuna::tests
