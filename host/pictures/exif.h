// The orientation of a photograph, which the camera stores in Exif.
#pragma once

#include <string_view>

#include "pictures/image.h"

namespace lacuna::pictures {

// The tag Orientation (0x0112; Exif 2.32, section 4.6.4, and TIFF 6.0, page 36) in the bytes of an
// APP1 marker: 1 to 8. It is 1, upright, if none can be read: broken metadata is no error.
int orientation_of(std::string_view app1);
// The same for the data of Exif alone, as PNG and WebP have it.
int orientation_in(std::string_view exif);

// The picture turned and mirrored so that its orientation is 1.
Image upright(Image image, int orientation);

}  // namespace lacuna::pictures
