// The requests of mode exact with a radius field on which every backend must equal the reference:
// fields, masks, borders, kept points, boundaries, rectangles, round sizes, limits, threads.
#pragma once

#include <lacuna/lacuna.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fields.h"

namespace lacuna::tests {

// A request and the objects that it points to.
struct FieldRequest {
    std::string name;
    Request request;
    std::shared_ptr<const Field> field;
    std::shared_ptr<const Mask> mask;
    std::shared_ptr<const std::vector<Point>> keep;
    std::shared_ptr<const std::vector<std::uint8_t>> keep_classes;
    std::vector<std::shared_ptr<const Mask>> masks;  // of classes
};

// Its scale is such that `count` samples are expected.
inline FieldRequest radius_field_request(std::string name, Field field, double count,
                                         Boundary boundary, double width = 1, double height = 1) {
    FieldRequest made;
    made.name = std::move(name);
    made.field = std::make_shared<const Field>(std::move(field));
    made.request.field = made.field.get();
    made.request.domain.width = width;
    made.request.domain.height = height;
    made.request.domain.boundary = boundary;
    made.request.scale = scale_of(*made.field, width * height, count);
    return made;
}

inline FieldRequest with_mask(FieldRequest made, Mask mask) {
    made.mask = std::make_shared<const Mask>(std::move(mask));
    made.request.places.mask = made.mask.get();
    return made;
}

inline FieldRequest with_keep(FieldRequest made, std::vector<Point> points) {
    made.keep = std::make_shared<const std::vector<Point>>(std::move(points));
    made.request.keep = *made.keep;
    return made;
}

inline FieldRequest with_border(FieldRequest made, double border) {
    made.request.places.border = border;
    return made;
}

// The same with classes that are called a, b and so on.
inline FieldRequest with_classes(FieldRequest made, std::vector<double> distances,
                                 std::vector<double> weights) {
    for (std::size_t i = 0; i < weights.size(); ++i)
        made.request.classes.names.push_back(std::string(1, static_cast<char>('a' + i)));
    made.request.classes.distances = std::move(distances);
    made.request.classes.weights = std::move(weights);
    made.request.radius.reset();
    made.request.scale.reset();
    return made;
}

// The same with places of their own: the border of each class, and the mask of the last one.
inline FieldRequest with_places(FieldRequest made, std::vector<double> borders, Mask mask) {
    made.masks.push_back(std::make_shared<const Mask>(std::move(mask)));
    made.request.places.masks.resize(borders.size());
    made.request.places.masks.back() = made.masks.back().get();
    made.request.places.borders = std::move(borders);
    return made;
}

inline FieldRequest with_keep_in_classes(FieldRequest made, std::vector<Point> points,
                                         std::vector<std::uint8_t> classes) {
    made = with_keep(std::move(made), std::move(points));
    made.keep_classes = std::make_shared<const std::vector<std::uint8_t>>(std::move(classes));
    made.request.keep_classes = *made.keep_classes;
    return made;
}

inline FieldRequest uniform(std::string name, double radius, Boundary boundary, double width = 1,
                            double height = 1) {
    FieldRequest made;
    made.name = std::move(name);
    made.request.radius = radius;
    made.request.domain.width = width;
    made.request.domain.height = height;
    made.request.domain.boundary = boundary;
    return made;
}

// Every other square, as on a chess board; and one square of noise.
inline Mask chess_mask(std::uint32_t columns, std::uint32_t rows) {
    Mask mask{columns, rows, {}};
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j)
            mask.allowed.push_back((i + j) % 2 == 0 ? 1 : 0);
    return mask;
}

inline Mask noise_mask(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Mask mask{columns, rows, {}};
    for (std::size_t i = 0; i < std::size_t{columns} * rows; ++i)
        mask.allowed.push_back(random() % 3 == 0 ? 0 : 255);
    mask.allowed.front() = 1;
    return mask;
}

