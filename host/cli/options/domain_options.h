// The options of `lacuna sample` and `lacuna verify` that say where samples may lie, and how
// densely: --field, --mask, --inside, --class, --keep and --border.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/options/bind.h"
#include "cli/options/common_options.h"
#include "cli/reports/output.h"
#include "files/point_files.h"
#include "files/read_points.h"
#include "options/chunk.h"
#include "options/classes.h"
#include "stipple/dot_size.h"

namespace lacuna::cli {

// The matrix of distances in a file of --between, row by row. Throws FileError.
std::vector<double> read_matrix(const std::string& path, const std::vector<std::string>& names);

// Throws BadRequest for NAME:FILE with the name of a class, which this option does not have.
void refuse_class_of_file(const std::string& option, const std::string& text,
                          const std::vector<std::string>& names, const std::string& why);

// The class that NAME:FILE is for, and FILE. The class is empty for FILE, which is for all: if no
// class has the name before the first colon.
std::pair<std::string, std::string> class_and_path(const std::string& text,
                                                   const std::vector<std::string>& names);
// Throws BadRequest for --OPTION TEXT if it looks like NAME:FILE, but names neither a class nor a
// file. `path` is what class_and_path() found.
void check_class_of_file(const std::string& option, const std::string& text,
                         const std::string& path, const std::vector<std::string>& names);

// The class of each point of a file, as places in `classes`. `name` stands for the file in
// messages. Throws FileError if points have no class, or one that is not among the classes.
std::vector<std::uint8_t> classes_in(const files::PointsOfFile& file, const Classes& classes,
                                     const std::string& name);

// The classes that a result has; empty if it has none.
std::vector<files::Layer> layers_of(const Classes& classes, const Result& result);

// The diameters of dots in classes: two thirds of the distance that two points of that class
// keep in this result.
std::vector<double> class_diameters(const Request& request, const Result& result);

nlohmann::ordered_json json_of(const Classes& classes);

// An ellipse instead of a disk for each sample: --ellipses and --stretch.
struct EllipseOptions {
    std::string path;  // of --ellipses; empty: not given
    std::string same;  // of --stretch

    bool are_given() const { return !path.empty() || !same.empty(); }
};

// The field of the ellipses, whose scale is 1. Throws BadRequest and files::FileError.
Field read_ellipses(const EllipseOptions& options);

nlohmann::ordered_json json_of(const EllipseOptions& options);

// The ellipse that A:B@DEGREES names. Throws BadRequest for --stretch.
Ellipse ellipse_from(const std::string& text);

// The ellipses of the points that were made of the request; empty if its field has no stretches.
std::vector<Ellipse> ellipses_of(const Request& request, const Result& result);

// Throws BadRequest if an output has no place for the columns.
void check_ellipse_columns(bool is_given, const std::vector<Output>& outputs);

// The outlines in a file of an option: --inside, --outside, --avoid or --near. The text of the last
// two is FILE, FILE:WIDTH or FILE:stroke. Points of a .csv have a column radius, or all have the
// width; lines and outlines of another file need one, or are strokes. Throws BadRequest and
// FileError.
std::vector<Outline> read_outlines(Role role, const std::string& text);
// FILE without the width.
std::string path_of_obstacles(const std::string& text);

// FILE of the picture of --field or --mask that is FILE@X0,Y0+WxH or FILE@world, and where it lies:
// in a rectangle of the plane, or as the world file beside it says, such as FILE.pgw.
struct PlacedPicture {
    std::string path;
    std::optional<std::string> place;
};
PlacedPicture placed_picture(const std::string& text);
// The rectangle; unset: the picture is stretched over the domain. Throws BadRequest and FileError.
std::optional<Domain> extent_of(const std::string& option, const PlacedPicture& picture,
                                const Raster& pixels);

// The options as given. An empty path means that the option was not given.
struct DomainOptions {
    Picture field;
    EllipseOptions ellipses;
    std::vector<std::string> mask;  // IMAGE or NAME:IMAGE
    // FILE or NAME:FILE; of roles that have a distance, FILE, FILE:WIDTH or FILE:stroke.
    std::map<Role, std::vector<std::string>> outlines;
    std::optional<double> edge;
    std::string keep;
    options::ClassOptions classes;
    // The names of the first .json, where --class is not given: files may be given for these.
    std::vector<std::string> known_classes;
    std::vector<std::string> borders;  // D or NAME:D
    bool inside_by_radius = false;
    options::ChunkOptions chunk;  // of sample alone
};

// The contents of the files. The request points into it.
struct DomainFiles {
    std::optional<Field> field;            // read from --field, or of the ellipses
    std::map<std::string, Mask> pictures;  // of --mask, by the class that each is for; "": for all
    std::vector<Point> keep;
    std::vector<std::uint8_t> keep_classes;
    std::shared_ptr<const std::vector<Mask>> masks;  // drawn from outlines
    double edge = 0;                                 // how far outlines may be off; 0: none
    std::optional<Domain> extent;                    // of the field's picture, if it has its own
    std::optional<Chunk> chunk;                      // whose request this is
    std::string hint;                                // of a page whose shape changes; or empty
};

Targets targets_of(DomainOptions& options);

// Gives the request this domain, but leaves its boundary.
void take_shape(const Domain& shape, Request& request);

// Reads the files, and gives `request` its places and what else they hold; without --domain its
// domain, too. Throws BadRequest and files::FileError.
void read_given_files(const CommandLine& line, const DomainOptions& options, Request& request,
                      DomainFiles& files);

// The part of the field that lies in the domain, where its picture has an extent. Throws
// BadRequest.
Field field_in(const Domain& domain, const DomainFiles& files);

// Gives the request the pictures of --mask that classes of these names have of their own. Throws
// BadRequest.
void take_masks(const std::vector<std::string>& names, const DomainFiles& files, Request& request);

// Does what read_given_files() does, and resolves the request's places.
void read_domain_files(const CommandLine& line, const DomainOptions& options, Request& request,
                       DomainFiles& files);

// The request with the radius and the distances of classes that the set keeps. Those of the request
// itself are only proportions if it has a count.
Request as_made(Request request, const Result& result);

// How many points were kept in the domain, and how many outside are near enough to matter, and
// whether points may lie nowhere, for the line that sums up a run; empty if there is nothing to
// say.
std::string words_of_places(const Request& request);

// The options as JSON, for reports and for files that hold the origin of a set.
nlohmann::ordered_json json_of(const DomainOptions& options, const Request& request,
                               const DomainFiles& files);

// The diameters of dots that follow the request's field; empty without a field.
std::vector<double> dots_of(const Request& request, std::span<const Point> points,
                            stippling::Spread spread);

// The next three are for `lacuna verify` of a .json: what it says of the options that its set was
// made with is used where no option is given, and files are asked for.

// Throws BadUsage if the set in `file` was made with a picture, polygons, obstacles or neighbours
// that the command was not given, or with another tone of the field. For distances alone only
// ellipses are needed. `name` stands for the file.
void ask_for_files(const CommandLine& line, const DomainOptions& options, bool distances_only,
                   const files::Origin& origin, const std::string& name);

// Fills in the scale, the classes, the borders and how far edges may be off, where the command was
// not given them. If the set has the same ellipse everywhere, returns its field, to which `request`
// points.
std::shared_ptr<const Field> use_values(const CommandLine& line, const files::Origin& origin,
                                        Request& request, DomainOptions& options);

// How many points of the set were kept: it begins with them.
std::size_t kept_in(const files::PointsOfFile& file);

}  // namespace lacuna::cli
