// Point files and pictures. The extension names the format, and a file appears whole or not at all.
#pragma once

#include <lacuna/files.h>
#include <lacuna/inks.h>
#include <lacuna/lacuna.h>
#include <lacuna/space.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/formats.h"

namespace lacuna::files {

// How a set was made: .json, .svg and .pdf record it, and .json is read again.
struct Origin {
    std::string version{};       // version of the program
    std::string command{};       // a command line that makes the same set, if there is one
    std::optional<Mode> mode{};  // unset: not known
    std::uint64_t seed = 0;
    std::optional<bool> maximal{};  // whether no further sample fits
    std::string image_sha256{};     // of the picture that was read; empty if there was none
    std::string options{};          // a JSON object of all options that the points depend on
    std::vector<Level> levels{};    // of a progressive order
    double scale = 0;               // of the field, asked for or chosen; 0: there is no field
    // Of `options`, as it was read: each that has a value, which is a number, a word, "true", or
    // several of these with colons between them; and the classes, which have names if there are
    // distances, with the border of each.
    std::map<std::string, std::string> values{};
    Classes classes{};
    std::vector<double> borders{};
};

// The sizes of the dots and their position on the page, for programs that draw them themselves.
// They are written to .csv, .npy, .ply and .json, as ellipses are.
struct Dots {
    std::vector<double> radii;  // radius of each point's dot, in the domain's units
    double millimetres_per_unit = 0;
    double left_mm = 0;    // from the left edge of the page to the domain
    double bottom_mm = 0;  // from the lower edge of the page to the domain

    // A dot's centre and radius on the page, in millimetres; y points upwards.
    double x_mm(Point point) const { return left_mm + point.x * millimetres_per_unit; }
    double y_mm(Point point) const { return bottom_mm + point.y * millimetres_per_unit; }
    double radius_mm(std::size_t index) const { return radii[index] * millimetres_per_unit; }
};

using lacuna::Layer;
enum class LayersAre { inks, classes };

// Such as #009ee3.
std::string hex_of(const Colour& colour);

// A number for each point, which some formats write after its coordinates.
struct Column {
    const char* name;
    std::vector<double> values;
};

// The radius of each point's object, by its class.
Column radius_of_each(std::span<const std::uint8_t> class_of_point,
                      std::span<const double> radii_of_classes);

// A set of points, and what is needed to draw it.
struct PointSet {
    std::span<const Point> points;
    Domain domain{};
    // Least distance; a dot's radius is a third of it. 0 means unknown: then dots are as large as
    // in a maximal set with the same number of points.
    double radius = 0;
    const Origin* origin = nullptr;  // null: unknown; then a relaxed set is of mode stratified
    bool is_relaxed = false;         // no least distance was kept
    std::optional<Raster>
        on_pixels{};             // whose centres the points are: a png has one pixel for each
    const Dots* dots = nullptr;  // null: not wanted
    // The ellipse of each point, for sets of ellipses: pictures stretch dots likewise.
    std::span<const Ellipse> ellipses{};
    bool writes_ellipses = false;  // to files with columns, too
    // Empty: all dots are black.
    std::span<const Layer> layers{};
    // The layer of each point. Empty: the points of the layers come one layer after the other.
    std::span<const std::uint8_t> layer_of_point{};
    LayersAre layers_are = LayersAre::inks;
    std::span<const Column> more{};  // for .csv, .ply, .geojson and .json
};

// radius, x_mm, y_mm and radius_mm of dots; a, b and angle of ellipses, as far as they are wanted;
// and those of PointSet::more.
std::vector<Column> columns_of(const PointSet& set);

// The layer of each point, for a set that has layers.
std::vector<std::uint8_t> layers_of_points(const PointSet& set);

// Layers for classes of points, in colours that can be told apart. Names and points are of the set.
std::vector<Layer> layers_of_classes(std::span<const std::string> names,
                                     std::span<const std::uint8_t> class_of_point);

using lacuna::ClosedPipe;
using lacuna::FileError;

// Converts ASCII letters only: the locale must not change which file is meant.
char lower_case(char c);

// The bytes of a file in the given format.
//   txt   `x y` on each line, 17 significant digits, so that reading gives back the same doubles
//   csv   the same with a header line `x,y`
//   npy   NumPy 1.0 header, N x 2 float64, little-endian, C order
//   ply   ASCII, vertex x y z as double, z = 0
//   geojson  a FeatureCollection of Points, whose properties are the columns
//   json  {"width":..., "height":..., "radius":..., "boundary":..., the members of Origin,
//         "count":..., "points":[[x,y],...]}
//   svg, pdf, png   black dots on white, y upwards; longer side 1024 pixels (png) or 512 points
// With dots, csv, npy and ply have the columns x, y, (z,) radius, x_mm, y_mm and radius_mm, and
// json has "dots" before the points. With ellipses these have columns a, b and angle (two radii in
// the domain's unit, and the angle in radians from the x axis to a), and json has "ellipses". With
// inks, csv and ply have a last column ink (its name or its index), npy too (its index); json has
// "inks" and, for each point, its index in "ink". With classes these are called class and
// "classes". Such an npy is not read again, because a third
// column may be a third coordinate. The same set gives the same bytes on every call. Throws
// FileError if a picture cannot be drawn, and BadRequest("output", ...) if the format has no place
// for the classes, inks or ellipses that the set writes.
std::string encode(const PointSet& set, const Format& format);

// Writes `bytes` to `path` ("-": standard output), whole or not at all: into a new file beside it,
// then a rename. Until the rename an older file stays as it is; the new one gets its permissions.
// Links are followed. Devices, pipes and the paths that descriptor_named() knows are written to
// directly, without a rename.
// Throws FileError, or ClosedPipe when the reader of a pipe has gone.
void write_whole(const std::string& path, std::string_view bytes);

// The number of the descriptor that /dev/stdout, /dev/stderr, /dev/fd/N or /proc/self/fd/N names.
std::optional<int> descriptor_named(const std::string& path);

// SHA-256, in hex, of the points as little-endian float64 x0 y0 x1 y1 ..., or x0 y0 z0 ...: the
// value that --report prints and that tests compare.
std::string sha256_of(std::span<const Point> points);
std::string sha256_in_space(std::span<const Point3> points);
// The same of any bytes.
std::string sha256_of_bytes(std::string_view bytes);
// The hash of points when the points arrive in parts.
class Sha256OfPoints {
public:
    Sha256OfPoints();
    ~Sha256OfPoints();
    Sha256OfPoints(const Sha256OfPoints&) = delete;
    Sha256OfPoints& operator=(const Sha256OfPoints&) = delete;

    void add(std::span<const Point> points);
    void add_numbers(std::span<const double> numbers);
    void add_bytes(std::string_view bytes);
    std::string hex();  // call it once, after the last add()

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lacuna::files
