// Places from python/lacuna: a list of (argument, rings, distance, class, page), each ring an
// array.
#pragma once

#include <lacuna/places.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "arrays.h"

namespace lacuna::python {

// Needs the GIL until it is made.
class Outlines {
public:
    explicit Outlines(const nb::list& given) {
        for (const nb::handle one : given) {
            const auto parts = nb::cast<nb::tuple>(one);
            Outline& outline = outlines_.emplace_back();
            // Arguments that are no role, such as `rings` of draw_mask, are insides.
            outline.role = role_called(nb::cast<std::string>(parts[0])).value_or(Role::inside);
            for (const nb::handle ring : nb::cast<nb::list>(parts[1]))
                arrays_.emplace_back(outlines_.size() - 1, nb::cast<PointArray>(ring));
            outline.distance = nb::cast<std::optional<double>>(parts[2]);
            outline.of_class = nb::cast<std::string>(parts[3]);
            if (const auto page = nb::cast<std::optional<std::pair<double, double>>>(parts[4]))
                outline.polygons.page = Domain{page->first, page->second};
        }
    }

    // Copies the rings.
    std::vector<Outline> copy() const {
        std::vector<Outline> outlines = outlines_;
        for (const auto& [i, array] : arrays_)
            outlines[i].polygons.rings.push_back(points_of(array));
        return outlines;
    }

private:
    std::vector<Outline> outlines_;
    std::vector<std::pair<std::size_t, PointArray>> arrays_;
};

}  // namespace lacuna::python
