// Figure 7: an image drawn with 20,000 dots of one size, min-conflict metric, m = 30.
//
// The paper uses images of Kopf et al.; any image can be given here. The figure's other methods, by
// Balzer and by Kopf, are not part of Lacuna.
#include "drawing/picture.h"
#include "reproduce/reproduce.h"
#include "reproduce/stipple.h"

namespace lacuna::reproduce {
namespace {

constexpr std::uint64_t kManyDots = 250'000;
constexpr double kPaperSeconds = 13 * 60;  // "13 minutes for ours" (5.2), for its bottom image

}  // namespace

Reproduction fig7(const Setting& setting) {
    const Field& image = *setting.image;
    constexpr double kCostOfMany = 8;
    Work work(setting, 2 + kCostOfMany);
    const Sets few = stipple(image, kDots, Metric::min, work, 1);
    const Sets max = stipple(image, kDots, Metric::max, work, 1);
    const Sets many = stipple(image, kManyDots, Metric::min, work, kCostOfMany);
    Reproduction made;
    made.numbers = {
        printed("dots", static_cast<double>(kDots), static_cast<double>(few.points[0].size()), 0),
        timing("250,000 dots: s", kPaperSeconds, many.seconds[0])};
    made.data = {{"pixels", {image.columns, image.rows}},
                 {"dots", few.points[0].size()},
                 {"tone_error_of_64_squares_across",
                  {{"min", tone_error(image, few.points[0], 64)},
                   {"max", tone_error(image, max.points[0], 64)}}},
                 {"seconds", few.seconds[0]},
                 {"seconds_of_250000_dots", many.seconds[0]},
                 {"threads", 1}};
    made.medium = files::Medium::png;
    // A dot's radius is a third of the radius given, so dots have 1/800 of the longer side.
    made.picture = drawing::draw({few.points[0], domain_like(image.columns, image.rows), 3.0 / 800},
                                 made.medium);
    return made;
}

}  // namespace lacuna::reproduce
