// A request in space, checked, and its plan in whole numbers.
#pragma once

#include <lacuna/space.h>

#include "plan/plan.h"
#include "space/first_bins.h"

namespace lacuna::space {

class CheckedRequest {
public:
    // Refers to the request. Throws BadRequest.
    explicit CheckedRequest(const SpaceRequest& request);

    const SpaceRequest& operator*() const { return *request_; }
    const SpaceRequest* operator->() const { return request_; }
    const Units& units() const { return units_; }

    // The expected number of points of a maximal set.
    double expected(double radius) const;
    // The radius at which so many are expected, within what the surface or the volume allows.
    double radius_expecting(double count) const;
    double smallest_radius() const;
    double largest_radius() const;
    // The plan of a set of at most `most` points, kept ones included. Throws BadRequest and
    // MemoryRefused.
    Plan plan(double radius, std::uint64_t most) const;

private:
    void find_units_of_mesh();
    void find_units_of_volume();
    void check_keep() const;
    bool wraps() const {
        return request_->mesh == nullptr && request_->volume.boundary == Boundary::torus;
    }

    const SpaceRequest* request_;
    Units units_;
    std::array<std::int32_t, 3> sides_{};  // of the volume, or the box around the mesh
    double measure_ = 0;                   // area or volume, in the user's unit
    double edges_ = 0;                     // the sum of the longest sides of all triangles
    double lost_ = 0;                      // how far a distance may be off by rounding to doubles
};

}  // namespace lacuna::space
