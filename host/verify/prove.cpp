// The public door to the proofs.
#include <lacuna/verify.h>

#include "verify/ground_proof.h"
#include "verify/verify.h"

namespace lacuna {
namespace {

// The proof for one radius everywhere is faster.
bool is_on_ground(const Claim& claim) {
    return claim.field != nullptr || claim.mask != nullptr || !claim.inside.empty() ||
           claim.border != 0;
}

}  // namespace

Proof prove(std::span<const Point> points, const Claim& claim,
            const std::function<bool()>& keep_going) {
    const verify::Patience patience(keep_going);
    if (const auto moved = verify::first_moved(points, claim.keep)) {
        Proof proof;
        proof.moved = moved;
        return proof;
    }
    if (is_on_ground(claim)) return verify::prove_on_ground(points, claim, patience);
    const bool torus = claim.boundary == Boundary::torus;
    const double tolerance =
        claim.tolerance.value_or(verify::default_tolerance(claim.width, claim.height));
    const verify::Verdict verdict = claim.distances_only
                                        ? verify::check_distances(points, claim.width, claim.height,
                                                                  torus, claim.radius, patience)
                                        : verify::check(points, claim.width, claim.height, torus,
                                                        claim.radius, tolerance, patience);
    Proof proof;
    proof.outside = verdict.outside;
    if (proof.outside) return proof;
    proof.kept = verdict.kept;
    proof.first = verdict.closest.first;
    proof.second = verdict.closest.second;
    proof.least_distance = verdict.closest.distance;
    proof.least_limit = claim.radius;
    if (claim.distances_only) return proof;
    proof.covered = verdict.covered;
    proof.emptiest = verdict.emptiest.at;
    proof.emptiest_distance = verdict.emptiest.distance;
    proof.emptiest_limit = claim.radius;
    proof.maximal =
        proof.kept && proof.covered && tolerance <= verify::kMostTolerance * claim.radius;
    return proof;
}

}  // namespace lacuna
