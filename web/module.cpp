// The functions that the page's worker calls, with numbers and bytes as arguments.
//
// A function that can fail returns false or null if it fails; lacuna_message() then says why. The
// last result is kept. Pointers to it are invalid after the next call.
#include <emscripten.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "base/number_text.h"
#include "lacuna_web.h"
#include "options/options.h"

namespace {

using namespace lacuna;

// Tells the page the fraction of the work that is done, 0 to 1.
EM_JS(void, tell_page, (double share), { Module["tell"](share); });

struct State {
    web::Pixels pixels;
    web::Set set;
    web::Spectrum spectrum;
    std::string text;  // a file, or the verdict on the set
    std::string message;
};

State& state() {
    static State only;
    return only;
}

template <typename Work>
bool is_done(const Work& work) {
    try {
        work();
        return true;
    } catch (const std::bad_alloc&) {
        state().message = "there is not enough memory for this number of points or pixels";
    } catch (const std::exception& error) {
        state().message = error.what();
    }
    return false;
}

// The command line of a form: the name of the command, then each option and its text, all ended by
// a line end. A flag has no text.
options::CommandLine line_of(std::string_view form) {
    const auto next = [&form] {
        const std::string_view line = form.substr(0, form.find('\n'));
        form.remove_prefix(std::min(line.size() + 1, form.size()));
        return line;
    };
    options::CommandLine line{options::command_called(next()).value(), {}};
    while (!form.empty()) {
        line.given.push_back({next(), {}});
        if (const std::string_view text = next(); !text.empty())
            line.given.back().values.emplace_back(text);
    }
    return line;
}

int number_of(const Colour& colour) {
    return colour[0] * 0x10000 + colour[1] * 0x100 + colour[2];
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* lacuna_message() {
    return state().message.c_str();
}

// Memory for the pixels, 4 bytes each.
EMSCRIPTEN_KEEPALIVE std::uint8_t* lacuna_room_for_pixels(std::uint32_t columns,
                                                          std::uint32_t rows) {
    const bool done = is_done([&] {
        web::Pixels& pixels = state().pixels;
        pixels.columns = columns;
        pixels.rows = rows;
        pixels.rgba.resize(std::size_t{4} * columns * rows);
    });
    return done ? state().pixels.rgba.data() : nullptr;
}

// Writes the command line of a form to lacuna_text(), with the output `file`.
EMSCRIPTEN_KEEPALIVE bool lacuna_command(const char* form, const char* file) {
    return is_done([&] {
        state().text = web::command_of(line_of(form)) + " -o " + options::quoted_path(file);
    });
}

// Makes the set of a form.
EMSCRIPTEN_KEEPALIVE bool lacuna_make(const char* form) {
    return is_done([&] {
        state().set = {};
        state().set = web::make(state().pixels, line_of(form), tell_page);
    });
}

EMSCRIPTEN_KEEPALIVE double lacuna_count() {
    return static_cast<double>(state().set.points.size());
}
EMSCRIPTEN_KEEPALIVE const double* lacuna_points() {
    return state().set.points.empty() ? nullptr : &state().set.points.front().x;
}
// One for each point, or null.
EMSCRIPTEN_KEEPALIVE const double* lacuna_diameters() {
    return state().set.diameters.empty() ? nullptr : state().set.diameters.data();
}
// Three numbers for each point: the radii and the angle of its ellipse or stroke. Or null.
EMSCRIPTEN_KEEPALIVE const double* lacuna_ellipses() {
    return state().set.ellipses.empty() ? nullptr : &state().set.ellipses.front().a;
}
EMSCRIPTEN_KEEPALIVE bool lacuna_are_strokes() {
    return state().set.style.are_strokes;
}
// Of a line through the dots; 0 without one.
EMSCRIPTEN_KEEPALIVE double lacuna_line_width() {
    return state().set.style.line_width;
}
// Writes the layers, which are inks or pens, as JSON to lacuna_text(): for each its name, its dots,
// which come layer by layer, its colour, 0xrrggbb, the width of its pen in mm or 0, and 1 if it is
// opaque.
EMSCRIPTEN_KEEPALIVE void lacuna_layers() {
    std::string& text = state().text = "[";
    for (const files::Layer& layer : state().set.layers) {
        text += text.size() == 1 ? "" : ",";
        text += "{\"name\":\"" + layer.ink.name + "\",\"dots\":" + std::to_string(layer.dots) +
                ",\"colour\":" + std::to_string(number_of(layer.ink.colour)) +
                ",\"pen\":" + shortest(layer.ink.pen_mm) + ",\"opaque\":" +
                std::to_string(layer.ink.is_opaque_on(state().set.style.paper_colour)) + "}";
    }
    text += "]";
}
EMSCRIPTEN_KEEPALIVE int lacuna_paper_colour() {
    return number_of(state().set.style.paper_colour);
}
// Writes what the page says of a plot to lacuna_text().
EMSCRIPTEN_KEEPALIVE void lacuna_plot() {
    state().text = state().set.plot;
}
EMSCRIPTEN_KEEPALIVE double lacuna_width() {
    return state().set.domain.width;
}
EMSCRIPTEN_KEEPALIVE double lacuna_height() {
    return state().set.domain.height;
}
EMSCRIPTEN_KEEPALIVE double lacuna_radius() {
    return state().set.radius;
}

// Writes the verdict as JSON to lacuna_text().
EMSCRIPTEN_KEEPALIVE bool lacuna_prove(double radius) {
    return is_done([&] {
        const Proof proof = web::prove(state().set, radius);
        const auto number = [](double value) {
            return std::isfinite(value) ? shortest(value) : std::string("null");
        };
        const auto truth = [](bool value) { return value ? "true" : "false"; };
        state().text =
            std::string("{\"kept\":") + truth(proof.kept) + ",\"covered\":" + truth(proof.covered) +
            ",\"maximal\":" + truth(proof.maximal) + ",\"least\":" + number(proof.least_distance) +
            ",\"largestGap\":" + number(proof.largest_gap_distance) + "}";
    });
}

EMSCRIPTEN_KEEPALIVE bool lacuna_spectrum(double most) {
    return is_done([&] { state().spectrum = web::spectrum(state().set, most, tell_page); });
}
EMSCRIPTEN_KEEPALIVE std::uint32_t lacuna_spectrum_side() {
    return state().spectrum.side;
}
EMSCRIPTEN_KEEPALIVE const float* lacuna_powers() {
    return state().spectrum.powers.data();
}
EMSCRIPTEN_KEEPALIVE std::size_t lacuna_radial_size() {
    return state().spectrum.radial.size();
}
EMSCRIPTEN_KEEPALIVE const double* lacuna_radial() {
    return state().spectrum.radial.data();
}

// Writes the paper as JSON to lacuna_text(): its width, height and margin in mm, or null.
EMSCRIPTEN_KEEPALIVE void lacuna_paper() {
    const std::optional<Paper>& paper = state().set.style.sheet;
    state().text = "null";
    if (paper)
        state().text = "[" + shortest(paper->width_mm) + "," + shortest(paper->height_mm) + "," +
                       shortest(paper->margin_mm) + "]";
}

// Writes the bytes of a file to lacuna_text().
EMSCRIPTEN_KEEPALIVE bool lacuna_encode(const char* format) {
    return is_done([&] { state().text = web::encode(state().set, format); });
}
EMSCRIPTEN_KEEPALIVE const char* lacuna_text() {
    return state().text.data();
}
EMSCRIPTEN_KEEPALIVE std::size_t lacuna_text_size() {
    return state().text.size();
}

}  // extern "C"
