// place_inks: places the dots of several inks along one curve, and relaxes each ink's dots together
// with all dots (docs/design.md, section 9).
#include <lacuna/inks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include "base/asked.h"
#include "base/polling.h"
#include "checks/pixels.h"
#include "lattice/lattice.h"
#include "lattice/stratified.h"
#include "plan/checked_request.h"
#include "relax/relax_backends.h"

namespace lacuna {
namespace {

using relaxing::Lattice;
using relaxing::RelaxBackend;
using relaxing::Site;

constexpr std::size_t kMostInks = 64;

double sum_of(const Field& field) {
    double sum = 0;
    for_each_polled(field.importance.size(), ask,
                    [&](std::size_t i) { sum += field.importance[i]; });
    return sum;
}

void check_inks(std::span<const InkPart> inks) {
    if (inks.empty() || inks.size() > kMostInks)
        throw BadRequest("inks", std::to_string(inks.size()),
                         "must be 1 to " + std::to_string(kMostInks));
    for (const InkPart& ink : inks) {
        if (ink.field == nullptr) throw BadRequest("field", "missing", "each ink must have one");
        check_importance(*ink.field);
        check_disks(*ink.field, "inks");
        if (ink.dots == 0) throw BadRequest("dots", "0", "an ink must have at least one dot");
        const auto size = [](const Field& field) {
            return std::to_string(field.columns) + "x" + std::to_string(field.rows);
        };
        if (size(*ink.field) != size(*inks[0].field))
            throw BadRequest("field", size(*ink.field),
                             "all inks must have equally many pixels, " + size(*inks[0].field));
    }
}

// The density of all dots: the sum over inks of their importance, each scaled so that its sum is
// the ink's number of dots.
Field density_of(std::span<const InkPart> inks) {
    Field density{inks[0].field->columns, inks[0].field->rows,
                  std::vector<double>(inks[0].field->importance.size(), 0.0)};
    for (const InkPart& ink : inks) {
        const double scale = static_cast<double>(ink.dots) / sum_of(*ink.field);
        for_each_polled(density.importance.size(), ask, [&](std::size_t i) {
            density.importance[i] += scale * ink.field->importance[i];
        });
    }
    return density;
}

// The request for the places of all dots.
Request request_of(const Field& density, std::span<const InkPart> inks, std::uint64_t seed,
                   const RelaxOptions& options) {
    Request request;
    request.domain = options.domain;
    request.mode = Mode::stratified;
    request.field = &density;
    request.count = 0;
    for (const InkPart& ink : inks) *request.count += ink.dots;
    request.seed = seed;
    check_request(request);
    return request;
}

// Gives each place on the curve an ink: among the inks that are wanted on its pixel and have dots
// left, the one whose dots up to there are fewest compared with its own cdf. If no ink is wanted
// there, any ink that has dots left will do.
class InkOfPlace : public OnCurve {
public:
    InkOfPlace(std::span<const InkPart> inks, std::span<const Lattice> lattices) {
        for (std::size_t k = 0; k < inks.size(); ++k) {
            Ink ink{lattices[k].masses, static_cast<double>(inks[k].dots)};
            for (std::size_t pixel = 0; pixel < ink.masses.size(); ++pixel)
                ink.mass += ink.mass_of(pixel);
            inks_.push_back(ink);
        }
    }

    void begin(std::uint64_t cells_a_pixel) override {
        for (Ink& ink : inks_) ink.mass *= static_cast<double>(cells_a_pixel);
    }
    void put(std::size_t pixel, double cells) override {
        std::size_t chosen = most_behind(pixel, cells, true);
        if (chosen == inks_.size()) chosen = most_behind(pixel, cells, false);
        ++inks_[chosen].placed;
        inks_of_places_.push_back(static_cast<std::uint8_t>(chosen));
    }
    void leave(std::size_t pixel, double cells) override {
        for (Ink& ink : inks_) ink.before += cells * ink.mass_of(pixel);
    }

