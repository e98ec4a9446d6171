// Replaces the code for sets with a radius field (fields in mode exact, masks, borders, kept
// points, progressive orders, classes and ellipses), which the page does not offer.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backends/cpu/make_backend.h"
#include "backends/cpu/plain_ellipses.h"
#include "drawing/picture_svg.h"
#include "pictures/importance.h"
#include "plan/kept.h"
#include "plan/plan.h"
#include "plan/radius_field.h"
#include "plan/sheets.h"
#include "rounds/sheet_shares.h"
#include "verify/classes.h"
#include "verify/ellipse_samples.h"
#include "verify/region.h"

namespace lacuna {
namespace {

[[noreturn]] void refuse() {
    throw Unavailable(
        "fields in mode exact, masks, borders, kept points, progressive orders and classes are "
        "not for the page");
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

// Without classes a request is settled, and the domain is the only sheet.
void check_classes(const Request& request) {
    if (!request.classes.names.empty()) refuse();
}
Request settled(const Request& request) {
    return request;
}
Sheets::Sheets(std::uint32_t, std::span<const double>, std::span<const double>)
    : count_(1), bits_(BITS_OF_ONE_SHEET), factors_{FACTOR_ONE}, weights_{1} {}
std::uint32_t Sheets::greatest_factor(std::uint32_t) const {
    refuse();
}
SheetShares::SheetShares(std::span<const std::uint64_t>, std::span<const std::uint32_t>) {
    refuse();
}
std::uint64_t SheetShares::area_at(std::uint64_t) const {
    refuse();
}

// No picture of the page asks for stretches.
std::vector<Stretch> pictures::stretches_along(std::span<const double>, std::size_t, std::size_t,
                                               double) {
    refuse();
}

// No set of the page has ellipses.
void drawing::append_ovals(std::string&, const files::PointSet&, const Style&, const Page&) {
    refuse();
}

std::size_t cpu::plain::next_in_ellipse(const SizedSpan&, Sample, const FloatEllipse&,
                                        std::size_t) {
    refuse();
}
std::uint32_t cpu::plain::find_touching_ellipses(const SizedSpan&, const FloatEllipse*, const Box*,
                                                 const FloatEllipse*, std::uint8_t*) {
    refuse();
}

std::unique_ptr<Backend> cpu::make_field_backend(const Plan&, const Placement&) {
    refuse();
}

// Claims of the page have no polygons, no classes and no ellipses, so these are never called.
verify::EllipseSamples::EllipseSamples(std::span<const Point>, const RadiusField&, Proof&) {
    refuse();
}
verify::Pair verify::EllipseSamples::closest_pair(const RadiusField&, const Patience&) const {
    refuse();
}
verify::Gap verify::EllipseSamples::largest_gap(const RadiusField&, double, const Patience&) const {
    refuse();
}
verify::Pair verify::closest_of_classes(const Domain&, const Claim&, std::span<const Disk>,
                                        const Patience&) {
    refuse();
}
verify::GapOfClass verify::largest_gap_of_classes(const RadiusField&, const Claim&,
                                                  std::span<const Disk>, double, const Patience&) {
    refuse();
}
verify::Region::Region(std::span<const PolygonSet>) {}
verify::Openness verify::Region::under(const Cell&, double) const {
    refuse();
}
double verify::Region::depth_of(Point) const {
    refuse();
}

}  // namespace lacuna
