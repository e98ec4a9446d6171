// Checks the options of a request.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/number_text.h"
#include "base/polling.h"
#include "base/threads.h"
#include "checks/classes.h"
#include "checks/domain.h"
#include "checks/numbers.h"
#include "checks/pixels.h"
#include "plan/checked_request.h"
#include "plan/sizes.h"

namespace lacuna {
namespace {

constexpr std::uint32_t kMostPixelsASide = 32767;  // of .png files
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 26;
constexpr std::uint32_t kMostLinesPerRadius = 1000;
constexpr std::uint64_t kMostPoints = std::uint64_t{1} << 31;     // of a set without distances
constexpr std::uint64_t kMostRoundSize = std::uint64_t{1} << 31;  // draws have 32-bit numbers

// A program may cast any number to an enum.
void check_enums(const Request& request) {
    const auto refuse = [](const char* option, auto value, const char* allowed) {
        throw BadRequest(option, std::to_string(static_cast<long long>(value)), allowed);
    };
    if (name_of(request.mode).empty())
        refuse("mode", request.mode, "must be Mode::exact, lines, cells, stratified or pixels");
    if (name_of(request.metric).empty())
        refuse("metric", request.metric, "must be Metric::min, mean or max");
    if (request.domain.boundary != Boundary::box && request.domain.boundary != Boundary::torus)
        refuse("boundary", request.domain.boundary, "must be Boundary::box or torus");
}

void check_round_size(const Request& request) {
    constexpr double kBytesPerDraw = 96;  // draw, candidate, status, and memory to sort them
    const std::uint64_t size = request.paper2011.round_size;
    const std::string value = std::to_string(size);
    if (request.paper2011.uniform_x && size > 1)
        throw BadRequest("round-size", value,
                         "must be 1 with --uniform-x, whose draws cannot be thinned");
    if (size > kMostRoundSize)
        throw BadRequest("round-size", value, "must be at most " + std::to_string(kMostRoundSize));
    if (request.run_on.backend == "reference") return;  // the reference takes one draw at a time
    refuse_more_memory(request, "round-size", value, kBytesPerDraw * static_cast<double>(size));
}

// Checks the options of a request with a field, except scale and count.
void check_field(const Request& request) {
    const std::string mode(name_of(request.mode));
    if (request.field == nullptr) {
        if (request.mode == Mode::cells)
            throw BadRequest("field", "missing", "mode cells needs one");
        if (request.scale) throw BadRequest("scale", shortest(*request.scale), "is for a field");
        return;
    }
    if (request.mode == Mode::lines)
        throw BadRequest("field", "with mode " + mode, "is for modes exact and cells");
    if (request.radius)
        throw BadRequest("radius", shortest(*request.radius),
                         "is not for a field: give --scale or --count");
    if (request.mode == Mode::exact && request.metric != Metric::min)
        throw BadRequest("metric", std::string(name_of(request.metric)),
                         "is for mode cells; mode exact knows min");
    check_importance(*request.field);
    if (request.field->stretches.empty()) return;
    if (request.mode != Mode::exact)
        throw BadRequest("stretches", "with mode " + mode, "are for mode exact");
    if (!request.classes.names.empty())
        throw BadRequest("class", "with ellipses", "classes have disks");
    check_stretches(*request.field);
}

void check_raster(const Request& request) {
    const bool has_pixels = request.on_pixels.has_value();
    if (has_pixels != (request.mode == Mode::pixels))
        throw BadRequest("on-pixels", has_pixels ? text_of(*request.on_pixels) : "missing",
                         has_pixels ? "is for mode pixels" : "mode pixels needs its pixels");
    if (!has_pixels) return;
    const Raster& raster = *request.on_pixels;
    const std::string value = text_of(raster);
    if (raster.pixels() == 0 || std::max(raster.columns, raster.rows) > kMostPixelsASide ||
        raster.pixels() > kMostPixels)
        throw BadRequest("on-pixels", value,
                         "each side must be 1 to " + std::to_string(kMostPixelsASide) +
                             " pixels, all together at most " + std::to_string(kMostPixels));
    constexpr double kBytesPerPixel = 40;
    refuse_more_memory(request, "on-pixels", value,
                       kBytesPerPixel * static_cast<double>(raster.pixels()));
}

// Points along a curve, or on pixels, keep no distance, and a part of them is a part of the domain.
void check_counted(const Request& request) {
    const std::string mode = "mode " + std::string(name_of(request.mode));
    const auto refuse = [&](const char* option, const std::string& value) {
        throw BadRequest(option, value, "is not for " + mode + ", which takes --count");
    };
    if (request.radius) refuse("radius", shortest(*request.radius));
    if (request.scale) refuse("scale", shortest(*request.scale));
    if (request.limit) refuse("limit", std::to_string(*request.limit));
    if (request.paper2011.lines_per_radius)
        refuse("lines-per-radius", std::to_string(*request.paper2011.lines_per_radius));
    if (request.metric != Metric::min) refuse("metric", std::string(name_of(request.metric)));
    if (request.paper2011.round_size != 0)
        refuse("round-size", std::to_string(request.paper2011.round_size));
    if (!request.count) throw BadRequest("count", "missing", mode + " needs one");
    const std::string count = std::to_string(*request.count);
    if (*request.count > kMostPoints)
        throw BadRequest("count", count, "must be at most " + std::to_string(kMostPoints));
    constexpr double kBytesPerPoint = 200;  // to relax it
    refuse_more_memory(request, "count", count,
                       kBytesPerPoint * static_cast<double>(*request.count));
}

}  // namespace

void check_request(const Request& request) {
    check_enums(request);
    check_raster(request);
    check_domain(request.domain);
    const std::uint32_t lines = lines_per_radius(request);
    if (lines < 1 || lines > kMostLinesPerRadius)
        throw BadRequest("lines-per-radius", std::to_string(lines),
                         "must be between 1 and " + std::to_string(kMostLinesPerRadius));
    if (request.mode != Mode::lines && (request.paper2011.snap || request.paper2011.uniform_x))
        throw BadRequest(request.paper2011.snap ? "snap" : "uniform-x",
                         "with mode " + std::string(name_of(request.mode)),
                         "is for mode lines only");
    if (request.progressive && request.mode != Mode::exact)
        throw BadRequest("progressive", "with mode " + std::string(name_of(request.mode)),
                         "is for mode exact");
    if (request.mode == Mode::stratified || request.mode == Mode::pixels) check_counted(request);
    check_field(request);
    check_classes(request);
    check_where(request);
    if (request.limit && *request.limit == 0) throw BadRequest("limit", "0", "must be at least 1");
    const bool has_field = request.field != nullptr;
    const std::string size = has_field ? "scale" : "radius";
    const std::optional<double>& given = has_field ? request.scale : request.radius;
    if (given && request.count)
        throw BadRequest(size, shortest(*given), "give either --" + size + " or --count");
    if (!given && !request.count && request.classes.names.empty())
        throw BadRequest(size, "missing", "give either --" + size + " or --count");
    if (request.count && *request.count == 0) throw BadRequest("count", "0", "must be at least 1");
    check_threads(request.run_on.threads);
    check_round_size(request);
}

CheckedRequest::CheckedRequest(const Request& given) : resolved_(resolve(given)) {
    Request& request = resolved_.request;
    check_request(request);
    Classes& classes = request.classes;
    take_size_of_classes(request);
    if (classes.names.size() == 1) {
        request.places.border = border_of(request, 0);
        request.places.mask = mask_of(request, 0);
        request.places.borders.clear();
        request.places.masks.clear();
        classes = {};
        request.keep_classes = {};
    }
    sort_kept();
}

void CheckedRequest::sort_kept() {
    Request& request = resolved_.request;
    const bool is_sorted = kept_ && kept_->has_radius;
    if (is_sorted || Members(request).are_all()) return;
    SortedKept sorted = sorted_kept(request);
    if (kept_)
        for (std::uint32_t& place : sorted.places) place = kept_->places[place];
    kept_ = std::make_shared<const SortedKept>(std::move(sorted));
    request.keep = kept_->points;
    request.keep_classes = kept_->classes;
}

}  // namespace lacuna
