// Classes of points from the texts of options: the distances that they keep, and their borders.
#pragma once

#include <lacuna/lacuna.h>

#include <string>
#include <vector>

namespace lacuna::options {

// --class and --between.
struct ClassOptions {
    std::vector<std::string> given;  // NAME:RADIUS:WEIGHT:N, where all but the name may be missing
    std::string between = "sum";     // a rule, or the path of a matrix
    bool by_priority = false;        // of --priority
    bool has_file() const { return between != "sum" && between != "union"; }
};

// The classes, without names if none were given. `read_matrix` reads the file of --between, class
// by class in rows, in the order of `names`. Throws BadRequest and what `read_matrix` throws.
Classes read_classes(const ClassOptions& options,
                     std::vector<double> (*read_matrix)(const std::string& path,
                                                        const std::vector<std::string>& names));

// The names of classes for the end of a message, as in " (trees or grass)"; empty if there are
// none.
std::string among_names(const std::vector<std::string>& names);

// Gives the request and its classes the borders of --border, D or NAME:D each. Throws BadRequest.
void take_borders(const std::vector<std::string>& borders, Request& request);

}  // namespace lacuna::options
