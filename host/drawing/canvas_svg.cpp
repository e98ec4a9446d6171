// The canvas that writes SVG, as text.
//
// Cairo is not used for two reasons. It numbers the surfaces of the whole process, so a second call
// gives other bytes; and its text is outlines, which nobody can search or edit.
#include "drawing/canvas.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "drawing/png.h"
#include "drawing/xml.h"
#include "files/point_files.h"

namespace lacuna::drawing {
namespace {

std::string base64_of(const std::string& bytes) {
    // Base64 takes four letters for three bytes, and OpenSSL adds a zero at the end.
    std::string letters((bytes.size() + 2) / 3 * 4 + 1, '\0');
    // The casts are safe: both are arrays of bytes, which OpenSSL declares unsigned.
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(letters.data()),
                                       reinterpret_cast<const unsigned char*>(bytes.data()),
                                       static_cast<int>(bytes.size()));
    letters.resize(static_cast<std::size_t>(length));
    return letters;
}

std::string png_of(const Image& image) {
    const Png shape{.columns = static_cast<std::uint32_t>(image.width),
                    .rows = static_cast<std::uint32_t>(image.height)};
    return encode_png(shape, [&](std::size_t y, std::span<std::uint8_t> bytes) {
        std::copy_n(&image.greys[y * bytes.size()], bytes.size(), bytes.begin());
    });
}

std::string_view name_of(Anchor anchor) {
    if (anchor == Anchor::middle) return "middle";
    return anchor == Anchor::end ? "end" : "start";
}

class SvgCanvas : public Canvas {
public:
    SvgCanvas(double width, double height) {
        bytes_ = fmt::format(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.9g}pt\" height=\"{1:.9g}pt\" "
            "viewBox=\"0 0 {0:.9g} {1:.9g}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
            "<rect width=\"{0:.9g}\" height=\"{1:.9g}\" fill=\"white\"/>\n",
            width, height);
    }

    void line(std::span<const Position> positions, const Pen& pen, const Rectangle& clip) override {
        add("<path clip-path=\"url(#{})\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.9g}\" "
            "stroke-linejoin=\"round\"{} d=\"",
            clip_for(clip), files::hex_of(pen.colour), pen.width,
            pen.dashed ? " stroke-dasharray=\"4 3\"" : "");
        std::string_view step = "M";
        for (const Position& position : positions) {
            add("{}{:.2f} {:.2f}", step, position.x, position.y);
            step = "L";
        }
        bytes_ += "\"/>\n";
    }

    void dots(std::span<const Position> centres, double radius, const Rectangle& clip) override {
        // Lines of almost no length with round caps take a tenth of the bytes of circles.
        add("<path clip-path=\"url(#{})\" fill=\"none\" stroke=\"black\" stroke-linecap=\"round\" "
            "stroke-width=\"{:.4g}\" d=\"",
            clip_for(clip), 2 * radius);
        for (const Position& centre : centres) add("M{:.3f} {:.3f}h0.01\n", centre.x, centre.y);
        bytes_ += "\"/>\n";
    }

    void frame(const Rectangle& box, const Pen& pen) override {
        add("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" "
            "stroke=\"{}\" stroke-width=\"{:.9g}\"/>\n",
            box.left, box.top, box.width, box.height, files::hex_of(pen.colour), pen.width);
    }

    void text(Position at, const std::string& utf8, const TextStyle& style) override {
        add("<text x=\"{0:.2f}\" y=\"{1:.2f}\" font-size=\"{2:.9g}\" text-anchor=\"{3}\" "
            "fill=\"{4}\"{5}{6}>{7}</text>\n",
            at.x, at.y, style.size, name_of(style.anchor), files::hex_of(style.colour),
            style.bold ? " font-weight=\"bold\"" : "",
            style.upwards ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", at.x, at.y)
                          : "",
            in_xml(utf8));
    }

    void image(const Rectangle& box, const Image& image) override {
        add("<image x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
            "preserveAspectRatio=\"none\" image-rendering=\"pixelated\" "
            "href=\"data:image/png;base64,{}\"/>\n",
            box.left, box.top, box.width, box.height, base64_of(png_of(image)));
    }

    std::string finish() override { return std::move(bytes_) + "</svg>\n"; }

private:
    template <class... Values>
    void add(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(bytes_), format, std::forward<Values>(values)...);
    }

    std::string clip_for(const Rectangle& box) {
        const std::string name = fmt::format("clip{}", ++clips_);
        add("<clipPath id=\"{}\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
            "height=\"{:.2f}\"/></clipPath>\n",
            name, box.left, box.top, box.width, box.height);
        return name;
    }

    std::string bytes_;
    int clips_ = 0;
};

}  // namespace

std::unique_ptr<Canvas> make_svg_canvas(double width, double height) {
    return std::make_unique<SvgCanvas>(width, height);
}

}  // namespace lacuna::drawing
