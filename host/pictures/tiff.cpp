// Reads TIFF with libtiff: the first picture of the file.
#include <fmt/core.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
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
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// The file in memory, as libtiff reads it.
struct Memory {
    std::string_view bytes;
    std::uint64_t at = 0;

    static Memory& of(thandle_t handle) { return *static_cast<Memory*>(handle); }
    static tmsize_t read(thandle_t handle, void* to, tmsize_t count) {
        Memory& memory = of(handle);
        const std::string_view rest =
            memory.bytes.substr(std::min<std::uint64_t>(memory.at, memory.bytes.size()),
                                static_cast<std::size_t>(count));
        std::memcpy(to, rest.data(), rest.size());
        memory.at += rest.size();
        return static_cast<tmsize_t>(rest.size());
    }
    static tmsize_t write(thandle_t, void*, tmsize_t) { return 0; }
    static toff_t seek(thandle_t handle, toff_t to, int from) {
        Memory& memory = of(handle);
        if (from == SEEK_CUR) to += memory.at;
        if (from == SEEK_END) to += memory.bytes.size();
        return memory.at = to;
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return of(handle).bytes.size(); }
    // libtiff 4.5 refuses whole tiles that are not mapped. It only reads what it maps.
    static int map(thandle_t handle, void** base, toff_t* size) {
        const std::string_view bytes = of(handle).bytes;
        *base = const_cast<char*>(bytes.data());
        *size = bytes.size();
        return 1;
    }
    static void unmap(thandle_t, void*, toff_t) {}
};

class TiffReader {
public:
    explicit TiffReader(const Encoded& file) : file_(file), memory_{file.bytes} {
        const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
            TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
        TIFFOpenOptionsSetErrorHandlerExtR(options.get(), on_error, this);
        TIFFOpenOptionsSetWarningHandlerExtR(options.get(), on_warning, nullptr);
        tiff_.reset(TIFFClientOpenExt("picture", "r", &memory_, Memory::read, Memory::write,
                                      Memory::seek, Memory::close, Memory::size, Memory::map,
                                      Memory::unmap, options.get()));
        check(tiff_ != nullptr);
    }

    Image read() {
        const Size size{tag<std::uint32_t>(TIFFTAG_IMAGEWIDTH),
                        tag<std::uint32_t>(TIFFTAG_IMAGELENGTH)};
        check_size(file_, size);
        const auto orientation = tag<std::uint16_t>(TIFFTAG_ORIENTATION);
        const auto bits = tag<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
        check_that_pixels_fit(size);
        Image image = make_image(file_, size);
        const std::optional<Layout> layout = layout_of_rows();
        if (layout && bits == 16)
            read_rows<std::uint16_t>(image, *layout);
        else if (layout && bits == 8)
            read_rows<std::uint8_t>(image, *layout);
        else
            read_as_rgba(image, bits);
        return upright(std::move(image), orientation >= 1 && orientation <= 8 ? orientation : 1);
    }

private:
    static constexpr std::uint64_t kMostOfTile = 1U << 24U;  // pixels, of tiles beyond the picture
    static constexpr unsigned kMostChannels = 64;

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

    // How samples lie side by side: 1 or 3 colours, then perhaps alpha, then others.
    struct Layout {
        unsigned channels;
        unsigned colours;
        std::uint16_t alpha;  // libtiff's EXTRASAMPLE_
        bool is_inverted;     // 0 is white
    };

