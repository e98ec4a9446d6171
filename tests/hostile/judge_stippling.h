// Judges dots: the same on every backend and through lacuna.h, as many as were asked for, where the
// picture is not white, as far apart as they say, in the picture if they are kept inside, and as
// long a path as it says.
#pragma once

#include <lacuna/stipple.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "hostile/counts.h"
#include "hostile/door_to_c.h"
#include "hostile/stippling.h"
#include "judge/judge.h"

namespace lacuna::tests {

// The dots, or why there are none.
struct Dots {
    Stippling made;
    std::string refusal;
};

inline Dots dots_of(const Drawing& drawing, const std::string& backend, std::uint32_t threads) {
    StippleOptions options = drawing.options;
    options.request.run_on.backend = backend;
    options.request.run_on.threads = threads;
    try {
        return {stipple(drawing.picture, options), ""};
    } catch (const BadRequest& error) {
        return {{}, error.what()};
    } catch (const FileError& error) {
        return {{}, error.what()};
    }
}

// The cpu's dots on one thread, after all other ones have been found to be the same. The reference
// compares each dot with the whole lattice of relax.
inline Dots dots_of_all(const Drawing& drawing, const std::vector<std::string>& names,
                        Counts& counts) {
    Dots expected = dots_of(drawing, "cpu", 1);
    const auto compare = [&](const std::string& name, std::uint32_t threads) {
        const Dots got = dots_of(drawing, name, threads);
        demand(got.refusal == expected.refusal &&
                   got.made.result.points == expected.made.result.points &&
                   got.made.diameters == expected.made.diameters,
               name + " with " + std::to_string(threads) +
                   " threads draws something else: " + got.refusal);
        ++counts.comparisons;
    };
    const std::uint32_t threads = drawing.options.request.run_on.threads;
    for (const std::string& name : names)
        if (name == "cpu" ? threads > 1
                          : name != "reference" || expected.made.result.points.size() <= 150)
            compare(name, threads);
    return expected;
}

inline void judge_in_c(const Drawing& drawing, const Stippling& made, Counts& counts) {
    if (drawing.words.empty()) return;
    const std::string options = drawing.words + " --backend cpu";
    const std::string& file = drawing.picture.content;
    const FromC got(lacuna_stipple(options.c_str(), file.data(), file.size()), options);
    const double* const sizes = lacuna_diameters(got.set.get());
    demand(got.points == made.result.points, "lacuna.h draws other dots by" + options);
    demand(
        made.diameters.empty() || std::equal(made.diameters.begin(), made.diameters.end(), sizes),
        "lacuna.h draws other sizes by" + options);
    ++counts.comparisons;
}

inline void judge_dots(const Drawing& drawing, const Stippling& made, Counts& counts) {
    const StippleOptions& options = drawing.options;
    const std::vector<Point>& dots = made.result.points;
    const Domain& domain = made.request.domain;
    ++counts.sets;
    counts.points += dots.size();
    std::size_t wanted = options.request.count.value_or(dots.size());
    if (!options.ink_counts.empty())
        wanted =
            std::accumulate(options.ink_counts.begin(), options.ink_counts.end(), std::size_t{0});
    if (!options.start_points.empty()) wanted = options.start_points.size();
    wanted = std::min<std::size_t>(wanted, options.request.limit.value_or(wanted));
    demand(dots.size() == wanted, "there are " + std::to_string(dots.size()) +
                                      " dots in place of " + std::to_string(wanted));
    Request places{.domain = domain};
    Field grey;
    // The middle of a stroke that is cut at the picture's edge may lie on white.
    if (options.inks.empty() && !options.keep_inside && !made.are_strokes) {
        grey = importance_of(drawing.picture, options.tone);
        grey.stretches.clear();
        places.field = &grey;
    }
    if (made.iterations > 0 && !domain.wraps()) {  // then dots may lie on the upper edges
        places.domain.width = std::nextafter(domain.width, 2 * domain.width);
        places.domain.height = std::nextafter(domain.height, 2 * domain.height);
    }
    const std::string fault = judge::Judge(places, dots, {}, 0).fault();
    demand(fault.empty(), fault);
    for (std::size_t i = 0; i < made.diameters.size(); ++i) {
        demand(made.diameters[i] > 0 && std::isfinite(made.diameters[i]), "a dot has no size");
        demand(!options.keep_inside || domain.wraps() ||
                   judge::to_edges(domain, dots[i]) >= made.diameters[i] / 2 * (1 - 1e-9),
               told(dots[i]) + " overhangs an edge");
    }
    const bool is_known = made.result.radius > 0 && options.tone.along == 1;
    const double least = judge::closest_pair(domain, dots).distance;
    const bool is_moved = made.iterations > 0;
    demand(!is_known || dots.size() < 2 ||
               (is_moved ? least == made.result.radius : least >= made.result.radius),
           "dots are " + std::to_string(least) + " apart");
    // A path is as long as its dots are apart, layer by layer, but with spirals and circles.
    if (!made.is_for_a_pen || made.are_strokes || made.pen_mm != 0) return;
    double length = 0;
    std::vector<Layer> layers = made.layers;
    if (layers.empty()) layers.push_back({{}, dots.size()});
    std::size_t first = 0;
    for (const Layer& layer : layers) {
        for (std::size_t i = first + 1; i < first + layer.dots; ++i)
            length += std::hypot(dots[i].x - dots[i - 1].x, dots[i].y - dots[i - 1].y);
        first += layer.dots;
    }
    demand(std::abs(length - made.path_length) <= 1e-9 * length + 1e-12,
           "the path is " + std::to_string(length) + " long");
    demand(made.path_length <= made.admitted_length * (1 + 1e-9), "the path is no shorter");
}

}  // namespace lacuna::tests
