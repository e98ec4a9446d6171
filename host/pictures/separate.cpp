// Separates colours into inks: how much of the paper each ink covers.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/importance.h"

namespace lacuna::pictures {
namespace {

using Light = std::array<double, 3>;  // red, green and blue, linear; white is 1

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

// Finds the amount of each ink, 0 to 1, that gives paper a given colour; an ink of amount a covers
// the part a of the paper. In each channel, let s be the part of the light that an ink absorbs
// where it covers. The light is 1 - (1 - product over inks of (1 - o a s)) / o. For o = 1 this is
// the product of 1 - a s, as of inks that lie independently of each other; near 0 it is 1 - sum of
// a s, as of inks that never overlap. o is overlap_of() the amounts. On paper that is not white see
// light_with(); black replaces no other inks there.
class Separator {
public:
    Separator(std::span<const Ink> inks, double black_ink, const Colour& paper)
        : black_ink_(black_ink),
          black_(inks.size()),
          is_white_(paper == kWhitePaper),
          paper_(light_of(paper)),
          amounts_(inks.size()) {
        for (const Ink& ink : inks) {
            Light absorbed = light_of(ink.colour);
            for (double& part : absorbed) part = 1 - part;
            const bool is_black = *std::min_element(absorbed.begin(), absorbed.end()) > kBlack;
            if (is_black && black_ == inks.size() && is_white_) black_ = absorbed_.size();
            absorbed_.push_back(absorbed);
            is_opaque_.push_back(ink.is_opaque_on(paper));
        }
        const auto is_grey = [](const Colour& one) { return one[0] == one[1] && one[1] == one[2]; };
        is_grey_ = is_grey(paper) && std::all_of(inks.begin(), inks.end(), [&](const Ink& ink) {
                       return is_grey(ink.colour);
                   });
    }

    // The result holds until the next call.
    std::span<const double> amounts(const Light& picture) {
        ask_after(64);
        const Light wanted = no_darker_than_black(is_grey_ ? luminance_of(picture) : picture);
        std::fill(amounts_.begin(), amounts_.end(), 0.0);
        if (has_black()) {
            amounts_[black_] = amount_of_black(wanted);
            improve(wanted, black_);
        }
        improve(wanted, amounts_.size());
        for (double& amount : amounts_)
            if (amount < kSmallChange) amount = 0;  // dots for it would be noise
        return amounts_;
    }

private:
    static constexpr double kBlack = 0.9;  // black absorbs more than this of each channel
    static constexpr double kSmallChange = 1e-4;
    // Light below kDark is left to black, and from kMiddle up --black-ink decides. If the change
    // came in a narrower range, or at darker greys, the other inks would jump on the way: dots that
    // overlap much and fewer dots that hardly overlap can print the same dark grey.
    static constexpr double kDark = 0.05;
    static constexpr double kMiddle = 0.5;

    static Light light_of(const Colour& colour) {
        Light light{};
        for (std::size_t c = 0; c < light.size(); ++c)
            light[c] = pictures::light_of(colour[c] / 255.0);
        return light;
    }

    // Grey inks can print no more of a colour than its luminance.
    static Light luminance_of(const Light& light) {
        const double grey =
            (kLuminance.red * light[0] + kLuminance.green * light[1] + kLuminance.blue * light[2]) /
            kAll;
        return {grey, grey, grey};
    }

    bool has_black() const { return black_ != amounts_.size(); }

    // Black ink reflects a little light. Colours that are about as dark are lightened until it can
    // print them; otherwise all other inks would be printed over it, or in its place. The change
    // is smooth, and ends at twice the light of black.
    Light no_darker_than_black(Light light) const {
        if (!has_black()) return light;
        const double lightest = *std::max_element(light.begin(), light.end());
        for (std::size_t c = 0; c < light.size(); ++c) {
            const double of_black = 1 - absorbed_[black_][c];
            if (lightest >= 2 * of_black) continue;
            const double near = 1 - lightest / (2 * of_black);
            light[c] += of_black * near * near;
        }
        return light;
    }

