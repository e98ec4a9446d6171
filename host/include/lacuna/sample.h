// A request goes in, a blue-noise point set comes out. Link lacuna.
//
// What is promised
//   - The same request and seed give the same points, bit for bit, on every backend, every device
//     and any number of threads.
//   - Points come in the order in which they were admitted; any prefix of a set is an unbiased
//     Poisson-disk set of the same radius. But a prefix is not maximal: it leaves gaps.
//   - Every point lies in the domain, [0, width) x [0, height), or was kept on an upper edge of a
//     box.
//   - Mode::exact: no two points are closer than the radius, computed in double from the points
//     returned. Every spot of the domain has a point within the radius plus 2^-28 of the longer
//     side. The set is distributed as if darts were thrown until no room is left.
//     With a field, a mask, a border or kept points each pixel has its own radius. Two points are
//     no closer than the smaller of their radii. Points lie only where samples may lie. Every spot
//     where samples may lie is covered: some point is no farther than the smaller radius of the
//     two, plus 2^-27 of the longer side; with classes see Claim::tolerance in lacuna/verify.h. A
//     spot within 2^-28 of the longer side of a pixel's border may have the radius of either pixel.
//   - Mode::lines with Paper2011::snap: no two points are closer than the radius. Without snap
//     (Kalantari & Sen 2011, section 4.1, x interpolated in its strip) no two points are closer
//     than radius * (1 - 1 / (2 * lines_per_radius)). Gaps narrower than a strip remain.
//   - Mode::cells: points lie on a lattice. Any two keep the distance that the metric makes of
//     their radii, computed in double from the coordinates returned. Every lattice point with
//     importance over 0 is too close to some point for another sample; this is computed in lattice
//     steps, with radii rounded up to 1/256 of a step. Where importance is 0 there is no point.
//   - The library never prints, never exits and never reads the clock.
//   - Any function may be called from several threads at once. A process forked after a device was
//     used or listed gets Unavailable for opencl and vulkan, for it lacks the drivers' threads.
//
// What can go wrong is thrown: see lacuna/errors.h.
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>
#include <lacuna/places.h>
#include <lacuna/run.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

// How a disk is stretched to an ellipse of the same area: its longer radius over its shorter one,
// and the angle from the x axis to the longer one, counterclockwise in radians.
struct Stretch {
    double ratio = 1;  // 1 to 1000
    double angle = 0;
};

// Two radii in the user's units, a >= b, and the angle from the x axis to the radius a,
// counterclockwise in radians.
struct Ellipse {
    double a = 0;
    double b = 0;
    double angle = 0;
};

// Importance over the domain: where samples are wanted, and how densely (section 4.2).
struct Field {
    std::uint32_t columns = 0;         // pixels
    std::uint32_t rows = 0;            // pixels
    std::vector<double> importance{};  // rows * columns values, finite, >= 0 (0: no sample there);
                                       // row by row, row 0 is the top of the picture (largest y)
    // In mode exact: the stretch of each pixel, in the order of the importance, or empty: disks.
    // With it each sample has an ellipse instead of a disk, and two samples conflict if each lies
    // in the other's (section 6). On a torus no ellipse may be longer than its shorter side.
    std::vector<Stretch> stretches{};
};

// The ellipses of points of the domain on a field that has stretches: r = scale / sqrt(I) is the
// root of a b. On the border of two pixels, the ellipse of either one.
std::vector<Ellipse> ellipses_of(std::span<const Point> points, const Field& field, double scale,
                                 const Domain& domain);

