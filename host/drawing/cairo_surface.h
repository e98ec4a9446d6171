// Owners for cairo's surfaces and contexts; cairo's errors as exceptions, its output as a string.
#pragma once

#include <cairo.h>

#include <exception>
#include <memory>
#include <string>

#include "files/point_files.h"

namespace lacuna::drawing {

struct SurfaceDeleter {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextDeleter {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;
using Context = std::unique_ptr<cairo_t, ContextDeleter>;

inline void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw files::FileError(std::string("the picture cannot be drawn: ") +
                               cairo_status_to_string(status));
}

inline Surface checked(cairo_surface_t* created) {
    Surface surface(created);
    check(cairo_surface_status(surface.get()));
    return surface;
}

inline void set_colour(cairo_t* context, const Colour& colour) {
    constexpr double kMost = 255;
    cairo_set_source_rgb(context, colour[0] / kMost, colour[1] / kMost, colour[2] / kMost);
}

// Cairo calls this to write. Cairo is a C library, so no exception may pass through it.
inline cairo_status_t append_to_string(void* closure, const unsigned char* data,
                                       unsigned int length) noexcept {
    try {
        auto& bytes = *static_cast<std::string*>(closure);
        bytes.append(data, data + length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::exception&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

// The bytes of a PNG file: grey if the surface has only alpha (A8), where opaque is white, else in
// colour (RGB24). Defined in png.cpp.
std::string png_of(cairo_surface_t* image, double pixels_per_inch);

}  // namespace lacuna::drawing
