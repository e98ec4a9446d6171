// The functions of lacuna.h: options are read by the table, as the command reads them.
#include <lacuna.h>
#include <lacuna/lacuna.h>
#include <lacuna/stipple.h>
#include <lacuna/verify.h>
#include <lacuna/version.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "c/calls.h"
#include "c/given.h"
#include "checks/classes.h"
#include "options/chunk.h"
#include "options/claim.h"
#include "options/make.h"
#include "options/read_text.h"
#include "options/settle.h"
#include "options/targets.h"
#include "plan/checked_request.h"

namespace lacuna {
namespace {

using c::error_of_thread;
using c::Watched;

lacuna_set* set_of(const Request& request, Result result) {
    auto set = std::make_unique<lacuna_set>();
    set->points = std::move(result.points);
    set->layers = std::move(result.classes);
    set->facts = {request.domain.width,
                  request.domain.height,
                  result.radius,
                  result.maximal ? 1 : 0,
                  request.domain.x0,
                  request.domain.y0,
                  0};
    return set.release();
}

lacuna_set* sampled(const char* options, const lacuna_given* given) {
    if (given != nullptr && given->classes != nullptr)
        throw BadRequest("classes", "given", "are those of the points that lacuna_verify() proves");
    Request request;
    c::ClassesAndBorders classes;
    options::Choices choices;
    options::Moves moves;
    options::Targets targets = options::targets_of(request);
    targets.merge(options::targets_of(moves));
    targets["mode"] = &choices.mode;
    targets["metric"] = &choices.metric;
    targets["relax"] = &choices.relax;
    classes.add_to(targets);
    options::ChunkOptions chunk_options;
    targets.merge(options::targets_of(chunk_options));
    const options::CommandLine line =
        options::read_text(options::kSample, options, targets, c::names_of(given, "field"));
    const c::Given held(given, request, line);
    classes.take_to(request);
    choices.has_domain = line.has("domain");
    choices.gaussian = moves.gaussian;
    moves.iterations = options::relax_of(choices);
    options::settle(choices, request);
    const std::optional<Chunk> chunk = options::chunk_of(chunk_options, request);
    if (chunk) request = chunk->request;
    Watched observer;
    return set_of(request, options::make(request, moves, observer).result);
}

lacuna_set* stippled(const char* options, const void* picture, std::size_t bytes) {
    StippleOptions asked;
    options::read_text(options::kStipple, options, options::targets_of(asked));
    if (asked.tone.along != 1)
        throw BadRequest("along", shortest(asked.tone.along),
                         "makes ellipses, which have no place in lacuna.h");
    if (picture == nullptr) throw BadRequest("picture", "NULL", "must be the content of a file");
    Picture given{std::string(static_cast<const char*>(picture), bytes), "the picture"};
    Watched observer;
    Stippling made = stipple(given, asked, observer);
    std::unique_ptr<lacuna_set> set(set_of(made.request, std::move(made.result)));
    set->diameters = std::move(made.diameters);
    if (set->diameters.empty() && made.line_width != 0)
        set->diameters.assign(set->points.size(), made.line_width);
    for (std::size_t k = 0; k < made.layers.size() && made.layers.size() > 1; ++k)
        set->layers.insert(set->layers.end(), made.layers[k].dots, static_cast<unsigned char>(k));
    return set.release();
}

lacuna_set* relaxed(const char* options, const lacuna_given* given, const double* points,
                    std::size_t count) {
    if (given != nullptr && given->kept_count != 0)
        throw BadRequest("keep", std::to_string(given->kept_count) + " points",
                         "are not for relax, which moves all points");
    if (given != nullptr && given->allowed != nullptr)
        throw BadRequest("mask", "given", "is not for relax, which moves points anywhere");
    if (given != nullptr && given->outline_count != 0)
        throw BadRequest("outlines", "given", "are not for relax, which moves points anywhere");
    Request request;
    options::Moves moves{.iterations = RelaxOptions().iterations};
    options::Targets targets = options::targets_of(request);
    targets.merge(options::targets_of(moves));
    targets["iterations"] = &moves.iterations;
    const options::CommandLine line =
        options::read_text(options::kRelax, options, targets, c::names_of(given, "IMAGE"));
    const c::Given held(given, request, line);
    Watched observer;
    const std::vector<Point> all = c::points_of("points", points, count);
    Result result;
    result.points =
        relax(all, request.field, options::relax_options_of(request, moves), observer).points;
    options::note_moves(request, result);
    return set_of(request, std::move(result));
}

std::string distance_in(const Proof& proof) {
    return "points " + std::to_string(proof.first) + " and " + std::to_string(proof.second) +
           ", numbered from 0, are " + shortest(proof.least_distance) + " apart, less than " +
           shortest(proof.least_limit);
}

// What the set lacks; empty if it is as claimed.
std::string lack_of(const Proof& proof, const Claim& claim) {
    const auto point = [](std::size_t number) { return "point " + std::to_string(number); };
    if (proof.outside)
        return point(*proof.outside) + ", numbered from 0, lies outside of the domain";
    if (proof.moved) return point(*proof.moved) + ", numbered from 0, is not the one that was kept";
    if (proof.miscounted)
        return "class " + std::to_string(*proof.miscounted) +
               ", numbered from 0, has another number of points than asked for";
    if (proof.forbidden)
        return point(*proof.forbidden) + ", numbered from 0, lies where no point may";
    if (!proof.kept) return distance_in(proof);
    if (claim.distances_only || proof.maximal) return "";
    if (proof.covered)
        return "not proven maximal, as the tolerance is over 1 % of the radius: " +
               shortest(proof.tolerance);
    const std::vector<std::string>& classes = claim.classes.names;
    return "there is room for a point " +
           (classes.empty() ? "" : "of class " + classes[proof.largest_gap_class] + " ") + "at (" +
           shortest(proof.largest_gap.x) + ", " + shortest(proof.largest_gap.y) + "), " +
           shortest(proof.largest_gap_distance) + " from the nearest one";
}

int verified(const char* options, const lacuna_given* given, const double* points,
             std::size_t count) {
    Request request;
    std::optional<double> tolerance;
    bool distances_only = false;
    c::ClassesAndBorders classes;
    options::Targets targets = options::targets_of(request);
    targets["tolerance"] = &tolerance;
    targets["distances-only"] = &distances_only;
    classes.add_to(targets);
    const options::CommandLine line =
        options::read_text(options::kVerify, options, targets, c::names_of(given, "field"));
    const c::Given held(given, request, line);
    classes.take_to(request);
    if (!(request.field != nullptr ? request.scale : request.radius))
        throw BadRequest(request.field != nullptr ? "scale" : "radius", "missing",
                         "give the distance that points should keep");
    Claim claim = options::claim_of(request);
    claim.tolerance = tolerance;
    claim.distances_only = distances_only || !has_open_class(request.classes);
    if (given != nullptr && given->classes != nullptr)
        claim.class_of_points = {given->classes, count};
    Watched observer;
    const std::uint64_t all = count;
    const Proof proof = prove(c::points_of("points", points, count), claim, [&] {
        return observer.keep_going({0, std::max<std::uint64_t>(1, all), 0});
    });
    error_of_thread = lack_of(proof, claim);
    return error_of_thread.empty() ? 1 : 0;
}

}  // namespace
}  // namespace lacuna

