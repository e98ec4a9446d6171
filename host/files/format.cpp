// The format that a file's extension names.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "files/point_files.h"

namespace lacuna::files {
namespace {

struct NamedFormat {
    std::string_view extension;
    Format format;
};

constexpr std::array<NamedFormat, 8> kFormats{{{".txt", Format::txt},
                                               {".csv", Format::csv},
                                               {".npy", Format::npy},
                                               {".ply", Format::ply},
                                               {".json", Format::json},
                                               {".svg", Format::svg},
                                               {".pdf", Format::pdf},
                                               {".png", Format::png}}};

std::string known_extensions() {
    std::string list;
    for (const NamedFormat& known : kFormats) list.append(" ").append(known.extension);
    return list;
}

}  // namespace

char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

Format format_of(const std::string& path) {
    if (path == "-") return Format::txt;
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), lower_case);
    const auto* found = std::find_if(kFormats.begin(), kFormats.end(), [&](const NamedFormat& f) {
        return f.extension == extension;
    });
    if (found == kFormats.end())
        throw BadRequest("output", path, "the extension must be one of" + known_extensions());
    return found->format;
}

bool is_picture(Format format) {
    return format == Format::svg || format == Format::pdf || format == Format::png;
}

}  // namespace lacuna::files
