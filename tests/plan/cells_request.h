// A request in mode cells, to be changed by a test.
#pragma once

#include <lacuna/lacuna.h>

namespace lacuna::tests {

inline Request cells_request(const Field& field) {
    Request request;
    request.mode = Mode::cells;
    request.field = &field;
    request.scale = 0.1;
    return request;
}

}  // namespace lacuna::tests
