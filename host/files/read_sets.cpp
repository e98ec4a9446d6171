// Chooses the reader for a file of sets.
#include "files/read_sets.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "files/formats.h"
#include "files/parse.h"
#include "files/read_whole.h"

namespace lacuna::files {
namespace {

void refuse_picture(const Format& format, const std::string& name) {
    if (format.medium)
        refuse(name,
               "a picture, whose points are rounded to what can be seen: give the points as " +
                   read_extensions());
}

}  // namespace

SetsOfFile decode_sets(std::string_view bytes, const Format& format, const std::string& name) {
    refuse_picture(format, name);
    return format.decode(bytes, name);
}

SetsOfFile read_sets(const std::string& path) {
    const Format* const format = path == "-" ? find_format("txt") : find_format_of(path);
    if (format == nullptr)
        refuse(path, "not a point file: the extension must be one of " + read_extensions());
    refuse_picture(*format, path);  // before the file is read
    return decode_sets(read_whole(path), *format, name_of(path));
}

}  // namespace lacuna::files
