// Replaces the code for radius fields in the page's module, a tenth of the library. The page does
// not offer what it is for: fields in mode exact, masks, borders and kept points.
#include <memory>

#include "backends/cpu/make_backend.h"
#include "backends/reference/free_space.h"
#include "plan/kept.h"
#include "plan/plan.h"
#include "verify/ground_proof.h"

namespace lacuna {
namespace {

[[noreturn]] void refuse() {
    throw Unavailable("the page has no fields in mode exact, masks, borders and kept points");
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
// There are no kept points: check_kept_place refuses them.
void check_kept_distances(const Request&) {}

std::unique_ptr<Backend> cpu::make_field_backend(const Plan&, const Placement&) {
    refuse();
}
std::unique_ptr<reference::FreeSpace> reference::make_exact_with_field(const Plan&) {
    refuse();
}
Proof verify::prove_on_ground(std::span<const Point>, const Claim&, const Patience&) {
    refuse();
}
// No claim of the page has kept points.
std::optional<std::size_t> verify::first_moved(std::span<const Point>, std::span<const Point>) {
    return {};
}

}  // namespace lacuna
