// The canvases that cairo draws, pdf and png, and the choice of the canvas for a format.
#include "drawing/canvas.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <string>
#include <utility>

#include "drawing/cairo_surface.h"
#include "drawing/picture.h"

namespace lacuna::drawing {
namespace {

constexpr double kPixelsPerPoint = 2;

// The image in opaque grey. Cairo demands its own alignment of rows.
Surface surface_of(const Image& image) {
    Surface surface =
        drawing::checked(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height));
    unsigned char* pixels = cairo_image_surface_get_data(surface.get());
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t row = 0; row < static_cast<std::size_t>(image.height); ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            const std::uint32_t grey = image.greys[row * width + column];
            const std::uint32_t pixel = (grey << 16U) | (grey << 8U) | grey;
            std::memcpy(pixels + row * stride + column * sizeof pixel, &pixel, sizeof pixel);
        }
    }
    cairo_surface_mark_dirty(surface.get());
    return surface;
}

void set_clip(cairo_t* context, const Rectangle& box) {
    cairo_rectangle(context, box.left, box.top, box.width, box.height);
    cairo_clip(context);
}

// Saves cairo's state and restores it in the destructor.
class Saved {
public:
    explicit Saved(cairo_t* context) : context_(context) { cairo_save(context); }
    ~Saved() { cairo_restore(context_); }
    Saved(const Saved&) = delete;
    Saved& operator=(const Saved&) = delete;

private:
    cairo_t* context_;
};

class CairoCanvas : public Canvas {
public:
    CairoCanvas(Medium medium, double width, double height)
        : is_pdf_(medium == Medium::pdf), surface_(make_surface(width, height)) {
        context_.reset(cairo_create(surface_.get()));
        check(cairo_status(context_.get()));
        if (!is_pdf_) cairo_scale(context_.get(), kPixelsPerPoint, kPixelsPerPoint);
        set_colour(context_.get(), {255, 255, 255});
        cairo_paint(context_.get());
    }

    void line(std::span<const Position> positions, const Pen& pen, const Rectangle& clip) override {
        const Saved saved(context_.get());
        set_clip(context_.get(), clip);
        use(pen);
        for (const Position& position : positions)
            cairo_line_to(context_.get(), position.x, position.y);
        cairo_stroke(context_.get());
        check(cairo_status(context_.get()));
    }

    void dots(std::span<const Position> centres, double radius, const Rectangle& clip) override {
        // A stroke this short keeps the working memory of cairo, and of viewers, small.
        constexpr std::size_t kDotsPerStroke = 4096;
        const Saved saved(context_.get());
        set_clip(context_.get(), clip);
        set_colour(context_.get(), {0, 0, 0});
        cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
        cairo_set_line_width(context_.get(), 2 * radius);
        for (std::size_t i = 0; i < centres.size(); ++i) {
            add_dot(centres[i], radius);
            if (i % kDotsPerStroke == kDotsPerStroke - 1) draw_dots();
        }
        draw_dots();
        check(cairo_status(context_.get()));
    }

    void frame(const Rectangle& box, const Pen& pen) override {
        const Saved saved(context_.get());
        use(pen);
        cairo_rectangle(context_.get(), box.left, box.top, box.width, box.height);
        cairo_stroke(context_.get());
        check(cairo_status(context_.get()));
    }

    void text(Position at, const std::string& utf8, const TextStyle& style) override {
        const Saved saved(context_.get());
        set_colour(context_.get(), style.colour);
        cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                               style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
        cairo_set_font_size(context_.get(), style.size);
        cairo_text_extents_t extents{};
        cairo_text_extents(context_.get(), utf8.c_str(), &extents);
        cairo_translate(context_.get(), at.x, at.y);
        if (style.upwards) cairo_rotate(context_.get(), -std::acos(0.0));
        const double share = style.anchor == Anchor::start    ? 0
                             : style.anchor == Anchor::middle ? 0.5
                                                              : 1;
        cairo_move_to(context_.get(), -share * extents.x_advance, 0);
        cairo_show_text(context_.get(), utf8.c_str());
        check(cairo_status(context_.get()));
    }

    void image(const Rectangle& box, const Image& image) override {
        const Saved saved(context_.get());
        const Surface pixels = surface_of(image);
        cairo_translate(context_.get(), box.left, box.top);
        cairo_scale(context_.get(), box.width / image.width, box.height / image.height);
        cairo_set_source_surface(context_.get(), pixels.get(), 0, 0);
        cairo_pattern_set_filter(cairo_get_source(context_.get()), CAIRO_FILTER_NEAREST);
        cairo_rectangle(context_.get(), 0, 0, image.width, image.height);
        cairo_fill(context_.get());
        check(cairo_status(context_.get()));
    }

    std::string finish() override {
        context_.reset();
        if (is_pdf_) {
            cairo_surface_finish(surface_.get());
            check(cairo_surface_status(surface_.get()));
        } else {
            bytes_ = drawing::png_of(surface_.get(), kPixelsPerPoint * kPointsPerInch);
        }
        return std::move(bytes_);
    }

private:
    Surface make_surface(double width, double height) {
        if (!is_pdf_)
            return drawing::checked(cairo_image_surface_create(
                CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(width * kPixelsPerPoint)),
                static_cast<int>(std::lround(height * kPixelsPerPoint))));
        Surface surface = drawing::checked(
            cairo_pdf_surface_create_for_stream(drawing::append_to_string, &bytes_, width, height));
        // Otherwise cairo would write the time of day, and two files would never be equal.
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                       "2000-01-01T00:00:00Z");
        return surface;
    }

    // A dot is a line of length 0, but in a pdf a circle: some viewers draw such lines as ovals.
    void add_dot(Position centre, double radius) {
        if (is_pdf_) {
            cairo_new_sub_path(context_.get());
            cairo_arc(context_.get(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
        } else {
            cairo_move_to(context_.get(), centre.x, centre.y);
            cairo_line_to(context_.get(), centre.x, centre.y);
        }
    }

    void draw_dots() {
        if (is_pdf_) {
            cairo_fill(context_.get());
        } else {
            cairo_stroke(context_.get());
        }
    }

    void use(const Pen& pen) {
        set_colour(context_.get(), pen.colour);
        cairo_set_line_width(context_.get(), pen.width);
        cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
        constexpr std::array kDashes{4.0, 3.0};
        if (pen.dashed) cairo_set_dash(context_.get(), kDashes.data(), kDashes.size(), 0);
    }

    bool is_pdf_;
    std::string bytes_;  // declared before the surface, which writes into it
    Surface surface_;
    Context context_;
};

}  // namespace

std::unique_ptr<Canvas> make_canvas(Medium medium, double width, double height) {
    if (medium == Medium::svg) return make_svg_canvas(width, height);
    return std::make_unique<CairoCanvas>(medium, width, height);
}

}  // namespace lacuna::drawing
