// The formats of point files: their names, readers and writers. The table in formats.cpp is the
// only list of them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "files/medium.h"

namespace lacuna::files {

struct PointSet;
struct PointsOfFile;

struct Format {
    std::string_view extension;                  // with its dot, in lower case
    std::string (*encode)(const PointSet& set);  // returns the bytes of a file
    // Returns the sets in the file called `name`; null for a format that is only written.
    PointsOfFile (*decode)(std::string_view bytes, const std::string& name) = nullptr;
    // Set if the format is a picture, which can be written but not read.
    std::optional<Medium> medium{};
    // Whether there is a place for the class, the ink and the ellipse of each point.
    bool has_columns = true;

    std::string_view name() const { return extension.substr(1); }
};

std::span<const Format> formats();

// Finds a format by its name, such as csv, or by a path's extension. Case is ignored; null if none.
const Format* find_format(std::string_view name);
const Format* find_format_of(const std::string& path);

// The format in which to write `path`, by its extension; "-" (standard output) is txt.
// Throws BadRequest("output", path, ...), which lists the extensions that can be written.
const Format& format_of(const std::string& path);

// The extensions of the formats for which `is_wanted` is true, separated by blanks, for messages.
std::string extensions(const std::function<bool(const Format&)>& is_wanted);
std::string written_extensions();
std::string read_extensions();
std::string picture_extensions();
std::string column_extensions();  // of formats that are no pictures and have columns

}  // namespace lacuna::files
