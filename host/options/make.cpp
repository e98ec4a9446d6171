// Samples, then relaxes.
#include "options/make.h"

#include <lacuna/verify.h>

#include <string_view>
#include <utility>
#include <vector>

#include "lattice/lattice.h"
#include "options/targets.h"
#include "relax/descent.h"

namespace lacuna::options {

RelaxOptions relax_options_of(const Request& request, const Moves& moves) {
    RelaxOptions options;
    options.domain = request.domain;
    options.iterations = moves.iterations;
    options.gaussian = moves.gaussian;
    options.gaussian_distance = moves.gaussian_distance.value_or(options.gaussian_distance);
    options.run_on = request.run_on;
    options.measure = moves.measure;
    return options;
}

void note_moves(const Request& request, Result& result) {
    result.maximal = false;
    result.radius = 0;
    if (result.points.size() < 2) return;
    result.radius = least_distance(result.points, request.domain);
}

namespace {

// The moves that are set, and what else is set that excludes some.
std::vector<GivenOption> members_set(const Request& request, Moves moves) {
    Moves usual;
    std::vector<GivenOption> given = given_in(kSample, targets_of(moves), targets_of(usual));
    const auto give = [&](std::string_view name, bool is_set) {
        if (is_set) given.push_back({name});
    };
    give("progressive", request.progressive);
    give("mask", request.places.mask != nullptr);
    for (const Outline& one : request.places.outlines) give(name_of(one.role), true);
    give("border", request.places.border != 0);
    give("inside-by-radius", request.places.border_by_radius);
    give("keep", !request.keep.empty());
    give("class", !request.classes.names.empty());
    give("ellipses", request.field != nullptr && !request.field->stretches.empty());
    return given;
}

}  // namespace

void check_moves(const Request& request, const Moves& moves) {
    refuse_pairs(kSample, members_set(request, moves));
    if (!moves.are_asked_for()) return;
    const RelaxOptions options = relax_options_of(request, moves);
    relaxing::check_options(options);
    relaxing::check_gaussian(request.field, options);
}

Made make(const Request& request, const Moves& moves, Observer& observer) {
    check_moves(request, moves);
    Made made{.result = sample(request, observer)};
    return moves.are_asked_for() ? move_on(std::move(made), request, moves, observer) : made;
}

Made move_on(Made made, const Request& request, const Moves& moves, Observer& observer) {
    move_points(made, request, moves, observer);
    note_moves(request, made.result);
    return made;
}

void move_points(Made& made, const Request& request, const Moves& moves, Observer& observer) {
    Result& result = made.result;
    Relaxed relaxed =
        relax(result.points, request.field, relax_options_of(request, moves), observer);
    result.points = std::exchange(relaxed.points, {});
    result.backend = relaxed.backend;  // a stratified start has none
    result.device = relaxed.device;
    made.relaxed = std::move(relaxed);
}

Made make_in_inks(const Request& request, std::span<const InkPart> inks, const Moves& moves,
                  Observer& observer) {
    InkDots placed = place_inks(inks, request.seed, relax_options_of(request, moves), observer);
    Made made;
    made.result.points = std::move(placed.points);
    made.result.backend = placed.backend;
    made.result.device = placed.device;
    made.relaxed.emplace(Relaxed{.lattice_columns = placed.lattice_columns,
                                 .lattice_rows = placed.lattice_rows,
                                 .backend = placed.backend,
                                 .device = placed.device});
    return made;
}

}  // namespace lacuna::options