// Islands smaller than a radius.
inline Mask islands_mask(std::uint32_t side) {
    Mask mask{side, side, std::vector<std::uint8_t>(std::size_t{side} * side, 0)};
    for (std::size_t i = 0; i < mask.allowed.size(); i += 37) mask.allowed[i] = 1;
    return mask;
}

// Requests by hand, each for one special case.
inline std::vector<FieldRequest> special_radius_field_requests() {
    const Boundary box = Boundary::box;
    const Boundary torus = Boundary::torus;
    FieldRequest rounds_of_one =
        radius_field_request("rounds of one draw", ramp_field(9, 4), 60, torus);
    rounds_of_one.request.paper2011.round_size = 1;
    FieldRequest rounds_of_all =
        radius_field_request("rounds larger than the set", noise_field(9, 4, 3), 60, box);
    rounds_of_all.request.paper2011.round_size = 5000;
    FieldRequest cut_short = radius_field_request("a limit", ramp_field(30, 40), 900, torus);
    cut_short.request.limit = 77;
    FieldRequest coarse =
        radius_field_request("long first boxes", noise_field(30, 40, 8), 500, torus);
    coarse.request.paper2011.lines_per_radius = 4;
    FieldRequest threads =
        radius_field_request("regions that threads share", ramp_field(64, 48), 30000, torus, 4, 3);
    threads.request.run_on.threads = 3;
    FieldRequest threads_on_box = radius_field_request("regions of a box that threads share",
                                                       white_holes_field(64, 48), 30000, box, 4, 3);
    threads_on_box.request.run_on.threads = 2;
    return {
        rounds_of_one,
        rounds_of_all,
        cut_short,
        coarse,
        threads,
        threads_on_box,
        radius_field_request("one pixel", constant_field(1, 1, 3), 100, torus),
        radius_field_request("one pixel of a box", constant_field(1, 1, 3), 100, box, 1, 0.3),
        radius_field_request("one sample", constant_field(4, 4), 0.01, box),
        radius_field_request("one sample on a torus", constant_field(4, 4), 0.01, torus),
        radius_field_request("disks that wrap at both ends", ramp_field(7, 5), 2, torus),
        radius_field_request("radii of all sizes", sizes_field(20, 15, 6), 600, torus),
        radius_field_request("radii of all sizes, box", sizes_field(31, 17, 7), 600, box),
        radius_field_request("one dark pixel", one_dark_pixel_field(5, 5), 60, torus),
        radius_field_request("holes", white_holes_field(40, 30), 300, box),
        radius_field_request("an image one pixel wide", noise_field(1, 64, 1), 90, torus),
        radius_field_request("an image one pixel high", noise_field(64, 1, 2), 90, box),
        radius_field_request("far more pixels than samples", noise_field(300, 200, 3), 20, torus),
        radius_field_request("a wide torus", ramp_field(50, 2), 300, torus, 100, 1),
        radius_field_request("a high torus", ramp_field(2, 50), 300, torus, 1, 100),
        radius_field_request("a high box", noise_field(3, 90, 4), 300, box, 1, 60),
        radius_field_request("as wide as may be", noise_field(90, 1, 5), 200, torus, 1000, 1),
        with_mask(uniform("a mask", 0.05, box), noise_mask(13, 9, 1)),
        with_mask(uniform("a mask on a torus", 0.04, torus, 2, 1), chess_mask(8, 5)),
        with_mask(uniform("islands smaller than a radius", 0.2, box), islands_mask(60)),
        with_mask(radius_field_request("a mask over a field", ramp_field(11, 7), 400, torus),
                  chess_mask(9, 9)),
        with_border(uniform("a border", 0.05, box, 1, 2), 0.11),
        with_border(
            radius_field_request("a border around a field", sizes_field(20, 10, 2), 300, box),
            0.31),
        with_keep(uniform("kept at corners", 0.07, box),
                  {{0, 0}, {0.999999999, 0}, {0, 1}, {1, 1}, {0.5, 0.5}}),
        with_keep(
            radius_field_request("kept on the upper edges of a field", ramp_field(8, 8), 200, box),
            {{1, 0.5}, {0.25, 1}}),
        with_keep(uniform("kept across the edge of a torus", 0.3, torus), {{0.999, 0.001}}),
        with_keep(with_mask(uniform("a mask and kept points", 0.06, box), chess_mask(4, 4)),
                  {{0.1, 0.9}, {0.6, 0.9}}),
        // Within 2^-28 of the border of a pixel where samples may lie.
        with_keep(with_mask(uniform("kept beside a mask", 0.06, box), chess_mask(4, 4)),
                  {{0.25 + 0x1p-29, 0.9}, {0.6, 0.75 - 0x1.8p-29}}),
        with_keep(
            radius_field_request("kept beside importance", {4, 1, {1, 0, 0.3, 0}}, 150, torus),
            {{0.25 + 0x1p-29, 0.2}, {0.75 + 0x1.8p-29, 0.6}}),
        with_keep(radius_field_request("kept in a field", ramp_field(8, 8), 200, torus),
                  {{0.1, 0.1}, {0.9, 0.9}, {0.5, 0.25}}),
        with_keep(uniform("kept outside", 0.08, box),
                  {{0.5, 0.5}, {-0.05, 0.3}, {1.0625, 0.9}, {0.4, 1}, {0.7, -0.01}, {9, 9}}),
        with_border(with_mask(with_keep(uniform("kept outside of a mask and a border", 0.06, box),
                                        {{-0.03, 0.3}, {0.3, 1.05}, {0.6, 0.6}}),
                              chess_mask(5, 5)),
                    0.02),
        with_keep(uniform("kept outside, all but a corner covered", 1, box, 1, 0.7),
                  {{-0.25, -0.2}}),
    };
}