    // The layout of rows of grey or RGB in whole numbers.
    std::optional<Layout> layout_of_rows() const {
        std::uint16_t photometric = 0;  // without it libtiff guesses
        if (TIFFGetField(tiff_.get(), TIFFTAG_PHOTOMETRIC, &photometric) == 0) return std::nullopt;
        const bool is_grey =
            photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE;
        Layout layout{tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL), is_grey ? 1U : 3U,
                      EXTRASAMPLE_UNSPECIFIED, photometric == PHOTOMETRIC_MINISWHITE};
        if ((!is_grey && photometric != PHOTOMETRIC_RGB) || layout.channels < layout.colours ||
            TIFFIsTiled(tiff_.get()) != 0 ||
            tag<std::uint16_t>(TIFFTAG_SAMPLEFORMAT) != SAMPLEFORMAT_UINT ||
            tag<std::uint16_t>(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG)
            return std::nullopt;
        std::uint16_t count = 0;
        std::uint16_t* kinds = nullptr;
        TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds);
        if (count > 0 && layout.channels > layout.colours) layout.alpha = kinds[0];
        return layout;
    }

    // libtiff gives samples in the machine's order of bytes.
    template <class Sample>
    void read_rows(Image& image, const Layout& layout) {
        constexpr std::int32_t kMax = std::numeric_limits<Sample>::max();
        const bool is_straight = layout.alpha == EXTRASAMPLE_UNASSALPHA;
        const bool is_white = file_.reading.backdrop == Backdrop::white;
        std::vector<Sample> samples(
            static_cast<std::size_t>(TIFFScanlineSize(tiff_.get())) / sizeof(Sample) + 1);
        const auto at = [&](std::size_t x, std::size_t channel) {
            const std::int32_t sample = samples[x * layout.channels + channel];
            return layout.is_inverted && channel == 0 ? kMax - sample : sample;
        };
        for (std::uint32_t y = 0; y < image.rows; ++y) {
            check(TIFFReadScanline(tiff_.get(), samples.data(), y, 0) == 1);
            const std::span<double> row = row_of(image, y);
            with_channels(layout.colours + (is_straight ? 1 : 0),
                          [&](auto channels) { fill_row<channels>(row, kMax, file_.reading, at); });
            if (layout.alpha != EXTRASAMPLE_ASSOCALPHA || !is_white) continue;
            for (std::size_t x = 0; x < row.size(); ++x)  // alpha has multiplied the colours
                row[x] = std::min(1.0, row[x] + 1 - at(x, layout.colours) / double{kMax});
        }
    }

    // All else that libtiff turns into 8 bits of red, green, blue and alpha, by strips or tiles.
    void read_as_rgba(Image& image, unsigned bits) {
        if (bits > 8)
            file_.refuse(
                fmt::format("a TIFF of {} bits a sample: must be 1 to 8 bits, or whole "
                            "numbers of 16 bits, grey or RGB, in rows",
                            bits));
        if (tag<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL) == 2)
            file_.refuse("a TIFF of grey with alpha: must be in rows");
        char why[1024] = "";
        if (TIFFRGBAImageOK(tiff_.get(), why) == 0)
            file_.refuse(fmt::format("a TIFF that libtiff cannot turn into colours: {}",
                                     files::excerpt(why)));
        // upright() applies the orientation, of which libtiff knows half.
        TIFFSetField(tiff_.get(), TIFFTAG_ORIENTATION, std::uint16_t{ORIENTATION_TOPLEFT});
        const bool is_tiled = TIFFIsTiled(tiff_.get()) != 0;
        const auto width = is_tiled ? tag<std::uint32_t>(TIFFTAG_TILEWIDTH) : image.columns;
        // libtiff fills whole tiles, however large they are.
        const auto height = is_tiled
                                ? tag<std::uint32_t>(TIFFTAG_TILELENGTH)
                                : std::min(tag<std::uint32_t>(TIFFTAG_ROWSPERSTRIP), image.rows);
        const std::uint64_t pixels = std::uint64_t{width} * height;
        if (pixels == 0 ||
            pixels > std::max(kMostOfTile, std::uint64_t{image.columns} * image.rows))
            file_.refuse(
                fmt::format("a TIFF in tiles of {} x {} pixels: must be smaller", width, height));
        std::vector<std::uint32_t> part(pixels);
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
    Memory memory_;
    std::string complaint_;
    std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff_{nullptr, TIFFClose};
};

}  // namespace

Image decode_tiff(const Encoded& file) {
    return TiffReader(file).read();
}

}  // namespace lacuna::pictures