const char* lacuna_version(void) {
    return LACUNA_VERSION;
}

const char* lacuna_error(void) {
    return lacuna::c::error_of_thread.c_str();
}

void lacuna_watch(int (*go_on)(double done, void* user), void* user) {
    lacuna::c::watch_of_thread = nullptr;
    if (go_on != nullptr)
        lacuna::c::watch_of_thread = [=](double done) { return go_on(done, user) != 0; };
}

lacuna_set* lacuna_sample(const char* options, const lacuna_given* given) {
    return lacuna::c::guarded(static_cast<lacuna_set*>(nullptr),
                              [&] { return lacuna::sampled(options, given); });
}

lacuna_set* lacuna_stipple(const char* options, const void* picture, size_t bytes) {
    return lacuna::c::guarded(static_cast<lacuna_set*>(nullptr),
                              [&] { return lacuna::stippled(options, picture, bytes); });
}

lacuna_set* lacuna_relax(const char* options, const lacuna_given* given, const double* points,
                         size_t count) {
    return lacuna::c::guarded(static_cast<lacuna_set*>(nullptr),
                              [&] { return lacuna::relaxed(options, given, points, count); });
}

int lacuna_verify(const char* options, const lacuna_given* given, const double* points,
                  size_t count) {
    return lacuna::c::guarded(-1, [&] { return lacuna::verified(options, given, points, count); });
}

size_t lacuna_count(const lacuna_set* set) {
    return set == nullptr ? 0 : std::max(set->points.size(), set->in_space.size());
}

const double* lacuna_points(const lacuna_set* set) {
    static_assert(sizeof(lacuna::Point) == 2 * sizeof(double));
    static_assert(sizeof(lacuna::Point3) == 3 * sizeof(double));
    if (lacuna_count(set) == 0) return nullptr;
    return set->points.empty() ? &set->in_space.front().x : &set->points.front().x;
}

const double* lacuna_diameters(const lacuna_set* set) {
    return set == nullptr || set->diameters.empty() ? nullptr : set->diameters.data();
}

const unsigned char* lacuna_layers(const lacuna_set* set) {
    return set == nullptr || set->layers.empty() ? nullptr : set->layers.data();
}

lacuna_facts lacuna_describe(const lacuna_set* set) {
    return set == nullptr ? lacuna_facts{} : set->facts;
}

void lacuna_free(lacuna_set* set) {
    delete set;
}
