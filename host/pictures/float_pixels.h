// Luminance of pictures in floats. Each number is checked; white is found after the last one.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "pictures/decode.h"

namespace lacuna::pictures {

class FloatPixels {
public:
    // Allocates the memory, so the size must have been checked.
    FloatPixels(const Encoded& file, Size size, bool has_alpha)
        : file_(file), image_(make_image(file, size)), alpha_(has_alpha ? size.pixels() : 0) {}

    // Sets a pixel from 1, 3 or 4 channels; row 0 is the top row.
    void set(std::size_t row, std::size_t column, std::span<const double> channels) {
        for (const double value : channels)
            if (!std::isfinite(value) || value < 0)
                refuse(row, column, value, "must be a finite number, 0 or more");
        const std::size_t index = row * image_.columns + column;
        image_.luminance[index] = channels.size() == 1 ? channels[0] : luminance(channels);
        if (alpha_.empty() || channels.size() < 4) return;
        if (channels[3] > 1) refuse(row, column, channels[3], "must be 0 to 1, as alpha");
        alpha_[index] = channels[3];
    }

    Image finish() && {
        std::vector<double>& all = image_.luminance;
        image_.white = std::max(1.0, *std::max_element(all.begin(), all.end()));
        const double behind = file_.reading.backdrop == Backdrop::white ? image_.white : 0;
        for_each_polled(alpha_.size(), ask, [&](std::size_t i) {
            all[i] = std::min(all[i] * alpha_[i] + behind * (1 - alpha_[i]), image_.white);
        });
        image_.is_linear = true;
        return std::move(image_);
    }

private:
    // Written like this, a grey pixel keeps its value to the last bit, and nothing overflows.
    double luminance(std::span<const double> channels) const {
        constexpr double kWhole = kAll;
        const Weights& weights = file_.reading.weights;
        const double green = channels[1];
        return green + weights.red / kWhole * (channels[0] - green) +
               weights.blue / kWhole * (channels[2] - green);
    }

    [[noreturn]] void refuse(std::size_t row, std::size_t column, double value,
                             const char* allowed) const {
        file_.refuse(fmt::format("{} is {}: {}", place(row, column), value, allowed));
    }

    const Encoded& file_;
    Image image_;
    std::vector<double> alpha_;  // empty: all pixels are opaque
};

}  // namespace lacuna::pictures
