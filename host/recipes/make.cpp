// Samples, then relaxes.
#include "recipes/make.h"

#include <lacuna/verify.h>

#include <string>
#include <utility>

#include "base/number_text.h"
#include "relax/descent.h"
#include "relax/lattice.h"

namespace lacuna::recipes {

RelaxOptions relax_options_of(const Request& request, const Moves& moves) {
    RelaxOptions options;
    options.width = request.width;
    options.height = request.height;
    options.boundary = request.boundary;
    options.iterations = moves.iterations;
    options.gaussian = moves.gaussian;
    options.gaussian_distance = moves.gaussian_distance.value_or(options.gaussian_distance);
    options.backend = request.backend;
    options.device = request.device;
    options.threads = request.threads;
    options.measure = moves.measure;
    return options;
}

void note_moves(const Request& request, Result& result) {
    result.maximal = false;
    result.radius = 0;
    if (result.points.size() < 2) return;
    result.radius = least_distance(result.points, request.width, request.height, request.boundary);
}

void check_moves(const Request& request, const Moves& moves) {
    if (moves.gaussian_distance && moves.gaussian == 0)
        throw BadRequest("gaussian-distance", shortest(*moves.gaussian_distance),
                         "is for --gaussian");
    if (!moves.are_asked_for()) return;
    const bool relaxes = moves.iterations != 0;
    const auto refuse = [&](const char* allowed) {
        throw BadRequest(relaxes ? "relax" : "gaussian",
                         std::to_string(relaxes ? moves.iterations : moves.gaussian), allowed);
    };
    if (request.progressive) refuse("cannot be used with --progressive: it moves the points");
    if (request.mask != nullptr || request.border != 0 || !request.keep.empty())
        refuse("cannot be used with --mask, --inside, --outside, --avoid, --border or --keep");
    if (!request.classes.names.empty())
        refuse("cannot be used with --class: it keeps no distances");
    if (request.field != nullptr && !request.field->stretches.empty())
        refuse("cannot be used with --ellipses, --stretch or --along: relaxing has disks");
    const RelaxOptions options = relax_options_of(request, moves);
    relaxing::check_options(options);
    relaxing::check_gaussian(request.field, options);
}

Made make(const Request& request, const Moves& moves, Observer& observer) {
    check_moves(request, moves);
    Made made{.result = sample(request, observer)};
    Result& result = made.result;
    if (!moves.are_asked_for()) return made;
    Relaxed relaxed =
        relax(result.points, request.field, relax_options_of(request, moves), observer);
    result.points = std::exchange(relaxed.points, {});
    result.backend = relaxed.backend;  // a stratified start has none
    result.device = relaxed.device;
    note_moves(request, result);
    made.relaxed = std::move(relaxed);
    return made;
}

}  // namespace lacuna::recipes
