// Turns a picture into the importance field that sample() follows, like the command stipple. Link
// lacuna::extras.
//
// What is promised
//   - The content decides the format, never the name: PNG, JPEG, TIFF, WebP, HEIC, AVIF, PGM,
//     PPM, PFM, Radiance HDR or NumPy's .npy (docs/images.md lists the variants that are read).
//   - Importance lies in [0, 1]. It is 1 where the picture is black, and 0 where it is white: no
//     sample ever lies there.
//   - Importance is the same to the last bit on every machine.
//   - Files are not trusted: broken, truncated and oversized ones are refused with a message of one
//     line, before memory is allocated for them.
//
//     const lacuna::Field field = lacuna::importance_of(lacuna::read_picture("photo.jpg"));
//     lacuna::Request request;
//     request.mode = lacuna::Mode::cells;
//     request.field = &field;
//     request.domain = lacuna::domain_like(field.columns, field.rows);
//     request.count = 20000;
#pragma once

#include <lacuna/export.h>
#include <lacuna/files.h>
#include <lacuna/inks.h>
#include <lacuna/sample.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

// A part of a picture, in pixels from its upper left corner.
struct Part {
    std::uint32_t left = 0;
    std::uint32_t top = 0;
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    friend bool operator==(const Part&, const Part&) = default;
};

// How luminance becomes importance.
struct Tone {
    // Levels: luminance up to `black` counts as black and from `white` on as white, and the range
    // between is stretched. 0 <= black < white <= 1.
    double black = 0;
    double white = 1;
    // Instead of both: clip half a percent of the pixels at each end, and paper, which is what over
    // half of the pixels show at the light end (at the dark end with invert).
    bool auto_levels = false;
    bool invert = false;  // bright is dense
    // What shows through where the picture is transparent: black, for light drawings, or white.
    bool on_black = false;
    // Areas average as numbers: a grey of number v, 0 to 1, has importance 1 - v, and paper, inks
    // and what they cover together mix by area in numbers of sRGB. So a drawing made smaller by any
    // viewer is the picture made smaller. With `light` areas average as light, for prints seen from
    // afar: the picture's numbers and inks are decoded as sRGB; numbers that are no whole ones, as
    // in HDR, are light already.
    bool light = false;
    double gamma = 1;           // importance is raised to this power, > 0
    double min_importance = 0;  // lower importance is raised to this, 0 to 1
    // Before levels: adds `sharpen_amount` times the difference between luminance and its blur, the
    // threefold mean over 2 sharpen + 1 pixels (unsharp mask). But pixels come at most half of
    // the way to black or, with invert, to white. At most 1000 pixels; 0: none.
    std::uint32_t sharpen = 0;
    double sharpen_amount = 1;  // over 0, at most 100
    // Over 1, at most 1000: the field has stretches along the picture's edges, for mode exact.
    // Where all edges nearby have one direction, an ellipse is this many times as long as wide, and
    // where there are none or all directions, it is a disk (structure tensor; docs/ellipses.md).
    // Angles are right for a domain of the picture's shape.
    double along = 1;
    // Before all else: the picture is turned right by this many degrees, 0, 90, 180 or 270, and
    // then cut to this part; Part{}: all of it.
    std::uint32_t turn = 0;
    Part crop{};
};

// A picture that is still encoded: the bytes of a file, and the name of the file in messages.
struct Picture {
    std::string content{};
    std::string name{};
};

// The picture in the file, or on standard input for "-". Throws FileError, also for a format that
// is not read.
Picture read_picture(const std::string& path);

// The importance of the picture. Throws FileError, also if importance is 0 on all pixels, and
// BadRequest for an invalid tone.
Field importance_of(const Picture& picture, const Tone& tone = {});

// The field on which samples have these ellipses at scale 1, for Request::field in mode exact: of
// rows * columns pixels, row 0 on top. Here either radius may be the longer one. Where both are 0
// no sample may lie. Throws BadRequest for other radii that are not over 0, for radii of which one
// is over 1000 times the other, for numbers that are not finite, and if all radii are 0.
Field ellipse_field(std::uint32_t columns, std::uint32_t rows, std::span<const Ellipse> ellipses);

// The inks that a text names: "cmyk", or up to 16 of #rrggbb, NAME=#rrggbb or one of the names
// black, grey, white, red, orange, yellow, green, cyan, blue, purple, magenta, pink and brown,
// separated by commas; each may have the width of its pen, as in red:0.5mm. Throws BadRequest.
std::vector<Ink> inks_of(const std::string& text);
// The colour of paper that a text names: one of these names or #rrggbb. Throws BadRequest.
Colour paper_of(const std::string& text);

// How much black ink replaces the other inks where these together would look grey, from 0 to 1.
inline constexpr double kBlackInk = 0.8;

// The importance of each ink, 0 to 1: the part of the paper that its dots are to cover. It is the
// least-squares solution, in numbers or with Tone::light in light, for dots that place_inks()
// places. Of a colour that the inks cannot make the lightness is kept first, then the hue, then the
// saturation. Gamma and min_importance change the inks' importance. An ink that is nowhere needed
// has a field of zeros. Inks that are opaque on the paper cover it and the inks before them. Throws
// what importance_of throws.
std::vector<Field> separate(const Picture& picture, std::span<const Ink> inks,
                            const Tone& tone = {}, double black_ink = kBlackInk,
                            const Colour& paper = kWhitePaper);

}  // namespace lacuna
