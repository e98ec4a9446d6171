// The public functions for pictures.
#include <lacuna/pictures.h>

#include "pictures/image.h"
#include "pictures/importance.h"

namespace lacuna {

Field read_field(const std::string& path, const Tone& tone) {
    pictures::check(tone);
    return pictures::importance_of(pictures::read_image(path), tone);
}

Field decode_field(std::string_view bytes, const std::string& name, const Tone& tone) {
    pictures::check(tone);
    return pictures::importance_of(pictures::decode_image(bytes, name), tone);
}

std::vector<Field> read_inks(const std::string& path, std::span<const Ink> inks, const Tone& tone,
                             double black_ink) {
    pictures::check(tone);
    return pictures::separated(pictures::read_colours(path), inks, tone, black_ink);
}

std::vector<Field> decode_inks(std::string_view bytes, const std::string& name,
                               std::span<const Ink> inks, const Tone& tone, double black_ink) {
    pictures::check(tone);
    return pictures::separated(pictures::decode_colours(bytes, name), inks, tone, black_ink);
}

}  // namespace lacuna
