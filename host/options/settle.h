// The defaults of a point set: what follows from what a person gave, whether they use the command,
// Python or the page.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>

namespace lacuna::options {

// What was given, as far as defaults depend on it. What is not set was not given.
struct Choices {
    bool is_picture = false;    // the set is the dots of a picture, as of stipple
    bool has_inks = false;      // in several inks
    bool has_ellipses = false;  // samples have ellipses instead of disks
    bool has_domain = false;
    std::optional<Mode> mode{};
    std::optional<Metric> metric{};
    std::optional<std::uint32_t> relax{};  // how often the points are moved after sampling
    std::uint32_t gaussian = 0;            // and the steps on the Gaussian energy that follow
};

// Decides the number of times that points are moved: 15 for the dots of a picture unless they are
// ellipses, and otherwise 0.
std::uint32_t relax_of(const Choices& given);

// Decides the mode and the metric. The sizes and limits of `request` must be set before; its field
// need not be, as `given` says whether there are ellipses or a picture.
//   - Points that will be relaxed begin stratified, if nothing was given that is about distances:
//     radius, scale, metric, limit, lines per radius or round size. Inks always do.
//   - Samples on pixels are of mode pixels. Without a domain it has as many units as pixels.
//   - Other dots of a picture are made in mode cells, ellipses and all other sets in mode exact.
//   - In cells the metric is mean if the points will be relaxed. Otherwise it is min.
// Throws BadRequest if points would be moved too often, if a stratified set would not be moved at
// all, and for a metric without a field or a picture.
void settle(const Choices& given, Request& request);

}  // namespace lacuna::options
