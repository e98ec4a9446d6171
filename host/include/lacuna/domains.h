// Where samples may lie, from files: masks that are pictures, and polygons, which are drawn onto a
// mask. Link lacuna::extras.
//
// What is promised
//   - Polygons together enclose what an odd number of rings goes around (the even-odd rule), so
//   that
//     a ring within a ring is a hole. It does not matter which way a ring goes, where it begins,
//     and whether it crosses itself or others.
//   - The same rings give the same mask, byte for byte, on every machine.
//   - Files are not trusted: what is broken is refused in one line that names the file, the line or
//     the element, what is there and what is allowed.
//
//     const lacuna::Polygons lakes = lacuna::read_polygons("lakes.svg");
//     lacuna::Request request;
//     request.width = lakes.width;    // of the page; other files tell of none
//     request.height = lakes.height;
//     request.radius = 2;
//     const lacuna::Mask mask = lacuna::draw_mask(lakes.rings, lakes.width, lakes.height, 2.0 /
//     16); request.mask = &mask;
#pragma once

#include <lacuna/files.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

// A closed outline: its last point is joined to its first.
using PolygonRing = std::vector<Point>;

struct Polygons {
    std::vector<PolygonRing> rings;  // of at least three points each, y upwards
    // Of the page, [0, width) x [0, height), that the rings are seen on; 0 for files without one.
    double width = 0;
    double height = 0;
};

// The mask of the picture in the file, or on standard input for "-": samples are allowed on pixels
// of which any channel is not 0, but for those of no opacity (alpha 0). Every picture that
// read_field() takes, of which those in JPEG are rarely 0 where they look black; numbers of .npy
// are compared with 0. Throws FileError, also where no pixel is allowed.
Mask read_mask(const std::string& path);
// The same for bytes that have been read. `name` stands for the file in messages.
Mask decode_mask(std::string_view bytes, const std::string& name);

// The polygons of a file, by its extension:
//   .svg             the outlines of paths, polygons, polylines, rects, circles and ellipses,
//   filled
//                    or not, as transformed, also in groups and by `use`; not those in defs and the
//                    like or with display none. Coordinates are user units of the page, which is
//                    the viewBox, or width x height in px (96 an inch); its lower left corner is 0,
//                    0. Curves become lines that are within 2^-20 of the page's longer side from
//                    them.
//   .geojson .json   Polygon, MultiPolygon, Feature, FeatureCollection and GeometryCollection;
//                    coordinates as they are; other geometries are passed over
//   .txt             a point, `x y`, a line; a blank line, or one that begins with #, ends a ring
// Throws FileError, also where there is no ring, and BadRequest for another extension.
Polygons read_polygons(const std::string& path);
// The same for bytes that have been read, of the format "svg", "geojson" or "txt".
Polygons decode_polygons(std::string_view bytes, std::string_view format, const std::string& name);

// The rings of `polygons` for a domain of that size: where there is a page it is stretched over the
// domain, and otherwise they are as they were.
std::vector<PolygonRing> fitted(Polygons polygons, double width, double height);

// The mask of the places within `rings` for a domain [0, width) x [0, height): a pixel is allowed
// if its middle lies within them. No sample on an allowed pixel is farther than `edge` from the
// inside, and no place that is farther than `edge` inside is lost, for no place of a pixel is
// farther from its middle. Throws BadRequest for numbers that make no sense, for rings that leave
// no pixel allowed, and for a mask of more bytes than the limit (0: a quarter of the machine's
// memory).
Mask draw_mask(std::span<const PolygonRing> rings, double width, double height, double edge,
               std::uint64_t memory_limit_bytes = 0);

}  // namespace lacuna
