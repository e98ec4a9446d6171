// Requests for chunks of several classes.
#pragma once

#include <lacuna/lacuna.h>

#include <vector>

namespace lacuna::tests {

inline Request chunk_of_classes() {
    Request request;
    request.classes.names = {"trees", "bushes", "grass"};
    request.classes.distances = distances_by_sum(std::vector{0.06, 0.03, 0.012});
    request.place.backend = "cpu";
    return request;
}

}  // namespace lacuna::tests
