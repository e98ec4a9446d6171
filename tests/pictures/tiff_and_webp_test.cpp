// Given a TIFF or WebP that libtiff or libwebp writes, its pixels are read back, upright.
#include <gtest/gtest.h>
#include <tiffio.h>
#include <unistd.h>
#include <webp/encode.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "files/parse.h"
#include "files/read_whole.h"
#include "pictures/exif.h"
#include "pictures/image.h"
#include "pictures/pictures.h"

namespace lacuna::pictures {
namespace {

struct Tiff {
    std::uint32_t columns = 1;
    std::uint32_t rows = 1;
    unsigned bits = 8;
    unsigned channels = 1;
    unsigned photometric = PHOTOMETRIC_MINISBLACK;
    unsigned compression = COMPRESSION_NONE;
    std::uint32_t rows_of_strip = 3;
    bool tiled = false;  // 16 pixels wide
    std::uint32_t tile_length = 16;
    int orientation = 1;
    unsigned format = SAMPLEFORMAT_UINT;
    unsigned extra = EXTRASAMPLE_UNASSALPHA;  // what the last of an even number of channels is
    bool planar = false;                      // each channel by itself
    const char* mode = "w";                   // b: big-endian, 8: BigTIFF
};

// The samples in the machine's order, of 8, 16 or 32 bits.
std::vector<std::uint8_t> raw(const Samples& samples, unsigned bits) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint16_t sample : samples)
        for (unsigned byte = 0; byte < bits / 8; ++byte)
            bytes.push_back(static_cast<std::uint8_t>(byte < 2 ? sample >> (8 * byte) : 0));
    return bytes;
}

// Writes the pixels, or one channel of them.
void write(TIFF* tiff, const Tiff& made, std::vector<std::uint8_t> bytes, unsigned channels,
           unsigned plane) {
    const std::size_t pixel = made.bits / 8 * channels;
    if (!made.tiled) {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, made.rows_of_strip);
        for (std::uint32_t y = 0; y < made.rows; ++y)
            TIFFWriteScanline(tiff, bytes.data() + y * made.columns * pixel, y,
                              static_cast<std::uint16_t>(plane));
        return;
    }
    constexpr std::uint32_t kSide = 16;
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, kSide);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, made.tile_length);
    for (std::uint32_t y = 0; y < made.rows; y += made.tile_length)
        for (std::uint32_t x = 0; x < made.columns; x += kSide) {
            std::vector<std::uint8_t> tile(kSide * made.tile_length * pixel);
            for (std::uint32_t row = 0; row < std::min(made.tile_length, made.rows - y); ++row)
                std::copy_n(bytes.begin() +
                                static_cast<std::ptrdiff_t>(((y + row) * made.columns + x) * pixel),
                            std::min(kSide, made.columns - x) * pixel,
                            tile.begin() + static_cast<std::ptrdiff_t>(row * kSide * pixel));
            TIFFWriteTile(tiff, tile.data(), x, y, 0, static_cast<std::uint16_t>(plane));
        }
}

std::string tiff_bytes(const Tiff& made, const Samples& samples) {
    // Tests may run side by side.
    const std::string path =
        testing::TempDir() + "lacuna_" + std::to_string(::getpid()) + "_test.tiff";
    std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(path.c_str(), made.mode), TIFFClose);
    const auto set = [&](std::uint32_t tag, unsigned value) {
        TIFFSetField(tiff.get(), tag, value);
    };
    set(TIFFTAG_IMAGEWIDTH, made.columns);
    set(TIFFTAG_IMAGELENGTH, made.rows);
    set(TIFFTAG_BITSPERSAMPLE, made.bits);
    set(TIFFTAG_SAMPLESPERPIXEL, made.channels);
    set(TIFFTAG_PHOTOMETRIC, made.photometric);
    set(TIFFTAG_COMPRESSION, made.compression);
    set(TIFFTAG_PLANARCONFIG, made.planar ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
    set(TIFFTAG_ORIENTATION, static_cast<unsigned>(made.orientation));
    set(TIFFTAG_SAMPLEFORMAT, made.format);
    if (made.channels % 2 == 0 && made.photometric != PHOTOMETRIC_SEPARATED) {
        const auto extra = static_cast<std::uint16_t>(made.extra);
        TIFFSetField(tiff.get(), TIFFTAG_EXTRASAMPLES, 1, &extra);
    }
    if (!made.planar) {
        write(tiff.get(), made, raw(samples, made.bits), made.channels, 0);
    } else {
        for (unsigned channel = 0; channel < made.channels; ++channel) {
            Samples own;
            for (std::size_t i = channel; i < samples.size(); i += made.channels)
                own.push_back(samples[i]);
            write(tiff.get(), made, raw(own, made.bits), 1, channel);
        }
    }
    tiff.reset();
    const std::string bytes_of_file = files::read_whole(path);
    std::filesystem::remove(path);
    return bytes_of_file;
}

