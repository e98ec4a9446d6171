// Turns a picture into dots, like the command stipple. Link lacuna::extras.
//
// What is promised
//   - The same picture, options and seed give the same dots, bit for bit, on every backend and any
//     number of threads.
//   - There are exactly as many dots as were asked for; each lies in the domain, which is the
//     picture with a longer side of 1 and y upwards, and none where the importance is 0.
//   - Without relaxing, dots keep the distances of sample(); relaxed dots have cells of equal
//     darkness, as after relax() or, in inks, after place_inks().
//
//     const lacuna::Picture photo = lacuna::read_picture("photo.jpg");
//     const lacuna::Stippling dots = lacuna::stipple(photo, {.inks = lacuna::inks_of("cmyk")});
//     lacuna::write_stippling("dots.svg", dots);
#pragma once

#include <lacuna/export.h>
#include <lacuna/inks.h>
#include <lacuna/pictures.h>
#include <lacuna/relax.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace LACUNA_API lacuna {

// The diameters of dots that pens draw: where the importance is 0, and where it is 1.
struct Pens {
    double least_mm = 0;
    double most_mm = 0;
    // The pens there are, by their widths, ascending from least_mm to most_mm. Each dot is as wide
    // as one of them, and each pen has a layer of its own. Empty: dots may have any width between.
    std::vector<double> widths_mm{};
    friend bool operator==(const Pens&, const Pens&) = default;
};

// A sheet of paper. The domain lies in its middle, as large as the margins allow.
struct Paper {
    double width_mm = 0;
    double height_mm = 0;
    double margin_mm = 0;   // of stipple(): no ink lies in it
    bool may_turn = false;  // to landscape, if the picture is wider than high
};

// How fast a plotter is. The defaults are those of an AxiDraw V3 as it comes.
struct Plotter {
    double seconds_per_dot = 0.28;       // to lower and raise the pen
    double seconds_per_metre_down = 20;  // along lines and strokes, at full speed
    double seconds_per_metre_up = 6.6;   // between dots and strokes, at full speed
    // To stop and start again with the pen down, at full speed. In blunt corners and between short
    // segments, where the pen is slower, it is less. 0: the pen is at full speed all the way.
    double seconds_per_corner = 0.066;
    friend bool operator==(const Plotter&, const Plotter&) = default;
};

struct StippleOptions {
    // How many dots, by count or scale, and limit, boundary, seed, backend and so on. Without count
    // and scale there are as many dots as suit the picture's size and darkness, or the pens. The
    // domain and the field are the picture's; mode and metric are decided by the next members.
    Request request{};

    // How dots are placed before they are moved: stratified, cells or exact. Default: stratified if
    // they are relaxed, but cells if scale, metric, limit, lines_per_radius or round_size is given,
    // because a stratified set keeps no least distance. Without relaxing cells, and exact with
    // Tone::along.
    std::optional<Mode> start{};
    // Instead of placing new dots: the dots of the picture before this one in a sequence, which lie
    // in the domain. They are moved on, so that each changes its place little where the pictures
    // are alike, jumps if it is needed elsewhere, and keeps its index, except with several pens and
    // along a pen's path. A count must be their number. Not with inks, Tone::along, plot_seconds or
    // 0 for relax.
    std::vector<Point> start_points{};
    std::optional<Metric> metric{};  // default: mean in cells that are relaxed, else min
    // How often the dots are moved. Default: 15, but 0 with Tone::along.
    std::optional<std::uint32_t> relax{};

    Tone tone{};  // how the picture becomes importance

    // Without inks the picture is grey and the dots are black. Dots in inks begin stratified and
    // are relaxed at least once.
    std::vector<Ink> inks{};
    std::optional<double> black_ink{};        // of inks; default: kBlackInk
    std::vector<std::uint64_t> ink_counts{};  // the dots of each ink, in place of a count

