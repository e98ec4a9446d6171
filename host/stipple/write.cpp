// Writes stippled pictures from C++.
#include <lacuna/stipple.h>

#include "drawing/picture.h"
#include "files/formats.h"
#include "files/point_files.h"

namespace lacuna {

void write_stippling(const std::string& path, const Stippling& stippling) {
    const files::Format& format = files::format_of(path);
    const auto& [set, style] = drawing::shown(stippling);
    files::write_whole(path, drawing::encode(set, format, style));
}

}  // namespace lacuna
