// Parts that several items' pictures use: page, legends, periodograms, fields and dots.
#pragma once

#include <lacuna/lacuna.h>

#include <array>
#include <memory>
#include <span>
#include <string>

#include "analysis/analyse.h"
#include "drawing/canvas.h"
#include "drawing/plot.h"
#include "reproduce/reproduce.h"
#include "reproduce/sets.h"

namespace lacuna::reproduce {

using drawing::Anchor;
using drawing::Axis;
using drawing::Canvas;
using drawing::Grid;
using drawing::Pen;
using drawing::Plot;
using drawing::Rectangle;

inline constexpr Colour kInk{0x22, 0x22, 0x22};
inline constexpr std::array kColours{drawing::kBlue,   drawing::kVermilion, drawing::kGreen,
                                     drawing::kPurple, drawing::kSky,       drawing::kOrange};

struct Key {
    std::string words;
    Pen pen;
};
// Draws a line for each key in the upper left corner of the box, or in the upper right one.
void draw_legend(Canvas& canvas, const Rectangle& box, std::span<const Key> keys,
                 Anchor corner = Anchor::start);

// Draws a title above a box.
void draw_title(Canvas& canvas, const Rectangle& box, const std::string& title);

// Whether the periodogram has kx to the right, as usual, or upwards.
enum class Turned { no, yes };
// Draws frequencies up to `farthest` sqrt(count). Power 0 is black; three times white noise's is
// white. A pixel is the mean of `block` x `block` frequencies, fewer at the rim.
void draw_periodogram(Canvas& canvas, const Rectangle& box, const analysis::Spectrum& spectrum,
                      double farthest, int block, Turned turned = Turned::no);

void draw_radial_power(Canvas& canvas, const Rectangle& box, const std::string& title,
                       const analysis::Radial& radial, Colour colour);
void draw_anisotropy(Canvas& canvas, const Rectangle& box, const std::string& title,
                     const analysis::Analysis& analysis, Colour colour);

// Draws the importance; dark is dense.
void draw_field(Canvas& canvas, const Rectangle& box, const Field& field);
// Draws all dots with one radius, in the domain's unit.
void draw_dots(Canvas& canvas, const Rectangle& box, std::span<const Point> points, double width,
               double height, double radius);

// Analyses sets on the torus of side 1. It is a small part of the work, and adds nothing to `work`.
analysis::Analysis analyse_on_torus(std::span<const std::vector<Point>> sets, double radius,
                                    Work& work);

// k r, mean power and anisotropy of the annuli up to `farthest` times sqrt(count).
nlohmann::ordered_json json_of(const analysis::Analysis& analysis, double farthest);

}  // namespace lacuna::reproduce
