// How much of the paper each ink covers, for one colour.
#include "pictures/separator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "base/polling.h"
#include "pictures/importance.h"

namespace lacuna::pictures {
namespace {

// A table's value between two of its entries, which stand at 0, `step`, 2 step, ...
template <std::size_t Size>
double between_entries(const std::array<double, Size>& table, double step, double at) {
    const double place = std::min(at / step, static_cast<double>(Size - 1));
    const std::size_t low = std::min(static_cast<std::size_t>(place), Size - 2);
    const double part = place - static_cast<double>(low);
    return table[low] + part * (table[low + 1] - table[low]);
}

// How often dots of different inks overlap, as a part of how often they would if each ink lay
// independently of the others. While there is room, even dots keep apart. So it grows with the sum
// of all inks' amounts, and where one ink covers most of the paper, with that ink's amount.
// Measured on the torus with dots of place_inks, 15 iterations: two, three and four equal inks of
// 6,000 dots in all, for sums of 0.25, 0.5, ... 3; and an ink of amount 0.3, 0.5, 0.7, 0.8, 0.9 or
// 0.96 with three of 0.03, 1,500 dots in all, and interpolated. Where the three have up to 0.3 the
// formula is within 0.06 of what was measured.
double overlap_of(std::span<const double> amounts) {
    constexpr std::array kEqual{0.0,  0.0,  0.03, 0.19,  0.42, 0.63, 0.78,
                                0.88, 0.94, 0.97, 0.985, 0.99, 1.0};
    constexpr std::array kOneInk{0.0, 0.0, 0.01, 0.03, 0.08, 0.16, 0.28, 0.42, 0.57, 0.81, 1.0};
    constexpr double kLeast = 0.01;  // it is divided by
    double most = 0, second = 0;
    for (const double amount : amounts) {
        second = std::max(second, std::min(most, amount));
        most = std::max(most, amount);
    }
    const double sum = std::accumulate(amounts.begin(), amounts.end(), 0.0);
    const double equal = between_entries(kEqual, 0.25, sum);
    const double one_ink = most > 0 ? between_entries(kOneInk, 0.1, most) * (1 - second / most) : 0;
    const auto [less, more] = std::minmax(equal, one_ink);
    return std::max(kLeast, more + less * (1 - more) / 2);
}

// Grey inks can print no more of a colour than its luminance.
Channels luminance_of(const Channels& colour) {
    const double grey =
        (kLuminance.red * colour[0] + kLuminance.green * colour[1] + kLuminance.blue * colour[2]) /
        kAll;
    return {grey, grey, grey};
}

constexpr double kSmallChange = 1e-4;  // of an amount
constexpr double kMostNumber = 255;

}  // namespace

Separator::Separator(std::span<const Ink> inks, double black_ink, const Colour& paper, bool light)
    : black_ink_(black_ink),
      black_(inks.size()),
      is_white_(paper == kWhitePaper),
      is_light_(light),
      paper_(channels_of(paper)),
      amounts_(inks.size()),
      above_(inks.size() + 1),
      next_(inks.size()),
      slopes_(inks.size()) {
    constexpr std::uint8_t kBlack = 89;  // the highest number that a channel of black may have
    for (const Ink& ink : inks) {
        const bool is_black = *std::max_element(ink.colour.begin(), ink.colour.end()) <= kBlack;
        if (is_black && black_ == inks.size() && is_white_) black_ = inks_.size();
        inks_.push_back({channels_of(ink.colour), ink.is_opaque_on(paper)});
    }
    const auto is_grey = [](const Colour& one) { return one[0] == one[1] && one[1] == one[2]; };
    is_grey_ = is_grey(paper) && std::all_of(inks.begin(), inks.end(),
                                             [&](const Ink& ink) { return is_grey(ink.colour); });
}

std::span<const double> Separator::amounts(const Channels& picture) {
    ask_after(64);
    const Channels wanted = no_darker_than_black(is_grey_ ? luminance_of(picture) : picture);
    std::fill(amounts_.begin(), amounts_.end(), 0.0);
    if (has_black()) {
        amounts_[black_] = amount_of_black(wanted);
        improve(wanted, black_);
    }
    improve(wanted, amounts_.size());
    if (!is_grey_) keep_lightness(wanted);
    for (double& amount : amounts_)
        if (amount < kSmallChange) amount = 0;  // dots for it would be noise
    return amounts_;
}

Channels Separator::channels_of(const Colour& colour) const {
    Channels channels{};
    for (std::size_t c = 0; c < channels.size(); ++c) {
        channels[c] = colour[c] / kMostNumber;
        if (is_light_) channels[c] = light_of(channels[c]);
    }
    return channels;
}

// Black ink reflects a little light. Colours that are about as dark are lightened until it can
// print them; otherwise all other inks would be printed over it, or in its place. The change is
// smooth, and ends at twice the channel of black.
Channels Separator::no_darker_than_black(Channels wanted) const {
    if (!has_black()) return wanted;
    const double lightest = *std::max_element(wanted.begin(), wanted.end());
    for (std::size_t c = 0; c < wanted.size(); ++c) {
        const double of_black = inks_[black_].colour[c];
        if (lightest >= 2 * of_black) continue;
        const double near = 1 - lightest / (2 * of_black);
        wanted[c] += of_black * near * near;
    }
    return wanted;
}

// In a light colour black takes the part `black_ink_` of what it can take without making a channel
// too dark. In dark ones this part rises to all.
double Separator::amount_of_black(const Channels& wanted) const {
    // Channels below kDark are left to black, and from kMiddle up --black-ink decides. If the
    // change came in a narrower range, or at darker greys, the other inks would jump on the way:
    // dots that overlap much and fewer dots that hardly overlap can print the same dark grey.
    constexpr double kDark = 0.05;
    constexpr double kMiddle = 0.5;
    double most = 1;
    for (std::size_t c = 0; c < wanted.size(); ++c)
        most = std::min(most, (1 - wanted[c]) / (1 - inks_[black_].colour[c]));
    most = std::max(0.0, most);
    const double dark = std::clamp((most - (1 - kMiddle)) / (kMiddle - kDark), 0.0, 1.0);
    const double smooth = dark * dark * (3 - 2 * dark);
    return most * (black_ink_ + (1 - black_ink_) * smooth);
}

// Least squares, one ink after the other, until no amount changes much. Ink `fixed` stays.
void Separator::improve(const Channels& wanted, std::size_t fixed) {
    constexpr int kMostSweeps = 200;
    for (int sweep = 0; sweep < kMostSweeps; ++sweep)
        if (improve_once(wanted, fixed) < kSmallChange) return;
}

// Returns the largest change of an amount. A channel is linear in one ink's amount.
double Separator::improve_once(const Channels& wanted, std::size_t fixed) {
    const double overlap = overlap_of(amounts_);
    above_.back() = {};
    for (std::size_t k = amounts_.size(); k-- > 0;)
        for (std::size_t c = 0; c < wanted.size(); ++c) {
            const auto [leaves, adds] = layer(k, overlap * amounts_[k], c);
            const Layer& above = above_[k + 1][c];
            above_[k][c] = {above.leaves * leaves, above.leaves * adds + above.adds};
        }
    double change = 0;
    Channels below = paper_;
    for (std::size_t k = 0; k < amounts_.size(); ++k) {
        double product = 0, square = 0;
        for (std::size_t c = 0; c < wanted.size() && k != fixed; ++c) {
            const Layer& above = above_[k + 1][c];
            const double without = above.leaves * below[c] + above.adds;
            const double one = (inks_[k].is_opaque ? 1 : below[c]) * inks_[k].colour[c];
            const double slope = above.leaves * (below[c] - one);
            product += (paper_[c] + (without - paper_[c]) / overlap - wanted[c]) * slope;
            square += slope * slope;
        }
        if (k != fixed) {
            const double better = square > 0 ? std::clamp(product / square, 0.0, 1.0) : 0;
            change = std::max(change, std::abs(better - amounts_[k]));
            amounts_[k] = better;
        }
        for (std::size_t c = 0; c < wanted.size(); ++c) {
            const auto [leaves, adds] = layer(k, overlap * amounts_[k], c);
            below[c] = leaves * below[c] + adds;
        }
    }
    return change;
}

Separator::Layer Separator::layer(std::size_t k, double covered, std::size_t c) const {
    const auto& [colour, is_opaque] = inks_[k];
    if (is_opaque) return {1 - covered, covered * colour[c]};
    return {1 - covered * (1 - colour[c]), 0};
}

Channels Separator::printed(std::span<const double> amounts) const {
    const double overlap = overlap_of(amounts);
    Channels printed = paper_;
    for (std::size_t c = 0; c < printed.size(); ++c) {
        for (std::size_t k = 0; k < amounts.size(); ++k) {
            const auto [leaves, adds] = layer(k, overlap * amounts[k], c);
            printed[c] = leaves * printed[c] + adds;
        }
        printed[c] = paper_[c] + (printed[c] - paper_[c]) / overlap;
    }
    return printed;
}

}  // namespace lacuna::pictures
