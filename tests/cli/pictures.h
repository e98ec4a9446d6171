// Pictures to be stippled.
#pragma once

#include <initializer_list>
#include <string>

#include "program.h"

namespace lacuna::tests {

inline const std::string kRaccoon = LACUNA_EXAMPLES "/raccoon.png";

inline std::string bytes(std::initializer_list<int> values) {
    std::string all;
    for (const int value : values) all += static_cast<char>(value);
    return all;
}

// A PGM file of this content, a byte a pixel.
inline std::string pgm(int columns, int rows, const std::string& pixels) {
    return "P5 " + std::to_string(columns) + " " + std::to_string(rows) + " 255\n" + pixels;
}

// The path of such a file in `folder`.
inline std::string grey_picture(const Folder& folder, int columns, int rows,
                                const std::string& pixels) {
    const std::string path = folder.path("picture.pgm");
    write_file(path, pgm(columns, rows, pixels));
    return path;
}

}  // namespace lacuna::tests
