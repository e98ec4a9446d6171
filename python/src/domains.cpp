// Masks, and polygons that are drawn onto masks.
#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "options.h"
#include "outlines.h"
#include "parts.h"
#include "places/sets.h"
#include "watch.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

using Truths = nb::ndarray<std::uint8_t, nb::numpy, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

Mask make_mask(std::uint32_t rows, std::uint32_t columns) {
    return {columns, rows, std::vector<std::uint8_t>(std::size_t{columns} * rows)};
}

// The values of a mask as an array that numpy can fill or keep, without a copy.
Truths truths_of(Mask& mask) {
    return Truths(mask.allowed.data(), {mask.rows, mask.columns}, nb::find(mask));
}

// The attributes of Polygons.
nb::dict polygons_of(const nb::bytes& bytes, bool as_lines) {
    const std::string path(bytes.c_str(), bytes.size());
    Polygons polygons;
    {
        const Unlocked unlocked;
        polygons = as_lines ? read_lines(path) : read_polygons(path);
    }
    nb::list rings;
    for (PolygonRing& ring : polygons.rings) rings.append(array_of(std::move(ring)));
    nb::dict found;
    found["rings"] = nb::tuple(rings);
    found["domain"] = nb::none();
    if (polygons.page)
        found["domain"] = nb::make_tuple(polygons.page->width, polygons.page->height);
    return found;
}

nb::list joined_rings(const nb::list& given) {
    std::vector<PolygonRing> rings;
    for (const nb::handle ring : given) rings.push_back(points_of(nb::cast<PointArray>(ring)));
    {
        const Unlocked unlocked;
        rings = joined(std::move(rings));
    }
    nb::list all;
    for (PolygonRing& ring : rings) all.append(array_of(std::move(ring)));
    return all;
}

Mask mask_of(const nb::list& given, const nb::dict& options) {
    const Outlines outlines(given);
    const Domain domain = domain_in(options);
    double edge = 0;
    std::uint64_t memory_limit_bytes = 0;
    read(options, "edge", edge);
    read(options, "memory_limit", memory_limit_bytes);
    const Unlocked unlocked;
    const places::Sets sets({.outlines = outlines.copy()}, domain, {});
    return draw_mask(sets[0], domain, edge, memory_limit_bytes);
}

nb::tuple domain_of(const nb::list& given, const nb::dict& options, const Field* field) {
    const Outlines outlines(given);
    Places places;
    read_places(options, places);
    Domain domain;
    Point most{};  // a sum of corner and sides would be rounded
    {
        const Unlocked unlocked;
        places.outlines = outlines.copy();
        domain = domain_around(places, field);
        most = {domain.x0, domain.y0};
        for (const Outline& outline : places.outlines)
            for (const PolygonRing& ring : outline.polygons.rings)
                for (const Point& point : ring)
                    most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
    if (!domain.has_corner()) return nb::make_tuple(domain.width, domain.height);
    if (domain.width > most.x - domain.x0)  // larger than they need
        most = {domain.x0 + domain.width, domain.y0 + domain.height};
    return nb::make_tuple(domain.x0, domain.y0, most.x, most.y);
}

}  // namespace

void add_domains(nb::module_& module) {
    nb::class_<Mask>(module, "Mask")
        .def_ro("rows", &Mask::rows)
        .def_ro("columns", &Mask::columns)
        .def_prop_ro("values", truths_of);
    module.def("make_mask", make_mask);
    module.def("read_polygons", polygons_of);
    module.def("joined", joined_rings);
    module.def("domain_around", domain_of, nb::arg(), nb::arg(), nb::arg().none());
    module.def("draw_mask", mask_of);
}

}  // namespace lacuna::python
