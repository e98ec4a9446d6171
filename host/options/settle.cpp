// Decides the defaults.
#include "options/settle.h"

#include <string>

#include "lattice/lattice.h"

namespace lacuna::options {
namespace {

bool is_about_distances(const Choices& given, const Request& request) {
    return given.metric || request.radius || request.scale || request.paper2011.lines_per_radius ||
           request.limit || request.paper2011.round_size != 0;
}

Mode mode_of(const Choices& given, const Request& request) {
    if (given.mode) return *given.mode;
    if (request.on_pixels) return Mode::pixels;
    if (given.has_inks) return Mode::stratified;
    if (given.has_ellipses) return Mode::exact;
    // The dots of a picture have a number of their own; other sets need one to be stratified.
    const bool has_count = request.count || given.is_picture;
    if (relax_of(given) != 0 && has_count && !is_about_distances(given, request))
        return Mode::stratified;
    return given.is_picture ? Mode::cells : Mode::exact;
}

}  // namespace

std::uint32_t relax_of(const Choices& given) {
    if (given.relax) return *given.relax;
    return given.is_picture && !given.has_ellipses ? RelaxOptions{}.iterations : 0;
}

void settle(const Choices& given, Request& request) {
    const std::uint32_t relax = relax_of(given);
    if (given.has_inks && relax == 0)
        throw BadRequest("relax", "0", "must be at least 1 for inks, whose dots are relaxed");
    if (relax > relaxing::kMostIterations)
        throw BadRequest("relax", std::to_string(relax),
                         "must be at most " + std::to_string(relaxing::kMostIterations));
    if (given.metric && !given.is_picture && request.field == nullptr)
        throw BadRequest("metric", std::string(name_of(*given.metric)), "is for a field");
    request.mode = mode_of(given, request);
    if (request.on_pixels && !given.has_domain) {
        request.domain.width = request.on_pixels->columns;
        request.domain.height = request.on_pixels->rows;
    }
    if (request.mode == Mode::stratified && relax == 0 && given.gaussian == 0)
        throw BadRequest("mode", std::string(name_of(request.mode)), "is a start for --relax");
    request.metric = given.metric.value_or(request.mode == Mode::cells && relax != 0 ? Metric::mean
                                                                                     : Metric::min);
}

}  // namespace lacuna::options
