// Reads WebP with libwebp.
#include <fmt/core.h>
#include <webp/decode.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/exif.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// The chunk EXIF of the RIFF file, which holds what follows "Exif\0\0" in a JPEG; empty without
// one.
std::string_view exif_of(std::string_view bytes) {
    constexpr std::size_t kHead = 12, kChunkHead = 8;
    std::string_view rest = bytes.substr(std::min(kHead, bytes.size()));
    while (rest.size() > kChunkHead) {
        const std::size_t size = files::load<std::uint32_t>(rest.substr(4), std::endian::little);
        const std::string_view content = rest.substr(kChunkHead, size);
        if (rest.starts_with("EXIF")) return content;
        rest.remove_prefix(std::min(rest.size(), kChunkHead + size + size % 2));
    }
    return {};
}

}  // namespace

Image decode_webp(const Encoded& file) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(file.bytes.data());
    WebPBitstreamFeatures features{};
    if (WebPGetFeatures(bytes, file.bytes.size(), &features) != VP8_STATUS_OK)
        file.refuse("not a whole WebP: libwebp cannot read its header");
    const Size size{static_cast<std::uint64_t>(features.width),
                    static_cast<std::uint64_t>(features.height)};
    check_size(file, size);
    if (features.has_animation != 0) file.refuse("an animated WebP: must be one picture");
    ask_after(size.pixels());
    const unsigned channels = features.has_alpha != 0 ? 4 : 3;
    const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> pixels(
        channels == 4 ? WebPDecodeRGBA(bytes, file.bytes.size(), nullptr, nullptr)
                      : WebPDecodeRGB(bytes, file.bytes.size(), nullptr, nullptr),
        WebPFree);
    if (!pixels) file.refuse("not a whole WebP: libwebp cannot decode it");
    Image image = make_image(file, size);
    const std::span<double> all = image.luminance;
    for (std::size_t y = 0; y < image.rows; ++y)
        fill_row_from(pixels.get() + y * image.columns * channels, channels, false,
                      all.subspan(y * image.columns, image.columns), 255, file.reading);
    return upright(std::move(image), orientation_in(exif_of(file.bytes)));
}

}  // namespace lacuna::pictures
