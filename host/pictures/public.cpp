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

}  // namespace lacuna