// Requests with ellipses, for the same tests.
inline std::vector<FieldRequest> ellipse_requests() {
    const Boundary box = Boundary::box;
    const Boundary torus = Boundary::torus;
    FieldRequest threads = radius_field_request("ellipses that threads share",
                                                swirled(ramp_field(40, 30), 6), 9000, box, 4, 3);
    threads.request.run_on.threads = 3;
    FieldRequest coarse = radius_field_request(
        "ellipses in long first boxes", stretched_at_random(ramp_field(3, 2), 8, 5), 300, box);
    coarse.request.paper2011.lines_per_radius = 4;
    FieldRequest small_rounds = radius_field_request(
        "ellipses in rounds of ten", stretched_at_random(noise_field(5, 4, 3), 12, 4), 60, box);
    small_rounds.request.paper2011.round_size = 10;
    // Some boxes get as narrow as can be while the mask forbids a part of them.
    FieldRequest narrow = with_mask(
        radius_field_request("ellipses on a mask of a long domain",
                             stretched_at_random(ramp_field(5, 1), 30, 3), 80, box, 45, 1),
        noise_mask(515, 12, 2));
    narrow.request.paper2011.lines_per_radius = 1;
    narrow.request.paper2011.round_size = 1;
    return {
        threads,
        coarse,
        small_rounds,
        narrow,
        radius_field_request("one ellipse", swirled(constant_field(1, 1), 5), 300, torus),
        radius_field_request("circles that count as ellipses", swirled(constant_field(3, 3), 1),
                             200, torus),
        radius_field_request("a swirl", swirled(constant_field(16, 16), 9), 500, box),
        radius_field_request("a swirl on a torus", swirled(constant_field(12, 8), 4), 600, torus,
                             1.5, 1),
        radius_field_request("ellipses at random",
                             stretched_at_random(noise_field(20, 15, 6), 32, 1), 400, box),
        radius_field_request("ellipses at random in few pixels",
                             stretched_at_random(constant_field(3, 3), 16, 2), 500, torus),
        radius_field_request("ellipses beside holes of many pixels",
                             stretched_at_random(white_holes_field(40, 30), 6, 4), 300, box),
        radius_field_request("ellipses longer than the domain",
                             stretched_at_random(constant_field(2, 2), 900, 3), 3, box),
        with_mask(
            radius_field_request("ellipses on a mask", swirled(ramp_field(7, 9), 5), 300, torus),
            noise_mask(13, 9, 8)),
        with_mask(radius_field_request("ellipses on a fine mask", swirled(constant_field(2, 2), 8),
                                       60, box),
                  chess_mask(30, 30)),
        with_border(radius_field_request("ellipses inside a border",
                                         stretched_at_random(ramp_field(6, 6), 5, 9), 200, box),
                    0.1),
        with_keep(radius_field_request("ellipses and kept points",
                                       stretched_at_random({4, 1, {1, 0, 0.3, 0}}, 4, 7), 150, box),
                  {{0.25 + 0x1p-29, 0.2}, {0.75 + 0x1.8p-29, 0.6}, {0.1, 0.9}}),
    };
}