    // In a light colour black takes the part `black_ink_` of what it can take without making a
    // channel too dark. In dark ones this part rises to all.
    double amount_of_black(const Light& wanted) const {
        double most = 1;
        for (std::size_t c = 0; c < wanted.size(); ++c)
            most = std::min(most, (1 - wanted[c]) / absorbed_[black_][c]);
        most = std::max(0.0, most);
        const double dark = std::clamp((most - (1 - kMiddle)) / (kMiddle - kDark), 0.0, 1.0);
        const double smooth = dark * dark * (3 - 2 * dark);
        return most * (black_ink_ + (1 - black_ink_) * smooth);
    }

    // Least squares, one ink after the other, until no amount changes much. Ink `fixed` stays.
    void improve(const Light& wanted, std::size_t fixed) {
        constexpr int kMostSweeps = 200;
        for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
            double change = 0;
            overlap_ = overlap_of(amounts_);
            for (std::size_t k = 0; k < amounts_.size(); ++k) {
                if (k == fixed) continue;
                const double better = best_amount(wanted, k);
                change = std::max(change, std::abs(better - amounts_[k]));
                amounts_[k] = better;
            }
            if (change < kSmallChange) return;
        }
    }

    // The light is linear in one ink's amount.
    double best_amount(const Light& wanted, std::size_t k) const {
        double above = 0;
        double below = 0;
        for (std::size_t c = 0; c < wanted.size(); ++c) {
            if (!is_white_) {
                const double without = light_with(k, 0, c);
                const double slope = without - light_with(k, 1, c);
                above += (without - wanted[c]) * slope;
                below += slope * slope;
                continue;
            }
            double product = 1;
            for (std::size_t other = 0; other < amounts_.size(); ++other)
                if (other != k) product *= 1 - overlap_ * amounts_[other] * absorbed_[other][c];
            const double without = 1 - (1 - product) / overlap_;
            const double slope = product * absorbed_[k][c];
            above += (without - wanted[c]) * slope;
            below += slope * slope;
        }
        return below > 0 ? std::clamp(above / below, 0.0, 1.0) : 0;
    }

    // The light of a channel if ink k has this amount, on paper of any colour, over which the inks
    // are drawn in their order. Let F be the light if each ink lay independently of the others: an
    // opaque ink of amount a leaves 1 - a of the light below it and adds a of its own, and a
    // transparent one leaves 1 - a s. Then the light is P + (F - P) / o, where P is the paper's and
    // F is that of the amounts times o.
    double light_with(std::size_t k, double amount, std::size_t c) const {
        double light = paper_[c];
        for (std::size_t i = 0; i < amounts_.size(); ++i) {
            const double covered = overlap_ * (i == k ? amount : amounts_[i]);
            light = is_opaque_[i] ? light * (1 - covered) + covered * (1 - absorbed_[i][c])
                                  : light * (1 - covered * absorbed_[i][c]);
        }
        return paper_[c] + (light - paper_[c]) / overlap_;
    }

    double overlap_ = 1;
    double black_ink_;
    std::size_t black_;  // the first black ink, or the number of inks if there is none
    bool is_white_;      // the paper
    bool is_grey_;       // paper and inks
    Light paper_;
    std::vector<Light> absorbed_;  // the part of the light that each ink absorbs where it covers
    std::vector<bool> is_opaque_;
    std::vector<double> amounts_;
};

// Remembers the amounts of colours, because most colours of a picture come again.
class Remembered {
public:
    Remembered(std::span<const Ink> inks, double black_ink, const Colour& paper, bool is_linear)
        : separator_(inks, black_ink, paper),
          is_linear_(is_linear),
          inks_(inks.size()),
          colours_(kColours, {-1, -1, -1}),
          amounts_(kColours * inks.size()) {}

