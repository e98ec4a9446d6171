// Reads TIFF with libtiff: the first picture of the file.
#include <fmt/core.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/exif.h"
#include "pictures/tiff_memory.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

class TiffReader {
public:
    explicit TiffReader(const Encoded& file) : file_(file), memory_{file.bytes} {
        const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
            TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, this);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
        tiff_.reset(TIFFClientOpenExt("picture", "r", &memory_, TiffMemory::read, TiffMemory::write,
                                      TiffMemory::seek, TiffMemory::close, TiffMemory::size,
                                      TiffMemory::map, TiffMemory::unmap, options.get()));
        check(tiff_ != nullptr);
    }

    Image read() {
        const Size size{tag<std::uint32_t>(TIFFTAG_IMAGEWIDTH),
                        tag<std::uint32_t>(TIFFTAG_IMAGELENGTH)};
        check_size(file_, size);
        const auto orientation = tag<std::uint16_t>(TIFFTAG_ORIENTATION);
        const auto bits = tag<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
        check_kind(bits);
        check_that_pixels_fit(size);
        Image image = make_image(file_, size);
        const std::optional<Layout> layout = layout_of_samples();
        if (layout && bits == 16)
            read_samples<std::uint16_t>(image, *layout);
        else if (layout && bits == 8)
            read_samples<std::uint8_t>(image, *layout);
        else
            read_as_rgba(image, bits);
        return upright(std::move(image), orientation >= 1 && orientation <= 8 ? orientation : 1);
    }

