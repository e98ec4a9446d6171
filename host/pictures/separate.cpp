// Separates colours into inks: how much of the paper each ink covers.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/polling.h"
#include "files/parse.h"
#include "pictures/importance.h"
#include "pictures/separator.h"

namespace lacuna::pictures {
namespace {

// Remembers the amounts of colours, because most colours of a picture come again.
class Remembered {
public:
    // `decodes`: the picture's numbers become light.
    Remembered(std::span<const Ink> inks, double black_ink, const Colour& paper, bool is_light,
               bool decodes)
        : separator_(inks, black_ink, paper, is_light),
          decodes_(decodes),
          inks_(inks.size()),
          colours_(kColours, {-1, -1, -1}),
          amounts_(kColours * inks.size()) {}

    // The amounts for a pixel of this darkness, as Separator finds them.
    std::span<const double> amounts(const Channels& darkness) {
        std::uint64_t hash = 0;
        for (const double one : darkness)
            hash = (hash ^ std::bit_cast<std::uint64_t>(one)) * 0x9e3779b97f4a7c15U;
        const std::size_t place = hash >> (64U - kBits);
        const std::span<double> known = std::span(amounts_).subspan(place * inks_, inks_);
        if (colours_[place] != darkness) {
            colours_[place] = darkness;
            Channels wanted{};
            for (std::size_t c = 0; c < wanted.size(); ++c)
                wanted[c] = decodes_ ? light_of(1 - darkness[c]) : 1 - darkness[c];
            const std::span<const double> found = separator_.amounts(wanted);
            std::copy(found.begin(), found.end(), known.begin());
        }
        return known;
    }

private:
    static constexpr unsigned kBits = 16;
    static constexpr std::size_t kColours = std::size_t{1} << kBits;

    Separator separator_;
    bool decodes_;
    std::size_t inks_;
    std::vector<Channels> colours_;
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
    for (Image* channel : channels) {
        cut(*channel, options);
        sharpen(*channel, options);
    }
    const Levels levels = levels_of(colours, options);
    for (Image* channel : channels) to_darkness(*channel, levels, options.invert);

    const std::size_t pixels = colours.red.luminance.size();
    std::vector<Field> fields(inks.size(), {colours.red.columns, colours.red.rows, {}});
    for (Field& field : fields) field.importance.resize(pixels);
    Remembered remembered(inks, black_ink, paper, options.light,
                          options.light && !colours.red.is_linear);
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
