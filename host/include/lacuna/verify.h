// Proves or refutes what a Poisson-disk set promises, from its coordinates alone, whoever made it.
//
// What is promised
//   - Everything is computed in double from the points given, by code that the samplers do not
//     share. Distances are what a user would compute, sqrt(dx * dx + dy * dy), around the edges of
//     a torus.
//   - Proof::kept is exact. If it is true, no two points are closer than the radius. If it is
//     false, `first` and `second` are two that are closer.
//   - Proof::covered: if it is true, no spot of the domain, edges and corners included, is farther
//     than radius + tolerance from every point, with an error of 1e-12 of the longer side at most.
//     If it is false, `largest_gap` is a spot that is farther.
//   - With a field, each spot has the radius of its pixel, scale / sqrt(importance). The limit of
//     two spots is the smaller of their radii. The distance of two points must be at least their
//     limit. A point covers a spot if their distance is at most their limit. Where the importance
//     is 0, no point may lie, and no spot need be covered.
//   - If the field has stretches, each spot has the ellipse of its pixel. The limit of two spots is
//     the smaller radius of their ellipses along the way between them, so their distance is less
//     than the limit if each lies in the other's ellipse. For the tolerance an ellipse is enlarged
//     in proportion, until its shorter radius is longer by the tolerance. On a torus no ellipse may
//     be longer than the shorter side.
//   - A mask, polygons and a border say where points may lie, as in Request. A spot where no point
//     may lie need not be covered. The same holds for spots nearer to an edge of polygons than
//     Places::edge plus the distance that the set keeps from them. A line that two rings share is
//     an edge of both. No point may lie outside, nor nearer than that distance; 4e-12 of the longer
//     side are for the rounding of doubles.
//   - Samplers round the borders of pixels to the lines of a grid. So a point that is within 2^-28
//     of the longer side of such a border counts as lying on both pixels. Its distances are checked
//     with the smaller radius, and the spots that it covers with the larger one. With ellipses it
//     is too close to another point if it is with both ellipses, and covers a spot if it does with
//     either. It is allowed if either pixel allows points. A point may cross Places::border or
//     polygons by as much.
//   - With classes the limit of two points, or of a point and a spot for one more point of a class,
//     is multiplied by the distance of their two classes, as a share of the least one.
//   - Points to keep are the first of the set, in their order, and equal to the last bit. Those
//     that lie outside of a box are its neighbours instead: they are no points of the set, but
//     distances to them must be kept, and they cover spots.
//   - Gaps, pixels and polygons are searched with the domain's corner as (0, 0). `largest_gap` is
//     rounded to doubles when the corner is added.
//   - The work grows nearly linearly with the number of points, however crowded they are.
#pragma once

#include <lacuna/export.h>
#include <lacuna/sample.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace LACUNA_API lacuna {

// What a set is said to be.
struct Claim {
    // Least distance between two points, > 0; ignored if there is a field. With classes it may be
    // 0.
    double radius = 0;
    Domain domain{};

    // How far over the radius a gap may be. If unset, it is 2^-28 of the longer side, which is more
    // than sample() may lose by rounding the radius up. With a field, mask, polygons, border or
    // kept points it is twice as much, because these are rounded too. With classes it is also twice
    // as much, times the greatest distance of two classes over the least that is not 0. More than 4
    // classes double that, and more than 8 make it four times as large. With neighbours the longer
    // side is that of the box around the domain and the neighbours that matter.
    std::optional<double> tolerance{};
    bool distances_only = false;  // gaps are not looked for, which takes most of the time

    // Radii that differ from place to place: the field, stretched over the domain, and the radius
    // where its importance is 1. Field::stretches makes ellipses of disks, but not with classes.
    // The field must outlive the call.
    const Field* field = nullptr;
    double scale = 0;  // > 0; with classes it may be 0

    // Where points may lie, as in Request. Spots nearer to outlines than Places::edge need no
    // point; it may be 0. A mask must not be one that draw_places() has drawn.
    Places places{};