private:
    static constexpr std::uint64_t kMostOfTile = 1U << 24U;  // pixels, of tiles beyond the picture
    static constexpr unsigned kMostChannels = 64;
    static constexpr std::size_t kMostBytesOfPart = 1U << 27U;  // beyond the picture's own memory

    // The beginning of the first message of libtiff; it may not be left by an exception.
    static int on_error(TIFF*, void* self, const char*, const char* format, va_list values) {
        std::string& complaint = static_cast<TiffReader*>(self)->complaint_;
        if (!complaint.empty()) return 1;
        complaint.resize(200);
        const int length = std::vsnprintf(complaint.data(), complaint.size(), format, values);
        complaint.resize(std::min<std::size_t>(complaint.size() - 1,
                                               static_cast<std::size_t>(std::max(length, 0))));
        return 1;
    }
    static int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }

    void check(bool done) const {
        if (!done)
            file_.refuse(
                fmt::format("not a whole TIFF: libtiff says {}", files::excerpt(complaint_)));
    }

    // libtiff would take numbers of other kinds for colours, and its white of Lab is yellow.
    void check_kind(unsigned bits) const {
        const auto format = tag<std::uint16_t>(TIFFTAG_SAMPLEFORMAT);
        if (format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID)
            file_.refuse(
                fmt::format("a TIFF of {} numbers, of {} bits: must be of whole numbers "
                            "from 0 on; PFM and .npy may hold others",
                            format == SAMPLEFORMAT_INT      ? "signed"
                            : format == SAMPLEFORMAT_IEEEFP ? "floating-point"
                                                            : "complex",
                            bits));
        const std::optional<std::uint16_t> photometric = given_photometric();
        if (photometric == PHOTOMETRIC_CIELAB || photometric == PHOTOMETRIC_ICCLAB ||
            photometric == PHOTOMETRIC_ITULAB)
            file_.refuse("a TIFF in Lab colours: must be grey, RGB or CMYK");
    }

    // Without it libtiff guesses.
    std::optional<std::uint16_t> given_photometric() const {
        std::uint16_t photometric = 0;
        if (TIFFGetField(tiff_.get(), TIFFTAG_PHOTOMETRIC, &photometric) == 0) return std::nullopt;
        return photometric;
    }

    // Called before memory is allocated. A fax packs a white line of 2^17 pixels into a bit.
    void check_that_pixels_fit(Size size) const {
        const auto channels = tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
        if (channels > kMostChannels)
            file_.refuse(fmt::format("a TIFF of {} samples a pixel: must be at most {}", channels,
                                     kMostChannels));
        constexpr std::uint64_t kHighestRatio = 1U << 17U;
        const std::uint64_t ratio =
            tag<std::uint16_t>(TIFFTAG_COMPRESSION) == COMPRESSION_NONE ? 1 : kHighestRatio;
        if (TIFFScanlineSize64(tiff_.get()) * size.rows / ratio > file_.bytes.size())
            file_.refuse(fmt::format("not a whole TIFF: {} bytes cannot hold {} x {} pixels",
                                     file_.bytes.size(), size.columns, size.rows));
    }

    template <class Number>
    Number tag(std::uint32_t name) const {
        Number number{};
        TIFFGetFieldDefaulted(tiff_.get(), name, &number);
        return number;
    }

    // What the samples of a pixel are: 1 or 3 colours, then perhaps alpha, then others.
    struct Layout {
        unsigned channels;
        unsigned colours;
        std::uint16_t alpha;  // libtiff's EXTRASAMPLE_
        bool is_inverted;     // 0 is white
        bool is_planar;       // all samples of a channel lie together, not those of a pixel
    };

    // The layout of grey or RGB in whole numbers.
    std::optional<Layout> layout_of_samples() const {
        const std::optional<std::uint16_t> photometric = given_photometric();
        const bool is_grey =
            photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE;
        Layout layout{tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL), is_grey ? 1U : 3U,
                      EXTRASAMPLE_UNSPECIFIED, photometric == PHOTOMETRIC_MINISWHITE,
                      tag<std::uint16_t>(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE};
        if ((!is_grey && photometric != PHOTOMETRIC_RGB) || layout.channels < layout.colours)
            return std::nullopt;
        std::uint16_t count = 0;
        std::uint16_t* kinds = nullptr;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds);
        if (count > 0 && layout.channels > layout.colours) layout.alpha = kinds[0];
        return layout;
    }

    // The parts of a picture that libtiff unpacks at once.
    struct Parts {
        bool are_tiles;
        std::uint32_t width;
        std::uint32_t height;  // the last strip may be lower
    };

    Parts parts_of(const Image& image) const {
        const bool are_tiles = TIFFIsTiled(tiff_.get()) != 0;
        const Parts parts{
            are_tiles, are_tiles ? tag<std::uint32_t>(TIFFTAG_TILEWIDTH) : image.columns,
            are_tiles ? tag<std::uint32_t>(TIFFTAG_TILELENGTH)
                      : std::min(tag<std::uint32_t>(TIFFTAG_ROWSPERSTRIP), image.rows)};
        const std::uint64_t pixels = std::uint64_t{parts.width} * parts.height;
        // libtiff fills whole tiles, however large they are.
        if (pixels == 0 ||
            pixels > std::max(kMostOfTile, std::uint64_t{image.columns} * image.rows))
            file_.refuse(fmt::format("a TIFF in tiles of {} x {} pixels: must be smaller",
                                     parts.width, parts.height));
        return parts;
    }

    // libtiff gives samples in the machine's order of bytes.
    template <class Sample>
    void read_samples(Image& image, const Layout& layout) {
        Parts parts = parts_of(image);
        const bool are_rows = !parts.are_tiles && !layout.is_planar;
        if (are_rows) parts.height = 1;
        const bool has_alpha = layout.alpha != EXTRASAMPLE_UNSPECIFIED;
        const unsigned planes = layout.is_planar ? layout.colours + (has_alpha ? 1 : 0) : 1;
        const std::size_t of_plane =
            std::size_t{parts.width} * parts.height * (layout.is_planar ? 1 : layout.channels);
        const std::size_t room = planes * of_plane * sizeof(Sample);
        if (room > std::max<std::size_t>(kMostBytesOfPart,
                                         image.luminance.size() * sizeof(image.luminance[0])))
            file_.refuse(fmt::format("a TIFF in parts of {:.2g} GB: must be smaller",
                                     static_cast<double>(room) / 1e9));
        std::vector<Sample> samples(planes * of_plane);
        for (std::uint32_t y = 0; y < image.rows; y += parts.height)
            for (std::uint32_t x = 0; x < image.columns; x += parts.width) {
                const std::uint32_t rows = std::min(parts.height, image.rows - y);
                for (unsigned plane = 0; plane < planes; ++plane) {
                    const auto number = static_cast<std::uint16_t>(plane);
                    Sample* const to = samples.data() + plane * of_plane;
                    const auto bytes = static_cast<tmsize_t>(of_plane * sizeof(Sample));
                    TIFF* const tiff = tiff_.get();
                    check(are_rows ? TIFFReadScanline(tiff, to, y, 0) == 1
                          : parts.are_tiles
                              ? TIFFReadEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, number),
                                                    to, bytes) >= 0
                              : TIFFReadEncodedStrip(tiff, TIFFComputeStrip(tiff, y, number), to,
                                                     bytes) >= 0);
                }
                for (std::uint32_t row = 0; row < rows; ++row)
                    fill_from(samples, layout, of_plane, std::size_t{row} * parts.width,
                              row_of(image, y + row)
                                  .subspan(x, std::min(parts.width, image.columns - x)));
            }
    }

    // Fills a row from the samples, the first of which is that of pixel `first` of its part.
    template <class Sample>
    void fill_from(const std::vector<Sample>& samples, const Layout& layout, std::size_t of_plane,
                   std::size_t first, std::span<double> row) const {
        constexpr std::int32_t kMax = std::numeric_limits<Sample>::max();
        const auto at = [&](std::size_t x, std::size_t channel) {
            const std::int32_t sample =
                samples[layout.is_planar ? channel * of_plane + first + x
                                         : (first + x) * layout.channels + channel];
            return layout.is_inverted && channel == 0 ? kMax - sample : sample;
        };
        const bool is_straight = layout.alpha == EXTRASAMPLE_UNASSALPHA;
        with_channels(layout.colours + (is_straight ? 1 : 0),
                      [&](auto channels) { fill_row<channels>(row, kMax, file_.reading, at); });
        if (layout.alpha != EXTRASAMPLE_ASSOCALPHA || file_.reading.backdrop != Backdrop::white)
            return;
        for (std::size_t x = 0; x < row.size(); ++x)  // alpha has multiplied the colours
            row[x] = std::min(1.0, row[x] + 1 - at(x, layout.colours) / double{kMax});
    }

    // All else that libtiff turns into 8 bits of red, green, blue and alpha, by strips or tiles.
    void read_as_rgba(Image& image, unsigned bits) {
        if (bits > 8)
            file_.refuse(
                fmt::format("a TIFF of {} bits a sample: must be 1 to 8 bits, or 16 bits "
                            "in grey or RGB",
                            bits));
        if (tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL) == 2)
            file_.refuse(fmt::format("a TIFF of {} bits with alpha: must be 8 or 16 bits", bits));
        char why[1024] = "";
        if (TIFFRGBAImageOK(tiff_.get(), why) == 0)
            file_.refuse(fmt::format("a TIFF that libtiff cannot turn into colours: {}",
                                     files::excerpt(why)));
        // upright() applies the orientation, of which libtiff knows half.
        TIFFSetField(tiff_.get(), TIFFTAG_ORIENTATION, std::uint16_t{ORIENTATION_TOPLEFT});
        const auto [is_tiled, width, height] = parts_of(image);
        std::vector<std::uint32_t> part(std::size_t{width} * height);
        for (std::uint32_t y = 0; y < image.rows; y += height)
            for (std::uint32_t x = 0; x < image.columns; x += width) {
                check((is_tiled ? TIFFReadRGBATileExt(tiff_.get(), x, y, part.data(), 1)
                                : TIFFReadRGBAStripExt(tiff_.get(), y, part.data(), 1)) == 1);
                const std::uint32_t rows = std::min(height, image.rows - y);
                // Its rows come from below; a strip's last part may be lower.
                const std::uint32_t last = (is_tiled ? height : rows) - 1;
                for (std::uint32_t row = 0; row < rows; ++row)
                    convert(std::span(part).subspan(std::size_t{last - row} * width, width),
                            row_of(image, y + row).subspan(x));
            }
    }

    // libtiff has multiplied the colours by alpha.
    void convert(std::span<const std::uint32_t> pixels, std::span<double> row) const {
        ask_after(row.size());
        constexpr std::int64_t kMax = 255;
        const bool is_white = file_.reading.backdrop == Backdrop::white;
        for (std::size_t x = 0; x < std::min(pixels.size(), row.size()); ++x) {
            const std::uint32_t pixel = pixels[x];
            const auto channel = [&](unsigned shift) {
                return static_cast<std::int32_t>(pixel >> shift & 0xffU);
            };
            const std::int64_t colour =
                weighted(file_.reading.weights, channel(0), channel(8), channel(16));
            const std::int64_t behind = is_white ? kAll * (kMax - channel(24)) : 0;
            row[x] = std::min(
                1.0, static_cast<double>(colour + behind) / static_cast<double>(kAll * kMax));
        }
    }

    static std::span<double> row_of(Image& image, std::uint32_t y) {
        return std::span(image.luminance).subspan(std::size_t{y} * image.columns, image.columns);
    }

    const Encoded& file_;
    TiffMemory memory_;
    std::string complaint_;
    std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff_{nullptr, TIFFClose};
};

}  // namespace

Image decode_tiff(const Encoded& file) {
    return TiffReader(file).read();
}

}  // namespace lacuna::pictures
