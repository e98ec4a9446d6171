// All capabilities of stipple(), which two of them exclude each other, and random options with the
// levels of a row.
#pragma once

#include <lacuna/stipple.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hostile/door_to_c.h"
#include "hostile/pairs.h"
#include "hostile/random_parts.h"

namespace lacuna::tests {

enum OfStipple : std::size_t {
    kStart,
    kMoves,
    kDots,
    kCut,
    kWraps,
    kInks,
    kInkCounts,
    kBlackInk,
    kTone,
    kAlong,
    kSizes,
    kPaper,
    kColour,
    kHeldInside,
    kPath,
    kPlotter,
    kM,
    kRoundSize,
    kMetricOfDots,
    kWorkers
};

inline const Tables kStippling{
    {
        {"start", {"default", "stratified", "cells", "exact", "points"}},
        {"moves", {"default", "none", "few"}},
        {"dots", {"of the picture", "count", "scale", "plot time"}},
        {"cut", {"no", "yes"}},
        {"wraps", {"no", "yes"}},
        {"inks", {"none", "one", "several", "pens"}},
        {"ink-counts", {"no", "yes"}},
        {"black-ink", {"default", "given"}},
        {"tone", {"plain", "levels", "inverted", "sharpened"}},
        {"along", {"no", "yes"}},
        {"sizes", {"one", "by tone", "a pen", "pens by tone", "several pens"}},
        {"paper", {"none", "a sheet"}},
        {"colour", {"white", "another"}},
        {"keep-inside", {"no", "yes"}},
        {"path", {"no", "of a pen", "a line"}},
        {"plotter", {"default", "given"}},
        {"m", {"default", "given"}},
        {"round-size", {"automatic", "given"}},
        {"metric-of-dots", {"default", "given"}},
        {"workers", {"one", "several"}},
    },
    {
        {kStart, "stratified", kMoves, "none", {"mode"}},
        {kStart, "stratified", kDots, "scale", {"scale"}},
        {kStart, "stratified", kCut, "yes", {"limit"}},
        {kStart, "stratified", kM, "given", {"lines-per-radius"}},
        {kStart, "stratified", kRoundSize, "given", {"round-size"}},
        {kStart, "stratified", kMetricOfDots, "given", {"metric"}},
        {kStart, "stratified", kAlong, "yes", {"along"}},
        {kStart, "exact", kMetricOfDots, "given", {"metric"}},
        {kStart, "cells", kAlong, "yes", {"along"}},
        {kStart, "cells", kInks, "!none", {"mode"}},
        {kStart, "exact", kInks, "!none", {"mode"}},
        {kStart, "points", kInks, "!none", {"start-points"}},
        {kStart, "points", kAlong, "yes", {"start-points"}},
        {kStart, "points", kDots, "scale", {"start-points"}},
        {kStart, "points", kDots, "plot time", {"start-points"}},
        {kStart, "points", kMetricOfDots, "given", {"start-points"}},
        {kStart, "points", kCut, "yes", {"start-points"}},
        {kStart, "points", kM, "given", {"start-points"}},
        {kStart, "points", kRoundSize, "given", {"start-points"}},
        {kStart, "points", kMoves, "none", {"start-points"}},
        {kMoves, "few", kAlong, "yes", {"along"}},
        {kMoves, "none", kInks, "!none", {"relax"}},
        {kAlong, "yes", kInks, "!none", {"along"}},
        {kAlong, "yes", kMetricOfDots, "given", {"metric"}},
        {kAlong, "yes", kSizes, "several pens", {"pens"}},
        {kAlong, "yes", kSizes, "pens by tone", {"dot-size"}},
        {kAlong, "yes", kHeldInside, "yes", {}},  // refused with a pen
        {kAlong, "yes", kDots, "plot time", {}},  // strokes alone may take longer
        {kAlong, "yes", kWraps, "yes", {}},       // an ellipse may be longer than the domain
        {kInks, "!none", kMetricOfDots, "given", {"metric"}},
        {kInks, "!none", kDots, "scale", {"scale"}},
        {kInks, "!none", kCut, "yes", {"limit"}},
        {kInks, "!none", kM, "given", {"lines-per-radius"}},
        {kInks, "!none", kRoundSize, "given", {"round-size"}},
        {kInks, "none", kInkCounts, "yes", {"ink-counts"}},
        {kInks, "none", kBlackInk, "given", {"black-ink"}},
        {kInks, "pens", kSizes, "by tone", {"size-by-tone"}},
        {kInkCounts, "yes", kDots, "count", {"ink-counts"}},
        {kInkCounts, "yes", kDots, "plot time", {"plot-time"}},
        {kBlackInk, "given", kColour, "another", {"black-ink"}},
        {kDots, "plot time", kCut, "yes", {"plot-time"}},
        {kPath, "a line", kAlong, "yes", {"path-line"}},
        {kPath, "a line", kSizes, "by tone", {"path-line"}},
        {kPath, "a line", kSizes, "pens by tone", {"path-line"}},
        {kPath, "a line", kSizes, "several pens", {"path-line"}},
        {kPath, "a line", kHeldInside, "yes", {"path-line"}},
        {kPath, "a line", kDots, "scale", {"path-line"}},
        {kPath, "no", kPlotter, "given", {}},  // needs a path or a pen
    },
};

// A picture, and options to make dots of it.
struct Drawing {
    Row row;
    StippleOptions options;
    Picture picture;
    std::string words;  // for lacuna_stipple(); empty if options cannot express it

