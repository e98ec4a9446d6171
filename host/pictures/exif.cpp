// Finds Exif's orientation and applies it.
#include "pictures/exif.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"

namespace lacuna::pictures {
namespace {

constexpr int kUpright = 1;
constexpr std::string_view kMagic{"Exif\0\0", 6};

// Exif data is a TIFF file without a picture. Reading beyond its end gives 0.
class Tiff {
public:
    explicit Tiff(std::string_view bytes)
        : bytes_(bytes), order_(bytes.starts_with("MM") ? std::endian::big : std::endian::little) {}

    template <class Number>
    std::size_t at(std::size_t offset) const {
        if (offset > bytes_.size() || bytes_.size() - offset < sizeof(Number)) return 0;
        return files::load<Number>(bytes_.substr(offset), order_);
    }

private:
    std::string_view bytes_;
    std::endian order_;
};

// The position in the stored picture of the pixel that is seen at (x, y).
std::pair<std::size_t, std::size_t> stored_at(std::size_t x, std::size_t y, const Image& stored,
                                              int orientation) {
    const std::size_t right = stored.columns - 1;
    const std::size_t bottom = stored.rows - 1;
    switch (orientation) {
        case 2:
            return {right - x, y};
        case 3:
            return {right - x, bottom - y};
        case 4:
            return {x, bottom - y};
        case 5:
            return {y, x};
        case 6:
            return {y, bottom - x};
        case 7:
            return {right - y, bottom - x};
        case 8:
            return {right - y, x};
        default:
            return {x, y};
    }
}

}  // namespace

int orientation_of(std::string_view app1) {
    return app1.starts_with(kMagic) ? orientation_in(app1) : kUpright;
}

int orientation_in(std::string_view exif) {
    if (exif.starts_with(kMagic)) exif.remove_prefix(kMagic.size());  // some programs write it
    const Tiff tiff(exif);
    constexpr std::size_t kMagicNumber = 42;
    if (tiff.at<std::uint16_t>(2) != kMagicNumber) return kUpright;
    const std::size_t directory = tiff.at<std::uint32_t>(4);
    const std::size_t entries = tiff.at<std::uint16_t>(directory);
    constexpr std::size_t kEntrySize = 12;
    constexpr std::size_t kOrientation = 0x0112;
    for (std::size_t i = 0; i < entries; ++i) {
        const std::size_t entry = directory + 2 + i * kEntrySize;
        if (tiff.at<std::uint16_t>(entry) != kOrientation) continue;
        const std::size_t value = tiff.at<std::uint16_t>(entry + 8);
        return value >= 1 && value <= 8 ? static_cast<int>(value) : kUpright;
    }
    return kUpright;
}

Image upright(Image image, int orientation) {
    if (orientation == kUpright) return image;
    std::vector<double> seen(image.luminance.size());
    const bool is_turned = orientation >= 5;
    const std::size_t columns = is_turned ? image.rows : image.columns;
    const std::size_t rows = is_turned ? image.columns : image.rows;
    for (std::size_t y = 0; y < rows; ++y) {
        ask_after(columns);
        for (std::size_t x = 0; x < columns; ++x) {
            const auto [from_x, from_y] = stored_at(x, y, image, orientation);
            seen[y * columns + x] = image.luminance[from_y * image.columns + from_x];
        }
    }
    image.luminance = std::move(seen);
    if (is_turned) std::swap(image.columns, image.rows);
    return image;
}

}  // namespace lacuna::pictures
