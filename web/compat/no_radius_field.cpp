// Replaces the code for sets with a radius field (fields in mode exact, masks, borders, kept
// points and progressive orders), which the page does not offer.
#include <memory>

#include "backends/cpu/make_backend.h"
#include "plan/kept.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "verify/region.h"

namespace lacuna {
namespace {

[[noreturn]] void refuse() {
    throw Unavailable(
        "fields in mode exact, masks, borders, kept points and progressive orders are not for "
        "the page");
}

}  // namespace

Plan make_radius_field_plan(const Request&, const Poll&, std::span<const Sample>) {
    refuse();
}
double radius_field_scale_for_count(const Request&, double, const Poll&) {
    refuse();
}
void check_kept_place(const Request&, std::size_t, const char*) {
    refuse();
}
FieldSize check_radius_field_size(const Request&, double, const Poll&) {
    refuse();
}
bool keep_their_distances(const Request&) {
    refuse();
}
// Called for requests without kept points, too. check_kept_place() refuses all others.
void check_kept_distances(const Request&) {}

// The reference backend calls these only if there is a radius field.
Under RadiusField::under(const Box&) const {
    refuse();
}
std::uint32_t RadiusField::cut_x(const Box&) const {
    refuse();
}
std::uint32_t RadiusField::cut_y(const Box&) const {
    refuse();
}

std::unique_ptr<Backend> cpu::make_field_backend(const Plan&, const Placement&) {
    refuse();
}

// Claims of the page have no polygons, so these are never called.
verify::Region::Region(std::span<const PolygonSet>, double) {}
verify::Openness verify::Region::under(const Cell&, double) const {
    refuse();
}
double verify::Region::depth_of(Point) const {
    refuse();
}

}  // namespace lacuna
