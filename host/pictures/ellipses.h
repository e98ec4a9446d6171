// Fields of ellipses, from arrays of them.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <span>
#include <string>

namespace lacuna::pictures {

// Whether radii are over 0, one of them is at most 1000 times the other, and all is finite.
bool is_allowed(const Ellipse& ellipse);
inline constexpr const char* kAllowedEllipse =
    "radii and angle must be finite, radii over 0, one at most 1000 times the other";

// ellipse_field() of lacuna/pictures.h for ellipses that are allowed or 0.
Field field_of(std::uint32_t columns, std::uint32_t rows, std::span<const Ellipse> ellipses);

// Reads an array of rows x columns x 3 numbers (.npy, of type float32 or float64): two radii in the
// unit of the domain, and the angle of the first one. Two radii of 0 mean that no sample may lie
// there. Throws FileError.
Field read_ellipses(const std::string& path);

}  // namespace lacuna::pictures