    // The points, all of the first ink first; of one ink in the order of the curve.
    std::vector<Point> by_ink(std::span<const Point> places) const {
        std::vector<Point> points;
        points.reserve(places.size());
        for (std::size_t k = 0; k < inks_.size(); ++k)
            for (std::size_t i = 0; i < places.size(); ++i)
                if (inks_of_places_[i] == k) points.push_back(places[i]);
        return points;
    }

private:
    struct Ink {
        std::span<const std::uint32_t> masses;  // as Lattice has them
        double dots;
        double mass = 0;
        double placed = 0;
        double before = 0;  // mass of all earlier cells

        double mass_of(std::size_t pixel) const {
            return static_cast<double>(portable::whole_mass(masses[pixel]));
        }
    };

    std::size_t most_behind(std::size_t pixel, double cells, bool only_wanted) const {
        std::size_t chosen = inks_.size();
        double most = 0;
        for (std::size_t k = 0; k < inks_.size(); ++k) {
            const Ink& ink = inks_[k];
            if (ink.placed == ink.dots || (only_wanted && ink.masses[pixel] == 0)) continue;
            const double behind =
                (ink.before + cells * ink.mass_of(pixel)) / ink.mass * ink.dots - ink.placed;
            if (chosen != inks_.size() && behind <= most) continue;
            chosen = k;
            most = behind;
        }
        return chosen;
    }

    std::vector<Ink> inks_;
    std::vector<std::uint8_t> inks_of_places_;
};

// Two thirds of the way from one position to another on an axis. Where it wraps, the shorter way
// counts.
std::uint32_t two_thirds(std::uint32_t from, std::uint32_t to, std::uint32_t period) {
    std::int64_t way = std::int64_t{to} - from;
    if (period != 0 && way > period / 2) way -= period;
    if (period != 0 && way < -std::int64_t{period / 2}) way += period;
    const std::int64_t at = from + way * 2 / 3;
    return static_cast<std::uint32_t>(period == 0 ? at : (at + period) % period);
}

// Some of the dots, on the lattice with their own importance.
struct Group {
    std::size_t first;  // dot
    std::unique_ptr<RelaxBackend> backend;
};

class Inks {
public:
    // `lattices` has one lattice for each ink, and then the lattice of all dots.
    Inks(std::span<const InkPart> inks, std::span<const Lattice> lattices,
         std::span<const Site> sites, const RelaxOptions& options, const Poll& poll)
        : lattices_(lattices) {
        std::size_t first = 0;
        const auto add = [&](const Lattice& lattice, std::size_t dots) {
            relaxing::Chosen chosen = relaxing::make_relax_backend(
                options.run_on, lattice, sites.subspan(first, dots), poll);
            name_ = chosen.name;
            groups_.push_back({first, std::move(chosen.backend)});
            first += dots;
        };
        for (std::size_t k = 0; k < inks.size(); ++k) add(lattices[k], inks[k].dots);
        first = 0;
        add(lattices.back(), sites.size());
    }

    void watch(const std::function<bool()>& may_go_on) {
        for (Group& group : groups_) group.backend->watch(may_go_on);
    }

    // One iteration. After the last one each dot lies where its ink is wanted.
    void iterate(Observer& observer, std::uint32_t way, bool is_last) {
        all_sites_ = moved(groups_.back(), observer, way, false);
        for (std::size_t k = 0; k + 1 < groups_.size(); ++k) {
            std::vector<Site> sites = moved(groups_[k], observer, way, is_last);
            for (std::size_t i = 0; i < sites.size(); ++i)
                join(lattices_[k], sites[i], all_sites_[groups_[k].first + i], is_last);
            if (!is_last) groups_[k].backend->restore(sites);
        }
        if (!is_last) groups_.back().backend->restore(all_sites_);
    }

    const std::vector<Site>& sites() const { return all_sites_; }
    const std::string& name() const { return name_; }
    std::string device() const { return groups_.back().backend->device(); }

private:
    static std::vector<Site> moved(Group& group, Observer& observer, std::uint32_t way,
                                   bool is_last) {
        const auto run = [&](Verb verb, auto work) {
            observer.begin(verb);
            work();
            observer.end(verb);
        };
        RelaxBackend& backend = *group.backend;
        run(Verb::assign, [&] { backend.assign(); });
        run(Verb::accumulate, [&] { backend.accumulate(); });
        run(Verb::move, [&] { is_last ? backend.rest() : backend.move(way); });
        return backend.sites();
    }

