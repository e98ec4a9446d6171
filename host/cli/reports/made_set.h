// A set of `lacuna sample`, as its files show it: with its classes and its ellipses.
#pragma once

#include <lacuna/lacuna.h>

#include <vector>

#include "cli/reports/random_columns.h"
#include "files/point_files.h"
#include "stipple/dot_size.h"

namespace lacuna::cli {

struct Showing {
    bool ellipse_columns;    // --ellipse-columns
    bool is_sized_by_radii;  // each dot is two thirds of its ellipse; the field is no picture
    std::vector<RandomColumn> columns;  // of --columns
};

// Half of the distance that two of each class keep.
std::vector<double> radii_of_classes(const Request& request, const Result& result);

// Refers to the request, the result and the origin, which must outlive it.
class MadeSet {
public:
    MadeSet(const Request& request, const Result& result, const files::Origin& origin,
            const Showing& showing);
    MadeSet(const MadeSet&) = delete;
    MadeSet& operator=(const MadeSet&) = delete;

    const files::PointSet& points() const { return set_; }
    // The diameters of its dots; empty if all follow from the radius.
    std::vector<double> diameters(stippling::Spread spread) const;

private:
    const Request& request_;
    const Result& result_;
    std::vector<files::Layer> layers_;
    std::vector<Ellipse> ellipses_;
    bool is_sized_by_radii_;
    std::vector<files::Column> more_;
    files::PointSet set_;
};

}  // namespace lacuna::cli
