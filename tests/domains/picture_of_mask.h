// A mask as text.
#pragma once

#include <lacuna/lacuna.h>

#include <cstddef>
#include <string>

namespace lacuna::tests {

// Rows of a mask, # where it allows samples.
inline std::string picture_of(const Mask& mask) {
    std::string text;
    for (std::size_t i = 0; i < mask.allowed.size(); ++i) {
        text += mask.allowed[i] != 0 ? '#' : '.';
        if ((i + 1) % mask.columns == 0) text += '\n';
    }
    return text;
}

}  // namespace lacuna::tests
