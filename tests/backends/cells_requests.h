// The requests of mode cells on which every backend must equal the reference: fields, metrics, m
// from 3 to 40, boundaries, rectangles, round sizes, threads, seeds.
#pragma once

#include <lacuna/lacuna.h>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fields.h"

namespace lacuna::tests {

// A request and the field that it points to.
struct CellsRequest {
    std::string name;
    std::shared_ptr<const Field> field;
    Request request;
};

// Its scale is such that `count` samples are expected with metric min.
inline CellsRequest cells_request(std::string name, Field field, double count, std::uint32_t m,
                                  Metric metric, Boundary boundary, double width = 1,
                                  double height = 1) {
    CellsRequest made{std::move(name), std::make_shared<const Field>(std::move(field)), {}};
    made.request.mode = Mode::cells;
    made.request.field = made.field.get();
    made.request.domain.width = width;
    made.request.domain.height = height;
    made.request.scale = scale_of(*made.field, width * height, count);
    made.request.paper2011.lines_per_radius = m;
    made.request.metric = metric;
    made.request.domain.boundary = boundary;
    return made;
}

// Requests by hand, each for one special case.
inline std::vector<CellsRequest> special_cells_requests() {
    const Boundary box = Boundary::box;
    const Boundary torus = Boundary::torus;
    const Metric min = Metric::min;
    const Metric mean = Metric::mean;
    const Metric max = Metric::max;
    return {
        cells_request("one lattice point", constant_field(1, 1), 0.01, 3, min, box),
        cells_request("a radius as large as the torus", constant_field(4, 4), 0.7, 12, min, torus),
        cells_request("disks that wrap at both ends", ramp_field(7, 5), 2, 40, min, torus),
        cells_request("reaches longer than the torus", one_dark_pixel_field(5, 5), 30, 10, max,
                      torus),
        cells_request("reaches longer than the box", one_dark_pixel_field(5, 5), 30, 10, mean, box),
        cells_request("two columns of a torus", constant_field(3, 3), 3.6, 10, min, torus),
        cells_request("three columns of a torus", constant_field(3, 3), 8, 10, max, torus),
        cells_request("radii of all sizes, mean", sizes_field(40, 30, 6), 900, 5, mean, torus),
        cells_request("radii of all sizes, max", sizes_field(31, 47, 7), 900, 5, max, box),
        cells_request("rows of many words, all sizes", sizes_field(9, 3, 8), 500, 40, max, torus),
        cells_request("an image one pixel wide", noise_field(1, 64, 1), 60, 8, mean, torus),
        cells_request("an image one pixel high", noise_field(64, 1, 2), 60, 8, max, box),
        cells_request("more pixels than lattice points", noise_field(300, 200, 3), 20, 3, max,
                      torus),
        cells_request("a wide torus", ramp_field(50, 2), 500, 4, max, torus, 100, 1),
        cells_request("a high torus", ramp_field(2, 50), 500, 4, mean, torus, 1, 100),
        cells_request("a high box", noise_field(3, 90, 4), 400, 5, min, box, 1, 60),
        cells_request("one line", noise_field(1, 90, 5), 300, 3, mean, torus, 1, 1000),
        cells_request("one row", noise_field(90, 1, 5), 300, 3, min, torus, 1000, 1),
        cells_request("a field of one pixel", constant_field(1, 1, 7), 50, 40, min, box, 1, 0.3),
        cells_request("rounds that threads share", ramp_field(64, 48), 6000, 7, min, torus, 4, 3),
    };
}

inline std::vector<std::pair<std::string, Field>> cells_fields() {
    std::vector<std::pair<std::string, Field>> fields = {
        {"ramp", ramp_field(40, 30)},
        {"step 10:1", step_field(32, 32)},
        {"white holes", white_holes_field(40, 30)},
        {"one dark pixel", one_dark_pixel_field(9, 7)},
        {"1 x N", ramp_field(1, 50)},
        {"noise", noise_field(30, 40, 11)},
        {"fine noise", noise_field(170, 130, 12)},
        {"constant", constant_field(4, 3, 0.3)},
    };
#ifdef LACUNA_RACCOON
    fields.emplace_back("raccoon 32", raccoon_field(32));
    fields.emplace_back("raccoon 128", raccoon_field(128));
#endif
    return fields;
}

// Every field with every metric; the rest is random.
inline std::vector<CellsRequest> cells_requests() {
    std::vector<CellsRequest> requests = special_cells_requests();
    std::mt19937_64 random(20112);
    const auto pick = [&](std::initializer_list<double> values) {
        return values.begin()[random() % values.size()];
    };
    for (int round = 0; round < 3; ++round) {
        for (const auto& [name, field] : cells_fields()) {
            for (const Metric metric : {Metric::min, Metric::mean, Metric::max}) {
                // The reference is slow with fine lattices and wide reaches: keep those sets small.
                const auto m = static_cast<std::uint32_t>(3 + random() % 38);
                const double count = m > 20 ? pick({10, 30}) : pick({10, 40, 150});
                const Boundary boundary = random() % 2 == 0 ? Boundary::torus : Boundary::box;
                CellsRequest made = cells_request(name, field, count, m, metric, boundary,
                                                  pick({1, 1, 1.7, 0.5}), pick({1, 1, 0.4, 2.1}));
                made.request.paper2011.round_size = static_cast<std::uint64_t>(pick({0, 0, 1, 7}));
                made.request.run_on.threads = static_cast<std::uint32_t>(pick({1, 2, 5}));
                made.request.seed = random();
                if (random() % 6 == 0) made.request.limit = 1 + random() % 20;
                requests.push_back(std::move(made));
            }
        }
    }
    return requests;
}

// Dark and light halves side by side, from the bottom to the top, in rounds in which most draws
// conflict with others.
inline std::vector<CellsRequest> crowded_cells_requests() {
    std::vector<CellsRequest> requests;
    for (const Metric metric : {Metric::min, Metric::mean, Metric::max})
        for (const double importance : {1e-2, 1e-4, 1e-8})
            for (const Boundary boundary : {Boundary::box, Boundary::torus})
                for (const std::uint64_t round_size : {0U, 20'000U}) {
                    requests.push_back(cells_request(
                        "halves",
                        made_field(2, 8,
                                   [&](double x, double) { return x < 0.5 ? 1 : importance; }),
                        2'000, 4, metric, boundary, 1, 4));
                    requests.back().request.paper2011.round_size = round_size;
                }
    return requests;
}

// Tens of thousands of samples; radii differ by up to a factor of 7.
inline CellsRequest large_cells_request() {
    return cells_request(
        "a large ramp with holes",
        made_field(256, 192,
                   [](double x, double y) {
                       return std::hypot(x - 0.4, y - 0.5) < 0.1 ? 0 : 0.02 + 0.98 * x * x;
                   }),
        50'000, 10, Metric::min, Boundary::torus, 4, 3);
}

}  // namespace lacuna::tests
