// The same requests through lacuna.h, by the options of the command line: the points must be the
// same.
#pragma once

#include <lacuna.h>
#include <lacuna/lacuna.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "hostile/answers.h"
#include "hostile/counts.h"
#include "hostile/made.h"

namespace lacuna::tests {

// A command line, word by word.
class OptionsText {
public:
    OptionsText() { text_.precision(std::numeric_limits<double>::max_digits10); }
    template <typename... Parts>
    void add(const char* option, const Parts&... parts) {
        text_ << " --" << option << (sizeof...(parts) == 0 ? "" : " ");
        if constexpr (sizeof...(parts) != 0) (text_ << ... << parts);
    }
    std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
};

struct FromC {
    std::unique_ptr<lacuna_set, void (*)(lacuna_set*)> set;
    std::vector<Point> points{};

    // What lacuna_sample() and the others return.
    FromC(lacuna_set* made, const std::string& options) : set(made, lacuna_free) {
        demand(made != nullptr, "lacuna.h refuses \"" + options + "\": " + lacuna_error());
        const double* const xy = lacuna_points(made);
        for (std::size_t i = 0; i < lacuna_count(made); ++i)
            points.push_back({xy[2 * i], xy[2 * i + 1]});
    }
};

inline const double* numbers_of(std::span<const Point> points) {
    return points.empty() ? nullptr : &points.front().x;
}

// Whether options can express the request.
inline bool fits_lacuna_h(const Made& made) {
    const Request& request = made.request;
    // An option of a border is for all sizes of a kind.
    const bool has_borders_of_sizes = made.is(kClasses, "sizes") && !request.places.borders.empty();
    return !made.is(kRadii, "ellipses") && !made.is(kClasses, "given") && !has_borders_of_sizes &&
           !made.is(kMask, "of classes") && made.frame == 0 &&
           (made.is(kClasses, "none") || !made.is(kSize, "given")) &&
           request.mode != Mode::stratified && request.mode != Mode::cells;
}

// What lacuna_sample() and lacuna_verify() both need.
inline OptionsText common_options_of(const Made& made) {
    const Request& request = made.request;
    const Domain& domain = request.domain;
    OptionsText line;
    line.add("domain", domain.width, "x", domain.height);
    if (domain.wraps()) line.add("torus");
    if (request.radius) line.add("radius", *request.radius);
    if (request.scale) line.add("scale", *request.scale);
    const Classes& classes = request.classes;
    for (std::size_t i = 0; i < classes.names.size(); ++i)
        line.add("class", classes.names[i], ":", made.radii[i], ":",
                 classes.weights.empty() ? 1 : classes.weights[i]);
    if (made.is(kClasses, "union")) line.add("between", "union");
    if (classes.by_priority) line.add("priority");
    const Places& places = request.places;
    if (places.border > 0 && places.borders.empty()) line.add("border", places.border);
    for (std::size_t i = 0; i < places.borders.size(); ++i)
        line.add("border", classes.names[i], ":", places.borders[i]);
    return line;
}

inline std::string options_of(const Made& made) {
    const Request& request = made.request;
    OptionsText line = common_options_of(made);
    line.add("seed", request.seed);
    if (request.count) line.add("count", *request.count);
    if (request.on_pixels) {
        line.add("on-pixels", request.on_pixels->columns, "x", request.on_pixels->rows);
        return line.text();
    }
    line.add("mode", name_of(request.mode));
    line.add("backend", "cpu");
    line.add("threads", request.run_on.threads);
    if (request.progressive) line.add("progressive");
    if (request.limit) line.add("limit", *request.limit);
    const Paper2011& paper = request.paper2011;
    if (paper.lines_per_radius) line.add("lines-per-radius", *paper.lines_per_radius);
    if (paper.round_size != 0) line.add("round-size", paper.round_size);
    if (paper.snap) line.add("snap");
    if (paper.uniform_x) line.add("uniform-x");
    return line.text();
}

inline void judge_in_c(const Made& made, const Answer& answer, Counts& counts) {
    if (!fits_lacuna_h(made)) return;
    const Request& request = made.request;
    const Result& expected = answer.sets.front();
    lacuna_given given{};
    if (request.field != nullptr) {
        given.importance = request.field->importance.data();
        given.columns = request.field->columns;
        given.rows = request.field->rows;
    }
    if (request.places.mask != nullptr) {
        given.allowed = request.places.mask->allowed.data();
        given.mask_columns = request.places.mask->columns;
        given.mask_rows = request.places.mask->rows;
    }
    given.kept = numbers_of(request.keep);
    given.kept_count = request.keep.size();
    given.kept_classes = request.keep_classes.empty() ? nullptr : request.keep_classes.data();
    const std::string options = options_of(made);
    const FromC got(lacuna_sample(options.c_str(), &given), options);
    const lacuna_facts facts = lacuna_describe(got.set.get());
    const unsigned char* const kinds = lacuna_layers(got.set.get());
    const bool has_same_classes = kinds == nullptr
                                      ? expected.classes.empty()
                                      : std::equal(expected.classes.begin(), expected.classes.end(),
                                                   kinds, kinds + lacuna_count(got.set.get()));
    demand(got.points == expected.points && has_same_classes,
           "lacuna.h makes another set of" + options);
    demand(facts.radius == expected.radius && facts.maximal == (expected.maximal ? 1 : 0),
           "lacuna.h says something else of" + options);
    ++counts.comparisons;
    if (request.mode == Mode::exact && expected.maximal && !request.count) {
        const std::string claim = common_options_of(made).text();
        given.classes = expected.classes.empty() ? nullptr : expected.classes.data();
        // A tolerance of over 1 % of the radius proves nothing.
        const int verdict = lacuna_verify(claim.c_str(), &given, numbers_of(expected.points),
                                          expected.points.size());
        const std::string_view why = lacuna_error();
        demand(verdict == 1 || why.starts_with("not proven maximal"),
               "lacuna.h does not prove the set of" + claim + ": " + std::string(why));
        ++counts.proofs;
    }
    if (!made.is_moved()) return;
    OptionsText moves;
    moves.add("domain", request.domain.width, "x", request.domain.height);
    if (request.domain.wraps()) moves.add("torus");
    moves.add("iterations", made.moves.iterations);
    moves.add("backend", "cpu");
    if (made.moves.gaussian > 0) {
        moves.add("gaussian", made.moves.gaussian);
        moves.add("gaussian-distance", made.moves.gaussian_distance);
    }
    lacuna_given picture{};
    if (!made.sparse.importance.empty()) {
        picture.importance = made.sparse.importance.data();
        picture.columns = made.sparse.columns;
        picture.rows = made.sparse.rows;
    }
    const FromC moved(lacuna_relax(moves.text().c_str(), &picture, numbers_of(expected.points),
                                   std::min(expected.points.size(), kMostToMove)),
                      moves.text());
    demand(moved.points == answer.moved, "lacuna.h moves points elsewhere by" + moves.text());
    ++counts.comparisons;
}

}  // namespace lacuna::tests
