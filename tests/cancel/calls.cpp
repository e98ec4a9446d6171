// What the calls work on is made once, before they are timed or counted.
#include "cancel/calls.h"

#include <lacuna/analysis.h>
#include <lacuna/domains.h>
#include <lacuna/files.h>
#include <lacuna/inks.h>
#include <lacuna/lacuna.h>
#include <lacuna/many.h>
#include <lacuna/order.h>
#include <lacuna/pictures.h>
#include <lacuna/stipple.h>
#include <lacuna/threshold_mask.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

#include "fields.h"
#include "folder.h"
#include "space/meshes.h"

namespace lacuna::tests {
namespace {

// All that the calls read. It lives as long as a call that holds it.
struct Given {
    explicit Given(std::size_t size)
        : side(static_cast<std::uint32_t>(256 * std::sqrt(size))),
          field(noise_field(side, side, 7)) {
        Request request;
        request.radius = 0.006 / std::sqrt(size);
        points = sample(request).points;
        radius_in_space = 0.04 / std::sqrt(size);
        in_space = sample_surface({.mesh = &mesh, .radius = radius_in_space});
        for (std::size_t i = 0; i < 2000 * size; ++i)
            rings.push_back(ring_at(points[i], 0.3 * *request.radius));
        dark = field;  // orders refuse points on importance 0
        for (double& one : dark.importance) one = std::max(one, 0.1);
        stretched = dark;
        stretched.stretches.assign(field.importance.size(), {3, 0.5});
        ellipses.assign(field.importance.size(), {2, 1, 0.5});
        seeds.resize(40 * size);
        std::iota(seeds.begin(), seeds.end(), std::uint64_t{1});
        mask = {side, side, std::vector<std::uint8_t>(field.importance.size(), 1)};
        mask.allowed[3] = 0;
        picture = "P5\n" + std::to_string(side) + ' ' + std::to_string(side) + "\n255\n";
        for (std::size_t i = 0; i < field.importance.size(); ++i)
            picture += static_cast<char>(i * 2654435761U >> 24U);
        colours = "P6" + picture.substr(2) + picture.substr(picture.find("255\n") + 4) +
                  picture.substr(picture.find("255\n") + 4);
        write_files();
    }

    static PolygonRing ring_at(Point middle, double reach) {
        PolygonRing ring;
        for (int i = 0; i < 16; ++i)
            ring.push_back(
                {middle.x + reach * std::cos(i * 0.39), middle.y + reach * std::sin(i * 0.39)});
        return ring;
    }

    std::string path(const std::string& name) const { return folder.path(name); }

    void write_files() {
        for (const char* const format : {"txt", "csv", "npy", "ply", "json"})
            write_points(path(std::string("points.") + format), points);
        geojson = R"({"type":"MultiPolygon","coordinates":[)";
        svg = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1">)";
        for (const PolygonRing& ring : rings) {
            std::string json, drawn, text;
            for (const Point& point : ring) {
                const std::string x = std::to_string(point.x), y = std::to_string(point.y);
                json += (json.empty() ? "[" : ",[") + x + ',' + y + ']';
                drawn += x + ',' + y + ' ';
                lines += x + ' ' + y + '\n';
            }
            geojson += (&ring == rings.data() ? "[[" : ",[[") + json + ",[" +
                       std::to_string(ring[0].x) + ',' + std::to_string(ring[0].y) + "]]]";
            svg += "<polygon points=\"" + drawn + "\"/>";
            lines += '\n';
        }
        geojson += "]}";
        svg += "</svg>";
        for (const Point3& at : mesh.vertices)
            obj += "v " + std::to_string(at.x) + ' ' + std::to_string(at.y) + ' ' +
                   std::to_string(at.z) + '\n';
        for (std::size_t i = 0; i < points.size(); ++i)
            obj += "f 1 2 " + std::to_string(i % 1000 + 3) + '\n';
        for (const auto& [name, bytes] : {std::pair("rings.geojson", &geojson),
                                          {"rings.svg", &svg},
                                          {"rings.txt", &lines},
                                          {"mesh.obj", &obj},
                                          {"grey.pgm", &picture},
                                          {"colours.ppm", &colours}})
            tests::write_file(path(name), *bytes);
    }

