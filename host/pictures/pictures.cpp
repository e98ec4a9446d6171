// The public functions for pictures.
#include <lacuna/pictures.h>

#include "files/read_whole.h"
#include "pictures/image.h"
#include "pictures/importance.h"

namespace lacuna {

Picture read_picture(const std::string& path) {
    Picture picture;
    picture.name = files::name_of(path);
    const auto look = [&](std::string_view first) { pictures::check_format(first, picture.name); };
    picture.content = files::read_whole(path, files::most_bytes(), look);
    return picture;
}

Field importance_of(const Picture& picture, const Tone& tone) {
    pictures::check(tone);
    return pictures::importance_of(
        pictures::decode_image(picture.content, picture.name, pictures::kMaxPixels,
                               pictures::kMaxSide, {.backdrop = pictures::backdrop_of(tone)}),
        tone);
}

std::vector<Field> separate(const Picture& picture, std::span<const Ink> inks, const Tone& tone,
                            double black_ink, const Colour& paper) {
    pictures::check(tone);
    return pictures::separated(
        pictures::decode_colours(picture.content, picture.name, pictures::backdrop_of(tone)), inks,
        tone, black_ink, paper);
}

}  // namespace lacuna
