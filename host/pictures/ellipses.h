// Fields of ellipses: read from arrays, or the same everywhere.
#pragma once

#include <lacuna/lacuna.h>

#include <string>

namespace lacuna::pictures {

// The field on which samples have an ellipse of these radii. Its scale is 1: with another one all
// radii are in proportion. Throws BadRequest for `option` unless both radii are finite and over 0,
// and the angle, in radians from the x axis counterclockwise, is finite.
struct Radii {
    double first;
    double second;
    double angle;  // of the first
};
void add_pixel(Field& field, const Radii& radii, const char* option, const std::string& value);

// Reads an array of rows x columns x 3 numbers (.npy, of type float32 or float64): two radii in the
// unit of the domain, and the angle of the first one. Two radii of 0 mean that no sample may lie
// there. Throws FileError.
Field read_ellipses(const std::string& path);

}  // namespace lacuna::pictures