// Kinds of points in one set, such as trees, bushes and grass. Every two kinds have a least
// distance of their own (Wei 2010, "Multi-class Blue Noise Sampling").
struct Classes {
    // 1 to 16, without spaces, commas or colons. Classes of one name, which follow each other and
    // keep unlike distances within themselves, are objects of one kind in several sizes. A border,
    // a mask and an outline of that name are for all sizes, and by priority they are drawn
    // together.
    std::vector<std::string> names{};
    // The least distance of each two classes, row by row: a symmetric matrix of names.size()^2
    // values >= 0, on its diagonal > 0. 0 means that the two classes ignore each other. The
    // greatest may be 4000 times the least that is not 0. See distances_by_sum and
    // distances_by_union.
    std::vector<double> distances{};
    // How often each class is drawn, in proportion to the room that it still has; >= 0, not all 0.
    // Empty: all alike. A class of weight 0 is not drawn: its points are the kept ones.
    std::vector<double> weights{};
    // How many points of each class there are, kept ones of the domain included; none: as many as
    // have room. Classes that have a number come first, and the others fill the room that is left.
    // The set is maximal in these alone, and not at all if all have a number. Empty: none has. For
    // two classes or more, without Request::count, limit and progressive. sample() throws
    // BadRequest if fewer points find room.
    std::vector<std::optional<std::uint64_t>> counts{};
    // Whether each class is drawn until none of it has room, or until it has its number, before the
    // next one begins, in the order of the names. The set is then maximal in each class beside the
    // kept points and the classes before it alone. No weight may be other than 0 or 1. Without
    // Request::count, limit and progressive.
    bool by_priority = false;
};

// The distances of round objects of these radii that do not overlap: the sum of two radii. Two
// objects of one class keep twice its radius.
std::vector<double> distances_by_sum(std::span<const double> radii);
// The distances with which each class alone is a set of its radius, and all together are evenly
// distributed too (Wei 2010): between two classes 1 / sqrt(sum of 1 / R^2), over all classes whose
// radius R is at least the smaller of both.
std::vector<double> distances_by_union(std::span<const double> radii);

// How the free space is cut up.
//   exact  strips, then boxes, refined until none has room: sets that are truly maximal
//   lines  the paper's section 4.1: one line stands for its whole strip
//   cells  the paper's section 4.2, for Request::field: a lattice, fine enough for the least radius
// Or, for relax() to begin with, points without a least distance:
//   stratified  the cdf of importance along a Hilbert curve of the domain, inverted at one random
//               number in each of Request::count equal intervals. So every part of a picture has
//               its share of the points. It needs a count, may have a field, and allows no other
//               option of the set; the points come in the order of the curve.
// Or, for masks and layouts that are pixels themselves:
//   pixels  exactly Request::count points, in the centres of pixels of Request::on_pixels, at most
//           one on each. They are dense in proportion to the field, if there is one. Pixels on
//           which it asks for more than one point have one, and what is left over goes to the other
//           pixels. Points are as even as a descent makes them that moves one at a time; pixels
//           count as squares. The importance, and whether the mask allows points, are those at the
//           centre of a pixel. The points come row by row, from the top; Result::radius is the
//           least distance of the centres of two pixels. Allows no other option of the set.
enum class Mode { exact, lines, cells, stratified, pixels };
std::string_view name_of(Mode mode);

// Which distance two points of different radii must keep (section 4.2.1): the smaller radius (the
// paper's), their mean, or the larger.
enum class Metric { min, mean, max };
std::string_view name_of(Metric metric);

// How the algorithm of Kalantari & Sen 2011 is run.
struct Paper2011 {
    // The paper's m, 1 to 1000. Default: 6 in exact, where it changes only the speed; 30, the
    // paper's, in lines; 10 lattice steps per least radius in cells. In exact with a field, a mask,
    // a border or kept points there are no lines. There the first boxes are at most 2 radii / m
    // long, the default is 1, and m again changes only the speed.
    std::optional<std::uint32_t> lines_per_radius{};
    std::uint64_t round_size = 0;  // draws in a round; 0: automatic, 1: the paper's algorithm
    // In mode lines only.
    bool snap = false;       // points on the lines themselves: keeps every distance >= radius
    bool uniform_x = false;  // end of section 4.1: lines with room are equally likely
};

// What sample() is to make. Exactly one of radius, scale and count must be given; with classes,
// none or one.
struct Request {
    Domain domain{};

    // Least distance between two points, in the domain's unit; not with a field. At least 2^-20 of
    // the longer side, at most the shorter side of a torus or the diagonal of a box.
    std::optional<double> radius{};
    // Exactly this many points, at a radius that has room for a few more: the set is not maximal.
    std::optional<std::uint64_t> count{};

    Mode mode = Mode::exact;
    // In mode pixels, and in no other: the pixels of the domain, at most 2^26.
    std::optional<Raster> on_pixels{};
    // In all modes but lines: importance, stretched over the domain. It must outlive the call. In
    // exact the radius is constant on a pixel, and the metric min.
    const Field* field = nullptr;
    // The paper's g (section 4.2): the radius at a point is g / sqrt(importance there), in the
    // domain's unit. Where the importance is 1 it is the radius itself.
    std::optional<double> scale{};
    Metric metric = Metric::min;

