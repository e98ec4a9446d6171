// Where samples may lie, from files: masks that are pictures, polygons, lines, and meshes. Link
// lacuna::extras.
//
// What is promised
//   - A point is inside of rings if an odd number of them goes around it (the even-odd rule): a
//     ring within a ring is a hole. It does not matter which way a ring goes, where it begins, or
//     whether it crosses itself or others.
//   - Polygons of one file that overlap are joined, and a hole is one of its own polygon alone.
//   - Files are not trusted: a broken one is refused. The message is one line that names the file,
//     the line or element, what was found and what is allowed.
//
//     lacuna::Request request{.radius = 2};
//     request.places.outlines = {{.polygons = lacuna::read_polygons("lakes.svg")}};
//     request.domain = lacuna::domain_around(request.places);
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>
#include <lacuna/files.h>
#include <lacuna/places.h>
#include <lacuna/space.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

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

// Reads lines and points from which samples keep a distance: rings for Role::avoid and near.
//   .svg             the outlines of its shapes; an open path is a line
//   .geojson .json   points, lines, and the rings of polygons
//   .txt             rings, as read_polygons() reads them, and lines and points that are rings of
//                    two points or one
// An outline becomes a ring that goes around it and back: its inside is not avoided.
// Throws what read_polygons throws.
Polygons read_lines(const std::string& path);
// The same for bytes that have been read.
Polygons decode_lines(std::string_view bytes, std::string_view format, const std::string& name);

// Reads the triangles of a mesh with assimp, which is loaded for the first one (Debian:
// libassimp5): .ply, .obj, .stl, .off, .gltf or .glb. Polygons are cut into triangles, nodes of a
// scene are put where their transforms say, and points and lines are skipped. Coordinates are
// single precision, as assimp of Debian has them. Throws FileError, also where there is no triangle
// or no assimp, and BadRequest for another extension.
Mesh read_mesh(const std::string& path);
// The same for bytes that have been read. `name` stands for the file in messages, and its extension
// is the format. A .gltf must hold all its numbers.
Mesh decode_mesh(std::string_view bytes, const std::string& name);

}  // namespace lacuna
