// Colours that inks cannot make: their lightness is kept first, then hue, then saturation.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "pictures/importance.h"
#include "pictures/perceived.h"
#include "pictures/separator.h"

namespace lacuna::pictures {
namespace {

// How much errors of lightness, hue and saturation count. With these, of a grid of colours that
// cmyk cannot make, lightness (0 to 1) is .006 off on average, where plain least squares are .052
// off, and hue 5 degrees instead of 10. With hue much over saturation, two or three inks would
// print few colours but greys: skin would have no red in black and red.
constexpr double kLightness = 2.5, kHue = 2, kSaturation = 1;
using Errors = Channels;

double square_of(const Errors& errors) {
    return errors[0] * errors[0] + errors[1] * errors[1] + errors[2] * errors[2];
}

// The slope of light_of().
double light_slope(double number, double light) {
    return number <= 0.04045 ? 1 / 12.92 : 2.4 * light / (number + 0.055);
}

// How the look of colours differs from that of a wanted one.
class Look {
public:
    // A colour that is about as dark as `black`, or darker, is wanted to be lighter, as in
    // Separator::no_darker_than_black().
    Look(const Channels& wanted, const Channels* black, bool is_light) : is_light_(is_light) {
        wanted_ = seen(light(wanted)).colour;
        const double twice = black == nullptr ? 0 : 2 * seen(light(*black)).colour[0];
        const double near = wanted_[0] < twice ? 1 - wanted_[0] / twice : 0;
        wanted_[0] += twice / 2 * near * near;
        const double saturation = std::sqrt(wanted_[1] * wanted_[1] + wanted_[2] * wanted_[2]);
        if (saturation > 0) hue_ = {wanted_[1] / saturation, wanted_[2] / saturation};
    }

    Errors errors_of(const Channels& colour) const {
        const Perceived it = seen(light(colour)).colour;
        return weighted({it[0] - wanted_[0], it[1] - wanted_[1], it[2] - wanted_[2]});
    }

    // By how much the errors change with each channel of a colour.
    std::array<Errors, 3> slopes_at(const Channels& colour) const {
        const Channels its_light = light(colour);
        const Seen it = seen(its_light);
        std::array<Errors, 3> slopes{};
        for (std::size_t c = 0; c < slopes.size(); ++c) {
            const double slope = is_light_ ? 1 : light_slope(colour[c], its_light[c]);
            slopes[c] = weighted(
                {slope * it.by_light[0][c], slope * it.by_light[1][c], slope * it.by_light[2][c]});
        }
        return slopes;
    }

private:
    Channels light(const Channels& colour) const {
        if (is_light_) return colour;
        return {light_of(colour[0]), light_of(colour[1]), light_of(colour[2])};
    }

    Errors weighted(const Perceived& by) const {
        return {kLightness * by[0], kHue * (hue_[0] * by[2] - hue_[1] * by[1]),
                kSaturation * (hue_[0] * by[1] + hue_[1] * by[2])};
    }

    bool is_light_;
    Perceived wanted_{};
    std::array<double, 2> hue_{1, 0};
};

// The amounts, from 0 to 1, at which the errors are least if they are linear in the amounts, plus
// `damping` times the square of their changes: one amount after the other.
void find_step(Errors errors, std::span<const Errors> slopes, double damping,
               std::span<const double> amounts, std::span<double> next) {
    constexpr int kSweeps = 30;
    constexpr double kSmall = 1e-4;
    for (std::size_t k = 0; k < next.size(); ++k) next[k] = amounts[k];
    double change = 1;
    for (int sweep = 0; sweep < kSweeps && change > kSmall; ++sweep) {
        change = 0;
        for (std::size_t k = 0; k < next.size(); ++k) {
            double product = damping * (next[k] - amounts[k]), square = damping;
            for (std::size_t i = 0; i < errors.size(); ++i) {
                product += slopes[k][i] * errors[i];
                square += slopes[k][i] * slopes[k][i];
            }
            const double way = std::clamp(next[k] - product / square, 0.0, 1.0) - next[k];
            for (std::size_t i = 0; i < errors.size(); ++i) errors[i] += slopes[k][i] * way;
            next[k] += way;
            change = std::max(change, std::abs(way));
        }
    }
}

}  // namespace

// By how much the errors change with each amount, where the amounts print this colour.
void Separator::find_slopes(const Channels& colour, const std::array<Errors, 3>& by_channel) {
    constexpr double kChange = 1e-3;
    next_ = amounts_;
    for (std::size_t k = 0; k < amounts_.size(); ++k) {
        const double change = amounts_[k] > 0.5 ? -kChange : kChange;
        next_[k] += change;
        const Channels other = printed(next_);
        next_[k] = amounts_[k];
        slopes_[k] = {};
        for (std::size_t c = 0; c < colour.size(); ++c)
            for (std::size_t i = 0; i < slopes_[k].size(); ++i)
                slopes_[k][i] += by_channel[c][i] * (other[c] - colour[c]) / change;
    }
}

// Steps of Gauss and Newton with damping (Levenberg 1944), from the amounts that are there.
void Separator::keep_lightness(const Channels& wanted) {
    constexpr int kMostSteps = 20;
    constexpr double kNear = 0.02;        // a colour that is no further off in a channel is made
    constexpr double kLeastGain = 0.999;  // of the square of the errors
    Channels colour = printed(amounts_);
    double most = 0;
    for (std::size_t c = 0; c < wanted.size(); ++c)
        most = std::max(most, std::abs(colour[c] - wanted[c]));
    if (most <= kNear) return;
    const Look look(wanted, has_black() ? &inks_[black_].colour : nullptr, is_light_);
    Errors errors = look.errors_of(colour);
    find_slopes(colour, look.slopes_at(colour));
    double damping = 1e-4;
    for (int i = 0; i < kMostSteps; ++i) {
        find_step(errors, slopes_, damping, amounts_, next_);
        const Channels next_colour = printed(next_);
        const Errors next_errors = look.errors_of(next_colour);
        if (!(square_of(next_errors) < square_of(errors))) {
            damping *= 16;
            continue;
        }
        const bool is_done = square_of(next_errors) > kLeastGain * square_of(errors);
        amounts_ = next_;
        if (is_done) return;
        colour = next_colour;
        errors = next_errors;
        damping /= 4;
        find_slopes(colour, look.slopes_at(colour));
    }
}

}  // namespace lacuna::pictures
