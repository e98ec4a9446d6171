// The options of classes of points, --class and --between, for `lacuna sample` and `lacuna verify`.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "files/point_files.h"
#include "files/read_sets.h"

namespace lacuna::cli {

struct ClassOptions {
    std::vector<std::string> given;  // NAME:RADIUS:WEIGHT, where the last two may be missing
    std::string between = "sum";     // a rule, or the path of a matrix
    bool has_file() const { return between != "sum" && between != "union"; }
};

// The classes, without names if none were given. Reads the matrix. Throws BadRequest and FileError.
Classes read_classes(const ClassOptions& options);

// The class of each point of a file, as places in `classes`. `name` stands for the file in
// messages. Throws FileError if points have no class, or one that is not among the classes.
std::vector<std::uint8_t> classes_in(const files::SetsOfFile& file, const Classes& classes,
                                     const std::string& name);

// The classes that a result has; empty if it has none.
std::vector<files::Layer> layers_of(const Classes& classes, const Result& result);

// The diameters of dots in classes: two thirds of the distance that two points of that class
// keep in this result.
std::vector<double> class_diameters(const Request& request, const Result& result);

nlohmann::ordered_json json_of(const Classes& classes);

}  // namespace lacuna::cli
