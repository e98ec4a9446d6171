// Checks the points that a request keeps: samples that exist already.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lacuna {

// Which kept points are points of the set. If all lie in the domain, to which the upper edges of a
// box belong, all are. If some lie outside, there are sets beside this one. Then points on the
// upper edges are outside, too, because they lie in the domains of those sets.
class Members {
public:
    explicit Members(const Request& request);
    bool are_all() const { return are_all_; }
    bool has(Point kept) const;

private:
    Domain domain_;
    bool are_all_;
};

// The members in their order, then the kept points outside that a point of the domain may be too
// close to. Without a radius, these are all.
struct SortedKept {
    std::vector<Point> points;
    std::vector<std::uint8_t> classes;
    std::vector<std::uint32_t> places;  // of each in Request::keep, for messages
    std::size_t members = 0;
    bool has_radius = false;

    std::size_t neighbours() const { return points.size() - members; }
};
SortedKept sorted_kept(const Request& request);

// Checks a point of Request::keep: it lies outside of a box, or where samples may lie. Throws
// BadRequest.
void check_kept(const Request& request, const Members& members, std::size_t index);

// Checks that a point lies in the domain, to which the upper edges of a box belong, on a pixel
// where samples may lie. A point within 2^-28 of
// the longer side of a pixel's border counts for both pixels, because a set that was made in whole
// units may be that far off. Throws BadRequest that names `option` and the point.
void check_kept_place(const Request& request, std::size_t index, const char* option = "keep");

// The radius of each kept point: the request's or, with a field, its scale over the root of the
// greatest importance at the point; with ellipses the longest radius.
std::vector<double> radii_of_kept(const Request& request);

// Whether no two kept points are closer than the smaller of their radii. The request was checked
// before, and has a radius or a scale.
bool keep_their_distances(const Request& request);

// Checks that no two kept points are closer than the smaller of their radii. The request was
// checked before, and has a radius or a scale. Throws BadRequest that names both points, by their
// `places` in the request as it was given; empty: these are their places in this one.
void check_kept_distances(const Request& request, std::span<const std::uint32_t> places = {});

}  // namespace lacuna
