// Where samples may lie, from files: masks that are pictures, and polygons, which are drawn onto a
// mask. Link lacuna::extras.
//
// What is promised
//   - A point is inside of rings if an odd number of them goes around it (the even-odd rule): a
//     ring within a ring is a hole. It does not matter which way a ring goes, where it begins, or
//     whether it crosses itself or others.
//   - Polygons of one file that overlap are joined, and a hole is one of its own polygon alone.
//   - The same rings give the same mask, byte for byte, on every machine.
//   - Files are not trusted: a broken one is refused. The message is one line that names the file,
//     the line or element, what was found and what is allowed.
//
//     const lacuna::Polygons lakes = lacuna::read_polygons("lakes.svg");
//     lacuna::Request request;
//     request.domain = *lakes.page;  // an .svg has a page, other formats have none
//     request.radius = 2;
//     const lacuna::Mask mask = lacuna::draw_mask(lakes.rings, request.domain, 2.0 / 16);
//     request.mask = &mask;
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>
#include <lacuna/files.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

struct Polygons {
    std::vector<PolygonRing> rings{};  // of at least three points each, or lines; y upwards
    std::optional<Domain> page{};      // a box; only an .svg has one
};

// Reads a mask from a picture file, or from standard input for "-". Samples are allowed on pixels
// that have any colour channel above 0, unless alpha is 0. Reads the formats of read_picture(); a
// number of an .npy allows samples if it is not 0. Beware of JPEG: pixels that look black are
// rarely 0. Throws FileError.
Mask read_mask(const std::string& path);
// The same for bytes that have been read. `name` stands for the file in messages.
Mask decode_mask(std::string_view bytes, const std::string& name);

// The polygons of a file, by its extension:
//   .svg .svgz       the outlines of paths, polygons, polylines, rects, circles and ellipses,
//                    with their transforms, also in groups and by `use`. What is hidden (in defs,
//                    by display, visibility or opacity 0), or of another namespace, is skipped, and
//                    a line without fill is refused, as is what moves or cuts shapes in another
//                    way, such as clip-path. Attributes, `style` and simple rules of <style> count.
//                    Each shape is filled by its fill-rule, nonzero unless the file says evenodd.
//                    Coordinates are user units of the page, which is the viewBox, or width x
//                    height in px (96 an inch). The page's lower left corner is (0, 0). Curves
//                    become lines with an error of at most 2^-20 of the page's longer side. Of a
//                    path such as map.svg#lakes only the element with this id is read, or the only
//                    one with this Inkscape label.
//   .geojson .json   Polygon, MultiPolygon, Feature, FeatureCollection and GeometryCollection, or
//   .geojsonl        a sequence of these; coordinates are not converted; points are skipped, and
//                    lines refused. A polygon is its shell less the union of its holes, wherever
//                    these lie.
//   .txt             `x y` on each line; a blank line, or one that begins with #, ends a ring. The
//                    rings are joined().
// Polygons of .svg and .geojson become the rings of their union: none runs where two overlap or
// touch. Corners are rounded to 2^-51 of the largest coordinate.
// Throws FileError, also where there is no ring, and BadRequest for another extension.
Polygons read_polygons(const std::string& path);
// The same for bytes that have been read, of the format "svg", "geojson" or "txt".
Polygons decode_polygons(std::string_view bytes, std::string_view format, const std::string& name);

// Rings that overlap in part, or are the same, become those of their union. Others stay as they
// are: a ring in a ring is a hole, and a ring in the hole is an island. By the even-odd rule, as
// all functions below have it, the result encloses just that.
std::vector<PolygonRing> joined(std::vector<PolygonRing> rings);

// Reads lines and points from which samples keep a distance: rings for PolygonSet::distance.
//   .svg             the outlines of its shapes; an open path is a line
//   .geojson .json   points, lines, and the rings of polygons
//   .txt             rings, as read_polygons() reads them, and lines and points that are rings of
//                    two points or one
// An outline becomes a ring that goes around it and back: its inside is not avoided.
// Throws what read_polygons throws.
Polygons read_lines(const std::string& path);
// The same for bytes that have been read.
Polygons decode_lines(std::string_view bytes, std::string_view format, const std::string& name);

// The rings of `polygons` for this domain. A page is stretched over it, its lower left corner on
// the domain's; without a page the coordinates do not change.
std::vector<PolygonRing> fitted(Polygons polygons, const Domain& domain);

// The domain of sets that have no page: 1 x 1, or from (0, 0) to their farthest corner if they
// reach beyond it. If they lie far from (0, 0), or beyond it, the box around them where it lies, or
// a larger square if the box is so small that doubles are too coarse for it there.
// Throws BadRequest for a box without an area, and for coordinates and distances that are not
// finite.
Domain domain_around(std::span<const PolygonSet> sets);

// The mask of the inside of `rings` for this domain: a pixel is allowed if all of it is inside,
// with 2^-27 of the longer side to spare. No two points of a pixel are farther apart than `edge`.
// So no sample lies outside, and every spot is allowed that is farther than `edge` from the rings.
// Rings may leave no pixel allowed. Throws BadRequest for invalid numbers, and for a mask of more
// bytes than the limit (0: a quarter of the machine's memory).
Mask draw_mask(std::span<const PolygonRing> rings, const Domain& domain, double edge,
               std::uint64_t memory_limit_bytes = 0);
// The same for several sets of polygons: a pixel is allowed if samples may lie on all of it. With a
// distance, every spot is allowed that is farther than this and `edge` from the rings.
Mask draw_mask(std::span<const PolygonSet> sets, const Domain& domain, double edge,
               std::uint64_t memory_limit_bytes = 0);
// The same pixels as Mask::drawn. Time and memory are in proportion to the length of the outlines,
// whatever the extent of the domain.
Mask draw_places(std::span<const PolygonSet> sets, const Domain& domain, double edge,
                 std::uint64_t memory_limit_bytes = 0);

}  // namespace lacuna
