// The canvas of a plot: lines, text, dots and grey images, as svg, pdf or png.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "files/medium.h"
#include "files/point_files.h"

namespace lacuna::drawing {

using files::Medium;

// A position on the page in points; x goes right and y down from the upper left corner.
using Position = Point;

struct Rectangle {
    double left;
    double top;
    double width;
    double height;

    double right() const { return left + width; }
    double bottom() const { return top + height; }
};

// Colours that colour-blind readers can tell apart (Okabe & Ito 2008).
inline constexpr Colour kBlue{0x00, 0x72, 0xb2}, kSky{0x56, 0xb4, 0xe9}, kGreen{0x00, 0x9e, 0x73},
    kOrange{0xe6, 0x9f, 0x00}, kVermilion{0xd5, 0x5e, 0x00}, kPurple{0xcc, 0x79, 0xa7};

struct Pen {
    Colour colour;
    double width;
    bool dashed = false;
};

enum class Anchor { start, middle, end };

struct TextStyle {
    double size;
    Anchor anchor = Anchor::start;
    Colour colour{0, 0, 0};
    bool bold = false;
    bool upwards = false;  // turned to the left by a quarter turn
};

// A grey image; the top row comes first; 0 is black, 255 is white.
struct Image {
    int width;
    int height;
    std::vector<std::uint8_t> greys;
};

class Canvas {
public:
    virtual ~Canvas() = default;

    // Draws a line through all positions in turn; the parts outside `clip` are cut off.
    virtual void line(std::span<const Position> positions, const Pen& pen,
                      const Rectangle& clip) = 0;
    // Draws black disks; the parts outside `clip` are cut off.
    virtual void dots(std::span<const Position> centres, double radius, const Rectangle& clip) = 0;
    virtual void frame(const Rectangle& box, const Pen& pen) = 0;
    virtual void text(Position at, const std::string& utf8, const TextStyle& style) = 0;
    // Fills the box with the image, whose pixels stay sharp squares.
    virtual void image(const Rectangle& box, const Image& image) = 0;

    // Returns the bytes of the file. Nothing may be drawn afterwards.
    virtual std::string finish() = 0;
};

// A white page, in points; a png has two pixels a point. The same drawing gives the same bytes on
// every call if the same fonts are installed. All errors are files::FileError with cairo's reason.
std::unique_ptr<Canvas> make_canvas(Medium medium, double width, double height);

// The canvas of an svg, which make_canvas() chooses.
std::unique_ptr<Canvas> make_svg_canvas(double width, double height);

}  // namespace lacuna::drawing
