// Where samples of each class may lie, and the closest pair and the largest gap of samples in
// classes.
#pragma once

#include <lacuna/verify.h>

#include <cstddef>
#include <deque>
#include <span>

#include "verify/closest.h"
#include "verify/largest_gap.h"
#include "verify/patience.h"
#include "verify/radius_field.h"

namespace lacuna::verify {

// A radius field for all samples, or one for each class if classes may lie in places of their own.
class Fields {
public:
    // `parts` are those of all classes, and `domain` begins at (0, 0). All that these point to must
    // outlive this. Polygons are moved by the claim's corner.
    Fields(const Domain& domain, const FieldParts& parts, const Claim& claim);

    // Radii are the same in all.
    const RadiusField& any() const { return fields_.front(); }
    const RadiusField& of_class(std::size_t kind) const {
        return fields_.size() == 1 ? fields_.front() : fields_[kind];
    }
    const RadiusField& of_sample(const Claim& claim, std::size_t sample) const {
        return fields_.size() == 1 ? fields_.front() : fields_[claim.class_of_points[sample]];
    }

private:
    std::deque<RadiusField> fields_;
};

// The samples are in the order of Claim::class_of_points, each with its radius for the least
// distance of all classes.
Pair closest_of_classes(const Domain& domain, const Claim& claim, std::span<const Disk> samples,
                        const Patience& patience);

// The largest gap of the classes that are drawn, and the class for which it is. Samples from
// `members` on are neighbours. By priority a class is asked beside those before it, and what was
// kept.
struct GapOfClass {
    Gap gap;
    std::size_t of_class;
};
GapOfClass largest_gap_of_classes(const Fields& fields, const Claim& claim,
                                  std::span<const Disk> samples, std::size_t members,
                                  double tolerance, const Patience& patience);

}  // namespace lacuna::verify
