// Periodograms of few points as matrix products. For many points see fast_sums.cpp.
//
// Let c and s be the cosine and sine of a point's phase. Then exp(-i (a + b)) is made of four
// products: c(a) c(b), s(a) s(b), s(a) c(b), c(a) s(b). Their sums over all points are one matrix
// product of all phases in x and all phases in y, which gives the sums at (kx, ky) and (kx, -ky).
#include "analysis/spectrum.h"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "analysis/fast_sums.h"

namespace lacuna::analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kPointsPerBlock = 512;
// Rows of the product in a task; constant, so that no core count changes the order of additions.
constexpr Index kRowsPerTask = 96;
// Every kStepsPerSeed steps sine and cosine are computed anew. In between the phase is turned by
// multiplications, and each adds a rounding error.
constexpr int kStepsPerSeed = 32;

struct Phase {
    double cosine;
    double sine;
};

Phase phase_of(double revolutions) {
    const double angle = 2 * std::numbers::pi * (revolutions - std::nearbyint(revolutions));
    return {std::cos(angle), std::sin(angle)};
}

// Fills rows 2k and 2k + 1 with cosine and sine of k revolutions of t, for k = 0, 1, ...
void fill_phases(double t, Eigen::Ref<Eigen::VectorXd> column) {
    const Phase step = phase_of(t);
    Phase phase{};
    const auto frequencies = static_cast<int>(column.size() / 2);
    for (int k = 0; k < frequencies; ++k) {
        phase = k % kStepsPerSeed == 0 ? phase_of(k * t)
                                       : Phase{phase.cosine * step.cosine - phase.sine * step.sine,
                                               phase.sine * step.cosine + phase.cosine * step.sine};
        column(2 * Index{k}) = phase.cosine;
        column(2 * Index{k} + 1) = phase.sine;
    }
}

// Sums of the four products. Row and column: 2k for the cosine, 2k + 1 for the sine.
class Sums {
public:
    explicit Sums(Range range)
        : x_phases_(2 * (Index{range.kx_max} + 1), kPointsPerBlock),
          y_phases_(2 * (Index{range.ky_max} + 1), kPointsPerBlock),
          sums_(MatrixXd::Zero(x_phases_.rows(), y_phases_.rows())) {}

    // Adds at most kPointsPerBlock points.
    void add(std::span<const Point> points, const Domain& domain) {
        const auto count = static_cast<Index>(points.size());
        tbb::parallel_for(Index{0}, count, [&](Index i) {
            const Point& point = points[static_cast<std::size_t>(i)];
            fill_phases(point.x / domain.width, x_phases_.col(i));
            fill_phases(point.y / domain.height, y_phases_.col(i));
        });
        const Index tasks = (sums_.rows() + kRowsPerTask - 1) / kRowsPerTask;
        tbb::parallel_for(Index{0}, tasks, [&](Index task) {
            const Index begin = task * kRowsPerTask;
            const Index rows = std::min(kRowsPerTask, sums_.rows() - begin);
            sums_.middleRows(begin, rows).noalias() +=
                x_phases_.block(begin, 0, rows, count) * y_phases_.leftCols(count).transpose();
        });
    }

    // sum|^2 at (kx, ky) and at (kx, -ky).
    struct Squares {
        double above;
        double below;
    };
    Squares squares(int kx, int ky) const {
        const Index row = 2 * Index{kx};
        const Index column = 2 * Index{ky};
        const double cc = sums_(row, column);
        const double cs = sums_(row, column + 1);
        const double sc = sums_(row + 1, column);
        const double ss = sums_(row + 1, column + 1);
        return {(cc - ss) * (cc - ss) + (sc + cs) * (sc + cs),
                (cc + ss) * (cc + ss) + (sc - cs) * (sc - cs)};
    }

private:
    MatrixXd x_phases_;  // a column for each point
    MatrixXd y_phases_;
    MatrixXd sums_;
};

std::size_t index_of(Range range, int kx, int ky) {
    const auto columns = 2 * static_cast<std::size_t>(range.ky_max) + 1;
    return static_cast<std::size_t>(kx) * columns + static_cast<std::size_t>(ky + range.ky_max);
}

}  // namespace

