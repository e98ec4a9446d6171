// Stands in the page's module for what makes sets with a radius field, which the page does not
// offer: fields in mode exact, masks, borders and kept points.
#include <memory>

#include "backends/cpu/make_backend.h"
#include "plan/kept.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "verify/outline.h"

namespace lacuna {
namespace {

[[noreturn]] void refuse() {
    throw Unavailable("fields in mode exact, masks, borders and kept points are not for the page");
}

}  // namespace

Plan make_radius_field_plan(const Request&, const Poll&) {
    refuse();
}
double radius_field_scale_for_count(const Request&, double, const Poll&) {
    refuse();
}
void check_kept_place(const Request&, std::size_t) {
    refuse();
}
// No points are kept: the one above refuses them.
void check_kept_distances(const Request&) {}

// The reference asks these only where there is a radius field.
Under RadiusField::under(const Rectangle&) const {
    refuse();
}
std::uint32_t RadiusField::cut_x(const Rectangle&) const {
    refuse();
}
std::uint32_t RadiusField::cut_y(const Rectangle&) const {
    refuse();
}

std::unique_ptr<Backend> cpu::make_field_backend(const Plan&, const Placement&) {
    refuse();
}

// Claims of the page name no polygons, so nobody asks these.
verify::Outline::Outline(std::span<const std::vector<Point>>) {}
verify::Openness verify::Outline::under(const Cell&, double) const {
    refuse();
}
double verify::Outline::depth_of(Point) const {
    refuse();
}

}  // namespace lacuna
