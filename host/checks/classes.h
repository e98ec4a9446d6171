// Questions about classes of points, and what no request and no claim may have of them.
#pragma once

#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lacuna {

// The least distances of classes, class by class in rows, as shares of the least that is not 0.
// Without classes there is one distance.
std::vector<double> distances_of(const Classes& classes);
// The greatest of these shares.
double greatest_share(const Classes& classes);
// The distance that two points of one class keep, in the request's unit.
double own_distance_of(const Classes& classes, std::size_t of_class);
// The least distance that is not 0, in the request's unit, which Request::radius or scale stand
// for. Infinite if there is none.
double least_distance_of(const Classes& classes);
// Gives a request of classes their least distance as its radius, or with a field as its scale,
// unless it has one or a count.
void take_size_of_classes(Request& request);
// The radius of a claim, or with a field its scale; with classes their least distance, unless the
// claim has one.
double size_of(const Claim& claim);
// The distances that classes keep in a set, over those of its request: not 1 if the request has a
// count, or a radius or scale of its own.
double distance_factor(const Request& request, const Result& result);

// Where samples of a class may lie: its own border and mask, or those of the request. The class is
// 0 in a request without classes.
double border_of(const Request& request, std::size_t of_class);
const Mask* mask_of(const Request& request, std::size_t of_class);
// Whether a class may have a border, a mask or an outline of its own.
bool has_own_places(const Places& places);
// Whether a class has a number of points.
bool has_counts(const Classes& classes);
// Whether the set is made in stages, in which not all classes are drawn.
bool has_stages(const Classes& classes);
// Whether a class is drawn until it has no room: one that has a weight and no number of points.
bool is_open(const Classes& classes, std::size_t of_class);
// The classes of the kind that `of_class` is one of, which have its name: first to last, as places.
// With sizes there are several (Classes::names).
struct KindOfClass {
    std::size_t first;
    std::size_t last;
};
KindOfClass kind_of(const Classes& classes, std::size_t of_class);
// Whether a kind has several sizes.
bool has_sizes(const Classes& classes);
// Whether there is such a class, so that a set may be maximal, or no class at all.
bool has_open_class(const Classes& classes);

// Checks that there is none of `what`, or one for each class. Throws BadRequest.
void check_each(const Classes& classes, const char* option, std::size_t size, const char* what);
// Checks that an order of classes has classes, and no weights. Throws BadRequest.
void check_priority(const Classes& classes);
// Checks the distances of classes that have names: that they are a matrix of finite numbers, the
// same both ways, and over 0 within each class. Throws BadRequest.
void check_distances(const Classes& classes);
// Checks the classes of points, one for each of `points`. `option` names them. Throws BadRequest.
void check_classes_of_points(const Classes& classes, const char* option, std::size_t points,
                             std::span<const std::uint8_t> of_points);

}  // namespace lacuna
