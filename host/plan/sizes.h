// Sizes, numbers of samples and memory: what a radius or scale gives, and what a count needs
// (docs/design.md, section 5).
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <string>

#include "base/polling.h"
#include "plan/make_plan.h"

namespace lacuna {

// Maximal sets on a torus: N r^2 over the area, which is the jamming density of random sequential
// adsorption, and the standard deviation of N over sqrt(N).
inline constexpr double kTorusDensity = 0.69656;
inline constexpr double kCountDeviation = 0.244;

// The radius at which a maximal set is expected to have this number of samples, at most the largest
// that the domain allows. `count` need not be a whole number.
double radius_expecting(const Request& request, double count);
// Throws BadRequest or MemoryRefused, for request.count, if it needs too small a radius.
void check_radius_for_count(const Request& request, double radius);

// In mode cells, the expected samples at a least radius of 1 user unit: the density times the
// integral of importance / greatest importance, less the lattice's loss (plan_cells.cpp).
double samples_at_radius_one(const Request& request, const FieldSums& sums);
// The scale at which a maximal set is expected to have `count` points. Throws like the next.
double scale_for_count(const Request& request, const FieldSums& sums, std::uint64_t count);
// Throws BadRequest or MemoryRefused, for request.count, if its lattice would be too large.
void check_scale_for_count(const Request& request, const FieldSums& sums, double scale);

// What a plan with a radius field has at a size, its radius or scale.
struct FieldSize {
    double least_radius;
    double samples;  // expected number in a maximal set
};
// Throws BadRequest or MemoryRefused, for the request's count, scale or radius, if it is too small.
FieldSize check_radius_field_size(const Request& request, double size,
                                  const Poll& poll = nobody_asks);
// The scale, or without a field the radius, at which a maximal set of the request is expected to
// have `count` samples.
double radius_field_scale_for_count(const Request& request, double count,
                                    const Poll& poll = nobody_asks);

// Most free spans of a line that is `radii` radii long. A line has most spans after the second or
// third round, 0.272 per radius on average, whatever m. In 18 sets of 20 to 1,000 radii no line had
// more than this function's value less 8.
double most_spans(double radii);

// The memory that a set may take if the request does not say.
std::uint64_t machine_memory_bytes();
// Throws BadRequest for `option` if `bytes` is more than the request or the machine allows.
void refuse_more_memory(const Request& request, const std::string& option, const std::string& value,
                        double bytes);

// The least distance of the centres of two pixels, computed in double; 0 for a single pixel.
double least_pixel_step(const Raster& raster, const Domain& domain);

}  // namespace lacuna
