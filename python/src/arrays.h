// Points and numbers as numpy arrays.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace lacuna::python {

namespace nb = nanobind;

static_assert(sizeof(Point) == 2 * sizeof(double), "points are rows of two numbers");

// Points from python/lacuna, which converts all it is given to N x 2 in C order and native bytes.
using PointArray =
    nb::ndarray<const double, nb::numpy, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;

// A number for each point, from python/lacuna, too.
using RadiusArray =
    nb::ndarray<const double, nb::numpy, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

// Two radii and an angle for each point, from python/lacuna, too.
using EllipseArray =
    nb::ndarray<const double, nb::numpy, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

// The class of each point, from python/lacuna, too.
using ClassArray =
    nb::ndarray<const std::uint8_t, nb::numpy, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

inline std::vector<std::uint8_t> classes_of(const ClassArray& array) {
    return {array.data(), array.data() + array.shape(0)};
}

// Copies the points: other threads may change an array while it is read.
inline std::vector<Point> points_of(const PointArray& array) {
    std::vector<Point> points(array.shape(0));
    const double* from = array.data();
    for (Point& point : points) {
        point = {from[0], from[1]};
        from += 2;
    }
    return points;
}

// Makes a read-only array that takes over the numbers, without a copy. Structs of doubles, such as
// points, are its rows.
template <typename Number>
nb::object array_of(std::vector<Number>&& numbers) {
    auto kept = std::make_unique<std::vector<Number>>(std::move(numbers));
    Number* const data = kept->data();
    const std::size_t count = kept->size();
    const nb::capsule owner(kept.get(), [](void* pointer) noexcept {
        const std::unique_ptr<std::vector<Number>> last(static_cast<std::vector<Number>*>(pointer));
    });
    static_cast<void>(kept.release());
    if constexpr (!std::is_arithmetic_v<Number>) {
        const auto* const first = reinterpret_cast<const double*>(data);
        return nb::cast(nb::ndarray<nb::numpy, const double, nb::ndim<2>>(
            first, {count, sizeof(Number) / sizeof(double)}, owner));
    } else {
        return nb::cast(nb::ndarray<nb::numpy, const Number, nb::ndim<1>>(data, {count}, owner));
    }
}

}  // namespace lacuna::python
