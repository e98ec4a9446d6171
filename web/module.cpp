// The functions that the page's worker calls, with numbers and bytes as arguments.
//
// A function that can fail returns false or null if it fails; lacuna_message() then says why. The
// last result is kept. Pointers to it are invalid after the next call.
#include <emscripten.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <new>
#include <string>

#include "base/number_text.h"
#include "lacuna_web.h"

namespace {

using namespace lacuna;

// Tells the page the fraction of the work that is done, 0 to 1.
EM_JS(void, tell_page, (double share), { Module["tell"](share); });

struct State {
    web::Pixels pixels;
    StippleOptions options;
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

// NaN from JavaScript means that no number was given.
bool is_given(double number) {
    return !std::isnan(number);
}

// Checks that a number that the user typed is whole.
std::uint64_t whole(const char* option, double number) {
    constexpr double kMost = 9007199254740992;  // 2^53: up to it JavaScript's numbers are exact
    if (!(number >= 0 && number <= kMost) || number != std::floor(number))
        throw BadRequest(option, shortest(number),
                         "must be a whole number from 0 to 9007199254740992");
    return static_cast<std::uint64_t>(number);
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

EMSCRIPTEN_KEEPALIVE void lacuna_tone(double black, double white, bool auto_levels, bool invert,
                                      double gamma, std::uint32_t sharpen) {
    Tone& tone = state().options.tone;
    tone.sharpen = sharpen;
    tone.black = black;
    tone.white = white;
    tone.auto_levels = auto_levels;
    tone.invert = invert;
    tone.gamma = gamma;
}

// Lengths are in mm. If `pen` is NaN, dots follow the darkness. If `width` is NaN: no paper.
EMSCRIPTEN_KEEPALIVE void lacuna_page(double pen, double width, double height, double margin,
                                      bool pen_path) {
    StippleOptions& options = state().options;
    options.pens.reset();
    options.paper.reset();
    if (is_given(pen)) options.pens = {pen, pen};
    if (is_given(width)) options.paper = {width, height, margin, true};
    options.pen_path = pen_path;
}

// `inks` is as for --inks, or empty.
EMSCRIPTEN_KEEPALIVE bool lacuna_dots(const char* inks, double size_by_tone, bool keep_inside) {
    return is_done([&] {
        StippleOptions& options = state().options;
        options.inks.clear();
        if (*inks != '\0') options.inks = inks_of(inks);
        options.size_by_tone = size_by_tone;
        options.keep_inside = keep_inside;
    });
}

// `count`: NaN for automatic. `metric`: 0 to 2 for min, mean, max; negative for the default.
EMSCRIPTEN_KEEPALIVE bool lacuna_stipple(double count, int metric, double relax, double seed) {
    return is_done([&] {
        State& now = state();
        now.options.request.count.reset();
        if (is_given(count)) now.options.request.count = whole("count", count);
        now.options.metric.reset();
        if (metric >= 0) now.options.metric = static_cast<Metric>(metric);
        now.options.relax = static_cast<std::uint32_t>(whole("relax", relax));
        now.options.request.seed = whole("seed", seed);
        now.set = {};
        now.set = web::stipple(now.pixels, now.options, tell_page);
    });
}

// Either `radius` or `count` must be NaN. `mode` is 0 (exact) or 1 (lines).
EMSCRIPTEN_KEEPALIVE bool lacuna_sample(double radius, double count, bool torus, int mode,
                                        double relax, double seed) {
    return is_done([&] {
        Request request;
        if (is_given(radius)) request.radius = radius;
        if (is_given(count)) request.count = whole("count", count);
        request.domain.boundary = torus ? Boundary::torus : Boundary::box;
        request.mode = mode == 0 ? Mode::exact : Mode::lines;
        request.seed = whole("seed", seed);
        const auto iterations = static_cast<std::uint32_t>(whole("relax", relax));
        state().set = {};
        state().set = web::sample(request, iterations, tell_page);
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
// Writes the inks as JSON to lacuna_text(): for each its dots, which come ink by ink, and its
// colour, 0xrrggbb.
EMSCRIPTEN_KEEPALIVE void lacuna_layers() {
    std::string& text = state().text = "[";
    for (const files::Layer& layer : state().set.layers) {
        const auto& [red, green, blue] = layer.ink.colour;
        text += text.size() == 1 ? "" : ",";
        text += "{\"dots\":" + std::to_string(layer.dots) +
                ",\"colour\":" + std::to_string(red * 0x10000 + green * 0x100 + blue) + "}";
    }
    text += "]";
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

// Writes the bytes of a file to lacuna_text().
EMSCRIPTEN_KEEPALIVE bool lacuna_encode(const char* format, const char* command) {
    return is_done([&] { state().text = web::encode(state().set, format, command); });
}
EMSCRIPTEN_KEEPALIVE const char* lacuna_text() {
    return state().text.data();
}
EMSCRIPTEN_KEEPALIVE std::size_t lacuna_text_size() {
    return state().text.size();
}

}  // extern "C"
