// Common parts of Tables 1 and 2: the paper's rows, the same rows made here, and their picture.
#pragma once

#include <lacuna/lacuna.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "reproduce/reproduce.h"

namespace lacuna::reproduce {

inline constexpr std::array<double, 4> kRadii{0.05, 0.01, 0.005, 0.001};

// The method of Lacuna that a row of the paper is compared with.
enum class Way {
    cdf,        // mode lines with x on the lines, m = 30: "Ours"
    uniform_x,  // the same with uniform-x
    exact,      // mode exact, for other authors' programs that make truly maximal sets
};

struct PublishedRow {
    std::string name;  // the paper's name for the method
    Way way;
    std::array<double, 4> seconds;  // by kRadii
    std::array<double, 4> samples;
};

// Dart throwing that stops at `samples` samples. The paper gives its time only without the torus
// (section 5.1).
struct PublishedDarts {
    double radius;
    std::uint64_t samples;
    std::optional<double> seconds;
};

// Counts must be within 0.5 % of the paper's, or within three standard errors of the mean of all
// runs, if that is more. Times are for information only.
Reproduction reproduce_table(const Setting& setting, Boundary boundary,
                             std::span<const PublishedRow> rows, const PublishedDarts& darts);

}  // namespace lacuna::reproduce
