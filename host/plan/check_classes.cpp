// Checks what a request says about classes.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "base/number_text.h"
#include "checks/classes.h"
#include "plan/checked_request.h"
#include "plan/kept.h"
#include "plan/radius_field.h"
#include "portable/class_copies.h"

namespace lacuna {
namespace {

constexpr double kMostRatio = 4000;  // of two distances

// The classes' names go into files, and some of these have no quotes.
bool is_name(const std::string& name) {
    return !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
        return c <= ' ' || c == ',' || c == ':' || c == ';' || c == '"' || c == '\'' || c == '<' ||
               c == '>' || c == '&' || c == '/' || c == '\\' || c == 127;
    });
}

void check_names(const Classes& classes) {
    const std::size_t count = classes.names.size();
    if (count > MOST_CLASSES)
        throw BadRequest("class", std::to_string(count) + " classes",
                         "must be at most " + std::to_string(MOST_CLASSES) +
                             (has_sizes(classes) ? ", and each size of a class is one" : ""));
    for (const std::string& name : classes.names)
        if (!is_name(name))
            throw BadRequest(
                "class", "'" + name + "'",
                "must be a name without spaces and without , : ; / \\ < > & or quotes");
}

// Classes of one name are sizes: they follow each other, and their own distances differ.
void check_sizes(const Classes& classes) {
    for (std::size_t i = 0; i < classes.names.size(); ++i) {
        const std::string& name = classes.names[i];
        const double own = own_distance_of(classes, i);
        for (std::size_t before = 0; before < i; ++before) {
            if (classes.names[before] != name) continue;
            if (before < kind_of(classes, i).first)
                throw BadRequest("class", name,
                                 "is given twice: sizes of one kind must follow "
                                 "each other");
            if (own_distance_of(classes, before) == own)
                throw BadRequest("class", name,
                                 "is given twice with the radius " + shortest(own / 2));
        }
    }
}

void check_weights(const Classes& classes) {
    if (classes.weights.empty()) return;
    check_each(classes, "class", classes.weights.size(), " weights");
    for (std::size_t i = 0; i < classes.weights.size(); ++i)
        if (!std::isfinite(classes.weights[i]) || classes.weights[i] < 0)
            throw BadRequest("class", classes.names[i],
                             "its weight is " + shortest(classes.weights[i]) +
                                 ": must be a finite number of at least 0");
    if (std::all_of(classes.weights.begin(), classes.weights.end(),
                    [](double weight) { return weight == 0; }))
        throw BadRequest("class", "all", "have the weight 0: one must be greater");
}

void check_ratio(const Classes& classes) {
    const double least = least_distance_of(classes);
    const double greatest = *std::max_element(classes.distances.begin(), classes.distances.end());
    if (greatest > kMostRatio * least)
        throw BadRequest("between",
                         "distances from " + shortest(least) + " to " + shortest(greatest),
                         "the greatest must be at most " + shortest(kMostRatio) +
                             " times the least that is not 0");
}

void check_counts(const Request& request) {
    const Classes& classes = request.classes;
    const std::size_t count = classes.names.size();
    if (classes.counts.empty()) return;
    const auto refuse = [](const std::string& which, const std::string& why) {
        throw BadRequest("class", which, why);
    };
    check_each(classes, "class", classes.counts.size(), " numbers of points");
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<std::uint64_t>& own = classes.counts[i];
        if (!own) continue;
        const std::string which = classes.names[i] + " with " + std::to_string(*own) + " points";
        if (*own == 0) refuse(which, "must have at least 1; the weight 0 lets it have none");
        if (!classes.weights.empty() && classes.weights[i] == 0)
            refuse(which, "is not drawn, as its weight is 0");
        if (count == 1) refuse(which, "is the only class: give a limit instead");
        if (request.count || request.limit || request.progressive)
            refuse(which, "is for sets without --count, --limit and --progressive");
        const Members members(request);
        std::uint64_t kept = 0;
        for (std::size_t k = 0; k < request.keep.size(); ++k)
            if (request.keep_classes[k] == i && members.has(request.keep[k])) ++kept;
        if (kept > *own) refuse(which, "has " + std::to_string(kept) + " kept ones already");
    }
}

}  // namespace

void check_classes(const Request& request) {
    const Classes& classes = request.classes;
    check_priority(classes);
    if (classes.by_priority && (request.count || request.limit || request.progressive))
        throw BadRequest("priority", "with --count, --limit or --progressive",
                         "classes are full one after the other");
    const std::string mode = "with mode " + std::string(name_of(request.mode));
    if (classes.names.empty()) {
        const Places& places = request.places;  // outlines name their classes themselves
        if (!classes.distances.empty() || !classes.weights.empty() || !places.borders.empty() ||
            !places.masks.empty())
            throw BadRequest("between", "distances, weights, borders or masks",
                             "are for classes, which lack names");
        if (!request.keep_classes.empty())
            throw BadRequest("keep", "classes of points", "are for requests with classes");
        return;
    }
    if (request.mode != Mode::exact) throw BadRequest("class", mode, "is for mode exact");
    check_names(classes);
    check_weights(classes);
    check_distances(classes);
    check_sizes(classes);
    check_ratio(classes);
    // Without a size of its own the request has the classes' least distance as its radius.
    const double least = least_distance_of(classes);
    const double smallest = request.domain.longer_side() * kSmallestRadius;
    if (request.field == nullptr && !request.count && request.radius.value_or(least) == least &&
        least < smallest)
        throw BadRequest("class", classes.names.front(),
                         "the least distance of two classes is " + shortest(least) +
                             ": must be at least " + shortest(smallest) +
                             ", the longer side / 2^20, or the grid's units run out");
    check_classes_of_points(classes, "keep", request.keep.size(), request.keep_classes);
    check_counts(request);
}

}  // namespace lacuna