Range range_for(const Domain& domain, double count, double frequency) {
    constexpr double kMostFrequency = 1000;
    constexpr double kMostOfHalfPlane = 0x1p31;
    if (!(frequency > 0) || frequency > kMostFrequency)
        throw BadRequest("max-frequency", fmt::format("{}", frequency),
                         fmt::format("must be over 0 and at most {}", kMostFrequency));
    const double extent = frequency * std::sqrt(count) + 3;
    const double aspect = std::sqrt(domain.width / domain.height);
    if (2 * (extent * aspect + 1) * (extent / aspect + 1) > kMostOfHalfPlane)
        throw BadRequest("max-frequency", fmt::format("{}", frequency),
                         fmt::format("is too far for {:.6g} points: at most 2^31 frequencies of "
                                     "half the plane, of 40 bytes each",
                                     count));
    return {static_cast<int>(std::ceil(extent * aspect)),
            static_cast<int>(std::ceil(extent / aspect))};
}

double Spectrum::power(int kx, int ky) const {
    return kx < 0 ? power(-kx, -ky) : powers[index_of(range, kx, ky)];
}

double Spectrum::magnitude(int kx, int ky) const {
    const double aspect = std::sqrt(domain.width / domain.height);
    return std::hypot(kx / aspect, ky * aspect);
}

std::vector<double> periodogram(std::span<const Point> points, const Domain& domain, Range range,
                                const KeepGoing& keep_going) {
    return (points.size() < kManyPoints ? exact_periodogram : fast_periodogram)(points, domain,
                                                                                range, keep_going);
}

std::optional<double> mean_power_below(const Spectrum& spectrum, double frequency) {
    const double limit = frequency * std::sqrt(spectrum.count);
    double sum = 0;
    std::size_t frequencies = 0;
    for (int kx = 0; kx <= spectrum.range.kx_max; ++kx)
        for (int ky = -spectrum.range.ky_max; ky <= spectrum.range.ky_max; ++ky) {
            if ((kx == 0 && ky <= 0) || spectrum.magnitude(kx, ky) >= limit) continue;
            sum += spectrum.power(kx, ky);
            ++frequencies;
        }
    if (frequencies == 0) return std::nullopt;
    return sum / static_cast<double>(frequencies);
}

std::vector<double> exact_periodogram(std::span<const Point> points, const Domain& domain,
                                      Range range, const KeepGoing& keep_going) {
    Sums sums(range);
    constexpr auto kBlock = static_cast<std::size_t>(kPointsPerBlock);
    for (std::size_t begin = 0; begin < points.size(); begin += kBlock) {
        const std::size_t size = std::min(kBlock, points.size() - begin);
        sums.add(points.subspan(begin, size), domain);
        if (!keep_going(static_cast<double>(begin + size) / static_cast<double>(points.size())))
            throw Cancelled();
    }
    const auto count = static_cast<double>(points.size());
    std::vector<double> powers(index_of(range, range.kx_max, range.ky_max) + 1);
    for (int kx = 0; kx <= range.kx_max; ++kx) {
        for (int ky = 0; ky <= range.ky_max; ++ky) {
            const auto [above, below] = sums.squares(kx, ky);
            powers[index_of(range, kx, ky)] = above / count;
            powers[index_of(range, kx, -ky)] = below / count;
        }
    }
    powers[index_of(range, 0, 0)] = 0;
    return powers;
}

Spectrum mean_spectrum(std::span<const std::vector<Point>> sets, const Domain& domain,
                       const KeepGoing& keep_going, double frequency) {
    double all = 0;
    for (const auto& points : sets) all += static_cast<double>(points.size());
    const double count = all / static_cast<double>(sets.size());
    Spectrum mean{domain, range_for(domain, count, frequency), sets.size(), count, {}};
    double done = 0;
    for (const auto& points : sets) {
        const double share = static_cast<double>(points.size()) / all;
        const std::vector<double> powers =
            periodogram(points, domain, mean.range,
                        [&](double part) { return keep_going(done + share * part); });
        mean.powers.resize(powers.size());
        for (std::size_t i = 0; i < powers.size(); ++i)
            mean.powers[i] += powers[i] / static_cast<double>(sets.size());
        done += share;
    }
    return mean;
}

}  // namespace lacuna::analysis
