// Where points may lie, as people say it: polygons, obstacles, what points are near, masks and
// borders. Link lacuna; lacuna/domains.h reads these from files.
//
//     lacuna::Request request{.radius = 0.01};
//     request.places.outlines = {{.polygons = {{park, pond}}},  // a ring in a ring is a hole
//                                {.polygons = {{road}}, .role = lacuna::Role::avoid,
//                                 .distance = 0.05}};
//     const lacuna::Result set = lacuna::sample(request);
//     lacuna::prove(set.points, lacuna::claim_of(request, set)).maximal;  // to the true outlines
#pragma once

#include <lacuna/domain.h>
#include <lacuna/export.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace LACUNA_API lacuna {

// Rings, and the page that they are on. y goes upwards.
struct Polygons {
    std::vector<PolygonRing> rings{};  // of at least three points each, or lines
    // A box; only an .svg has one. It is stretched over the domain, its lower left corner on the
    // domain's. Without a page the coordinates are those of the domain.
    std::optional<Domain> page{};
};

// What rings are for points. Inside of them is what an odd number of them goes around (the even-odd
// rule), so that a ring within a ring is a hole.
//   inside   points lie inside; of several outlines with this role, in any of them
//   outside  points do not lie inside
//   avoid    points lie outside, and keep the distance from the rings. A line is a ring that goes
//            there and back, and a point is a ring of one point: nothing is inside of these
//   near     points lie within the distance of the rings, of this outline or of another one that is
//            near; an inside has no meaning
// On a torus what to avoid and what is near has images on all sides.
enum class Role { inside, outside, avoid, near };
inline constexpr std::array kRoles{Role::inside, Role::outside, Role::avoid, Role::near};
std::string_view name_of(Role role);
std::optional<Role> role_called(std::string_view name);
// Whether the distance from the rings is what the role is about: it must be given, and on a torus
// the rings have images.
inline bool has_distance(Role role) {
    return role == Role::avoid || role == Role::near;
}

// Whether points may not lie inside of the rings.
inline bool is_forbidden(Role role) {
    return role == Role::outside || role == Role::avoid;
}

// Rings on a domain, all in its unit, and how far points stay from them, or may be from those that
// are near. It refers to the rings.
struct PolygonSet {
    std::span<const PolygonRing> rings{};
    Role role = Role::inside;
    double distance = 0;
};

struct Outline {
    Polygons polygons{};
    Role role = Role::inside;
    // >= 0, in the domain's unit. Default: of inside and outside the border; else 0.
    std::optional<double> distance{};
    // The class of points that it is for. Empty: for all. But a class with an inside of its own has
    // that in place of those for all.
    std::string of_class{};
    // Whether the distance, too, is in the page's unit, as half of a drawn line's width is. The
    // domain then must have the page's shape.
    bool is_on_page = false;
};

struct Places {
    std::vector<Outline> outlines{};
    // Points lie on pixels of the mask that are not 0. Beside outlines the pixels' edges are
    // outlines, too, from which no border is kept. It must outlive the call.
    const Mask* mask = nullptr;
    // Least distance of points to each edge of the domain, in its unit; in a box only, and under
    // half of its shorter side. 0: points lie up to the edges. Outlines whose distance is not given
    // keep it, too.
    double border = 0;
    // In place of a border: objects lie inside with all of their extent: the border of points is
    // half of the distance that two of them keep, or two of their class. In boxes, for disks of one
    // radius, or one for each class, which must be given. Points then stay by their border from
    // obstacles, too, beyond the distance of these.
    bool border_by_radius = false;
    // How far inside of an outline points may begin, > 0: it is drawn onto pixels of this diagonal.
    // Default: a sixteenth of the least radius, which is estimated for a count.
    std::optional<double> edge{};
    // The border and the mask of each class of points, in place of those above. Empty: those are
    // for all. A mask may be null: then it is the one above. All must outlive the call.
    std::vector<double> borders{};
    std::vector<const Mask*> masks{};
};

struct Field;  // lacuna/sample.h

// The domain of places for which none is given. A field or, without one, a mask that has an extent
// or is alone gives it the shape of its pixels, with a longer side of 1. Else it is the first page
// of the outlines; else 1 x 1, or from (0, 0) to the farthest corner of rings that reach beyond it.
// If they lie far from (0, 0), or beyond it, the box around them where it lies, or a larger square
// if the box is so small that doubles are too coarse for it there. Throws BadRequest for a box
// without an area, and for coordinates and distances that are not finite.
Domain domain_around(const Places& places, const Field* field = nullptr);

// The rings of `polygons` for this domain. A page is stretched over it, its lower left corner on
// the domain's; without a page the coordinates do not change.
std::vector<PolygonRing> fitted(Polygons polygons, const Domain& domain);

// The mask of the inside of `rings` for this domain: a pixel is allowed if all of it is inside,
// with 2^-27 of the longer side to spare. No two points of a pixel are farther apart than `edge`.
// So no sample lies outside, and every spot is allowed that is farther than `edge` from the rings.
// Rings may leave no pixel allowed. Throws BadRequest for invalid numbers, and for a mask of more
// bytes than the limit (0: a quarter of the machine's memory).
Mask draw_mask(std::span<const PolygonRing> rings, const Domain& domain, double edge,
               std::uint64_t memory_limit_bytes = 0);
// The same for several sets of polygons: a pixel is allowed if samples may lie on all of it. With a
// distance, every spot is allowed that is farther than this and `edge` from the rings.
Mask draw_mask(std::span<const PolygonSet> sets, const Domain& domain, double edge,
               std::uint64_t memory_limit_bytes = 0);
// The same pixels as Mask::drawn. Time and memory are in proportion to the length of the outlines,
// whatever the extent of the domain.
Mask draw_places(std::span<const PolygonSet> sets, const Domain& domain, double edge,
                 std::uint64_t memory_limit_bytes = 0);

}  // namespace lacuna
