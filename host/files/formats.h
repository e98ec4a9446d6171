// The formats of point files: what each is called, and what writes and reads it. formats.cpp has
// the table, which is the one place that lists them.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "drawing/medium.h"

namespace lacuna::files {

struct PointSet;
struct SetsOfFile;

struct Format {
    std::string_view extension;  // with its dot, in lower case
    // The bytes of a file; null for a format that is only read.
    std::string (*encode)(const PointSet& set) = nullptr;
    // The sets of a file, whose name messages give; null for a format that is only written.
    SetsOfFile (*decode)(std::string_view bytes, const std::string& name) = nullptr;
    // Of a picture, which is to be seen and cannot be read.
    std::optional<drawing::Medium> medium{};

    std::string_view name() const { return extension.substr(1); }
};

std::span<const Format> formats();

// By its name, such as csv, or by the extension of a path, in any case; null if there is none.
const Format* find_format(std::string_view name);
const Format* find_format_of(const std::string& path);

// The format to write `path` in: what its extension names; "-" (standard output) is txt.
// Throws BadRequest("output", path, ...) listing the extensions that can be written.
const Format& format_of(const std::string& path);

// The extensions of the formats that `is_wanted`, with a blank between two, as messages list them.
std::string extensions(const std::function<bool(const Format&)>& is_wanted);
std::string written_extensions();
std::string read_extensions();
std::string picture_extensions();

}  // namespace lacuna::files
