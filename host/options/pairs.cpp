// The table of pairs: which options need others, which exclude each other, and why.
#include <lacuna/lacuna.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "options/options.h"

namespace lacuna::options {
namespace {

enum class Needs : bool { one_of, none_of };

// Each of `options` needs one of `others`, or none of them. Names have blanks between them;
// NAME=WORD is an option that is given as this word. Messages read "--OPTION VALUE with --OTHER:
// WHY".
struct Pairs {
    Commands commands;
    std::string_view options;
    Needs needs;
    std::string_view others;
    std::string_view why;
};

constexpr std::string_view kReading =
    "turn crop invert black white background auto-levels sharpen along light gamma min-importance";

constexpr std::string_view kOutlines = "inside outside avoid near";  // the names of kRoles
constexpr std::string_view kWhereNoneMayLie =
    "it would move points to where none may lie, and points that are kept";

constexpr Pairs kPairs[] = {
    // Pictures and ellipses
    {kSample | kVerify, kReading, Needs::one_of, "field",
     "says how a field is read: give its picture too"},
    {kCompare, kReading, Needs::one_of, "IMAGE", "is for pictures only"},
    {kCompare, "metric mode=cells", Needs::one_of, "IMAGE", "is for pictures only"},
    {kCompare, "domain mode=lines", Needs::none_of, "IMAGE", "is for requests without a picture"},
    {kSample | kVerify, "scale", Needs::one_of, "field ellipses stretch",
     "multiplies the radii of a field: give its picture too"},
    {kVerify, "radius", Needs::none_of, "field", "is for sets of one radius: give --scale"},
    {kSample | kVerify, "field", Needs::none_of, "ellipses stretch", "these give all radii"},
    {kSample | kVerify, "stretch", Needs::none_of, "ellipses", "one of them gives all ellipses"},
    {kSample, "ellipse-columns", Needs::one_of, "ellipses stretch along",
     "is for sets of ellipses"},
    {kStipple, "ellipse-columns", Needs::one_of, "along", "is for sets of ellipses"},
    {kStipple, "along", Needs::none_of, "mode=cells mode=stratified", "is for --mode exact"},

    // Classes and places
    {kSample | kVerify, "between", Needs::one_of, "class", "is for classes of points"},
    {kSample, "priority", Needs::one_of, "class", "is the order of classes"},
    {kSample, "priority", Needs::none_of, "count limit progressive",
     "classes are full one after the other"},
    {kSample, "radius scale", Needs::none_of, "class", "each class has a radius of its own"},
    {kSample | kVerify, "edge", Needs::one_of, kOutlines,
     "is for the outlines in these files: give one too"},
    {kSample | kVerify, "inside-by-radius", Needs::none_of, "border", "both say how far to stay"},
    {kSample, "inside-by-radius", Needs::none_of, "on-pixels", "its samples keep no distance"},
    {kSample | kVerify, "inside-by-radius", Needs::none_of, "count",
     "the radius must be known before: give it"},
    {kSample | kVerify, "inside-by-radius", Needs::none_of, "field ellipses stretch",
     "is for disks of one size, or of one for each class"},
    {kSample | kVerify, "inside-by-radius", Needs::none_of, "mask", "its pixels have no outline"},
    {kSample | kVerify, "inside-by-radius", Needs::none_of, "torus", "a torus has no edges"},

    // Pixels
    {kSample, "on-pixels", Needs::none_of,
     "radius scale mode limit progressive lines-per-radius round-size snap uniform-x",
     "its samples keep no distance: give --count alone"},
    {kSample, "on-pixels", Needs::none_of, "relax gaussian", "they move points off their pixels"},
    {kSample, "on-pixels", Needs::none_of, "border keep class ellipses stretch along",
     "these are for points that keep a distance"},
    {kSample, "on-pixels", Needs::none_of, "dot-size paper-size dpi",
     "a sample is a pixel: dots are for points in the plane"},
    {kSample, "on-pixels", Needs::none_of, "backend device threads",
     "one thread of the cpu places its samples"},

    // Moving points
    {kSample, "relax gaussian", Needs::none_of, "progressive", "it moves the points"},
    {kSample, "relax gaussian", Needs::none_of, "seeds", "relax each file with lacuna relax"},
    {kSample, "relax gaussian", Needs::none_of, kOutlines, kWhereNoneMayLie},
    {kSample, "relax gaussian", Needs::none_of, "mask border inside-by-radius keep",
     kWhereNoneMayLie},
    {kSample, "relax gaussian", Needs::none_of, "class", "it keeps no distances"},
    {kSample, "relax gaussian", Needs::none_of, "ellipses stretch along", "relaxing has disks"},
    {kStipple | kCompare, "along", Needs::none_of, "relax", "relaxing has disks"},
    {kSample | kRelax, "gaussian-distance", Needs::one_of, "gaussian",
     "is a distance of its steps"},
    {kSample, "chunk", Needs::one_of, "chunk-size", "is a square: how long is its side?"},
    {kSample, "chunk-size", Needs::one_of, "chunk", "is that of a chunk: which one?"},
    {kSample, "chunk", Needs::none_of, "torus seeds count limit progressive keep",
     "chunks are maximal sets of one radius that keep the points of those beside them"},
    {kSample, "chunk", Needs::none_of, "field ellipses stretch mode=lines mode=stratified",
     "is for --mode exact, and radii that are alike everywhere"},
    {kSample, "chunk", Needs::none_of, "border inside-by-radius",
     "it would leave gaps where chunks meet: give --avoid FILE:D"},
    {kSample, "chunk", Needs::none_of, "on-pixels relax gaussian", "its points keep a distance"},
    {kSample, "columns", Needs::none_of, "ellipse-columns", "both may have a column angle"},
    {kSample, "seeds", Needs::none_of, "seed", "must be one of both"},
    {kSample, "frame", Needs::one_of, "seeds", "is what the sets of several seeds share"},
    {kSample, "frame", Needs::one_of, "torus", "is for tiles, whose edges wrap"},
    {kSample, "frame", Needs::none_of, "count limit progressive keep mode=lines mode=stratified",
     "tiles are maximal sets of one radius that begin with the points of the frame"},

    // Inks and sizes of dots
    {kStipple, "black-ink ink-counts", Needs::one_of, "inks", "is for a picture in inks"},
    {kStipple, "along", Needs::none_of, "inks", "dots of inks are relaxed"},
    {kStipple, "metric scale limit lines-per-radius round-size mode=cells mode=exact",
     Needs::none_of, "inks", "dots of inks begin stratified"},
    {kStipple, "ink-counts", Needs::none_of, "count", "both give the number of dots"},
    {kStipple, "pens", Needs::none_of, "dot-size size-by-tone", "both say how large dots are"},
    {kStipple, "pens", Needs::none_of, "along", "strokes are of one pen: give --dot-size"},
    {kStipple, "pen", Needs::none_of, "pens along path-line", "is for dots of many sizes"},
    {kStipple, "dot-style", Needs::one_of, "pen", "says how a pen draws dots wider than it"},
    {kStipple, "seconds-per-dot seconds-per-metre-down seconds-per-metre-up seconds-per-corner",
     Needs::one_of, "dot-size pens pen inks pen-path path-line plot-time", "is the time of a pen"},
    {kStipple, "no-pen-path", Needs::none_of, "pen-path path-line plot-time",
     "dots then come in the order of a path"},
    {kStipple, "path-line", Needs::none_of, "along pens size-by-tone keep-inside scale",
     "a line has no dots of its own"},
    {kStipple, "plot-time", Needs::none_of, "count scale limit ink-counts",
     "both give the number of dots"},
    {kStipple, "frames", Needs::none_of, "IMAGE", "one of them names the pictures"},
    {kStipple, "frames", Needs::none_of,
     "inks along mode=cells mode=exact scale metric limit lines-per-radius round-size",
     "the dots of the picture before are moved on"},
    {kStipple, "start-points", Needs::none_of,
     "inks along mode scale metric limit lines-per-radius round-size plot-time",
     "these dots are moved on"},
    {kStipple, "frames", Needs::none_of, "report", "is about one set: give an --output of .json"},
    {kSample | kStipple | kRelax | kOrder, "margin", Needs::one_of, "paper-size",
     "is a margin of the paper"},

    // Looking at sets
    {kVerify, "tolerance", Needs::none_of, "distances-only",
     "is for gaps, which are not looked for then"},
    {kAnalyze, "json", Needs::none_of, "format", "is another format of standard output"},
};

// Calls `visit` with each name of a list until it returns true, which is then returned.
template <class Visit>
bool any_of_names(std::string_view names, const Visit& visit) {
    while (!names.empty()) {
        const std::string_view name = names.substr(0, names.find(' '));
        names.remove_prefix(std::min(names.size(), name.size() + 1));
        if (visit(name)) return true;
    }
    return false;
}

// The numbers that switch an option off, or leave it to Lacuna, as auto does the backend.
struct Off {
    std::string_view option;
    double number;
};
constexpr Off kOff[] = {{"along", 1}, {"border", 0},     {"gaussian", 0}, {"margin", 0},
                        {"relax", 0}, {"round-size", 0}, {"threads", 0}};

bool is_off(const GivenOption& one) {
    if (one.name == "backend") return !one.values.empty() && one.values.front() == "auto";
    const auto* const off = std::find_if(std::begin(kOff), std::end(kOff), [&](const Off& known) {
        return known.option == one.name;
    });
    if (off == std::end(kOff) || one.values.empty()) return false;
    const std::string& text = one.values.front();
    double number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && number == off->number;
}

// Null if it was not given, or not as the word that NAME=WORD says.
const GivenOption* find(std::span<const GivenOption> given, std::string_view name) {
    const std::size_t equals = std::min(name.find('='), name.size());
    const std::string_view word = name.substr(std::min(equals + 1, name.size()));
    for (const GivenOption& one : given)
        if (one.name == name.substr(0, equals) &&
            (word.empty() || (!one.values.empty() && one.values.front() == word)))
            return &one;
    return nullptr;
}

// The name as it is written on a command line.
std::string written(std::string_view name) {
    const bool is_argument = name.front() >= 'A' && name.front() <= 'Z';
    return (is_argument ? "" : "--") + std::string(name);
}

std::string written_all(std::string_view names) {
    std::vector<std::string> all;
    any_of_names(names, [&](std::string_view name) {
        all.push_back(written(name));
        return false;
    });
    return listed(std::vector<std::string_view>(all.begin(), all.end()));
}

[[noreturn]] void refuse(const GivenOption& one, const std::string& with, std::string_view why) {
    std::string value;
    if (!one.values.empty()) value = one.values.front() + " ";
    throw BadRequest(std::string(one.name), value + with, std::string(why));
}

void refuse(std::span<const GivenOption> given, const Pairs& pairs, const GivenOption& one) {
    if (is_off(one)) return;
    const bool needs_one = pairs.needs == Needs::one_of;
    const bool has_one = any_of_names(pairs.others, [&](std::string_view other) {
        const GivenOption* const found = find(given, other);
        if (found == nullptr || is_off(*found)) return false;
        if (!needs_one) refuse(one, "with " + written(other), pairs.why);
        return true;
    });
    if (needs_one && !has_one) refuse(one, "without " + written_all(pairs.others), pairs.why);
}

}  // namespace

void refuse_pairs(Commands command, std::span<const GivenOption> given) {
    for (const Pairs& pairs : kPairs) {
        if ((pairs.commands & command) == 0) continue;
        any_of_names(pairs.options, [&](std::string_view name) {
            if (const GivenOption* const one = find(given, name)) refuse(given, pairs, *one);
            return false;
        });
    }
}

}  // namespace lacuna::options
