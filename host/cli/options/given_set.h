// Points in a file, the picture that they follow, and their domain: what `lacuna relax` and
// `lacuna order` are given.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/options/bind.h"
#include "cli/options/common_options.h"
#include "cli/options/drawing.h"
#include "cli/reports/output.h"
#include "files/read_points.h"

namespace lacuna::cli {

struct GivenSet {
    std::string points;  // path
    Picture picture;     // its path is empty if there is none
};

// The targets of POINTS, IMAGE and what says how a picture is read.
Targets targets_of(GivenSet& set);

// Reads the points and the picture. Sets the request's domain: as given, or the picture's shape, or
// as in the file of the points.
struct SetAndField {
    files::PointsOfFile file;
    std::optional<Field> field;
};
SetAndField read_given_set(const CommandLine& line, const GivenSet& set, Request& request);

[[noreturn]] void refuse_points(const GivenSet& set, const BadRequest& error);

// Calls `work` and returns what it returns. Where it throws a BadRequest of the points, which are
// no option of the command, the message names their file instead, in a files::FileError.
template <class Work>
auto naming_points(const GivenSet& set, const Work& work) {
    try {
        return work();
    } catch (const BadRequest& error) {
        refuse_points(set, error);
    }
}
// The classes, inks and ellipses of points that were read, to be written with them again.
class GivenColumns {
public:
    // Throws files::FileError if the file has a column that would be lost: one that is not known;
    // the sizes of dots, unless --dot-size or --paper-size makes them anew; and any, if an output
    // has no place for it. `can_have_ellipses` is false where points are moved, because an ellipse
    // belongs to a place.
    GivenColumns(const GivenSet& set, const SetAndField& given, const DrawingOptions& drawing,
                 const std::vector<Output>& outputs, bool can_have_ellipses);

    // Puts them into this order; each is an index of a point that was read.
    void put_in_order(std::span<const std::uint32_t> order);
    // Gives them to `set`, which refers to them.
    void add_to(files::PointSet& set) const;

private:
    std::vector<files::Layer> layers_;
    std::vector<std::uint8_t> layer_of_point_;
    files::LayersAre layers_are_ = files::LayersAre::classes;
    std::vector<Ellipse> ellipses_;
    std::vector<files::Column> more_;
};

}  // namespace lacuna::cli