    // How much of the tone is in the dots' sizes, 0 to 1: areas are proportional to importance to
    // this power, and dots as dense as importance over area.
    double size_by_tone = 0;
    // Dots as pens draw them, in inks that have no pen of their own (Ink::pen_mm). Unset: the dots'
    // ink is as much as the picture is dark.
    std::optional<Pens> pens{};
    // The width of the one pen that draws all dots, none of which is narrower: wider ones as
    // spirals without gaps or, with `circles`, as circles whose outer edges are the dots'. Unset:
    // there is a pen for each width.
    std::optional<double> pen_mm{};
    bool circles = false;
    std::optional<Paper> paper{};  // unset: the page is the picture, its longer side 512 points
    Colour paper_colour = kWhitePaper;  // inks are separated for it, and pictures show it
    // Keeps dots off white and in the picture: dots that overhang an edge are moved inwards, and in
    // a shape narrower than a dot they are smaller and denser, but not smaller than a pen.
    bool keep_inside = false;
    // Orders the dots of each ink along a short path. Default: if there are pens.
    std::optional<bool> pen_path{};
    // Draws that path as one line a layer in place of dots (Kaplan & Bosch 2005, TSP art). Dots lie
    // as densely as importance squared, so that the line has as much ink as the picture is dark.
    bool path_line = false;
    Plotter plotter{};
    // In place of a count: as many dots as the plotter draws in at most this time along that path,
    // in which they are ordered then. With pens there are no more than the picture needs.
    std::optional<double> plot_seconds{};

    bool measure = false;  // fill in Relaxed::evenness, as RelaxOptions::measure does
};

// What a plotter does for a layer: the length of the pen's path, in the domain's unit, and about
// how long it takes.
struct LayerPlot {
    double path_length = 0;
    double seconds = 0;
};

// The dots of a picture, and how they were made.
struct Stippling {
    // The request as it was settled: with its domain, mode, metric and count. Its field is null.
    Request request{};
    // The dots, ink by ink, in order of admission or of the pen's path. If they were moved, the
    // radius is the least distance of two dots, 0 if there are fewer.
    Result result{};
    std::vector<double> diameters{};  // of each dot, in the domain's unit
    // With Tone::along: of each dot. With a pen it is a stroke: 2 a long with its round ends, and
    // 2 b wide, as the pen is.
    std::vector<Ellipse> ellipses{};
    bool are_strokes = false;
    double pen_mm = 0;  // StippleOptions::pen_mm; 0: none
    bool circles = false;
    std::vector<Layer> layers{};       // the inks, or pens, and their dots; empty: black
    std::uint32_t iterations = 0;      // how often the dots were moved
    std::optional<Relaxed> relaxed{};  // how, without the points
    // As it lies for this picture. Its margin is wider than that of the options by as much as ink
    // reaches over the picture's edges, such as half of a pen's width.
    std::optional<Paper> paper{};
    Colour paper_colour = kWhitePaper;
    bool is_for_a_pen = false;  // whether dots were ordered along a path

    double darkness = 0;        // the mean of the importance, in inks of their sum
    std::uint32_t columns = 0;  // of the picture, in pixels
    std::uint32_t rows = 0;
    // With pens for all inks: how many dots, or lines through how many, would have the picture's
    // ink; 0 for strokes.
    double dots_for_ink = 0;
    // With pens or a pen's path: its length with all strokes, circles and spirals, in the domain's
    // unit, in the dots' order and in that of admission, and about how long a plotter takes.
    double path_length = 0;
    double admitted_length = 0;
    double plot_seconds = 0;
    std::vector<LayerPlot> layer_plots{};  // the same of each layer, or of all dots
    // With StippleOptions::plot_seconds: the picture needs no more dots than these.
    bool is_finished_sooner = false;
    double line_width = 0;  // with path_line: in the domain's unit, where the ink has no pen
};

// Throws BadRequest for options that stipple() refuses with every picture.
void check(const StippleOptions& options);

// Throws what sample() and relax() throw, and FileError for a picture that cannot be decoded or
// that has no importance.
Stippling stipple(const Picture& picture, const StippleOptions& options = {});
Stippling stipple(const Picture& picture, const StippleOptions& options, Observer& observer);

// The same for the importance of a picture or, in their order, of its inks; see StippleOptions.
// Options of the tone and the separation are not used.
Stippling stipple(std::vector<Field> importance, const StippleOptions& options, Observer& observer);

// Writes the dots in the format of the path's extension, as write_points() does: pictures (.svg
// .pdf .png) with each dot's size and ink, .csv .npy .ply .json with each dot's ink. Throws what
// write_points() throws.
void write_stippling(const std::string& path, const Stippling& stippling);

}  // namespace lacuna
