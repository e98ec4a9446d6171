// A set that was made, and what files need besides its points.
#include "cli/reports/made_set.h"

#include <cmath>

#include "checks/classes.h"
#include "cli/options/domain_options.h"

namespace lacuna::cli {

std::vector<double> radii_of_classes(const Request& request, const Result& result) {
    const double half = distance_factor(request, result) / 2;
    std::vector<double> radii;
    for (std::size_t i = 0; i < request.classes.names.size(); ++i)
        radii.push_back(half * own_distance_of(request.classes, i));
    return radii;
}

MadeSet::MadeSet(const Request& request, const Result& result, const files::Origin& origin,
                 const Showing& showing)
    : request_(request),
      result_(result),
      layers_(layers_of(request.classes, result)),
      ellipses_(ellipses_of(request, result)),
      is_sized_by_radii_(showing.is_sized_by_radii),
      more_(values_of(showing.columns, request.seed, result.points.size())),
      set_{result.points, request.domain, result.radius, &origin} {
    if (has_sizes(request.classes))
        more_.push_back(files::radius_of_each(result.classes, radii_of_classes(request, result)));
    set_.more = more_;
    set_.on_pixels = request.on_pixels;
    set_.ellipses = ellipses_;
    set_.writes_ellipses = showing.ellipse_columns;
    set_.layers = layers_;
    if (layers_.empty()) return;
    set_.layer_of_point = result.classes;
    set_.layers_are = files::LayersAre::classes;
}

std::vector<double> MadeSet::diameters(stippling::Spread spread) const {
    if (!layers_.empty()) return class_diameters(request_, result_);
    if (is_sized_by_radii_) {
        std::vector<double> diameters;
        for (const Ellipse& ellipse : ellipses_)
            diameters.push_back(2. / 3 * std::sqrt(ellipse.a * ellipse.b));
        return diameters;
    }
    return dots_of(request_, result_.points, spread);
}

}  // namespace lacuna::cli
