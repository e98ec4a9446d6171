// What places are on a domain: sets of polygons, for all points or for each class, and borders.
#pragma once

#include <lacuna/places.h>
#include <lacuna/sample.h>
#include <lacuna/verify.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace lacuna::places {

class Sets {
public:
    // Pages are stretched over the domain, and obstacles have images around a torus. Borders are
    // kept from insides and outsides, and from obstacles too if they are the radii of objects.
    // Throws BadRequest for an outline of a class that there is not.
    Sets(const Places& places, const Domain& domain, const Classes& classes);
    Sets(const Sets&) = delete;
    Sets& operator=(const Sets&) = delete;

    // 1 if the sets are those of all points; else one for each class.
    std::size_t size() const { return kinds_.size(); }
    // Those of a class, or of all.
    std::span<const PolygonSet> operator[](std::size_t kind) const {
        return size() == 1 ? sets_.front() : sets_[kind];
    }
    // The first class that has the same ones.
    std::size_t first_like(std::size_t kind) const;
    // Those of the class that has most.
    std::span<const PolygonSet> most() const;

private:
    // The numbers of outlines, and how far points stay from each.
    using Clearances = std::vector<std::pair<std::size_t, double>>;

    std::vector<std::vector<PolygonRing>> rings_;  // of each outline, and of its images
    std::vector<Clearances> kinds_;
    std::vector<std::vector<PolygonSet>> sets_;
};

// Gives points, or each class, the border of Places::border_by_radius. Without a radius it is the
// least distance of the classes. Throws BadRequest for a torus, and if the domain has no place for
// an object.
void take_border_by_radius(std::optional<double> radius, const Domain& domain,
                           const Classes& classes, Places& places);

// How far the outlines of a set of this least radius are off, if nothing else is said.
double edge_of_radius(double least_radius);

// Throws BadRequest for places of a claim that make no sense.
void check(const Claim& claim);

// A claim that was checked, with numbers in place of Places::border_by_radius and of an edge that
// is not given, and masks that are cut to its domain. Null if nothing had to be filled in.
std::shared_ptr<const Claim> settled(const Claim& claim);

}  // namespace lacuna::places
