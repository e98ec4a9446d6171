// Sets of polygons from python/lacuna: a list of (argument, rings, forbidden, distance), each ring
// an array.
#pragma once

#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"

namespace lacuna::python {

class PolygonSets {
public:
    // Needs the GIL.
    explicit PolygonSets(const nb::list& sets) {
        for (const nb::handle set : sets) {
            const auto parts = nb::cast<nb::tuple>(set);
            Given& given = given_.emplace_back();
            given.argument = nb::cast<std::string>(parts[0]);
            for (const nb::handle ring : nb::cast<nb::list>(parts[1]))
                given.arrays.push_back(nb::cast<PointArray>(ring));
            given.forbidden = nb::cast<bool>(parts[2]);
            given.distance = nb::cast<double>(parts[3]);
        }
    }

    bool are_none() const { return given_.empty(); }

    // Copies the rings, which needs no GIL. The result is valid until the next call.
    std::span<const PolygonSet> copy() {
        rings_.clear();
        sets_.clear();
        rings_.resize(given_.size());
        for (std::size_t i = 0; i < given_.size(); ++i) {
            for (const PointArray& array : given_[i].arrays) rings_[i].push_back(points_of(array));
            sets_.push_back({.rings = rings_[i],
                             .forbidden = given_[i].forbidden,
                             .distance = given_[i].distance,
                             .near = given_[i].argument == "near",
                             .option = given_[i].argument});
        }
        return sets_;
    }

private:
    struct Given {
        std::string argument;
        std::vector<PointArray> arrays;
        bool forbidden = false;
        double distance = 0;
    };
    std::vector<Given> given_;
    std::vector<std::vector<PolygonRing>> rings_;
    std::vector<PolygonSet> sets_;
};

// The sets of all classes, or those of each.
inline std::vector<PolygonSets> polygons_of_classes(const nb::list& lists) {
    std::vector<PolygonSets> all;
    for (const nb::handle one : lists) all.emplace_back(nb::cast<nb::list>(one));
    return all;
}

}  // namespace lacuna::python
