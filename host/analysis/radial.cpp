// Averages over annuli.
#include "analysis/radial.h"

#include <algorithm>
#include <cmath>

namespace lacuna::analysis {
namespace {

// Welford's running mean and sum of squared deviations. A difference of squares would lose the
// variance of almost equal powers to rounding.
class Moments {
public:
    void add(double value) {
        ++count_;
        const double before = value - mean_;
        mean_ += before / static_cast<double>(count_);
        squares_ += before * (value - mean_);
    }
    std::size_t count() const { return count_; }
    double mean() const { return mean_; }
    double variance() const { return squares_ / static_cast<double>(count_ - 1); }

private:
    std::size_t count_ = 0;
    double mean_ = 0;
    double squares_ = 0;
};

std::size_t annulus_of(double magnitude) {
    return static_cast<std::size_t>(magnitude / kAnnulusWidth);
}

std::size_t whole_annuli(const Spectrum& spectrum) {
    const double reach = std::min(spectrum.magnitude(spectrum.range.kx_max + 1, 0),
                                  spectrum.magnitude(0, spectrum.range.ky_max + 1));
    return annulus_of(reach);
}

// Calls `visit(kx, ky)` for the frequencies of half the plane, without DC.
template <class Visit>
void for_each_mode(Range range, const Visit& visit) {
    for (int kx = 0; kx <= range.kx_max; ++kx)
        for (int ky = kx == 0 ? 1 : -range.ky_max; ky <= range.ky_max; ++ky) visit(kx, ky);
}

std::optional<double> anisotropy(const Moments& powers, double rounding) {
    if (powers.count() < 2 || powers.mean() <= rounding) return std::nullopt;
    const double ratio = powers.variance() / (powers.mean() * powers.mean());
    // Below this ratio the powers differ by rounding only, so there is no spread to measure.
    constexpr double kLeastRatio = 1e-20;
    if (ratio <= kLeastRatio) return std::nullopt;
    return 10 * std::log10(ratio);
}

// Calls `power_of(k)` for k = 1, 2, ... within the annuli.
template <class PowerOf, class MagnitudeOf>
std::optional<LinePower> line_power(const Spectrum& spectrum, const Radial& radial, int k_max,
                                    const MagnitudeOf& magnitude_of, const PowerOf& power_of) {
    double sum = 0;
    std::size_t modes = 0;
    for (int k = 1; k <= k_max; ++k) {
        const double frequency = magnitude_of(k) / std::sqrt(spectrum.count);
        if (frequency >= radial.annuli.back().outer) break;
        const Annulus& annulus = radial.at(frequency);
        if (annulus.power <= spectrum.rounding()) continue;
        sum += power_of(k) / annulus.power;
        ++modes;
    }
    if (modes == 0) return std::nullopt;
    return LinePower{sum / static_cast<double>(modes), modes};
}

}  // namespace

Radial radial_of(const Spectrum& spectrum) {
    const std::size_t count = whole_annuli(spectrum);
    std::vector<Moments> powers(count);
    std::vector<Moments> magnitudes(count);
    for_each_mode(spectrum.range, [&](int kx, int ky) {
        const double magnitude = spectrum.magnitude(kx, ky);
        const std::size_t annulus = annulus_of(magnitude);
        if (annulus >= count) return;
        powers[annulus].add(spectrum.power(kx, ky));
        magnitudes[annulus].add(magnitude);
    });
    const double unit = std::sqrt(spectrum.count);
    Radial radial;
    for (std::size_t a = 0; a < count; ++a) {
        // No annulus is empty: along the domain's longer side |k| grows by at most 1 a step.
        radial.annuli.push_back(
            {magnitudes[a].mean() / unit, kAnnulusWidth * static_cast<double>(a + 1) / unit,
             powers[a].mean(), powers[a].count(), anisotropy(powers[a], spectrum.rounding())});
    }
    return radial;
}

const Annulus& Radial::at(double frequency) const {
    const auto found = std::find_if(annuli.begin(), annuli.end(),
                                    [=](const Annulus& a) { return frequency < a.outer; });
    return found == annuli.end() ? annuli.back() : *found;
}

const Annulus& Radial::peak() const {
    return *std::max_element(annuli.begin(), annuli.end(),
                             [](const Annulus& a, const Annulus& b) { return a.power < b.power; });
}

std::optional<double> Radial::mean_anisotropy_db() const {
    double sum = 0;
    double modes = 0;
    for (const Annulus& annulus : annuli) {
        if (!annulus.anisotropy_db) continue;
        sum += *annulus.anisotropy_db * static_cast<double>(annulus.modes);
        modes += static_cast<double>(annulus.modes);
    }
    if (modes == 0) return std::nullopt;
    return sum / modes;
}

std::optional<LinePower> vertical_line(const Spectrum& spectrum, const Radial& radial) {
    return line_power(
        spectrum, radial, spectrum.range.ky_max, [&](int k) { return spectrum.magnitude(0, k); },
        [&](int k) { return spectrum.power(0, k); });
}

std::optional<LinePower> horizontal_line(const Spectrum& spectrum, const Radial& radial) {
    return line_power(
        spectrum, radial, spectrum.range.kx_max, [&](int k) { return spectrum.magnitude(k, 0); },
        [&](int k) { return spectrum.power(k, 0); });
}

}  // namespace lacuna::analysis
