// What a picture is drawn as.
#pragma once

namespace lacuna::drawing {

enum class Medium { svg, pdf, png };

}  // namespace lacuna::drawing