// What a PNG of the same samples gives, which png_test.cpp tests.
std::vector<double> as_png(const Tiff& tiff, const Samples& samples) {
    constexpr int kTypes[] = {0, 0, 4, 2, 6};  // PNG's colour type by the number of channels
    return decode_image(png_bytes({tiff.columns, tiff.rows, static_cast<int>(tiff.bits),
                                   kTypes[tiff.channels]},
                                  samples),
                        "png")
        .luminance;
}

// Every way in which the samples of grey and RGB with and without alpha may lie.
std::vector<Tiff> all_ways() {
    std::vector<Tiff> all;
    for (const unsigned bits : {8U, 16U})
        for (const unsigned channels : {1U, 2U, 3U, 4U})
            for (const int compression : {COMPRESSION_NONE, COMPRESSION_LZW})
                for (const char* const mode : {"wl", "wb", "wb8"})
                    for (const bool tiled : {false, true})
                        for (const bool planar : {false, true}) {
                            Tiff& tiff = all.emplace_back(Tiff{37, 21, bits, channels});
                            if (channels > 2) tiff.photometric = PHOTOMETRIC_RGB;
                            tiff.compression = static_cast<unsigned>(compression);
                            tiff.mode = mode;
                            tiff.tiled = tiled;
                            tiff.planar = planar;
                        }
    return all;
}

std::string text_of(const Tiff& tiff) {
    return std::to_string(tiff.bits) + " bits, " + std::to_string(tiff.channels) + " channels, " +
           tiff.mode + (tiff.tiled ? ", tiles" : "") + (tiff.planar ? ", planes" : "");
}

TEST(ATiff, GivesThePixelsOfThePngInStripsTilesOrPlanesOfAnyCompression) {
    for (const Tiff& tiff : all_ways()) {
        const Samples samples =
            pattern(std::size_t{37} * 21 * tiff.channels, (1U << tiff.bits) - 1);
        const Image image = decode_image(tiff_bytes(tiff, samples), "file");
        ASSERT_EQ(image.columns, 37U);
        ASSERT_EQ(image.rows, 21U);
        const std::vector<double> expected = as_png(tiff, samples);
        for (std::size_t i = 0; i < expected.size(); ++i)
            ASSERT_NEAR(image.luminance[i], expected[i], 1e-15) << text_of(tiff) << " " << i;
    }
}

TEST(ATiff, WithABandThatIsNoAlphaHasThePixelsOfTheOthers) {
    for (Tiff tiff : all_ways()) {
        if (tiff.channels % 2 == 1) continue;
        tiff.extra = EXTRASAMPLE_UNSPECIFIED;
        const Samples samples =
            pattern(std::size_t{37} * 21 * tiff.channels, (1U << tiff.bits) - 1);
        Samples colours;
        for (std::size_t i = 0; i < samples.size(); ++i)
            if ((i + 1) % tiff.channels != 0) colours.push_back(samples[i]);
        const Image image = decode_image(tiff_bytes(tiff, samples), "file");
        --tiff.channels;
        EXPECT_EQ(image.luminance, as_png(tiff, colours)) << text_of(tiff);
    }
}