    bool is(std::size_t capability, std::string_view level) const {
        return is_level(kStippling, row, capability, level);
    }
};

class RandomDrawing {
public:
    RandomDrawing(std::uint64_t seed, std::uint64_t number, const Row& row)
        : choose_(seed, number), made_{row, {}, {}, {}} {}

    Drawing make() {
        draw();
        choose_dots();
        choose_tone();
        choose_inks();
        choose_pens();
        made_.options.request.seed = choose_.below(1000);
        line_.add("seed", made_.options.request.seed);
        made_.options.request.run_on.threads = is(kWorkers, "one") ? 1 : 2 + choose_.below(3);
        if (!is(kStart, "points") && !is(kAlong, "yes")) made_.words = line_.text();
        return made_;
    }

private:
    bool is(std::size_t capability, std::string_view level) const {
        return made_.is(capability, level);
    }

    // A .pgm or, for inks, a .ppm of few pixels: at random, a ramp, or black on white.
    void draw() {
        columns_ = 3 + choose_.below(24);
        rows_ = 3 + choose_.below(24);
        const std::uint32_t kind = choose_.below(3);
        const std::uint32_t bands = is(kInks, "none") ? 1 : 3;
        std::string pixels;
        for (std::uint32_t i = 0; i < columns_ * rows_ * bands; ++i)
            pixels += static_cast<char>(kind == 0   ? choose_.below(256)
                                        : kind == 1 ? 255 * (i / bands % columns_) / columns_
                                                    : choose_.below(2) * 255);
        pixels[pixels.size() / 2] = 40;
        made_.picture = {(bands == 1 ? "P5 " : "P6 ") + std::to_string(columns_) + " " +
                             std::to_string(rows_) + " 255\n" + pixels,
                         "drawing"};
    }

    void choose_dots() {
        StippleOptions& options = made_.options;
        Request& request = options.request;
        if (!is(kStart, "default") && !is(kStart, "points")) {
            constexpr std::array kStarts{Mode::exact, Mode::stratified, Mode::cells, Mode::exact};
            options.start = kStarts[made_.row[kStart]];
            line_.add("start", name_of(*options.start));
        }
        const std::uint32_t count = 1 + choose_.some(300);
        if (is(kStart, "points")) {
            const Domain domain = domain_like(columns_, rows_);
            for (std::uint32_t i = 0; i < count; ++i)
                options.start_points.push_back(judge::any_place(choose_.random(), domain));
        }
        if (!is(kMoves, "default")) {
            options.relax = is(kMoves, "none") ? 0 : 1 + choose_.below(3);
            line_.add("relax", *options.relax);
        }
        if (is(kDots, "count")) line_.add("count", *(request.count = count));
        if (is(kDots, "scale")) line_.add("scale", *(request.scale = choose_.power(0.03, 0.3)));
        if (is(kDots, "plot time"))
            line_.add("plot-time", *(options.plot_seconds = 5 + choose_.below(50)), "s");
        if (is(kCut, "yes")) line_.add("limit", *(request.limit = 1 + choose_.below(60)));
        if (is(kM, "given"))
            line_.add("lines-per-radius",
                      *(request.paper2011.lines_per_radius = 1 + choose_.below(12)));
        if (is(kRoundSize, "given"))
            line_.add("round-size", request.paper2011.round_size = 2 + choose_.below(40));
        if (is(kMetricOfDots, "given")) {
            options.metric = std::array{Metric::mean, Metric::max}[choose_.below(2)];
            line_.add("metric", name_of(*options.metric));
        }
        if (is(kWraps, "no")) return;
        request.domain.boundary = Boundary::torus;
        line_.add("torus");
    }