    std::uint32_t side;
    Mesh mesh = sphere(24);
    double radius_in_space;
    SpaceResult in_space;
    Field field;
    Field dark;
    Field stretched;
    Mask mask;
    std::vector<Point> points;
    std::vector<PolygonRing> rings;
    std::vector<Ellipse> ellipses;
    std::vector<std::uint64_t> seeds;
    std::string picture, colours, geojson, svg, lines, obj;
    tests::Folder folder;
};

using Shared = std::shared_ptr<const Given>;

void add_samples(const Shared& given, std::size_t size, std::vector<Call>& all) {
    const double length = 1 / std::sqrt(size);
    const auto add = [&](const char* what, auto change) {
        all.push_back({std::string("sample") + what, [=] {
                           Request request;
                           change(request, *given);
                           sample(request);
                       }});
    };
    add("", [=](Request& r, const Given&) { r.radius = 0.003 * length; });
    add(" in lines", [=](Request& r, const Given&) {
        r.mode = Mode::lines;
        r.radius = 0.005 * length;
    });
    add(" in cells", [=](Request& r, const Given& g) {
        r.mode = Mode::cells;
        r.field = &g.field;
        r.count = 4000 * size;
    });
    add(" stratified", [=](Request& r, const Given& g) {
        r.mode = Mode::stratified;
        r.field = &g.field;
        r.count = 4000 * size;
    });
    add(" on pixels", [=](Request& r, const Given& g) {
        r.mode = Mode::pixels;
        r.field = &g.field;
        r.on_pixels = {g.side, g.side};
        r.count = 8000 * size;
    });
    add(" on a field with a mask", [=](Request& r, const Given& g) {
        r.field = &g.field;
        r.places.mask = &g.mask;
        r.scale = 0.005 * length;
    });
    add(" of a count", [=](Request& r, const Given&) { r.count = 30000 * size; });
    add(" with kept points", [=](Request& r, const Given& g) {
        r.radius = 0.0059 * length;
        r.keep = g.points;
    });
    add(" with points kept outside", [=](Request& r, const Given& g) {
        r.radius = 0.0059 * length;
        r.domain = {1, 1, Boundary::box, 0.5, 0.5};
        r.keep = g.points;
    });
    add(" of classes", [=](Request& r, const Given&) {
        r.classes = {{"a", "b"}, distances_by_sum(std::vector{0.1, 0.003 * length})};
    });
    add(" in a progressive order", [=](Request& r, const Given&) {
        r.progressive = true;
        r.count = 500 * size;
    });
    for (const char* const backend : {"opencl", "vulkan"})
        add((std::string(" on ") + backend).c_str(), [=](Request& r, const Given&) {
            r.run_on.backend = backend;
            r.radius = 0.02 * length;
        });
    const auto slowly = [&](const char* what, auto change) {
        add(what, [=](Request& r, const Given& g) {
            r.run_on.backend = "reference";
            change(r, g);
        });
    };
    slowly(" on reference", [=](Request& r, const Given&) { r.radius = 0.02 * length; });
    slowly(" on reference in lines", [=](Request& r, const Given&) {
        r.mode = Mode::lines;
        r.radius = 0.02 * length;
    });
    slowly(" on reference in cells", [=](Request& r, const Given& g) {
        r.mode = Mode::cells;
        r.field = &g.field;
        r.count = 500 * size;
    });
}

void add_others(const Shared& given, std::size_t size, std::vector<Call>& all) {
    const double length = 1 / std::sqrt(size);
    const auto add = [&](const char* name, auto run) {
        all.push_back({name, [=] { run(*given); }});
    };
    add("sample_many", [](const Given& g) {
        Request request;
        request.radius = 0.02;
        sample_many(request, g.seeds, [](std::uint64_t, const Result&) {});
    });
    add("tile_ring", [=](const Given&) {
        Request request;
        request.domain.boundary = Boundary::torus;
        request.radius = 0.004 * length;
        tile_ring(request, 0.1);
    });
    add("chunk", [=](const Given&) {
        Request request;
        request.radius = 0.02 * length;
        chunk(request, 1, 1, 1);
    });
    add("relax", [](const Given& g) { relax(g.points, &g.field, {.iterations = 2}); });
    add("relax on reference", [](const Given& g) {
        relax(std::span(g.points).first(g.points.size() / 100), nullptr,
              {.iterations = 1, .run_on = {.backend = "reference"}});
    });
    add("place_inks", [=](const Given& g) {
        const std::vector<InkPart> inks{{&g.field, 2000 * size}, {&g.field, 1000 * size}};
        place_inks(inks, 1, {.iterations = 2});
    });
    add("dots_by_ink", [](const Given& g) { dots_by_ink(1000, std::vector<Field>(8, g.field)); });
    add("progressive_order", [](const Given& g) { progressive_order(g.points, nullptr, {}); });
    add("progressive_order on a field",
        [](const Given& g) { progressive_order(g.points, &g.dark, {}); });
    add("ellipses_of", [](const Given& g) { ellipses_of(g.points, g.stretched, 1, {1, 1}); });
    add("ellipse_field", [](const Given& g) { ellipse_field(g.side, g.side, g.ellipses); });
    add("prove", [=](const Given& g) { prove(g.points, {.radius = 0.006 * length}); });
    add("sample_surface",
        [](const Given& g) { sample_surface({.mesh = &g.mesh, .radius = g.radius_in_space}); });
    add("sample_volume", [](const Given& g) {
        sample_volume({.radius = 1.5 * std::pow(g.radius_in_space, 2. / 3) / 4});
    });
    add("prove in space", [](const Given& g) {
        prove(g.in_space.points, {.mesh = &g.mesh, .radius = g.radius_in_space});
    });
    add("normals_of",
        [=](const Given& g) { normals_of(g.mesh, std::vector<std::uint32_t>(200000 * size, 7)); });
    add("least_distance", [](const Given& g) { least_distance(g.points); });
    add("analyze", [](const Given& g) { analyze(std::vector<std::vector<Point>>{g.points}); });
    add("draw_mask", [=](const Given& g) { draw_mask(g.rings, {1, 1}, 0.0015 * length); });
    add("draw_places", [=](const Given& g) {
        const std::vector<PolygonSet> sets{{g.rings}};
        draw_places(sets, {1, 1}, 0.0015 * length);
    });
    add("draw_mask with a distance", [=](const Given& g) {
        const std::vector<PolygonSet> sets{{g.rings, Role::outside, 0.001}};
        draw_mask(sets, {1, 1}, 0.0015 * length);
    });
    add("resolve", [=](const Given& g) {
        resolve({.radius = 0.02,
                 .places = {.outlines = {{.polygons = {g.rings, {}}}}, .edge = 0.0015 * length}});
    });
    add("joined", [](const Given& g) { joined(g.rings); });
    add("fitted", [](const Given& g) { fitted({g.rings, Domain{2, 2}}, {1, 1}); });
}

template <class Read>
void with_assimp(const Read& read) {
    try {
        read();
    } catch (const FileError& error) {
        throw Unavailable(error.what());
    }
}

void add_files(const Shared& given, std::vector<Call>& all) {
    const auto add = [&](const std::string& name, auto run) {
        all.push_back({name, [=] { run(*given); }});
    };
    for (const std::string format : {"txt", "csv", "npy", "ply", "json"})
        add("read_points of " + format,
            [=](const Given& g) { read_points(g.path("points." + format)); });
    for (const std::string format : {"txt", "csv", "npy", "ply", "json", "svg", "pdf", "png"})
        add("encode_points as " + format, [=](const Given& g) { encode_points(g.points, format); });
    add("write_points", [](const Given& g) { write_points(g.path("copy.csv"), g.points); });
    for (const std::string format : {"geojson", "svg", "txt"}) {
        const auto bytes = [=](const Given& g) -> const std::string& {
            return format == "svg" ? g.svg : format == "txt" ? g.lines : g.geojson;
        };
        add("read_polygons of " + format,
            [=](const Given& g) { read_polygons(g.path("rings." + format)); });
        add("decode_polygons of " + format,
            [=](const Given& g) { decode_polygons(bytes(g), format, "rings"); });
        add("read_lines of " + format,
            [=](const Given& g) { read_lines(g.path("rings." + format)); });
        add("decode_lines of " + format,
            [=](const Given& g) { decode_lines(bytes(g), format, "rings"); });
    }
    const Tone tone{.auto_levels = true, .gamma = 2, .sharpen = 4, .along = 3};
    const Tone of_inks{.auto_levels = true, .gamma = 2, .sharpen = 4};
    add("threshold_mask", [](const Given&) { threshold_mask(48, 48); });
    add("threshold_mask of frames", [](const Given&) { threshold_mask(24, 24, 0, 4); });
    add("read_mask", [](const Given& g) { read_mask(g.path("grey.pgm")); });
    add("decode_mask", [](const Given& g) { decode_mask(g.picture, "grey"); });
    add("read_mesh", [](const Given& g) { with_assimp([&] { read_mesh(g.path("mesh.obj")); }); });
    add("decode_mesh",
        [](const Given& g) { with_assimp([&] { decode_mesh(g.obj, "mesh.obj"); }); });
    const std::vector<Ink> inks = inks_of("cmyk");
    add("importance_of",
        [=](const Given& g) { importance_of(read_picture(g.path("grey.pgm")), tone); });
    add("separate",
        [=](const Given& g) { separate(read_picture(g.path("colours.ppm")), inks, of_inks); });
    add("stipple", [=](const Given& g) {
        stipple({g.picture, "grey"}, {.relax = 2, .pen_path = true});
    });
    add("write_stippling", [](const Given& g) {
        Stippling made;
        made.result.points = g.points;
        made.diameters.assign(g.points.size(), 0.001);
        write_stippling(g.path("dots.svg"), made);
    });
    add("stipple in inks", [=](const Given& g) {
        stipple({g.colours, "colours"}, {.relax = 1, .inks = inks, .keep_inside = true});
    });
}

}  // namespace

std::vector<Call> calls(std::size_t size) {
    const auto given = std::make_shared<const Given>(size);
    std::vector<Call> all;
    add_samples(given, size, all);
    add_others(given, size, all);
    add_files(given, all);
    return all;
}

}  // namespace lacuna::tests
