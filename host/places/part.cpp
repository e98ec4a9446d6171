// Cuts the pixels of a domain out of a picture with an extent.
#include "places/part.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/number_text.h"
#include "checks/domain.h"
#include "checks/pixels.h"

namespace lacuna::places {
namespace {

constexpr double kMostPixelsOfPart = 1 << 28;

// The pixels along one side: those before the domain, and those in it.
struct Along {
    double before;
    double count;
};
Along along(double first, double side, double begin, double length, std::uint32_t pixels,
            const char* option) {
    const double size = length / pixels;
    const double before = (first - begin) / size, behind = (first + side - begin) / size;
    const double from = std::round(before), to = std::round(behind);
    constexpr double kRounding = 1e-6;  // of a pixel
    if (!(std::abs(before - from) <= kRounding && std::abs(behind - to) <= kRounding && to > from))
        throw BadRequest(option,
                         "of " + std::to_string(pixels) + " pixels from " + shortest(begin) +
                             " to " + shortest(begin + length),
                         "the domain, from " + shortest(first) + " to " + shortest(first + side) +
                             ", must begin and end at borders of pixels");
    return {from, to - from};
}

}  // namespace

Part part_of(const Raster& picture, const Domain& extent, const Domain& domain,
             const char* option) {
    check_domain(extent);
    check_domain(domain);
    const Along x =
        along(domain.x0, domain.width, extent.x0, extent.width, picture.columns, option);
    const Along y = along(domain.y0, domain.height, extent.y0, extent.height, picture.rows, option);
    if (x.count * y.count > kMostPixelsOfPart)
        throw BadRequest(option, shortest(x.count * y.count) + " pixels in the domain",
                         "must be at most 2^28");
    return {static_cast<std::int64_t>(x.before),
            static_cast<std::int64_t>(picture.rows - y.before - y.count),
            static_cast<std::uint32_t>(x.count), static_cast<std::uint32_t>(y.count)};
}

bool has_extents(const Places& places) {
    const auto has_one = [](const Mask* mask) { return mask != nullptr && mask->extent; };
    return has_one(places.mask) || std::any_of(places.masks.begin(), places.masks.end(), has_one);
}

std::shared_ptr<const std::vector<Mask>> cut_masks(const Domain& domain, Places& places) {
    const auto own = std::make_shared<std::vector<Mask>>();
    own->reserve(places.masks.size() + 1);  // so that pointers into it stay
    const auto take = [&](const Mask*& mask) {
        if (mask == nullptr || !mask->extent || mask->drawn) return;
        check_mask(*mask);
        const Raster picture{mask->columns, mask->rows};
        const Part part = part_of(picture, *mask->extent, domain, "mask");
        mask = &own->emplace_back(
            Mask{part.columns, part.rows, cut(mask->allowed, picture, part), {}, {}});
    };
    take(places.mask);
    for (const Mask*& mask : places.masks) take(mask);
    return own->empty() ? nullptr : own;
}

}  // namespace lacuna::places
