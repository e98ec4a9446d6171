// The options of `lacuna sample` and `lacuna verify` that say where samples may lie, and how
// densely: --field, --mask, --inside, --class, --keep and --border.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/class_options.h"
#include "cli/options/ellipse_options.h"
#include "cli/options/given_files.h"
#include "cli/options/picture_field.h"
#include "drawing/dot_size.h"

namespace lacuna::cli {

// The options as given. An empty path means that the option was not given.
struct DomainOptions {
    Picture field;
    EllipseOptions ellipses;
    std::string mask;
    std::vector<std::string> inside;
    std::vector<std::string> outside;
    std::vector<std::string> avoid;  // FILE or FILE:WIDTH
    std::optional<double> edge;
    std::string keep;
    ClassOptions classes;
};

// The contents of the files. The request points into it.
struct DomainFiles {
    std::optional<Field> field;  // read from --field, or of the ellipses
    std::optional<Mask> mask;    // read from --mask, or drawn from the polygons
    // The polygons of --inside, then of --outside, then the lines of --avoid. `kinds` has what else
    // a PolygonSet says of each: whether it is forbidden, and the distance to keep.
    std::vector<Polygons> polygons;
    std::vector<PolygonSet> kinds;
    std::vector<Point> keep;
    std::vector<std::uint8_t> keep_classes;
    double edge = 0;  // how far the polygons' outline may be off
};

// Adds --field, --scale, the options of add_importance(), --ellipses, --stretch, --class,
// --between, --mask, --inside,
// --outside, --avoid, --edge, --border and --keep.
void add_domain(CLI::App& command, DomainOptions& options, Request& request);

// The files that are read, which no output may overwrite.
std::vector<GivenFile> files_of(const DomainOptions& options);

// All that can be checked before the files are read. Throws BadRequest.
void check_domain(const CLI::App& command, const DomainOptions& options);

// Reads the files and makes `request` point to their contents. Without --domain, the first of these
// that is given decides the domain: the field's picture (longer side 1), the page of the polygons,
// the mask (longer side 1). Draws no polygons. Throws BadRequest and files::FileError.
void read_given_files(const CLI::App& command, const DomainOptions& options, Request& request,
                      DomainFiles& files);

// The rings of each file of polygons on the request's domain, and the sets that they are. The rings
// must outlive the sets.
std::vector<std::vector<PolygonRing>> rings_of(const Request& request, const DomainFiles& files);
std::vector<PolygonSet> sets_of(std::span<const PolygonSet> kinds,
                                std::span<const std::vector<PolygonRing>> rings);
// How far the polygons' outline may be off: --edge, or a sixteenth of the least radius, which for a
// count is estimated.
double edge_of(const DomainOptions& options, const Request& request,
               std::span<const PolygonSet> sets, const DomainFiles& files);

// Does what read_given_files() does, and draws the polygons onto the request's mask. Without
// --domain polygons that have no page must lie within the domain.
void read_domain_files(const CLI::App& command, const DomainOptions& options, Request& request,
                       DomainFiles& files);

// The options as JSON, for reports and for files that hold the origin of a set.
nlohmann::ordered_json json_of(const DomainOptions& options, const Request& request,
                               const DomainFiles& files);

// The diameters of dots that follow the request's field; empty without a field.
std::vector<double> dots_of(const Request& request, std::span<const Point> points,
                            drawing::Spread spread);

}  // namespace lacuna::cli
