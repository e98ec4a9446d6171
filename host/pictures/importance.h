// Turns a picture into importance, section 4.2's field I: dark is dense.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/pictures.h>

#include <cstddef>
#include <span>
#include <vector>

#include "pictures/image.h"

namespace lacuna::pictures {

using Importance = lacuna::Tone;

// What is behind the picture.
inline Backdrop backdrop_of(const Importance& options) {
    return options.on_black ? Backdrop::black : Backdrop::white;
}

// Checks the options. Throws BadRequest if a value is not allowed.
void check(const Importance& options);

// Turns the picture and cuts it to a part, as the options say. Throws BadRequest if the part is not
// in it.
void cut(Image& image, const Importance& options);

// Sharpens the luminance, as the options say.
void sharpen(Image& image, const Importance& options);

// I = max(min_importance, d^gamma), where d = 1 - l, or l with invert. Here l is luminance / white
// of the picture, stretched between black and white of the options. So every value is in [0, 1],
// and white (black with invert) is 0, which means no sample there, unless min_importance is over 0.
// The result is the same to the last bit on every machine. Reuses the picture's memory. Throws
// BadRequest as check() does, or if gamma rounds all importance to 0, and FileError with the
// picture's name if no pixel has any importance.
Field importance_of(Image image, const Importance& options);

// The steps of importance_of().
struct Levels {
    double black;
    double white;
};
Levels levels_of(const Image& image, const Importance& options);
void to_darkness(Image& image, const Levels& levels, bool invert);  // d, in luminance's place
// Light, from 0 to 1, of a number of a picture, also from 0 to 1: IEC 61966-2-1, sRGB. The same to
// the last bit on every machine.
double light_of(double encoded);
bool is_zero_all_over(const std::vector<double>& values);
[[noreturn]] void refuse_blank(const std::string& name, bool invert);
void apply_gamma_and_least(std::vector<double>& values, const std::string& name,
                           const Importance& options);

// The stretches along the edges of a picture, up to `ratio`: Tone::along. Row 0 is the top.
std::vector<Stretch> stretches_along(std::span<const double> darkness, std::size_t columns,
                                     std::size_t rows, double ratio);

// The importance of each ink (lacuna/pictures.h). Throws as importance_of() does.
std::vector<Field> separated(Colours colours, std::span<const Ink> inks, const Importance& options,
                             double black_ink, const Colour& paper = kWhitePaper);

}  // namespace lacuna::pictures