    // In mode exact, and without a border in mode pixels: where samples may lie. The set is maximal
    // there, to within the edge of the outlines.
    Places places{};
    // In mode exact: classes of points. No two points are closer than the distance of their
    // classes, and no spot is left where a point of any class has room. With a radius, scale or
    // count the distances are in proportion: the least that is not 0 becomes the radius or scale.
    // With a field these are the distances where the importance is 1. Elsewhere they are divided by
    // the square root of the importance, as the radius is.
    Classes classes{};

    // Points that are there already. They come first in the result, in this order and bit for bit,
    // and samples keep their distance from them as from each other. Each must lie in the domain or
    // on a box's edge, where samples may lie, and keep its distance from the others. They count for
    // limit and count. They must outlive the call.
    // Those that lie outside of a box, such as the points of sets beside it, are no points of the
    // result. But samples keep their distance from them, and the result is maximal beside them. If
    // there are such points, those on the upper edges are outside, too. Not with a field or a
    // progressive order; with masks of classes only if all masks have as many columns and rows.
    std::span<const Point> keep{};
    // With classes the class of each kept point: its place in Classes::names.
    std::span<const std::uint8_t> keep_classes{};

    // In mode exact: an order in which the first n points, for any n, are spread as evenly as a set
    // of n points. A maximal set of about 16 points is kept, then one at a radius smaller by
    // 2^(-1/32), and so on down to the radius or scale asked for, or until there are `count`
    // points. A larger count continues the same sequence.
    bool progressive = false;

    std::optional<std::uint64_t> limit{};  // stop after this many points, >= 1
    std::uint64_t seed = 0;                // sets of different seeds are independent

    Paper2011 paper2011{};
    RunOn run_on = RunOn();  // {} makes gcc 12 warn at -O3 that its texts may be uninitialized
};

// A level of a progressive order: the first `points` points are a maximal set of this size.
struct Level {
    double size = 0;  // the radius, or with a field the scale
    std::uint64_t points = 0;
};

// A point set, and how it was made.
struct Result {
    std::vector<Point> points{};  // in order of admission
    // With classes, of each point: its class, the place of its name in Classes::names.
    std::vector<std::uint8_t> classes{};
    // The radius asked for, or chosen for Request::count; with a field the least of all radii. With
    // classes the least distance of any two classes; the other distances are in proportion.
    double radius = 0;
    double scale = 0;  // with a field: the g asked for, or chosen for Request::count; else 0
    double edge = 0;   // with outlines: Places::edge, as given or chosen
    std::uint32_t lines_per_radius = 0;  // the m asked for, or the mode's default
    bool maximal = false;  // false if limit or count ended the run while there was room
    // How many rounds (docs/design.md, section 3) the run took, and how many draws in all, whether
    // they became points or not. Runs that chose a radius for Request::count are not included.
    std::uint64_t rounds = 0;
    std::uint64_t draws = 0;
    std::string backend{};        // the name of the backend that did the work
    std::string device{};         // the name of its device
    Work work{};                  // in rounds and draws, as these are counted
    std::vector<Level> levels{};  // the finished levels of a progressive order
};

// A request whose outlines are drawn onto masks, and whose borders by radius are numbers.
struct Resolved {
    Request request = Request();  // without outlines; it points into the masks
    double edge = 0;              // of the outlines; 0: there are none
    std::shared_ptr<const std::vector<Mask>> masks{};
};
// What sample() does first. For who makes many sets of one request, or looks at the masks. Throws
// BadRequest, also for an outline of a class that there is not.
Resolved resolve(const Request& request);

// Makes the set that `request` describes.
// Throws BadRequest (also as MemoryRefused), Unavailable, DeviceError, Cancelled.
Result sample(const Request& request);
Result sample(const Request& request, Observer& observer);

// The expected number of points of a maximal set, all lengths in one unit: 0.69656 * area /
// radius^2 on the torus (the jamming limit of random sequential adsorption), with an edge term on
// the box (docs/design.md, section 5). The standard deviation of counts is 0.244 sqrt(count).
double expected_count(const Domain& domain, double radius);

}  // namespace lacuna
