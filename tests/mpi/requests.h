// The requests on which lacuna-mpi must equal lacuna: tori and boxes, narrow ones, few columns,
// limits and counts.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <vector>

namespace lacuna::tests {

inline std::vector<Request> requests_for_ranks() {
    struct Shape {
        double width, height, radius;
    };
    std::vector<Request> requests;
    // The second is a torus hardly higher than a radius; the third has 16 columns; the fourth and
    // the last are long.
    for (const auto& [width, height, radius] :
         {Shape{1, 1, 0.02}, Shape{3, 0.03, 0.027}, Shape{1, 1, 0.05}, Shape{1, 20, 0.05},
          Shape{2.5, 1.3, 0.03}, Shape{40, 1, 0.3}})
        for (const Boundary boundary : {Boundary::torus, Boundary::box})
            for (const std::uint64_t kind : {0u, 1u, 2u, 3u, 4u}) {
                Request request;
                request.domain.width = width;
                request.domain.height = height;
                request.domain.boundary = boundary;
                request.seed = 1000 * kind + requests.size();
                request.radius = radius;
                request.run_on.threads = 1;
                if (kind == 1) request.limit = 1 + requests.size() * 7;
                if (kind == 2) request.paper2011.lines_per_radius = 2;
                if (kind == 3) request.paper2011.round_size = 40;
                if (kind == 4) {
                    request.radius.reset();
                    request.count =
                        static_cast<std::uint64_t>(0.6 * width * height / (radius * radius)) + 1;
                }
                if (requests.size() % 3 == 1) {  // some lie elsewhere
                    request.domain.x0 = -1e4 / 3;
                    request.domain.y0 = 5411;
                }
                requests.push_back(request);
            }
    return requests;
}

}  // namespace lacuna::tests
