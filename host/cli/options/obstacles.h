// Obstacles from which points keep a distance: --avoid of `lacuna sample` and `lacuna verify`.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>

#include <string>
#include <vector>

namespace lacuna::cli {

// What a file has at one distance.
struct Obstacles {
    Polygons lines;
    double distance;
};

// `text` is FILE or FILE:WIDTH. Points of a .csv have a column radius, or all have the width; the
// lines and outlines of another file need one. Throws BadRequest and FileError.
std::vector<Obstacles> read_obstacles(const std::string& text);

// FILE without the width.
std::string path_of_obstacles(const std::string& text);

}  // namespace lacuna::cli
