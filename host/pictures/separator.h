// How much of the paper each ink covers, for one colour.
#pragma once

#include <lacuna/inks.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lacuna::pictures {

// Red, green and blue as areas average them, 0 to 1: the numbers of sRGB, or light (Tone::light).
using Channels = std::array<double, 3>;

// Finds the amount of each ink, 0 to 1, that gives paper a given colour; an ink of amount a covers
// the part a of the paper. On each channel, inks are drawn over the paper P in their order. An
// opaque ink of amount a leaves 1 - a of what lies below it, and adds a of its own; a transparent
// one, which takes the part s where it covers, leaves 1 - a s. Let F be the channel if each ink lay
// independently of the others. Then it is P + (F - P) / o, where F is that of the amounts times o:
// for o = 1 it is F itself, and near 0 it is that of inks that never overlap. How often inks
// overlap, o, was measured. On paper that is not white, black replaces no other inks.
class Separator {
public:
    // `light`: the channels are light.
    Separator(std::span<const Ink> inks, double black_ink, const Colour& paper, bool light);

    // The amounts of the inks for a colour: those that give it by least squares. If the inks cannot
    // make it, those that keep its lightness first, then its hue, then its saturation. The result
    // holds until the next call.
    std::span<const double> amounts(const Channels& picture);

    // The colour that these amounts give.
    Channels printed(std::span<const double> amounts) const;

private:
    // What an ink of an amount does to the channel below it: it leaves a share of it, and adds.
    struct Layer {
        double leaves = 1;
        double adds = 0;
    };

    Channels channels_of(const Colour& colour) const;
    Layer layer(std::size_t k, double covered, std::size_t c) const;
    bool has_black() const { return black_ != amounts_.size(); }
    Channels no_darker_than_black(Channels wanted) const;
    double amount_of_black(const Channels& wanted) const;
    void improve(const Channels& wanted, std::size_t fixed);
    double improve_once(const Channels& wanted, std::size_t fixed);
    void keep_lightness(const Channels& wanted);
    void find_slopes(const Channels& colour, const std::array<Channels, 3>& by_channel);

    double black_ink_;
    std::size_t black_;  // the first black ink, or the number of inks if there is none
    bool is_white_;      // the paper
    bool is_grey_;       // paper and inks
    bool is_light_;      // the channels
    Channels paper_;
    struct Printed {
        Channels colour{};  // on white paper
        bool is_opaque = false;
    };
    std::vector<Printed> inks_;
    std::vector<double> amounts_;
    std::vector<std::array<Layer, 3>> above_;  // of improve_once(): all inks above each one
    std::vector<double> next_;                 // of keep_lightness(): the next amounts,
    std::vector<Channels> slopes_;             // and what each of them changes
};

}  // namespace lacuna::pictures
