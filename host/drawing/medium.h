// The formats of pictures.
#pragma once

namespace lacuna::drawing {

enum class Medium { svg, pdf, png };

}  // namespace lacuna::drawing
