// lacuna::stipple for pictures that are still to be decoded.
#include <lacuna/stipple.h>

#include <utility>

#include "base/asked.h"
#include "pictures/image.h"
#include "pictures/importance.h"

namespace lacuna {
namespace {

// The importance of the picture, or of each ink.
std::vector<Field> importance_for(const Picture& picture, const StippleOptions& options) {
    using namespace pictures;
    std::vector<Field> fields;
    const Tone& tone = options.tone;
    if (options.inks.empty())
        fields.push_back(
            importance_of(decode_image(picture.content, picture.name, kMaxPixels, kLargestAspect,
                                       {.backdrop = backdrop_of(tone)}),
                          tone));
    else
        fields = separated(
            decode_colours(picture.content, picture.name, backdrop_of(tone), kLargestAspect),
            options.inks, tone, options.black_ink.value_or(kBlackInk), options.paper_colour);
    return fields;
}

}  // namespace

Stippling stipple(const Picture& picture, const StippleOptions& options, Observer& observer) {
    check(options);
    Asked asked(observer, {0, options.request.count.value_or(1), 0});
    asked.begin(Verb::read);
    std::vector<Field> importance = importance_for(picture, options);
    asked.end(Verb::read);
    return stipple(std::move(importance), options, asked);
}

Stippling stipple(const Picture& picture, const StippleOptions& options) {
    Observer nobody;
    return stipple(picture, options, nobody);
}

}  // namespace lacuna
