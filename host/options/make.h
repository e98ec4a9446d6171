// Makes a point set from a request: samples it, then moves its points if that is asked for.
#pragma once

#include <lacuna/inks.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <span>

namespace lacuna::options {

// How the points of a set are moved after sampling: see the members of RelaxOptions.
struct Moves {
    std::uint32_t iterations = 0;
    std::uint32_t gaussian = 0;
    std::optional<double> gaussian_distance{};  // default: that of RelaxOptions
    bool measure = false;

    bool are_asked_for() const { return iterations != 0 || gaussian != 0; }
};

// A point set, and how it was made.
struct Made {
    // If the points were moved, they are the moved points, the backend and the device are those
    // that moved them, the set is not maximal, and the radius is the least distance of two points,
    // 0 if there are fewer.
    Result result{};
    std::optional<Relaxed> relaxed{};  // how the points were moved, without the points
};

// The options of relax() for a set of this request.
RelaxOptions relax_options_of(const Request& request, const Moves& moves);

// Notes that the points of a set were moved: it is not maximal, and its radius becomes the least
// distance of two points, 0 if there are fewer.
void note_moves(const Request& request, Result& result);

// Throws BadRequest for moves that make no sense, or that cannot be made with this request.
// Relaxing moves points to where none may lie, moves kept points, and keeps neither a distance nor
// an order; it has disks instead of ellipses.
void check_moves(const Request& request, const Moves& moves);

// Makes the set. The mode and the metric of `request` are decided: see settle(). Throws what
// check_moves(), sample() and relax() throw.
Made make(const Request& request, const Moves& moves, Observer& observer);

// Moves the points of a set. Throws what relax() throws.
Made move_on(Made made, const Request& request, const Moves& moves, Observer& observer);

// The same, and with the dots of several inks, ink by ink, what place_inks() throws. note_moves()
// is left to the caller, who may choose from the points.
void move_points(Made& made, const Request& request, const Moves& moves, Observer& observer);
Made make_in_inks(const Request& request, std::span<const InkPart> inks, const Moves& moves,
                  Observer& observer);

}  // namespace lacuna::options