// Requests with classes, for the same tests.
inline std::vector<FieldRequest> class_requests() {
    const Boundary box = Boundary::box;
    const Boundary torus = Boundary::torus;
    const std::vector<double> three{0.2, 0.08, 0.03}, two{0.15, 0.05};
    FieldRequest of_sixteen = uniform("sixteen classes", 1, torus, 1.3, 1);
    std::vector<double> sixteen;
    for (int i = 0; i < 16; ++i) sixteen.push_back(0.05 + 0.012 * i);
    FieldRequest cut_short =
        with_classes(uniform("a limit on classes", 1, torus), distances_by_union(three), {1, 1, 1});
    cut_short.request.limit = 50;
    FieldRequest threads = with_classes(uniform("zones that threads share", 1, torus, 2, 1),
                                        distances_by_union(std::vector{0.03, 0.012}), {1, 1});
    threads.request.run_on.threads = 3;
    return {
        cut_short,
        threads,
        with_classes(uniform("two classes by sum", 1, box), distances_by_sum(two), {1, 1}),
        with_classes(uniform("three classes by union", 1, torus, 1, 2), distances_by_union(three),
                     {1, 2, 0.1}),
        with_classes(of_sixteen, distances_by_union(sixteen), std::vector<double>(16, 1)),
        with_classes(uniform("classes that ignore each other", 1, torus), {0.1, 0, 0, 0.1}, {1, 3}),
        with_classes(uniform("a class that another leaves no room", 1, box), {0.05, 5, 5, 0.1},
                     {1, 1e-3}),
        with_classes(uniform("one large beside many small ones", 1, box), {0.9, 0.02, 0.02, 0.03},
                     {1, 1}),
        with_classes(uniform("a class far sparser than another", 1, box),
                     distances_by_sum(std::vector{0.25, 0.007}), {1, 1}),
        with_keep_in_classes(
            with_classes(radius_field_request("far sparser, on a field, with kept points",
                                              ramp_field(7, 9), 1, torus),
                         distances_by_sum(std::vector{0.3, 0.08, 0.012}), {1, 3, 1}),
            {{0.5, 0.5}, {0.52, 0.9}, {0.9, 0.95}}, {1, 2, 2}),
        with_keep_in_classes(with_classes(uniform("kept in a class that is not drawn", 1, torus),
                                          {0.1, 0.2, 0.2, 0.07}, {0, 1}),
                             {{0.5, 0.5}, {0.1, 0.99}, {0.7, 0.9}}, {0, 0, 1}),
        with_keep_in_classes(with_classes(uniform("kept outside in classes", 1, box),
                                          distances_by_sum(three), {1, 1, 1}),
                             {{-0.1, 0.5}, {0.5, 1.02}, {1.3, 0.4}, {0.5, 0.5}}, {0, 2, 0, 1}),
        with_mask(with_classes(uniform("classes on a mask", 1, box), distances_by_union(three),
                               {1, 1, 1}),
                  chess_mask(5, 7)),
        with_border(
            with_classes(radius_field_request("classes on a field", noise_field(9, 7, 4), 1, box),
                         distances_by_union(two), {1, 1}),
            0.1),
        with_mask(with_classes(radius_field_request("classes on a field and a mask",
                                                    sizes_field(12, 9, 3), 1, torus, 2, 1),
                               distances_by_sum(three), {1, 1, 1}),
                  noise_mask(9, 11, 2)),
        with_places(with_classes(uniform("borders of their own", 1, box, 2, 1),
                                 distances_by_sum(three), {1, 1, 1}),
                    {0.2, 0.08, 0}, noise_mask(90, 40, 3)),
        with_places(
            with_mask(with_classes(radius_field_request("places of their own on a field and a mask",
                                                        noise_field(9, 7, 4), 1, box),
                                   distances_by_union(three), {1, 1, 3}),
                      noise_mask(40, 11, 2)),
            {0.3, 0, 0.01}, chess_mask(13, 21)),
        with_keep_in_classes(
            with_places(with_classes(uniform("places of their own and kept points", 1, torus),
                                     distances_by_sum(two), {0, 1}),
                        {0, 0}, islands_mask(60)),
            {{0.5, 0.5}, {0.1, 0.99}}, {0, 0}),
    };
}

