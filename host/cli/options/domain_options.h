// Where samples may lie, and how densely, as `lacuna sample` and `lacuna verify` are told by files:
// --field, --mask, --inside and --keep, and --border.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/app_fwd.h"
#include "cli/options/given_files.h"
#include "cli/options/picture_field.h"
#include "drawing/dot_size.h"

namespace lacuna::cli {

// As given; an empty path is an option that was not.
struct DomainOptions {
    Picture field;
    std::string mask;
    std::string inside;
    std::optional<double> edge;
    std::string keep;
};

// What the files hold. A request points into it.
struct DomainFiles {
    std::optional<Field> field;
    std::optional<Mask> mask;  // as read, or as the polygons were drawn
    std::optional<Polygons> polygons;
    std::vector<Point> keep;
    double edge = 0;  // what the polygons' outline may be off by
};

// --field, --scale and how its picture becomes importance; --mask, --inside, --edge, --border and
// --keep.
void add_domain(CLI::App& command, DomainOptions& options, Request& request);

// The files among them, which nothing that is written may overwrite.
std::vector<GivenFile> files_of(const DomainOptions& options);

// All that can be checked before the files are read. Throws BadRequest.
void check_domain(const CLI::App& command, const DomainOptions& options);

// Reads the files, lets `request` point to what they hold, and where there is no --domain gives it
// the shape of the field's picture (its longer side is 1), else the page's that polygons lie on,
// else the mask's. Draws no polygons. Throws BadRequest and files::FileError.
void read_given_files(const CLI::App& command, const DomainOptions& options, Request& request,
                      DomainFiles& files);

// The polygons on the request's domain, and what their outline may be off by: --edge, or a
// sixteenth of the least radius of the request, which may have a count instead.
std::vector<PolygonRing> rings_of(const Request& request, const DomainFiles& files);
double edge_of(const DomainOptions& options, const Request& request,
               const std::vector<PolygonRing>& rings, const DomainFiles& files);

// The same, and draws the polygons onto the request's mask.
void read_domain_files(const CLI::App& command, const DomainOptions& options, Request& request,
                       DomainFiles& files);

// What was given, for reports and for files that tell where a set comes from.
nlohmann::ordered_json json_of(const DomainOptions& options, const Request& request,
                               const DomainFiles& files);

// The diameters of a picture's dots where they follow a field; none where there is no field.
std::vector<double> dots_of(const Request& request, std::span<const Point> points,
                            drawing::Spread spread);

}  // namespace lacuna::cli
