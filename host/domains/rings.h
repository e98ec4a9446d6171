// What the readers of polygons have in common: limits of coordinates, and the list of formats.
#pragma once

#include <lacuna/domains.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "places/fair.h"

namespace lacuna::domains {

using places::is_fair;
using places::kFair;
using places::kLargest;

// Most points of a drawing. Small files can ask for more by repetition: `use` in SVG does it.
inline constexpr std::size_t kMostPoints = 20'000'000;

// In a file the last point of a ring may repeat the first one; it is removed.
inline void open(PolygonRing& ring) {
    while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
}

// What a reader takes from a file: what lies within its outlines, or the outlines themselves as
// lines, also where they are open.
// `strokes` is a part of the latter: the lines that are drawn, with their widths.
enum class Take { insides, lines, strokes };

// The ring that goes along a line and back.
inline PolygonRing there_and_back(PolygonRing line) {
    for (std::size_t i = line.size(); i > 2; --i) line.push_back(line[i - 2]);
    return line;
}

// The ring that goes around an outline and back, so that nothing is inside of it.
inline PolygonRing around_and_back(PolygonRing ring) {
    if (ring.size() < 3) return ring;
    ring.push_back(ring.front());
    return there_and_back(std::move(ring));
}

// The parts of FILE.svg#LAYER. Other paths have no layer, nor has the path of a file that exists.
struct FileAndLayer {
    std::string file{};
    std::string layer{};  // an id, or Inkscape's label
};
FileAndLayer file_and_layer(const std::string& path);

Polygons decode_svg(std::string_view bytes, const std::string& name, Take take,
                    std::string_view layer = {});

// Lines of an .svg that are drawn equally wide. `distance` is half of their width.
struct Strokes {
    Polygons lines;
    double distance;
};
std::vector<Strokes> decode_strokes(std::string_view bytes, const std::string& name,
                                    std::string_view layer = {});
// Those of FILE.svg or FILE.svg#LAYER. Throws what read_lines() throws, and BadRequest for other
// files, which names the option.
std::vector<Strokes> read_strokes(const std::string& path, const std::string& option);

Polygons decode_geojson(std::string_view bytes, const std::string& name, Take take);
Polygons decode_rings(std::string_view bytes, const std::string& name, Take take);

}  // namespace lacuna::domains
