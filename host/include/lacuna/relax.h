// Makes point sets even: their cells hold equal importance. Link lacuna.
#pragma once

#include <lacuna/export.h>
#include <lacuna/sample.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace LACUNA_API lacuna {

// How points are relaxed: see relax.
struct RelaxOptions {
    Domain domain{};

    std::uint32_t iterations = 15;  // 0 to 10,000; 0 leaves the points as they are
    // After the iterations, this many steps of descent on the Gaussian energy, 0 to 10,000; 150 are
    // usual. They lower the power of low frequencies. For domains without a field.
    std::uint32_t gaussian = 0;
    // The distance in mean spacings, 0 to 1, below which a term of these steps pushes points apart.
    // 0: only the energy does.
    double gaussian_distance = 0.90;

    RunOn run_on = RunOn();

    bool measure = false;  // fill in Relaxed::evenness; costs two more passes over the lattice
};

// How equal the points' capacities are; a capacity is the importance inside a point's cell. Each
// number is a coefficient of variation, standard deviation over mean: 0 when all are equal.
struct Evenness {
    double before = 0;  // in the Voronoi cells of the points given
    double after = 0;   // in the final power cells; after_voronoi with RelaxOptions::gaussian
    double after_voronoi = 0;  // in the Voronoi cells of the moved points
};

struct Relaxed {
    std::vector<Point> points{};  // in the order given
    std::uint64_t lattice_columns = 0;
    std::uint64_t lattice_rows = 0;
    std::optional<Evenness> evenness{};
    std::string backend{};
    std::string device{};
};

// Moves points until their cells hold equal importance and each point is the centroid of its cell:
// a centroidal power diagram with equal capacities. It is computed on a lattice in whole numbers,
// so every backend and any number of threads give the same points. Without a field importance is
// the same everywhere. All points given come back, each in the domain and, if iterations is not 0,
// none where importance is 0. No least distance is promised.
//
// RelaxOptions::gaussian then makes steps of descent, with momentum, on the sum over all pairs of
// exp(-d^2 / 2), d in mean spacings (Ahmed, Ren & Wonka 2022, "Gaussian Blue Noise"); in a box less
// the attraction of an even domain. Each step moves every point by at most a mean spacing. It is
// computed in whole numbers, too, so again all backends give the same points. At most 2^28 points,
// and at most 1,024 of them in any square of two mean spacings when the steps begin; the longer
// side at most 2^18 mean spacings.
//
// Progress counts points times iterations and steps. Throws what sample throws.
Relaxed relax(std::span<const Point> points, const Field* field, const RelaxOptions& options);
Relaxed relax(std::span<const Point> points, const Field* field, const RelaxOptions& options,
              Observer& observer);

}  // namespace lacuna
