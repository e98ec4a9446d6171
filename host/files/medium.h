// The formats of pictures.
#pragma once

namespace lacuna::files {

enum class Medium { svg, pdf, png };

}  // namespace lacuna::files
