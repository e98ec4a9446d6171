// Makes masks from pictures.
#include <lacuna/domains.h>

#include <cstddef>
#include <string>
#include <string_view>

#include "base/polling.h"
#include "files/parse.h"
#include "files/read_whole.h"
#include "pictures/image.h"

namespace lacuna {

Mask read_mask(const std::string& path) {
    const std::string name = files::name_of(path);
    const auto look = [&](std::string_view first) { pictures::check_format(first, name); };
    return decode_mask(files::read_whole(path, files::most_bytes(), look), name);
}

// Over a black backdrop a pixel's luminance is 0 exactly if all channels are 0 or the opacity is 0,
// because no channel is negative and each has a positive weight.
Mask decode_mask(std::string_view bytes, const std::string& name) {
    const pictures::Image image = pictures::decode_image(
        bytes, name, pictures::kMaxPixels, pictures::kMaxSide, {pictures::Backdrop::black});
    Mask mask;
    mask.columns = image.columns;
    mask.rows = image.rows;
    mask.allowed.resize(image.luminance.size());
    for_each_polled(image.luminance.size(), ask,
                    [&](std::size_t i) { mask.allowed[i] = image.luminance[i] == 0 ? 0 : 1; });
    return mask;
}

}  // namespace lacuna