TEST(ATiff, WhoseZeroIsWhiteIsInverted) {
    for (const unsigned bits : {8U, 16U}) {
        Tiff tiff{5, 4, bits};
        const Samples samples = pattern(20, (1U << bits) - 1);
        const std::vector<double> black = decode_image(tiff_bytes(tiff, samples), "f").luminance;
        tiff.photometric = PHOTOMETRIC_MINISWHITE;
        const std::vector<double> white = decode_image(tiff_bytes(tiff, samples), "f").luminance;
        for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(white[i], 1 - black[i], 1e-15);
    }
}

TEST(ATiff, MayHaveLongStripsAndTilesThatAreMuchLongerThanItself) {
    Tiff wide{2100, 3, 8, 4, PHOTOMETRIC_SEPARATED};  // CMYK
    wide.rows_of_strip = 1;
    EXPECT_EQ(decode_image(tiff_bytes(wide, Samples(2100 * 3 * 4, 0)), "f").luminance,
              std::vector<double>(6300, 1));
    Tiff tall{16, 20, 8};
    tall.tiled = true;
    tall.tile_length = 70000;
    tall.compression = COMPRESSION_LZW;
    const Samples samples = pattern(320, 255);
    const Image image = decode_image(tiff_bytes(tall, samples), "f");
    EXPECT_EQ(image.luminance, as_png({16, 20, 8}, samples));
}

TEST(ATiff, IsTurnedUpright) {
    for (const unsigned bits : {8U, 16U})
        for (int orientation = 1; orientation <= 8; ++orientation)
            for (const bool tiled : {false, true}) {
                Tiff tiff{19, 20, bits};
                tiff.tiled = tiled;
                const Samples samples = pattern(380, 255);
                const Image expected =
                    upright(decode_image(tiff_bytes(tiff, samples), "f"), orientation);
                tiff.orientation = orientation;
                const Image image = decode_image(tiff_bytes(tiff, samples), "f");
                EXPECT_EQ(image.columns, expected.columns) << orientation;
                EXPECT_EQ(image.luminance, expected.luminance) << orientation << tiled;
            }
}

std::string refused(const std::string& bytes) {
    try {
        decode_image(bytes, "f");
    } catch (const files::FileError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(ATiff, ThatIsBrokenOrOfAnotherKindIsRefused) {
    struct Kind {
        unsigned bits, format, photometric, channels;
        const char* told;
    };
    for (const auto& [bits, format, photometric, channels, told] : std::vector<Kind>{
             {32, SAMPLEFORMAT_IEEEFP, PHOTOMETRIC_MINISBLACK, 1,
              "a TIFF of floating-point numbers, of 32 bits: must be of whole numbers from 0 on; "
              "PFM and .npy may hold others"},
             {16, SAMPLEFORMAT_INT, PHOTOMETRIC_MINISBLACK, 1,
              "a TIFF of signed numbers, of 16 bits: must be of whole numbers from 0 on; PFM and "
              ".npy may hold others"},
             {8, SAMPLEFORMAT_INT, PHOTOMETRIC_RGB, 3,
              "a TIFF of signed numbers, of 8 bits: must be of whole numbers from 0 on; PFM and "
              ".npy may hold others"},
             {32, SAMPLEFORMAT_UINT, PHOTOMETRIC_MINISBLACK, 1,
              "a TIFF of 32 bits a sample: must be 1 to 8 bits, or 16 bits in grey or RGB"},
             {16, SAMPLEFORMAT_UINT, PHOTOMETRIC_SEPARATED, 4,
              "a TIFF of 16 bits a sample: must be 1 to 8 bits, or 16 bits in grey or RGB"},
             {8, SAMPLEFORMAT_UINT, PHOTOMETRIC_CIELAB, 3,
              "a TIFF in Lab colours: must be grey, RGB or CMYK"}}) {
        Tiff other{40, 30, bits, channels, photometric};
        other.format = format;
        EXPECT_EQ(refused(tiff_bytes(other, pattern(std::size_t{1200} * channels, 9))),
                  std::string("f: ") + told);
    }
    Tiff tiff{40, 30, 8};
    tiff.compression = COMPRESSION_LZW;
    const std::string whole = tiff_bytes(tiff, pattern(1200, 255));
    for (const std::size_t length : {std::size_t{4}, std::size_t{8}, whole.size() / 2})
        EXPECT_EQ(refused(whole.substr(0, length)).substr(0, 33),
                  "f: not a whole TIFF: libtiff says")
            << refused(whole.substr(0, length));
}

std::string webp_bytes(int columns, int rows, int channels, const Samples& samples) {
    const std::vector<std::uint8_t> pixels = raw(samples, 8);
    std::uint8_t* encoded = nullptr;
    const std::size_t size =
        channels == 3 ? WebPEncodeLosslessRGB(pixels.data(), columns, rows, 3 * columns, &encoded)
                      : WebPEncodeLosslessRGBA(pixels.data(), columns, rows, 4 * columns, &encoded);
    const std::unique_ptr<std::uint8_t, decltype(&WebPFree)> owner(encoded, WebPFree);
    return {reinterpret_cast<const char*>(encoded), size};
}

std::string little(std::uint32_t number, std::size_t bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i) & 0xffU);
    return text;
}

