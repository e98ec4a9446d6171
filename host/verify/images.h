// The images of a sample on a torus.
#pragma once

#include <cmath>

namespace lacuna::verify {

// The images of a sample on a torus that can be the nearest one to some spot of an interval.
struct Images {
    double first;
    double second;  // the same as `first` if there is only one

    Images(bool torus, double at, double middle, double half, double side) : first(at), second(at) {
        if (!torus) return;
        const double turns = (at - middle) / side;
        if (std::abs(turns) >= 0.5) first = turns > 0 ? at - side : at + side;
        const double offset = first - middle;
        second = first;
        if (std::abs(offset) > side / 2 - half) second = offset > 0 ? first - side : first + side;
    }
};

}  // namespace lacuna::verify
