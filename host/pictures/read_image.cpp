// Finds the format of a picture by its first bytes, and checks its size.
#include "pictures/image.h"

#include <fmt/core.h>
#include <lacuna/pictures.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "files/npy.h"
#include "files/parse.h"
#include "files/read_whole.h"
#include "pictures/decode.h"
#include "plan/sizes.h"

namespace lacuna::pictures {
namespace {

using Decode = Image (*)(const Encoded&);

struct Known {
    std::string_view magic;
    Decode decode;
};

constexpr std::array<Known, 18> kFormats{{{"\x89PNG\r\n\x1a\n", decode_png},
                                          {"\xff\xd8\xff", decode_jpeg},
                                          {"P1", decode_netpbm},
                                          {"P2", decode_netpbm},
                                          {"P3", decode_netpbm},
                                          {"P4", decode_netpbm},
                                          {"P5", decode_netpbm},
                                          {"P6", decode_netpbm},
                                          {"P7", decode_netpbm},
                                          {"Pf", decode_pfm},
                                          {"PF", decode_pfm},
                                          {"#?RADIANCE", decode_hdr},
                                          {"#?RGBE", decode_hdr},
                                          {files::kNpyMagic, decode_npy},
                                          {std::string_view("II*\0", 4), decode_tiff},
                                          {std::string_view("MM\0*", 4), decode_tiff},
                                          {std::string_view("II+\0", 4), decode_tiff},
                                          {std::string_view("MM\0+", 4), decode_tiff}}};
constexpr std::size_t kWebpAt = 8;  // after RIFF and the file's size
constexpr Known kWebp{"WEBP", decode_webp};
constexpr std::size_t kHeifAt = 4;  // after the size of the first box
constexpr std::array<Known, 3> kHeif{
    {{"ftyphei", decode_heif}, {"ftypmif1", decode_heif}, {"ftypavif", decode_heif}}};

// Known formats that are not read; the message names them.
struct Unread {
    std::size_t at;
    std::string_view magic;
    std::string_view name;
    std::string_view advice;
};

constexpr std::string_view kToPng = "convert it first, for example to PNG";
constexpr std::array<Unread, 9> kUnread{{{0, "GIF8", "a GIF", kToPng},
                                         {4, "ftypavis", "an animated AVIF", kToPng},
                                         {4, "ftyphevc", "an animated HEIF", kToPng},
                                         {4, "ftypmsf1", "an animated HEIF", kToPng},
                                         {0, "BM", "a BMP", kToPng},
                                         {0, "8BPS", "a Photoshop", kToPng},
                                         {0, "v/1\1", "an OpenEXR", kToPng},
                                         {0, "%PDF", "a PDF", kToPng},
                                         {0, "<svg", "an SVG", kToPng}}};

constexpr std::string_view kAllowed =
    "must be a picture in PNG, JPEG, TIFF, WebP, HEIC, AVIF, PGM, PPM, PFM, Radiance HDR or "
    "NumPy's .npy";

std::string size_text(Size size) {
    return fmt::format("{} x {} pixels", size.columns, size.rows);
}

// Throws FileError if the file has no known format.
const Known& format_of(const Encoded& file) {
    const std::string_view bytes = file.bytes;
    const auto* known = std::find_if(kFormats.begin(), kFormats.end(), [&](const Known& format) {
        return bytes.starts_with(format.magic);
    });
    if (known != kFormats.end()) return *known;
    if (bytes.starts_with("RIFF") &&
        bytes.substr(std::min(kWebpAt, bytes.size())).starts_with(kWebp.magic))
        return kWebp;
    for (const Known& heif : kHeif)
        if (bytes.substr(std::min(kHeifAt, bytes.size())).starts_with(heif.magic)) return heif;
    if (bytes.empty()) file.refuse(fmt::format("empty: {}", kAllowed));
    for (const Unread& unread : kUnread)
        if (bytes.substr(std::min(unread.at, bytes.size())).starts_with(unread.magic))
            file.refuse(fmt::format("{} picture: {}; {}", unread.name, kAllowed, unread.advice));
    // Programs such as this one begin an SVG with an XML declaration.
    constexpr std::size_t kBeginning = 4096;
    if (bytes.starts_with("<?xml") &&
        bytes.substr(0, kBeginning).find("<svg") != std::string_view::npos)
        file.refuse(fmt::format("an SVG picture: {}; {}", kAllowed, kToPng));
    constexpr std::size_t kShown = 16;
    file.refuse(
        fmt::format("begins with {}: {}", files::excerpt(bytes.substr(0, kShown)), kAllowed));
}

// The memory that a picture may take: what the machine has or, if it is less, `ulimit -v`.
double memory_for_pixels() {
    rlimit limit{};
    const auto machine = static_cast<double>(machine_memory_bytes());
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return machine;
    return std::min(machine, static_cast<double>(limit.rlim_cur));
}

// Three channels take 24 bytes a pixel; separating and relaxing four inks takes some 80 more.
constexpr std::uint32_t kBytesOfInks = 104;

}  // namespace

void check_size(const Encoded& file, Size size) {
    if (size.columns == 0 || size.rows == 0)
        file.refuse(fmt::format("{}: must be at least 1 x 1", size_text(size)));
    if (size.columns > kMaxSide || size.rows > kMaxSide)
        file.refuse(fmt::format("{}: no side may be over {}", size_text(size), kMaxSide));
    if (size.pixels() > file.max_pixels)
        file.refuse(fmt::format("{}: must be at most {} in all", size_text(size), file.max_pixels));
    if (std::max(size.columns, size.rows) > file.max_aspect * std::min(size.columns, size.rows))
        file.refuse(fmt::format("{}: the longer side may be at most {} times the shorter",
                                size_text(size), file.max_aspect));
    const double needed = file.reading.bytes_a_pixel * static_cast<double>(size.pixels());
    if (needed > memory_for_pixels())
        file.refuse(fmt::format(
            "{} need about {:.2g} GB of memory, more than the {:.2g} GB there is: make it smaller",
            size_text(size), needed / 1e9, memory_for_pixels() / 1e9));
}

Image make_image(const Encoded& file, Size size) {
    Image image;
    image.columns = static_cast<std::uint32_t>(size.columns);
    image.rows = static_cast<std::uint32_t>(size.rows);
    image.luminance.resize(size.pixels());
    image.name = file.name;
    return image;
}

void check_format(std::string_view first, const std::string& name) {
    format_of({first, name, kMaxPixels, kMaxSide});
}

Image decode_image(std::string_view bytes, const std::string& name, std::uint64_t max_pixels,
                   std::uint64_t max_aspect, const Reading& reading) {
    const Encoded file{bytes, name, max_pixels, max_aspect, reading};
    return format_of(file).decode(file);
}

Image read_image(const std::string& path, std::uint64_t max_aspect, const Reading& reading) {
    const Picture picture = read_picture(path);
    return decode_image(picture.content, picture.name, kMaxPixels, max_aspect, reading);
}

Colours decode_colours(std::string_view bytes, const std::string& name, Backdrop backdrop,
                       std::uint64_t max_aspect) {
    const auto channel = [&](const Weights& weights) {
        return decode_image(bytes, name, kMaxPixels, max_aspect, {backdrop, weights, kBytesOfInks});
    };
    return {channel({kAll, 0, 0}), channel({0, kAll, 0}), channel({0, 0, kAll})};
}

}  // namespace lacuna::pictures