// The file with Exif's data, in WebP's extended form.
std::string with_exif(const std::string& plain, std::uint32_t columns, std::uint32_t rows,
                      const std::string& data) {
    constexpr char kHasExif = 8;
    std::string chunks = "WEBPVP8X" + little(10, 4) + std::string{kHasExif, 0, 0, 0} +
                         little(columns - 1, 3) + little(rows - 1, 3) + plain.substr(12);
    chunks += "EXIF" + little(static_cast<std::uint32_t>(data.size()), 4) + data;
    if (data.size() % 2 == 1) chunks += '\0';
    return "RIFF" + little(static_cast<std::uint32_t>(chunks.size()), 4) + chunks;
}

TEST(AWebp, GivesThePixelsOfThePng) {
    for (const int channels : {3, 4}) {
        Samples samples = pattern(static_cast<std::size_t>(31 * 17 * channels), 255);
        // Colours under full transparency are not kept.
        for (std::size_t i = 3; channels == 4 && i < samples.size(); i += 4)
            samples[i] = std::max<std::uint16_t>(samples[i], 1);
        const Image image = decode_image(webp_bytes(31, 17, channels, samples), "file");
        EXPECT_EQ(image.columns, 31U);
        EXPECT_EQ(image.white, 1);
        EXPECT_EQ(image.luminance, as_png({31, 17, 8, static_cast<unsigned>(channels)}, samples));
    }
}

TEST(AWebp, AndAPngAreTurnedUprightAsExifSays) {
    const Samples samples = pattern(5 * 3 * 3, 255);
    const std::string webp = webp_bytes(5, 3, 3, samples);
    const std::string png = png_bytes({5, 3, 8, 2}, samples);
    constexpr std::size_t kAfterHeader = 33;
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Image expected = upright(decode_image(png, "f"), orientation);
        const std::string data = exif(orientation, orientation % 2 == 0).substr(6);
        for (const std::string& bytes :
             {with_exif(webp, 5, 3, data), with_exif(webp, 5, 3, exif(orientation, true)),
              png.substr(0, kAfterHeader) + png_chunk("eXIf", data) + png.substr(kAfterHeader)}) {
            const Image image = decode_image(bytes, "f");
            EXPECT_EQ(image.columns, expected.columns);
            EXPECT_EQ(image.luminance, expected.luminance) << orientation;
        }
    }
}

TEST(AWebp, ThatIsBrokenIsRefused) {
    const std::string whole = webp_bytes(20, 20, 3, pattern(1200, 255));
    EXPECT_EQ(refused(whole.substr(0, 14)).substr(0, 22), "f: not a whole WebP: l");
    EXPECT_EQ(refused(whole.substr(0, whole.size() / 2)),
              "f: not a whole WebP: libwebp cannot decode it");
}

}  // namespace
}  // namespace lacuna::pictures
