// Netpbm's PGM and PPM, as text (P2, P3) and as bytes (P5, P6).
#include <fmt/core.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "files/parse.h"
#include "pictures/decode.h"
#include "pictures/whole_samples.h"

namespace lacuna::pictures {
namespace {

// Takes words from a header, or from a picture in text.
class Words {
public:
    Words(const Encoded& file, std::string_view bytes) : file_(file), rest_(bytes) {}

    // Skips blanks and comments, which go from # to the line's end, and takes the next number.
    // `name` is called for messages.
    template <class Name>
    std::uint64_t take(std::uint64_t most, const Name& name) {
        skip();
        std::uint64_t number = 0;
        const std::string_view all = rest_.substr(0, rest_.find_first_of(kBlanks));
        std::string_view word = all;
        if (all.empty()) file_.refuse(fmt::format("ends before {}", name()));
        if (files::take_number(word, number) != std::errc{} || !word.empty() || number > most)
            file_.refuse(fmt::format("{} is {}: must be a whole number up to {}", name(),
                                     files::excerpt(all), most));
        rest_.remove_prefix(all.size());
        return number;
    }

    std::string_view rest() const { return rest_; }

private:
    void skip() {
        for (;;) {
            const std::size_t blanks = rest_.find_first_not_of(kBlanks);
            rest_.remove_prefix(blanks == std::string_view::npos ? rest_.size() : blanks);
            if (!rest_.starts_with('#')) return;
            files::take_line(rest_);
        }
    }

    const Encoded& file_;
    std::string_view rest_;
};

struct Layout {
    Size size;
    unsigned channels;
    std::int32_t max;

    std::size_t samples_a_row() const { return size.columns * channels; }
    std::span<double> row(Image& image, std::size_t y) const {
        return std::span(image.luminance).subspan(y * size.columns, size.columns);
    }
};

Image read_text(const Encoded& file, Words words, const Layout& layout) {
    // Each sample takes at least one digit, and a blank between two samples.
    const std::uint64_t samples = layout.samples_a_row() * layout.size.rows;
    if (2 * samples - 1 > words.rest().size())
        file.refuse(fmt::format("{} bytes of pixels cannot hold {} samples ({} x {} of {})",
                                words.rest().size(), samples, layout.size.columns, layout.size.rows,
                                layout.channels));
    Image image = make_image(file, layout.size);
    std::vector<std::int32_t> row(layout.samples_a_row());
    const auto most = static_cast<std::uint64_t>(layout.max);
    for (std::size_t y = 0; y < image.rows; ++y) {
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = static_cast<std::int32_t>(
                words.take(most, [&] { return place(y, i / layout.channels); }));
        with_channels(layout.channels, [&](auto constant) {
            constexpr unsigned kChannels = constant;
            fill_row<kChannels>(
                layout.row(image, y), layout.max, file.reading,
                [&](std::size_t x, std::size_t c) { return row[x * kChannels + c]; });
        });
    }
    return image;
}

// Only needed if maxval is not the largest number that its bytes can hold.
void check_samples(const Encoded& file, const unsigned char* bytes, std::size_t y,
                   const Layout& layout, bool is_wide) {
    if (layout.max == 255 || layout.max == 65535) return;
    for (std::size_t i = 0; i < layout.samples_a_row(); ++i) {
        const std::int32_t sample = is_wide ? bytes[2 * i] * 256 + bytes[2 * i + 1] : bytes[i];
        if (sample > layout.max)
            file.refuse(fmt::format("{} is {}: must be up to maxval, {}",
                                    place(y, i / layout.channels), sample, layout.max));
    }
}

Image read_bytes(const Encoded& file, std::string_view bytes, const Layout& layout) {
    const bool is_wide = layout.max > 255;
    const std::size_t row_size = layout.samples_a_row() * (is_wide ? 2 : 1);
    if (row_size * layout.size.rows > bytes.size())
        file.refuse(fmt::format("{} bytes of pixels: {} are announced, {} rows of {}", bytes.size(),
                                row_size * layout.size.rows, layout.size.rows, row_size));
    Image image = make_image(file, layout.size);
    const auto* pixels = reinterpret_cast<const unsigned char*>(bytes.data());
    for (std::size_t y = 0; y < image.rows; ++y, pixels += row_size) {
        check_samples(file, pixels, y, layout, is_wide);
        fill_row_from(pixels, layout.channels, is_wide, layout.row(image, y), layout.max,
                      file.reading);
    }
    return image;
}

}  // namespace

Image decode_netpbm(const Encoded& file) {
    const char kind = file.bytes[1];
    if (kind == '1' || kind == '4' || kind == '7')
        file.refuse(fmt::format("Netpbm's P{}: must be P2 or P5 (PGM), or P3 or P6 (PPM)", kind));
    Words words(file, file.bytes.substr(2));
    constexpr std::uint64_t kMost = 0xffff'ffffU;
    const std::uint64_t columns = words.take(kMost, [] { return "the width"; });
    const std::uint64_t rows = words.take(kMost, [] { return "the height"; });
    const auto max = static_cast<std::int32_t>(words.take(65535, [] { return "maxval"; }));
    if (max == 0) file.refuse("maxval is 0: must be 1 to 65535");
    const Layout layout{{columns, rows}, kind == '2' || kind == '5' ? 1U : 3U, max};
    check_size(file, layout.size);
    if (kind == '2' || kind == '3') return read_text(file, words, layout);
    // Exactly one blank ends the header: the next byte may be a pixel with the value of a blank.
    return read_bytes(file, words.rest().substr(words.rest().empty() ? 0 : 1), layout);
}

}  // namespace lacuna::pictures