// Requests whose masks allow nothing, and one where they allow nothing to a class.
inline std::vector<FieldRequest> requests_without_places() {
    const Mask none{3, 2, std::vector<std::uint8_t>(6, 0)};
    const std::vector<double> two{0.15, 0.05};
    const auto of_classes = [&](const char* name) {
        return with_classes(uniform(name, 1, Boundary::torus), distances_by_sum(two), {1, 1});
    };
    return {
        with_mask(uniform("nowhere", 0.05, Boundary::box), none),
        with_mask(radius_field_request("on a field", ramp_field(8, 8), 200, Boundary::torus), none),
        with_mask(
            radius_field_request("ellipses", swirled(ramp_field(7, 9), 5), 300, Boundary::box),
            none),
        with_keep(with_mask(uniform("beside kept points", 0.1, Boundary::box), none),
                  {{-0.03, 0.3}, {0.3, 1.05}}),
        with_mask(of_classes("classes"), none),
        with_places(of_classes("a class that lies nowhere"), {0, 0}, none),
    };
}

// The requests are the same in every run.
inline std::vector<FieldRequest> radius_field_requests() {
    std::vector<FieldRequest> all = special_radius_field_requests();
    std::mt19937_64 random(20111);
    const auto below = [&](std::uint32_t end) {
        return static_cast<std::uint32_t>(random() % end);
    };
    const auto share = [&] { return static_cast<double>(random() % 1000) / 1000; };
    for (int i = 0; i < 40; ++i) {
        const std::uint32_t columns = 1 + below(24);
        const std::uint32_t rows = 1 + below(24);
        const Boundary boundary = random() % 2 == 0 ? Boundary::torus : Boundary::box;
        Field field = i % 3 == 0   ? noise_field(columns, rows, random())
                      : i % 3 == 1 ? sizes_field(columns, rows, random())
                                   : ramp_field(columns, rows);
        field.importance.front() = std::max(field.importance.front(), 0.1);
        FieldRequest made = radius_field_request("random " + std::to_string(i), std::move(field),
                                                 std::exp(1 + 5 * share()), boundary,
                                                 0.3 + 2 * share(), 0.3 + 2 * share());
        made.request.seed = random();
        made.request.run_on.threads = 1 + below(2);
        if (random() % 3 == 0)
            made = with_mask(made, noise_mask(1 + below(30), 1 + below(30), random()));
        if (boundary == Boundary::box && random() % 3 == 0)
            made.request.places.border = 0.1 * share();
        all.push_back(made);
    }
    return all;
}

}  // namespace lacuna::tests