    void choose_tone() {
        Tone& tone = made_.options.tone;
        if (is(kTone, "levels")) {
            line_.add("black", tone.black = choose_.in(0, 0.3));
            line_.add("white", tone.white = choose_.in(0.6, 1));
            line_.add("gamma", tone.gamma = choose_.power(0.4, 2.5));
        }
        if (is(kTone, "inverted")) {
            tone.invert = true;
            line_.add("invert");
            line_.add("min-importance", tone.min_importance = choose_.in(0.01, 0.2));
        }
        if (is(kTone, "sharpened")) {
            tone.auto_levels = true;
            line_.add("auto-levels");
            line_.add("sharpen", tone.sharpen = 1 + choose_.below(5), ":",
                      tone.sharpen_amount = choose_.power(0.2, 5));
        }
        if (is(kAlong, "yes")) tone.along = 1 + choose_.in(0.1, 3);
    }

    void choose_inks() {
        StippleOptions& options = made_.options;
        if (is(kColour, "another")) {
            options.paper_colour = paper_of("#e0d8c0");
            line_.add("paper-colour", "#e0d8c0");
        }
        if (!is(kInks, "none")) {
            const std::string inks = is(kInks, "one")       ? "#223388"
                                     : is(kInks, "several") ? "red,#0000ff,black"
                                                            : "red:0.4mm,black:0.7mm";
            options.inks = inks_of(inks);
            line_.add("inks", inks);
        }
        if (is(kInkCounts, "yes")) {
            std::string counts;
            for (std::size_t i = 0; i < std::max<std::size_t>(options.inks.size(), 1); ++i) {
                options.ink_counts.push_back(1 + choose_.below(80));
                counts += (i == 0 ? "" : ",") + std::to_string(options.ink_counts.back());
            }
            line_.add("ink-counts", counts);
        }
        if (is(kBlackInk, "given")) line_.add("black-ink", *(options.black_ink = choose_.in(0, 1)));
    }

    void choose_pens() {
        StippleOptions& options = made_.options;
        if (is(kSizes, "by tone"))
            line_.add("size-by-tone", options.size_by_tone = choose_.in(0.05, 1));
        const double pen = choose_.power(1, 5), wide = pen * choose_.power(1.1, 3);
        if (is(kSizes, "a pen")) {
            options.pens = Pens{pen, pen};
            line_.add("dot-size", pen, "mm");
        }
        if (is(kSizes, "pens by tone")) {
            options.pens = Pens{pen, wide};
            line_.add("dot-size", pen, "mm..", wide, "mm");
            if (!is(kInks, "pens") && !is(kAlong, "yes") && !is(kPath, "a line") &&
                choose_.below(2) == 0)
                line_.add("pen", *(options.pen_mm = pen / 2), "mm");
            if (options.pen_mm)
                line_.add("dot-style",
                          (options.circles = choose_.below(2) == 0) ? "circle" : "spiral");
        }
        if (is(kSizes, "several pens")) {
            options.pens = Pens{pen, wide, {pen, wide}};
            line_.add("pens", pen, "mm,", wide, "mm");
        }
        if (is(kPaper, "a sheet")) {
            options.paper = Paper{148, 210, 15, true};
            line_.add("paper-size", "A5");
            line_.add("margin", "15mm");
        }
        options.keep_inside = is(kHeldInside, "yes");
        if (options.keep_inside) line_.add("keep-inside");
        options.path_line = is(kPath, "a line");
        if (options.path_line) line_.add("path-line");
        if (is(kPath, "of a pen")) {
            options.pen_path = true;
            line_.add("pen-path");
        }
        if (is(kPlotter, "given"))
            line_.add("seconds-per-dot", options.plotter.seconds_per_dot = choose_.power(0.05, 1));
    }

    Chooser choose_;
    Drawing made_;
    OptionsText line_;
    std::uint32_t columns_ = 0, rows_ = 0;
};

}  // namespace lacuna::tests