    // The amounts for a pixel of this darkness, as Separator finds them.
    std::span<const double> amounts(const std::array<double, 3>& darkness) {
        std::uint64_t hash = 0;
        for (const double one : darkness)
            hash = (hash ^ std::bit_cast<std::uint64_t>(one)) * 0x9e3779b97f4a7c15U;
        const std::size_t place = hash >> (64U - kBits);
        const std::span<double> known = std::span(amounts_).subspan(place * inks_, inks_);
        if (colours_[place] != darkness) {
            colours_[place] = darkness;
            Light light{};
            for (std::size_t c = 0; c < light.size(); ++c)
                light[c] = is_linear_ ? 1 - darkness[c] : pictures::light_of(1 - darkness[c]);
            const std::span<const double> found = separator_.amounts(light);
            std::copy(found.begin(), found.end(), known.begin());
        }
        return known;
    }

private:
    static constexpr unsigned kBits = 16;
    static constexpr std::size_t kColours = std::size_t{1} << kBits;

    Separator separator_;
    bool is_linear_;  // the picture's numbers are light
    std::size_t inks_;
    std::vector<std::array<double, 3>> colours_;
    std::vector<double> amounts_;
};

// The channels are on one scale, and their luminance decides automatic levels.
Levels levels_of(Colours& colours, const Importance& options) {
    const double white = std::max({colours.red.white, colours.green.white, colours.blue.white});
    colours.red.white = colours.green.white = colours.blue.white = white;
    if (!options.auto_levels) return levels_of(colours.red, options);
    constexpr double kWhole = kAll;
    Image luminance = colours.green;
    for (std::size_t i = 0; i < luminance.luminance.size(); ++i)
        luminance.luminance[i] = kLuminance.red / kWhole * colours.red.luminance[i] +
                                 kLuminance.green / kWhole * colours.green.luminance[i] +
                                 kLuminance.blue / kWhole * colours.blue.luminance[i];
    return levels_of(luminance, options);
}

}  // namespace

std::vector<Field> separated(Colours colours, std::span<const Ink> inks, const Importance& options,
                             double black_ink, const Colour& paper) {
    check(options);
    if (!(black_ink >= 0 && black_ink <= 1))
        throw BadRequest("black-ink", fmt::format("{}", black_ink), "must be 0 to 1");
    if (options.along != 1)
        throw BadRequest("along", fmt::format("{}", options.along), "is not for inks");
    const std::array channels{&colours.red, &colours.green, &colours.blue};
    for (Image* channel : channels) sharpen(*channel, options);
    const Levels levels = levels_of(colours, options);
    for (Image* channel : channels) to_darkness(*channel, levels, options.invert);

    const std::size_t pixels = colours.red.luminance.size();
    std::vector<Field> fields(inks.size(), {colours.red.columns, colours.red.rows, {}});
    for (Field& field : fields) field.importance.resize(pixels);
    Remembered remembered(inks, black_ink, paper, colours.red.is_linear);
    for (std::size_t i = 0; i < pixels; ++i) {
        ask_after();
        const std::span<const double> amounts = remembered.amounts(
            {colours.red.luminance[i], colours.green.luminance[i], colours.blue.luminance[i]});
        for (std::size_t k = 0; k < inks.size(); ++k) fields[k].importance[i] = amounts[k];
    }
    const auto is_blank = [](const Field& field) { return is_zero_all_over(field.importance); };
    if (options.min_importance == 0 && std::all_of(fields.begin(), fields.end(), is_blank)) {
        if (paper != kWhitePaper)
            files::refuse(colours.red.name, "needs none of the inks on paper of this colour");
        refuse_blank(colours.red.name, options.invert);
    }
    for (Field& field : fields) apply_gamma_and_least(field.importance, colours.red.name, options);
    return fields;
}

}  // namespace lacuna::pictures
