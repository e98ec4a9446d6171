// Given any bytes, the readers of pictures give a picture that keeps its promises, or refuse in one
// line.
#include <zlib.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "files/parse.h"
#include "files/point_files.h"
#include "pictures/image.h"
#include "pictures/importance.h"

namespace {

using namespace lacuna;

void require(bool holds) {
    if (!holds) std::abort();
}

void require_promises(const pictures::Image& image) {
    require(image.columns > 0 && image.rows > 0);
    require(image.luminance.size() == std::uint64_t{image.columns} * image.rows);
    require(std::isfinite(image.white) && image.white >= 1);
    for (const double luminance : image.luminance)
        require(luminance >= 0 && luminance <= image.white);
}

// Corrects the checksums of a PNG's whole chunks: with wrong ones the reader would never get past
// the first chunk.
void mend_checksums(std::span<std::uint8_t> bytes) {
    constexpr std::string_view kMagic = "\x89PNG\r\n\x1a\n";
    constexpr std::size_t kLengthAndType = 8;
    constexpr std::size_t kChecksum = 4;
    const std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    if (!text.starts_with(kMagic)) return;
    for (std::size_t at = kMagic.size(); bytes.size() - at >= kLengthAndType + kChecksum;) {
        const std::size_t length = files::load<std::uint32_t>(text.substr(at), std::endian::big);
        if (length > bytes.size() - at - kLengthAndType - kChecksum) return;
        const std::size_t end = at + kLengthAndType + length;
        const auto checksum = crc32(0, &bytes[at + 4], static_cast<unsigned>(4 + length));
        for (std::size_t i = 0; i < kChecksum; ++i)
            bytes[end + i] = static_cast<std::uint8_t>(checksum >> (24 - 8 * i));
        at = end + kChecksum;
    }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
    const std::size_t changed = LLVMFuzzerMutate(data, size, max_size);
    if (seed % 8 != 0) mend_checksums({data, changed});  // some stay wrong
    return changed;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Larger pictures take too long here: a few bytes can stand for many equal pixels.
    constexpr std::uint64_t kMaxPixels = 1U << 16U;
    try {
        const pictures::Image image =
            pictures::decode_image({reinterpret_cast<const char*>(data), size}, "file", kMaxPixels);
        require_promises(image);
        for (const double importance : pictures::importance_of(image, {}).importance)
            require(importance >= 0 && importance <= 1);
    } catch (const files::FileError& error) {
        const std::string_view what = error.what();
        require(what.starts_with("file: ") && what.find('\n') == std::string_view::npos);
    }
    return 0;
}
