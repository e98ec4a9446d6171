// The rows of the table of options. The file is long because it is the only list of them.
#include "options/options.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <iterator>
#include <utility>

namespace lacuna::options {
namespace {

// An option, and its help. {read}, {written} and {pictures} stand for the extensions of the files
// that can be read, written, and written as pictures.
struct Row {
    Option option;
    std::string_view help;
};

constexpr Commands kUniform = kSample | kCompare | kMpiSample;  // radius, count, domain
constexpr Commands kPlaced = kSample | kVerify;                 // in polygons, around others
constexpr Commands kMoved = kRelax | kOrder;                    // points that are there
constexpr Commands kPicture = kStipple | kCompare | kPlaced | kMoved;
constexpr Commands kMade = kSample | kStipple | kCompare | kMpiSample;
constexpr Commands kDrawn = kSample | kStipple | kMoved;
constexpr Commands kReported = kSample | kStipple | kRelax;

// The rows below belong to it, in --help. It is no option of any command.
constexpr Row heading(std::string_view text) {
    return {{}, text};
}

constexpr Row kRows[] = {
    // Arguments
    {{"FILE", "...", Kind::read_file, kVerify | kAnalyze, {.repeats = true, .is_required = true}},
     "By extension: {read}; - is standard input, as .txt"},
    {{"POINTS", "", Kind::read_file, kMoved, {.is_required = true}},
     "The points; - is standard input, as .txt"},
    {{"IMAGE", "", Kind::read_file, kStipple | kMoved | kCompare},
     "The picture; - is standard input"},
    {{"FILE", "", Kind::read_file, kAgain, {.is_required = true}},
     "The .svg or .json that is to be made again"},
    {{"IMAGE", "", Kind::read_file, kAgain}, "The picture of stipple, if it lies elsewhere now"},
    {{"SIZE", "", Kind::text, kMask, {.is_required = true}},
     "Its sides in pixels, WIDTHxHEIGHT, each 8 to 1024"},
    {{"WHAT",
      "...",
      Kind::word,
      kReproduce,
      {.words = Words::figures, .repeats = true, .is_required = true}},
     "table1, table2, fig3 to fig8, or all"},

    heading("What points are asked for"),
    {{"radius", "R", Kind::number, kUniform}, "Least distance between two points; this or --count"},
    {{"radius", "R", Kind::number, kVerify},
     "The least distance promised (default: the one in a .json)"},
    {{"radius", "R", Kind::number, kAnalyze},
     "Radius of the sets, to print count * R^2 and distances in radii"},
    {{"count", "N", Kind::whole, kUniform},
     "Exactly N points, at a radius with room for a few more, so that the set is not maximal; this "
     "or --radius"},
    {{"domain", "WxH", Kind::text, kUniform & ~kPlaced},
     "Width and height of the domain (default 1x1); X0,Y0+WxH with its lower left corner, such as "
     "448000,5411000+2000x1500"},
    {{"domain", "WxH[xD]", Kind::text, kPlaced},
     "Width and height of the domain; X0,Y0+WxH with its lower left corner, such as "
     "448000,5411000+2000x1500 (default: from a .json, a picture or polygons, or 1x1). WxHxD, with "
     "a depth, is a volume: points have three coordinates"},
    {{"on", "MESH", Kind::read_file, kPlaced},
     "Points on the surface of a mesh: .ply .obj .stl .off .gltf .glb. Distances are straight "
     "through space, and points have three coordinates"},
    {{"on-pixels", "COLUMNSxROWS", Kind::text, kSample},
     "Cuts the domain into this many pixels (and is its size, unless --domain is given): exactly "
     "--count samples lie in the centres of pixels, at most one on each, as even as can be or, "
     "with --field, as dense as it says. A .png has a pixel for each, white where there is a "
     "sample"},
    {{"domain", "WxH", Kind::text, kMoved | kAnalyze},
     "Width and height of the domain, or X0,Y0+WxH with its lower left corner (default: from a "
     ".json or a picture, or 1x1)"},

    heading("Pictures"),
    {{"field", "IMAGE", Kind::read_file, kPlaced},
     "A picture that says where points are wanted: many where it is dark, none where it is white. "
     "IMAGE@X0,Y0+WxH lies in this rectangle, of which the domain is a part, and IMAGE@world where "
     "its world file says"},
    {{"scale", "G", Kind::number, kPlaced},
     "With --field, instead of --radius: the radius where the picture is black"},
    {{"scale", "G", Kind::number, kStipple | kCompare},
     "The radius where the picture is black, if its longer side is 1; this or --count"},
    {{"metric", "METRIC", Kind::word, kStipple | kCompare, {.words = Words::metrics}},
     "Least distance of two dots: the min, mean or max of their two radii"},
    {{"invert", "", Kind::flag, kPicture}, "Bright is dense instead of dark"},
    {{"black", "L", Kind::number, kPicture}, "Luminance from 0 to L counts as black (default 0)"},
    {{"white", "L", Kind::number, kPicture}, "Luminance from L to 1 counts as white (default 1)"},
    {{"background", "COLOUR", Kind::word, kPicture, {.words = Words::backgrounds}},
     "What shows through where the picture is transparent: white (default), or black for light "
     "drawings"},
    {{"auto-levels", "", Kind::flag, kPicture},
     "Chooses --black and --white: half a percent of the pixels lie beyond each, and paper, which "
     "is what most of the picture shows at its light end"},
    {{"sharpen", "R[:X]", Kind::text, kPicture},
     "Sharpens edges of about R pixels, X times as much (default 1), by an unsharp mask: shows "
     "more with few dots"},
    {{"along", "RATIO", Kind::number, kPicture & ~kMoved},
     "Ellipses instead of disks, up to RATIO times as long as wide, along the picture's edges "
     "(default 1); in mode exact. With a --dot-size of stipple, strokes of a pen"},
    {{"light", "", Kind::flag, kPicture},
     "Areas average as light, for prints seen from afar: grey 128 of 255 has importance 0.78. By "
     "default they average as the picture's numbers, as on a screen: 0.50"},
    {{"gamma", "X", Kind::number, kPicture},
     "Importance is raised to this power: over 1 lightens middle tones (default 1)"},
    {{"min-importance", "I", Kind::number, kPicture},
     "Least importance, so that white has dots too (default 0)"},

    heading("Where points may lie"),
    {{"ellipses", "FILE", Kind::read_file, kPlaced},
     "An ellipse for each point instead of a disk: a .npy of rows x columns x 3 numbers, two radii "
     "and the angle of the first one, in radians counterclockwise from the x axis; --scale "
     "multiplies all radii (default 1)"},
    {{"stretch", "A:B@DEGREES", Kind::text, kPlaced},
     "The same ellipse for all points: two radii, and the angle of the first one in degrees "
     "counterclockwise from the x axis"},
    {{"stretch", "A:B@DEGREES", Kind::text, kAnalyze},
     "For sets of one ellipse, as of lacuna sample --stretch: analyses them compressed, so that "
     "the ellipse is a disk. The angle must be a multiple of 90"},
    {{"class", "NAME:R[:W[:N]]", Kind::text, kPlaced, {.repeats = true}},
     "Points of a class, such as trees:0.05, trees:0.05:3 or trees:0.05:3:20: its name, its "
     "radius or, as in trees:0.02..0.05, objects of several sizes, how often it is drawn (default "
     "1), and how many there are (default: as many as have room); once for each class"},
    {{"between", "RULE", Kind::word_or_file, kPlaced, {.words = Words::between}},
     "The least distance of two classes. sum (default): the sum of their radii, as of objects that "
     "do not overlap; union: each class alone and all together are evenly distributed; or a file "
     "of distances, .csv or .json, a row and a column a class, perhaps with their names, which "
     "leaves no R to --class"},
    {{"priority", "", Kind::flag, kPlaced},
     "With --class: each class is full before the next begins, in the order in which they are "
     "given: first as many trees as have room, then bushes, then grass. verify then proves that "
     "there is no room beside the classes before"},
    {{"mask", "[NAME:]IMAGE", Kind::places, kPlaced, {.repeats = true}},
     "A picture that says where points may lie: on pixels that are neither black nor transparent; "
     "NAME:IMAGE is that of one class, and may be given for each; IMAGE@X0,Y0+WxH as for --field"},
    {{"inside", "[NAME:]FILE", Kind::places, kPlaced, {.repeats = true}},
     "Polygons that points must lie in: .svg, .geojson or .txt (`x y` on each line, a blank line "
     "between rings); FILE.svg#NAME is the part with this id or Inkscape label; polygons that "
     "overlap are joined, each filled by its own rule; may be given several times, and points then "
     "lie inside of any. NAME:FILE is for one class, whose points lie inside of its own files "
     "alone"},
    {{"outside", "[NAME:]FILE", Kind::places, kPlaced, {.repeats = true}},
     "Polygons that points must not lie in, as for --inside; may be given several times. NAME:FILE "
     "is for one class"},
    {{"avoid", "[NAME:]FILE[:WIDTH]", Kind::obstacles, kPlaced, {.repeats = true}},
     "Obstacles that points stay away from: points of a .csv, by its column radius, or lines and "
     "outlines of a .svg, .geojson or .txt, within WIDTH; FILE.svg:stroke has the widths drawn; "
     "FILE.svg#NAME and NAME:FILE as for --inside; may be given several times"},
    {{"near", "[NAME:]FILE[:D]", Kind::obstacles, kPlaced, {.repeats = true}},
     "Points lie within D of the lines, outlines or points in this file, which is as for --avoid; "
     "may be given several times, and points are then near to any"},
    {{"edge", "E", Kind::number, kPlaced},
     "How far inside the outline of polygons points may begin (default: a sixteenth of the least "
     "radius)"},
    {{"border", "[NAME:]D", Kind::text, kPlaced, {.repeats = true}},
     "Least distance of points to the domain's edges, and to the outlines of --inside and "
     "--outside (default 0); NAME:D is that of one class, and may be given for each"},
    {{"inside-by-radius", "", Kind::flag, kPlaced},
     "No object overhangs the domain's edges, the outlines of --inside and --outside, or the "
     "obstacles of --avoid: points keep half of their --radius from them, and those of a class its "
     "own radius"},
    {{"keep", "FILE", Kind::read_file, kPlaced},
     "Points that are there already: they come first, unmoved, and new points fill the space "
     "around them. Points outside of the domain are no part of the set, but keep their distance: "
     "give those of the chunks beside it"},

    heading("Dots of a picture"),
    {{"count", "N", Kind::whole, kStipple},
     "Exactly N dots, at a scale that fits; this or --scale (default: a number that suits the "
     "picture's size and darkness, or --dot-size)"},
    {{"turn", "DEGREES", Kind::whole, kPicture},
     "Turns the picture right by 90, 180 or 270 degrees (default 0)"},
    {{"crop", "X,Y,W,H", Kind::text, kPicture},
     "Takes a part of the picture, as it was turned: W x H pixels, X from its left edge and Y from "
     "its top"},
    {{"mode", "MODE", Kind::word, kStipple, {.words = Words::dot_modes, .alias = "start"}},
     "How dots are placed before they are moved. stratified (default with --relax): every part of "
     "the picture has its share of the dots; cells (default with --relax 0): on a lattice, as in "
     "the paper; exact: in the plane, with no gap left, and with --metric min. The default is "
     "cells, too, if --scale, --metric, --limit, --lines-per-radius or --round-size is given, "
     "because a stratified set keeps no least distance"},
    {{"lines-per-radius", "M", Kind::whole, kStipple},
     "Lattice steps per least radius (default 10); in exact it changes only the speed (default 1)"},
    {{"inks", "LIST", Kind::text, kStipple},
     "Draws in colour: cmyk, or inks separated by commas: names such as black,red, or #rrggbb, or "
     "NAME=#rrggbb, each with its pen if it has one, as in black:0.3mm,red:0.5mm. All dots "
     "together "
     "are evenly spread, too; .svg has a layer per ink"},
    {{"black-ink", "X", Kind::number, kStipple},
     "With --inks: how much black replaces other inks that would look grey together, 0 to 1 "
     "(default 0.8)"},
    {{"paper-colour", "COLOUR", Kind::text, kStipple},
     "black, #rrggbb or another colour (default white): inks are separated for paper of this "
     "colour, which pictures show. Inks that are lighter than it are opaque, as of gel pens"},
    {{"ink-counts", "N,N...", Kind::text, kStipple},
     "With --inks: the dots of each ink, in place of --count (default: as much as the picture "
     "needs of each)"},

    heading("How they are made"),
    {{"torus", "", Kind::flag, kMade | kMoved | kVerify | kAnalyze},
     "The edges wrap: distances go across them"},
    {{"limit", "K", Kind::whole, kMade}, "Stop after K points"},
    {{"seed", "S", Kind::whole, kMade},
     "Same seed, same points, whatever the backend (default 0); sets of different seeds are "
     "independent. Give each colour channel a seed of its own: where channels are equal, one seed "
     "puts their dots on the same spots"},
    {{"seed", "S", Kind::whole, kOrder},
     "Another seed gives another order of the points of a level (default 0)"},
    {{"seed", "S", Kind::whole, kMask},
     "Another seed gives another tile, independent of this one (default 0)"},
    {{"frames", "N", Kind::whole, kMask},
     "The number of tiles, for the frames of a film, each in a file -o 'mask{frame}.png', from 0 "
     "on: the "
     "values of a pixel, too, vary as fast as they can from frame to frame (default 1)"},
    {{"bits", "B", Kind::whole, kMask}, "Bits of a pixel, 8 or 16 (default 16)"},
    {{"seeds", "A..B", Kind::text, kSample},
     "A set for each seed from A to B, both included; each goes to a file of its own: every "
     "--output has {seed} in its name. Instead of --seed"},
    {{"chunk", "I,J", Kind::text, kSample},
     "The chunk of a plane that is cut into squares, I of them to the right and J up from 0,0, as "
     "in 3,-2: each chunk is the same in whatever order they are made, and all of them are one "
     "maximal set"},
    {{"chunk-size", "D", Kind::number, kSample},
     "With --chunk: the side of the squares, longer than any two points must be apart"},
    {{"frame", "D", Kind::number, kSample},
     "With --seeds and --torus: all sets have the same points within D of the edges, so that any "
     "of them fit side by side, as tiles; at least 1.5 times the greatest distance of two points"},
    {{"progressive", "", Kind::flag, kSample},
     "Orders the points so that the first n, for any n from 16 on, are spread as evenly as a set "
     "of n points. --count may then cut the sequence anywhere"},
    {{"iterations", "K", Kind::whole, kRelax},
     "Times that points are moved, at most 10000 (default 15)"},
    {{"relax", "K", Kind::whole, kSample | kCompare},
     "Then moves the points K times, as lacuna relax does; 0 leaves them (default 0)"},
    {{"relax", "K", Kind::whole, kStipple},
     "Then moves the points K times, as lacuna relax does; 0 leaves them (default 15)"},
    {{"gaussian", "K", Kind::whole, kSample | kRelax, {.usual = "150"}},
     "Then K steps (150 if no number follows) of descent on the Gaussian energy, which take low "
     "frequencies out of the set and keep a least distance; for domains without a picture"},
    {{"gaussian-distance", "D", Kind::number, kSample | kRelax},
     "The distance below which the steps of --gaussian push points apart, in mean spacings, 0 to 1 "
     "(default 0.90)"},
    {{"mode", "MODE", Kind::word, kSample, {.words = Words::point_modes, .alias = "start"}},
     "exact (default): no gap is left, every distance is at least the radius; lines: the paper's "
     "algorithm, which is approximate; stratified (default with --relax and --count): every part "
     "of the domain has its share of the points"},
    {{"mode", "MODE", Kind::word, kCompare, {.words = Words::compared_modes, .alias = "start"}},
     "exact (default): no gap is left, every distance is at least the radius; lines: the paper's "
     "algorithm, which is approximate; stratified, or with a picture cells: as for sample and "
     "stipple"},
    {{"lines-per-radius", "M", Kind::whole, kSample | kCompare},
     "Number of lines per radius (default 6 in exact, 30 in lines)"},
    {{"lines-per-radius", "M", Kind::whole, kMpiSample}, "Lines in a radius' width (default 6)"},
    {{"uniform-x", "", Kind::flag, kSample | kCompare},
     "In mode lines: all lines with room are equally likely, however much room they have"},
    {{"snap", "", Kind::flag, kSample | kCompare},
     "In mode lines: points lie on the lines, and every distance is at least the radius R; without "
     "it distances may be R/(2M) less"},

    heading("Dots on paper"),
    {{"dot-size", "D", Kind::text, kSample},
     "Diameter of dots, such as 0.5mm; or radius (default): two thirds of --radius. In .csv .npy "
     ".ply .json it adds columns for dots, as --paper-size does"},
    {{"dot-size", "D[..D]", Kind::text, kStipple},
     "Diameter of dots, such as 0.5mm, or 0.3mm..0.8mm from light to dark; or radius (default): "
     "the ink of all dots is as much as the picture is dark. In .csv .npy .ply .json it adds "
     "columns for dots, as --paper-size does"},
    {{"pens", "D,D..", Kind::text, kStipple},
     "Widths of pens, such as 0.3mm,0.5mm,0.8mm: each dot is as wide as one of them, wider where "
     "it "
     "is darker, and each pen has a layer of its own"},
    {{"pen", "D", Kind::text, kStipple},
     "Width of the one pen that draws dots of all sizes, such as 0.3mm: wider ones as spirals that "
     "leave no gap, or as --dot-style says; none is narrower"},
    {{"dot-style", "STYLE", Kind::word, kStipple, {.words = Words::dot_styles}},
     "With --pen: dots that are wider than it are filled spirals (default), or circles whose outer "
     "edges are the dots', which look lighter"},
    {{"dot-size", "D", Kind::text, kRelax},
     "Diameter of dots, such as 0.5mm; or radius (default): dots have as much ink as the picture "
     "is dark, or are two thirds of the least distance wide. In .csv .npy .ply .json it adds "
     "columns for dots, as --paper-size does"},
    {{"dot-size", "D", Kind::text, kOrder},
     "Diameter of dots, such as 0.5mm; or radius (default): dots have as much ink as the picture "
     "is dark, or as a maximal set of as many points has. In .csv .npy .ply .json it adds columns "
     "for dots, as --paper-size does"},
    {{"paper-size", "WxH", Kind::text, kDrawn, {.words = Words::papers}},
     "Such as 210x297mm (or cm, in, pt); or A0 to A6, letter, legal, tabloid, which are turned to "
     "suit the picture"},
    {{"margin", "D", Kind::text, kDrawn},
     "Margin around the dots, with --paper-size (default 0mm); no ink of stipple lies in it"},
    {{"dpi", "X", Kind::number, kDrawn},
     "Pixels per inch of .png (default 144, or more where dots would be under 4 pixels apart)"},
    {{"ellipse-columns", "", Kind::flag, kSample | kStipple},
     "Writes the ellipse of each point to .csv .npy .ply .geojson .json: its radii a and b, and "
     "the angle of a in radians"},
    {{"columns", "LIST", Kind::text, kSample},
     "Writes random numbers of each point to .csv .ply .geojson .json, by the seed: angle, in "
     "degrees, or size, a factor from 0.8 to 1.2, or size:0.5..2, with commas between them"},
    {{"size-by-tone", "A", Kind::number, kStipple},
     "How much of the tone is in the dots' sizes, 0 to 1 (default 0: all are equally large). Areas "
     "are proportional to importance^A, and dots as dense as importance^(1 - A): with few dots "
     "more is seen"},
    {{"frames", "PATTERN", Kind::text, kStipple},
     "In place of IMAGE: the pictures of a sequence, such as 'in/*.png', in the order of their "
     "names (2 before 10), each to a file -o 'out/{frame}.svg'. Each dot keeps its index, except "
     "along a path of a pen and with --pens: with --dot-size 0.5mm give --no-pen-path"},
    {{"keep-inside", "", Kind::flag, kStipple},
     "Keeps dots off white, and in the picture: dots that overhang an edge are moved inwards, and "
     "in a shape narrower than a dot they are smaller and denser, but not smaller than a pen. "
     "Where the picture is black no gaps are left"},
    {{"pen-path", "", Kind::flag, kStipple},
     "Orders the dots along a short path for a pen, in every format (default with pens: --dot-size "
     "0.5mm, --pens, --pen, or --inks that have pens)"},
    {{"no-pen-path", "", Kind::flag, kStipple},
     "Leaves the dots of pens in the order in which they were made"},
    {{"path-line", "", Kind::flag, kStipple},
     "Draws that path as one line, in .svg .pdf .png, in place of dots: as wide as the pen of "
     "--dot-size or, without it, so wide that its ink is as much as the picture is dark"},
    {{"plot-time", "T", Kind::text, kStipple},
     "As many dots as a plotter draws in at most this time, such as 90min or 1.5h, along a pen's "
     "path; with pens no more than the picture needs"},
    {{"seconds-per-dot", "S", Kind::number, kStipple},
     "How long the plotter takes to lower and raise the pen (default 0.28, as an AxiDraw V3 does; "
     "so are the next defaults)"},
    {{"seconds-per-metre-down", "S", Kind::number, kStipple},
     "How long it takes for a metre at full speed with the pen down, along strokes and lines "
     "(default 20)"},
    {{"seconds-per-metre-up", "S", Kind::number, kStipple},
     "The same with the pen up, between dots and strokes (default 6.6)"},
    {{"seconds-per-corner", "S", Kind::number, kStipple},
     "How long it takes to stop and start again with the pen down, at full speed (default 0.066); "
     "less in blunt corners and on short ways"},

    heading("Looking at sets"),
    {{"tolerance", "T", Kind::number, kVerify},
     "How far over R a gap may be (default 2^-28 of the longer side, for one radius everywhere)"},
    {{"distances-only", "", Kind::flag, kVerify},
     "Look for points too close only: for sets that are not meant to be maximal"},
    {{"max-frequency", "F", Kind::number, kAnalyze},
     "Largest |k| / sqrt(count) of the spectrum (default 2)"},
    {{"backends", "LIST", Kind::text, kCompare, {.words = Words::named_backends}},
     "Some of cpu,opencl,vulkan,reference (default: the first three)"},
    {{"runs", "N", Kind::whole, kCompare},
     "Number of timed runs of each backend, after the first run (default 5)"},
    {{"work", "", Kind::flag, kCompare},
     "Also prints what devices were asked to do in a round: launches, waits, transfers, kernels"},
    {{"runs", "N", Kind::whole, kReproduce},
     "Number of sets in each mean (default: 2 to 100, depending on the item)"},
    {{"image", "FILE", Kind::read_file, kReproduce}, "The picture that figure 7 stipples"},
    {{"smallest-radius", "R", Kind::number, kReproduce},
     "Leaves out rows of the tables with smaller radii"},

    heading("Where it runs"),
    {{"round-size", "K", Kind::whole, kMade},
     "Draws in a round; 0 chooses (default), 1 is the paper's algorithm"},
    {{"threads", "T", Kind::whole, kReported | kCompare | kAnalyze, {.decides_points = false}},
     "Number of threads; 0 is one for each core (default)"},
    {{"threads", "T", Kind::whole, kMpiSample, {.decides_points = false}},
     "Threads of each rank; 0 divides a machine's cores among its ranks (default)"},
    {{"backend",
      "NAME",
      Kind::text,
      kReported | kMpiSample,
      {.words = Words::backends, .decides_points = false}},
     "cpu, opencl, vulkan or reference; auto (default) is the one that the environment variable "
     "LACUNA_BACKEND names, or else cpu"},
    {{"device", "NAME", Kind::text, kReported | kMpiSample, {.decides_points = false}},
     "A device's number or a part of its name"},

    heading("What is written"),
    {{"output",
      "FILE",
      Kind::written_file,
      kDrawn,
      {.alias = "o", .repeats = true, .decides_points = false}},
     "By extension: {written}; - is standard output, as .txt (default); may be given several "
     "times"},
    {{"output",
      "FILE",
      Kind::written_file,
      kAgain,
      {.alias = "o", .repeats = true, .is_required = true, .decides_points = false}},
     "By extension: {written}; may be given several times"},
    {{"output",
      "REPORT",
      Kind::written_file,
      kAnalyze,
      {.alias = "o", .repeats = true, .decides_points = false}},
     "Numbers and curves as .json, or a plot sheet as {pictures}; - is standard output, as .json; "
     "may be given several times"},
    {{"output",
      "FILE",
      Kind::written_file,
      kCompare,
      {.alias = "o", .repeats = true, .decides_points = false}},
     "A bar chart of the times: {pictures}"},
    {{"output",
      "FILE.png",
      Kind::written_file,
      kMask,
      {.alias = "o", .repeats = true, .is_required = true, .decides_points = false}},
     "A grey .png; - is standard output"},
    {{"output", "FOLDER", Kind::written_file, kReproduce, {.alias = "o", .decides_points = false}},
     "A folder for a .json and a picture of each item; it is made if it is missing"},
    {{"output",
      "FILE.npy",
      Kind::written_file,
      kMpiSample,
      {.alias = "o", .decides_points = false}},
     "A .npy file, which all ranks write together"},
    {{"format", "NAME", Kind::text, kDrawn, {.words = Words::formats, .decides_points = false}},
     "Format of outputs whose name has no extension, such as -; for example json"},
    {{"format",
      "NAME",
      Kind::text,
      kAnalyze,
      {.words = Words::report_formats, .decides_points = false}},
     "Format of outputs whose name has no extension, such as -; for example json"},
    {{"format",
      "NAME",
      Kind::text,
      kCompare,
      {.words = Words::chart_formats, .decides_points = false}},
     "Format of outputs whose name has no extension, such as -; for example svg"},
    {{"report", "FILE.json", Kind::written_file, kReported, {.decides_points = false}},
     "Writes the request, counts, seconds by verb, memory and SHA-256 of the points; - is standard "
     "output"},
    {{"report", "FILE.json", Kind::written_file, kMpiSample, {.decides_points = false}},
     "Writes the request, counts, the SHA-256 of the points, and the least, median and most "
     "seconds, bytes and memory of a rank; - is standard output"},
    {{"json", "FILE.json", Kind::written_file, kCompare},
     "Writes the tables and the seconds of every run; - is standard output"},
    {{"json", "", Kind::flag, kAnalyze | kVerify | kDevices},
     "Prints all that is found as JSON on standard output"},
    {{"progress", "", Kind::flag, kMpiSample},
     "Shows the progress bar although standard error is no terminal under mpirun"},
    {{"quiet", "", Kind::flag, kReported, {.decides_points = false}},
     "No progress bar, no warning and no summary at the end"},
    {{"quiet", "", Kind::flag, kAgain}, "No progress bar, no warning and no summary at the end"},
    {{"quiet", "", Kind::flag, kMask}, "No summary at the end"},
    {{"quiet", "", Kind::flag, kOrder}, "No summary at the end, and no warning"},
    {{"quiet", "", Kind::flag, kVerify},
     "Print nothing; only the exit code says whether all claims hold"},
    {{"quiet", "", Kind::flag, kAnalyze | kCompare | kReproduce}, "No progress bar"},
    {{"quiet", "", Kind::flag, kMpiSample}, "No progress bar and no last line"},
};

// The options alone: what does not ask for help is linked without its texts, as on the page.
constexpr auto kOptions = [] {
    std::array<Option, std::size(kRows)> options{};
    for (std::size_t i = 0; i < options.size(); ++i) options[i] = kRows[i].option;
    return options;
}();

// With what --help begins where a command has many options. --help-all lists them all.
constexpr auto kEverybodysOptions = std::to_array<std::pair<std::string_view, Commands>>({
    {"radius", kUniform | kVerify},
    {"count", kMade},
    {"domain", kUniform | kVerify | kMoved},
    {"on", kPlaced},
    {"field", kPlaced},
    {"class", kPlaced},
    {"inside", kPlaced},
    {"avoid", kPlaced},
    {"keep", kPlaced},
    {"torus", kUniform | kVerify | kMoved},
    {"iterations", kRelax},
    {"inks", kStipple},
    {"auto-levels", kStipple},
    {"crop", kStipple},
    {"dot-size", kStipple},
    {"pen", kStipple},
    {"paper-size", kStipple},
    {"plot-time", kStipple},
    {"seed", kMade},
    {"backends", kCompare},
    {"runs", kCompare},
    {"output", kDrawn | kCompare | kMpiSample},
    {"json", kVerify | kCompare},
});

constexpr std::array<std::string_view, 12> kCommands{"sample",  "stipple", "relax",   "order",
                                                     "verify",  "analyze", "compare", "reproduce",
                                                     "devices", "sample",  "mask",    "again"};

}  // namespace

std::string_view name_of_command(Commands command) {
    return kCommands.at(static_cast<std::size_t>(std::countr_zero(command)));
}

std::optional<Commands> command_called(std::string_view name) {
    const auto* const found = std::find(kCommands.begin(), kCommands.end(), name);
    if (found == kCommands.end()) return std::nullopt;
    return Commands{1} << static_cast<unsigned>(found - kCommands.begin());
}

std::string Option::key() const {
    std::string key(name);
    std::replace(key.begin(), key.end(), '-', '_');
    return key;
}

std::vector<const Option*> options_of(Commands command) {
    std::vector<const Option*> rows;
    for (const Option& row : kOptions)
        if ((row.commands & command) != 0) rows.push_back(&row);
    return rows;
}

std::string_view heading_of(const Option& option) {
    std::size_t row = static_cast<std::size_t>(&option - kOptions.data());
    while (row > 0 && !kOptions[row].name.empty()) --row;
    return row == 0 ? "Options" : kRows[row].help;
}

bool is_in_short_help(Commands command, const Option& option) {
    return std::any_of(kEverybodysOptions.begin(), kEverybodysOptions.end(), [&](const auto& one) {
        return one.first == option.name && (one.second & command) != 0;
    });
}

const Option* find_option(Commands command, std::string_view name) {
    const auto* const found =
        std::find_if(kOptions.begin(), kOptions.end(), [&](const Option& row) {
            return (row.commands & command) != 0 && (row.name == name || row.traits.alias == name);
        });
    return found == kOptions.end() ? nullptr : found;
}

std::string_view help_of(const Option& option) {
    return kRows[&option - kOptions.data()].help;
}

bool CommandLine::has(std::string_view name) const {
    return std::any_of(given.begin(), given.end(),
                       [&](const GivenOption& one) { return one.name == name; });
}

void CommandLine::sort() {
    std::vector<GivenOption> sorted;
    for (const Option* option : options_of(command))
        for (GivenOption& one : given)
            if (one.name == option->name) sorted.push_back(std::move(one));
    given = std::move(sorted);
}

std::string CommandLine::text(std::uint64_t seed) const {
    std::string text = "lacuna " + std::string(name_of_command(command));
    for (const auto& [name_in_table, values] : given) {
        const Option& option = *find_option(command, name_in_table);
        const bool is_argument = option.is_argument();
        const std::string name = is_argument ? "" : " --" + std::string(name_in_table);
        if (!option.traits.decides_points) continue;
        if (name_in_table == "seeds") {
            text += " --seed " + std::to_string(seed);
            continue;
        }
        if (values.empty()) text += name;  // a flag
        // An option that may be given several times is given with each of its values.
        for (const std::string& value : values) {
            text += name + " " + (is_argument ? quoted_path(value) : quoted(value));
        }
    }
    return text;
}

std::string quoted_path(const std::string& path) {
    const bool looks_like_an_option = path.starts_with("-") && path != "-";
    return quoted(looks_like_an_option ? "./" + path : path);
}

std::string quoted(const std::string& word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./:=,+%@";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
    std::string result = "'";
    for (const char c : word) {
        if (c == '\'')
            result += "'\\''";
        else
            result += c;
    }
    return result + "'";
}

}  // namespace lacuna::options
