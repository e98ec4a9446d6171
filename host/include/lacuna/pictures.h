// From a picture to the importance that sample() follows, as the command stipple does. Link
// lacuna::extras.
//
// What is promised
//   - The format is told by the content, never by the name: PNG, JPEG, PGM, PPM, PFM, Radiance HDR
//     and NumPy's .npy (docs/images.md has what of each).
//   - Importance lies in [0, 1]. Dark is dense: 1 is where the picture is black, and 0, no sample
//     there ever, where it is white.
//   - With gamma 1 importance is the same to the last bit on every machine.
//   - Files are not trusted: broken, truncated and oversized ones are refused in one line, before
//     memory is taken for them.
//
//     const lacuna::Field field = lacuna::read_field("photo.jpg");
//     lacuna::Request request;
//     request.mode = lacuna::Mode::cells;
//     request.field = &field;
//     request.width = double(field.columns) / field.rows;  // the picture's shape
//     request.count = 20000;
#pragma once

#include <lacuna/files.h>
#include <lacuna/lacuna.h>

#include <string>
#include <string_view>

namespace lacuna {

// How luminance becomes importance.
struct Tone {
    // Luminance / white that becomes 0 and 1, 0 <= black < white <= 1; what is between is
    // stretched.
    double black = 0;
    double white = 1;
    bool auto_levels = false;   // instead: what half a percent of the pixels are darker, or lighter
    bool invert = false;        // bright is dense
    double gamma = 1;           // the power that importance is raised to, > 0
    double min_importance = 0;  // where importance would be less it is this, 0 to 1
};

// The importance of the picture in the file, or on standard input for "-".
// Throws FileError, also where no pixel has any importance, and BadRequest for a tone that makes no
// sense.
Field read_field(const std::string& path, const Tone& tone = {});

// The same for bytes that have been read. `name` stands for the file in messages.
Field decode_field(std::string_view bytes, const std::string& name, const Tone& tone = {});

}  // namespace lacuna
