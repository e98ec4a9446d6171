// Memory and verbs of mode exact on a ground.
#include "backends/cpu/ground_state.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>

#include "backends/cpu/chords.h"
#include "portable/chord.h"
#include "portable/distance.h"
#include "portable/fate.h"

namespace lacuna::cpu {
namespace {

class Remnants {
public:
    Remnants(const GroundState& state, std::vector<GroundState::Place>& left)
        : state_(state), left_(left) {}

    // Of a part of a first place, cut by these.
    void begin(std::uint32_t first, std::span<const Sized> near) {
        first_ = first;
        near_ = near;
        even_radius_ = state_.first.even_radii[first];
    }

    void append_halves(const Rectangle& place) {
        const std::uint32_t cut = even_radius_ != 0 ? middle_of(place) : state_.ground.cut_x(place);
        if (cut == 0) return append_parts(place);
        append_parts({place.x, cut - place.x, place.begin, place.end});
        append_parts({cut, place.x + place.width - cut, place.begin, place.end});
    }

    void append(const Rectangle& place) { append(place, least_under(place)); }

private:
    std::uint32_t least_under(const Rectangle& place) const {
        return even_radius_ != 0 ? even_radius_ : state_.ground.under(place).least;
    }

    // A chord covers the whole width of a place, and no more than any point of the place lets the
    // sample cover.
    void append(const Rectangle& place, std::uint32_t radius) {
        chords_.clear();
        for (const Sized& sample : near_)
            if (add(place, sample, std::min(radius, sample.radius))) return;
        leave_of({place.begin, place.end}, chords_, [&](std::uint32_t begin, std::uint32_t end) {
            left_.push_back({{place.x, place.width, begin, end}, first_});
        });
    }

    static std::uint32_t middle_of(const Rectangle& place) {
        return place.width > 1 ? place.x + place.width / 2 : 0;
    }

    // Only at borders of pixels.
    void append_parts(const Rectangle& place) {
        const std::uint32_t cut = even_radius_ != 0 ? 0 : state_.ground.cut_y(place);
        if (cut == 0) return append_part(place);
        append_part({place.x, place.width, place.begin, cut});
        append_part({place.x, place.width, cut, place.end});
    }

    // Unless no sample may go there.
    void append_part(const Rectangle& place) {
        if (const std::uint32_t radius = least_under(place); radius != 0) append(place, radius);
    }

    // Most samples near leave a place alone, which shows in squared distances: only what is left
    // takes a square root. True where the sample covers all of the place.
    bool add(const Rectangle& place, const Sized& sample, std::uint64_t radius) {
        const Plan& plan = state_.plan;
        const std::uint32_t half = place.width / 2;
        const std::uint32_t dx =
            portable::axis_distance(sample.x, place.x + half, plan.period_x) + half;
        const std::uint64_t squared = radius * radius;
        if (std::uint64_t{dx} * dx >= squared) return false;
        if (plan.period_y == 0) {
            if (portable::squared_length(
                    dx, portable::nearest_distance(sample.y, place.begin, place.end)) >= squared)
                return false;
            if (portable::squared_length(
                    dx, portable::farthest_distance(sample.y, place.begin, place.end)) < squared)
                return true;
        }
        const std::uint32_t reach = portable::chord_reach(dx, squared);
        for (std::uint32_t window = 0; window < (plan.period_y == 0 ? 1 : 3); ++window) {
            const Span chord{portable::window_begin(window, sample.y, reach, plan.height),
                             portable::window_end(window, sample.y, reach, plan.height)};
            if (chord.begin >= chord.end) continue;
            if (chord.begin <= place.begin && chord.end >= place.end) return true;
            chords_.push_back(chord);
            sort_in_last(chords_.data(), chords_.size());
        }
        return false;
    }

    const GroundState& state_;
    std::vector<GroundState::Place>& left_;
    std::uint32_t first_ = 0;
    std::span<const Sized> near_;
    std::uint32_t even_radius_ = 0;  // 0: it is not even
    std::vector<Span> chords_;
};

}  // namespace

GroundState::GroundState(const Plan& the_plan)
    : State(the_plan, the_plan.first_places->begins),
      ground(*the_plan.ground),
      first(*the_plan.first_places),
      places(columns),
      near(the_plan) {}

void GroundState::settle_places() {
    ++round;
    free_lengths.clear();
    place_widths.clear();
    for (std::uint32_t region = 0; region < columns; ++region) {
        for (const Place& place : places[region]) {
            free_lengths.push_back(place.at.end - place.at.begin);
            place_widths.push_back(place.at.width);
        }
        place_begins[region + 1] = static_cast<std::uint32_t>(free_lengths.size());
    }
}

Snapshot GroundState::snapshot() const {
    Snapshot snapshot = State::snapshot();
    for (Candidate& candidate : snapshot.candidates) candidate.line = 0;
    for (const std::vector<Place>& of_region : places)
        for (const Place& place : of_region) snapshot.rectangles.push_back(place.at);
    snapshot.samples = near.samples();
    return snapshot;
}

void GroundState::restore(const Snapshot&) {
    throw std::logic_error("no test restores a ground");
}

void set_free(GroundState& state, std::uint32_t region) {
    for (std::uint32_t i = state.first.begins[region]; i < state.first.begins[region + 1]; ++i)
        state.places[region].push_back({state.first.places[i], i});
}

void locate(GroundState& state, std::span<const Draw> draws, std::uint32_t region) {
    for (std::uint32_t i = state.column_begins[region]; i < state.column_begins[region + 1]; ++i) {
        const auto& [at, first] = state.places[region][draws[i].place - state.place_begins[region]];
        state.candidates[i] = {at.x + draws[i].offset, at.begin + draws[i].rank, first,
                               draws[i].order};
        state.fates[i] = FATE_UNDECIDED;
    }
    state.find_orders(region);
    screen(state, region);
}

void refine(GroundState& state, std::uint32_t region, bool halve) {
    thread_local std::vector<GroundState::Place> of_thread;
    std::vector<GroundState::Place>& left = of_thread;  // looked up once, see subtract.cpp
    left.clear();
    std::vector<Sized> scratch;
    Remnants remnants(state, left);
    const std::span<const GroundState::Place> places = state.places[region];
    // Places that are not cut up are cut by what has not cut them yet.
    const auto round = halve ? std::nullopt : std::optional(state.round);
    for (const auto& [at, first] : places) {
        const std::span<const Sized> near = state.near.of_part(first, at, round, scratch);
        remnants.begin(first, near);
        if (halve)
            remnants.append_halves(at);
        else if (near.empty())
            left.push_back({at, first});
        else
            remnants.append(at);
    }
    state.places[region].assign(left.begin(), left.end());
}

}  // namespace lacuna::cpu
