// lacuna::relax repeats assign, accumulate and move (docs/design.md, section 9).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/asked.h"
#include "base/polling.h"
#include "checks/pixels.h"
#include "lacuna/lacuna.h"
#include "lattice/lattice.h"
#include "plan/checked_request.h"
#include "relax/descent.h"
#include "relax/relax_backends.h"

namespace lacuna {
namespace {

using relaxing::Lattice;
using relaxing::RelaxBackend;
using relaxing::Share;
using relaxing::Site;

// Coefficient of variation of the masses.
double variation(const std::vector<Share>& shares) {
    double sum = 0;
    double squares = 0;
    for (const Share& share : shares) {
        const auto mass = static_cast<double>(share.mass);
        sum += mass;
        squares += mass * mass;
    }
    const auto count = static_cast<double>(shares.size());
    return std::sqrt(std::max(0.0, squares * count / (sum * sum) - 1));
}

// Iterations, and steps of the descent that follows them.
std::uint64_t turns_of(const RelaxOptions& options) {
    return std::max<std::uint64_t>(std::uint64_t{options.iterations} + options.gaussian, 1);
}

// Runs an iteration, or the last move, and reports each verb to the observer.
class Iterations {
public:
    Iterations(RelaxBackend& backend, Observer& observer, std::uint64_t points,
               const RelaxOptions& options)
        : backend_(backend),
          observer_(observer),
          points_(points),
          iterations_(options.iterations),
          turns_(turns_of(options)) {
        backend_.watch([this] { return keep_going(); });
    }

    void iterate() {
        look();
        observer_.begin(Verb::move);
        if (done_ + 1 == iterations_)
            backend_.rest();
        else
            backend_.move(relaxing::way_of(done_, iterations_));
        observer_.end(Verb::move);
        ++done_;
        if (!keep_going()) throw Cancelled();
    }

    void look() {
        observer_.begin(Verb::assign);
        backend_.assign();
        observer_.end(Verb::assign);
        observer_.begin(Verb::accumulate);
        backend_.accumulate();
        observer_.end(Verb::accumulate);
    }

    double variation_without_weights(const Lattice& lattice) {
        return variation_without_weights(lattice, backend_.sites());
    }
    double variation_without_weights(const Lattice& lattice, std::vector<Site> plain) {
        for (Site& site : plain) site.weight = portable::even_weight(lattice.numbers.farthest);
        backend_.restore(plain);
        look();
        return variation(backend_.shares());
    }

private:
    bool keep_going() {
        return observer_.keep_going(
            {points_ * done_, points_ * turns_, done_, Stage::relaxing, turns_});
    }

    RelaxBackend& backend_;
    Observer& observer_;
    std::uint64_t points_;
    std::uint32_t iterations_;
    std::uint64_t turns_;
    std::uint32_t done_ = 0;
};

// Runs all iterations and returns the final sites. Measurements that do not affect the result come
// after them: with the final weights, and with all weights 0.
std::vector<Site> iterate(Iterations& run, RelaxBackend& backend, const Lattice& lattice,
                          const RelaxOptions& options, Relaxed& relaxed) {
    Evenness evenness{};
    for (std::uint32_t i = 0; i < options.iterations; ++i) {
        run.iterate();
        if (i == 0 && options.measure) evenness.before = variation(backend.shares());
    }
    std::vector<Site> sites = backend.sites();
    if (options.measure) {
        run.look();
        evenness.after = variation(backend.shares());
        if (options.iterations == 0) evenness.before = evenness.after;
        evenness.after_voronoi = run.variation_without_weights(lattice);
        relaxed.evenness = evenness;
    }
    return sites;
}

}  // namespace

Relaxed relax(std::span<const Point> points, const Field* field, const RelaxOptions& options,
              Observer& given) {
    Asked observer(given,
                   {0, points.size() * turns_of(options), 0, Stage::relaxing, turns_of(options)});
    relaxing::check_options(options);
    if (field != nullptr) {
        check_importance(*field);
        check_disks(*field, "relax");
    }
    Relaxed relaxed;
    relaxed.points.assign(points.begin(), points.end());
    const std::optional<relaxing::GaussianField> gaussian =
        relaxing::checked_gaussian(std::max<std::size_t>(points.size(), 1), field, options);
    if (points.empty()) return relaxed;
    const Lattice lattice = relaxing::make_lattice(points.size(), field, options, ask);
    relaxed.lattice_columns = lattice.numbers.columns;
    relaxed.lattice_rows = lattice.numbers.rows;
    if (gaussian && options.iterations == 0 && !options.measure) {
        relaxing::descend(relaxed, *gaussian, options, observer);
        return relaxed;
    }
    const std::vector<Site> start = relaxing::sites_of(points, lattice, options, ask);
    observer.begin(Verb::first_use);
    const relaxing::Chosen chosen =
        relaxing::make_relax_backend(options.run_on, lattice, start, ask);
    observer.end(Verb::first_use);
    relaxed.backend = chosen.name;
    relaxed.device = chosen.backend->device();

    Iterations run(*chosen.backend, observer, points.size(), options);
    const std::vector<Site> sites = iterate(run, *chosen.backend, lattice, options, relaxed);
    if (options.iterations != 0)
        for (std::size_t i = 0; i < sites.size(); ++i)
            relaxed.points[i] = lattice.to_user(sites[i]);
    if (!gaussian) return relaxed;
    relaxing::descend(relaxed, *gaussian, options, observer);
    if (relaxed.evenness)
        relaxed.evenness->after = relaxed.evenness->after_voronoi = run.variation_without_weights(
            lattice, relaxing::sites_of(relaxed.points, lattice, options, ask));
    return relaxed;
}

Relaxed relax(std::span<const Point> points, const Field* field, const RelaxOptions& options) {
    Observer nobody;
    return relax(points, field, options, nobody);
}

}  // namespace lacuna
