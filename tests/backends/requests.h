// The requests on which every backend must equal the reference: modes, boundaries, rectangles,
// m from 1 to 60, round sizes, threads, seeds.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace lacuna::tests {

inline std::string describe(const Request& request) {
    std::ostringstream out;
    out << name_of(request.mode) << ", " << request.domain.width << "x" << request.domain.height
        << (request.domain.wraps() ? " torus" : " box");
    if (request.mode == Mode::cells)
        out << ", scale " << *request.scale << ", metric " << name_of(request.metric) << ", limit "
            << request.limit.value_or(0);
    else
        out << ", radius " << *request.radius
            << (request.paper2011.snap ? ", snap" : ", interpolated")
            << (request.paper2011.uniform_x ? ", uniform-x" : ", cdf");
    out << ", m " << request.paper2011.lines_per_radius.value_or(0) << ", round size "
        << request.paper2011.round_size << ", seed " << request.seed << ", threads "
        << request.run_on.threads;
    return out.str();
}

// Requests by hand, each for one special case.
inline std::vector<Request> special_requests(Mode mode) {
    const auto request = [mode](double width, double height, double radius, std::uint32_t m,
                                Boundary boundary) {
        Request made;
        made.mode = mode;
        made.domain = {width, height, boundary};
        made.radius = radius;
        made.paper2011.lines_per_radius = m;
        return made;
    };
    return {
        request(1, 1, 1.2, 1, Boundary::box),       // one line, a radius larger than the square
        request(1, 1, 1.2, 60, Boundary::box),      // 50 lines in one column
        request(1, 1, 1, 3, Boundary::torus),       // a radius as large as the torus
        request(1, 1, 0.6, 7, Boundary::torus),     // a torus narrower than 2r
        request(1, 1, 0.45, 10, Boundary::torus),   // two columns that are each other's neighbours
        request(1, 1, 0.3, 10, Boundary::torus),    // three columns
        request(1000, 1, 0.9, 2, Boundary::torus),  // the largest aspect, both ways
        request(1, 1000, 0.9, 2, Boundary::torus),
        request(1000, 1, 1.3, 1, Boundary::box),
        request(1, 1000, 1.3, 1, Boundary::box),
        request(1e-9, 1e-9, 1e-10, 5, Boundary::torus),  // units of any size
        request(1e12, 2e12, 1e11, 5, Boundary::box),
        request(1, 1, 0.004, 8, Boundary::torus),  // rounds large enough for several threads
    };
}

// Rounds with more draws than samples fit: most draws conflict with others of their round.
inline std::vector<Request> crowded_requests() {
    std::vector<Request> requests;
    const auto add = [&](Mode mode, double width, double radius, std::uint64_t round_size,
                         Boundary boundary, std::optional<std::uint32_t> m = {}) {
        Request& request = requests.emplace_back();
        request.mode = mode;
        request.domain = {width, 1, boundary};
        request.radius = radius;
        request.paper2011.round_size = round_size;
        request.paper2011.lines_per_radius = m;
        request.seed = round_size;
    };
    for (const Mode mode : {Mode::exact, Mode::lines})
        for (const Boundary boundary : {Boundary::box, Boundary::torus})
            for (const double radius : {0.5, 0.12, 0.03}) add(mode, 1, radius, 20'000, boundary);
    for (const std::uint32_t m : {1u, 40u}) {
        add(Mode::exact, 1, 0.2, 5'000, Boundary::torus, m);
        add(Mode::lines, 30, 0.2, 5'000, Boundary::torus, m);
    }
    return requests;
}

inline std::vector<Request> equality_requests(Mode mode) {
    std::vector<Request> requests = special_requests(mode);
    std::mt19937_64 random(20111);
    const auto pick = [&](std::initializer_list<double> values) {
        return values.begin()[random() % values.size()];
    };
    while (requests.size() < 220) {
        Request request;
        request.mode = mode;
        request.domain.width = pick({1, 1, 0.5, 1.7, 3});
        request.domain.height = pick({1, 1, 0.4, 2.1});
        request.domain.boundary = random() % 2 == 0 ? Boundary::torus : Boundary::box;
        request.radius = pick({0.4, 0.2, 0.1, 0.05, 0.02, 0.013});
        request.paper2011.lines_per_radius = static_cast<std::uint32_t>(1 + random() % 60);
        request.paper2011.snap = random() % 2 == 0 && mode == Mode::lines;
        request.paper2011.uniform_x =
            random() % 5 == 0 && *request.radius > 0.015 && mode == Mode::lines;
        request.paper2011.round_size = static_cast<std::uint64_t>(pick({0, 0, 1, 2, 7}));
        if (request.paper2011.uniform_x) request.paper2011.round_size = 1;
        // Small rounds need many launches, so these sets have few points.
        if (request.paper2011.round_size != 0)
            request.radius =
                std::max(*request.radius, request.paper2011.round_size < 7 ? 0.1 : 0.05);
        request.run_on.threads = static_cast<std::uint32_t>(pick({1, 2, 5}));
        request.seed = random();
        if (requests.size() % 5 == 2) {  // some lie elsewhere
            request.domain.x0 = -10.0 / 3;
            request.domain.y0 = 54110;
        }
        requests.push_back(request);
    }
    return requests;
}

}  // namespace lacuna::tests
