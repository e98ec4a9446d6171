// The options of `lacuna order`, and its run.
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/order.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "cli/options/common_options.h"
#include "cli/options/domain_options.h"
#include "cli/options/drawing.h"
#include "cli/options/given_set.h"
#include "cli/reports/output.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "pictures/importance.h"

namespace lacuna::cli {
namespace {

constexpr const char* kOrderDescription =
    R"(Orders points so that the first n, for any n, are spread over the domain as evenly as can be.

Examples:
  lacuna order points.txt --torus -o ordered.npy        any set, on a domain whose edges wrap
  lacuna sample --count 4096 --torus --relax 30 -o a.json && lacuna order a.json -o b.npy
  lacuna order dots.npy photo.jpg -o a.npy              dots of a picture: dense where it is dark

The first points are far apart, and the distance shrinks from level to level, by 2^(-1/32): each
level adds points that keep that distance from all that were added before. With a picture the
distance follows its darkness. No point is moved. lacuna sample --progressive makes new points in
such an order, more evenly spread at each n.

Without --domain and --torus the domain comes from a .json, or is the picture's shape with a longer
side of 1, or 1x1. Points are read as by analyze, and pictures as by stipple.

Exit code: 0 done, 2 bad usage, 3 a file cannot be read or written, 130 interrupted.
)";

struct OrderCommand {
    CommonOptions common;
    GivenSet set;
    DrawingOptions drawing;
};

void run(const CommandLine& line, const OrderCommand& options) {
    const std::vector<Output> outputs = checked_outputs(options.common, files_read(line));
    pictures::check(options.set.picture.importance);
    const DrawingOptions drawing = checked_drawing(line, options.drawing, outputs);
    Interruption interruption;
    Request request = options.common.request;
    const SetAndField given = read_given_set(line, options.set, request);
    GivenColumns columns(options.set, given, drawing, outputs, true);
    if (given.field) request.field = &*given.field;
    const std::vector<std::uint32_t> order = naming_points(options.set, [&] {
        return progressive_order(given.file.points, request.field, {request.domain, request.seed});
    });
    std::vector<Point> points;
    points.reserve(order.size());
    for (const std::uint32_t index : order) points.push_back(given.file.points[index]);
    columns.put_in_order(order);

    files::PointSet set{points, request.domain};
    columns.add_to(set);
    finish(interruption, options.common, drawing, outputs,
           {.set = set,
            .style = style_of(drawing, request.domain),
            .find_diameters = [&] { return dots_of(request, points, stippling::Spread::even); },
            .report = {},
            .words = fmt::format("{} points, in order", points.size())});
}

// Where the value of each option goes.
Targets targets_of(OrderCommand& all) {
    Targets targets;
    targets.merge(targets_of(all.set));
    targets.merge(targets_of(all.common));
    targets.merge(targets_of(all.drawing));
    return targets;
}

}  // namespace

void add_order(CLI::App& app) {
    const auto all = std::make_shared<OrderCommand>();
    add_command(app, options::kOrder, kOrderDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