    // Puts a dot between the positions to which its ink and all dots would move it. In the middle
    // dots of two inks would come closer; nearer to the second, inks would be less even.
    static void join(const Lattice& lattice, Site& of_ink, Site& of_all, bool is_last) {
        Site both = of_ink;
        both.x = two_thirds(of_ink.x, of_all.x, lattice.numbers.period_x);
        both.y = two_thirds(of_ink.y, of_all.y, lattice.numbers.period_y);
        if (is_last && lattice.stored_below(both) == 0) both = of_ink;
        of_ink.x = of_all.x = both.x;
        of_ink.y = of_all.y = both.y;
    }

    std::span<const Lattice> lattices_;
    std::vector<Group> groups_;
    std::vector<Site> all_sites_;
    std::string name_;
};

}  // namespace

InkDots place_inks(std::span<const InkPart> inks, std::uint64_t seed, const RelaxOptions& options,
                   Observer& given) {
    Asked observer(given, {.stage = Stage::relaxing, .all_rounds = options.iterations});
    check_inks(inks);
    if (options.iterations == 0)
        throw BadRequest("relax", "0", "must be at least 1: several inks are even once relaxed");
    relaxing::check_options(options);
    const Field density = density_of(inks);
    const Request request = request_of(density, inks, seed, options);
    const std::uint64_t dots = *request.count;
    std::uint64_t done = 0;
    const auto may_go_on = [&] {
        return observer.keep_going(
            {dots * done, dots * options.iterations, done, Stage::relaxing, options.iterations});
    };
    const Poll poll = [&] {
        if (!may_go_on()) throw Cancelled();
    };
    const Lattice all = relaxing::make_lattice(dots, &density, options, poll);
    std::vector<Lattice> lattices;
    for (const InkPart& ink : inks)
        lattices.push_back(relaxing::with_field(all, ink.dots, *ink.field, poll));
    InkOfPlace ink_of_place(inks, lattices);
    observer.begin(Verb::invert);
    const std::vector<Point> start =
        ink_of_place.by_ink(stratified_points(request, poll, &ink_of_place));
    observer.end(Verb::invert);
    lattices.push_back(all);

    observer.begin(Verb::first_use);
    Inks both(inks, lattices, relaxing::sites_of(start, all, options, poll), options, poll);
    observer.end(Verb::first_use);
    both.watch(may_go_on);
    while (done < options.iterations) {
        both.iterate(observer, relaxing::way_of(done, options.iterations),
                     done + 1 == options.iterations);
        ++done;
        poll();
    }
    InkDots result{{}, all.numbers.columns, all.numbers.rows, both.name(), both.device()};
    for (const Site& site : both.sites()) result.points.push_back(all.to_user(site));
    return result;
}

InkDots place_inks(std::span<const InkPart> inks, std::uint64_t seed, const RelaxOptions& options) {
    Observer nobody;
    return place_inks(inks, seed, options, nobody);
}

std::vector<std::uint64_t> dots_by_ink(std::uint64_t dots, std::span<const Field> inks) {
    std::vector<double> sums;
    for (const Field& ink : inks) sums.push_back(sum_of(ink));
    const double all = std::accumulate(sums.begin(), sums.end(), 0.0);
    std::vector<std::uint64_t> shares(inks.size(), 0);
    if (!(all > 0)) return shares;
    std::vector<double> left(inks.size());  // what rounding down has left of each share
    std::uint64_t shared = 0;
    for (std::size_t k = 0; k < inks.size(); ++k) {
        const double exact = static_cast<double>(dots) * (sums[k] / all);
        shares[k] = static_cast<std::uint64_t>(exact);
        left[k] = exact - std::floor(exact);
        shared += shares[k];
    }
    for (; shared < dots; ++shared) {
        const auto most = std::max_element(left.begin(), left.end());
        ++shares[static_cast<std::size_t>(most - left.begin())];
        *most = -1;
    }
    return shares;
}

}  // namespace lacuna