    // Classes of points, as in Request. No two points may be closer than the distance of their
    // classes, and no spot may be left where a point of any class with a weight, and without a
    // count, has room. By priority no spot may be left beside the points of its own class, of those
    // before it and of `keep`. With a radius or scale the distances are in proportion, as in
    // Request.
    Classes classes{};
    std::span<const std::uint8_t> class_of_points{};  // of each point: its place in the names

    // As in Request: the points that the set begins with, equal to the bit, and its neighbours,
    // which lie outside of a box; these not with a field. They must outlive the call.
    std::span<const Point> keep{};
    // With classes and neighbours, the class of each of these points.
    std::span<const std::uint8_t> keep_classes{};
};

// What was found. Points are numbered from 0, in the order given. A neighbour has the number of
// points plus its place in Claim::keep.
struct Proof {
    // The first point outside the domain. The far edges belong to a box, and not to a torus. If
    // there is such a point, only `moved` was looked at besides.
    std::optional<std::size_t> outside{};
    // The first point of Claim::keep that is not in its place. If there is one, nothing else was
    // looked at.
    std::optional<std::size_t> moved{};
    // The first class that has another number of points than Classes::counts says. If there is one,
    // nothing else was looked at.
    std::optional<std::size_t> miscounted{};
    // The first point that lies where no point may, and what forbids it. If there is one, nothing
    // else was looked at.
    enum class Closed { importance, mask, polygons, border };
    std::optional<std::size_t> forbidden{};
    Closed forbidden_by = Closed::importance;

    // The closest pair, if there are two points: with a field, the two whose distance is the
    // smallest share of their limit, or a pair below a millionth of its limit.
    bool kept = false;
    std::size_t first = 0;
    std::size_t second = 0;
    double least_distance = 0;  // infinite for fewer than two points
    double least_limit = 0;     // what the two must keep: the radius, or the smaller of theirs

    // The largest gap, if there is a point: the spot that is farthest from every point. With a
    // field it is the spot that is farthest over its limit, or any spot if all are covered. With
    // ellipses it is the spot that would need the largest tolerance.
    bool covered = false;
    Point largest_gap{0, 0};
    double largest_gap_distance = 0;  // to the nearest point; with a field, to the one whose limit
                                      // the spot exceeds least
    double largest_gap_limit = 0;     // the radius, or the smaller of the spot's and that point's
    std::size_t largest_gap_class = 0;  // with classes: the one for which the gap is

    double tolerance = 0;  // how far over its limit a covered spot may be: as claimed, or chosen
    // The set is kept and covered, and the tolerance is at most 1 % of the radius, or of the least
    // radius of a field, with ellipses the least shorter one. With a larger tolerance a set that
    // lacks points would pass.
    bool maximal = false;
};

// `keep_going`, if given, is asked often, by every thread that works; if it returns false the work
// ends. Throws BadRequest for a domain, radius, tolerance, field, scale, mask, polygons or border
// that makes no sense, Unavailable if the system makes no threads, and Cancelled.
Proof prove(std::span<const Point> points, const Claim& claim,
            const std::function<bool()>& keep_going = {});

// What a set that sample() made of this request promises: its radius or scale in its domain, where
// its points may lie, and its classes and kept points.
//   - Gaps are looked for in maximal sets of mode exact alone; other sets promise distances.
//   - In mode lines without snap the distance is radius * (1 - 1 / (2 * lines_per_radius)).
//   - Sets of mode stratified promise no more than Result::radius, which is 0 unless
//     least_distance() or relaxing sets it; prove() refuses the claim of a radius of 0.
// The field, mask and kept points of the request and the classes of the result must outlive the
// claim.
Claim claim_of(const Request& request, const Result& result);

// The least distance of two points, as prove() computes it; infinite for fewer than two points.
// Throws BadRequest for a domain that makes no sense and for a point outside of it.
double least_distance(std::span<const Point> points, const Domain& domain = {});

}  // namespace lacuna
