// Describes requests by the table of options.
#include "options/describe.h"

#include <algorithm>

#include "checks/domain.h"

namespace lacuna::options {
namespace {

// Adds options to a description by their names, each once.
class Describer {
public:
    explicit Describer(const Request& request) : request_(request) {}

    void tell(const char* key, Value value) { told_.emplace_back(key, std::move(value)); }
    void add(std::string_view option, bool is_told = true) {
        const auto found = values_.find(option);
        if (is_told)
            told_.emplace_back(find_option(kSample, option)->key(), value_of(found->second));
        values_.erase(found);
    }
    // Adds the other options that were given.
    void add_the_rest() {
        Request usual;
        const Targets values = targets_of(usual);
        for (const Option* option : options_of(kSample))
            if (option->traits.decides_points && values_.contains(option->name) &&
                value_of(values_.at(option->name)) != value_of(values.at(option->name)))
                add(option->name);
    }
    Description told() { return std::move(told_); }

private:
    Request request_;
    Targets values_ = targets_of(request_);
    Description told_;
};

}  // namespace

Description describe(const Request& request, const Result& result) {
    const bool has_pixels = request.on_pixels.has_value();
    const bool has_no_rounds = request.mode == Mode::stratified || has_pixels;
    const bool is_cells = request.mode == Mode::cells;
    const bool has_field = request.field != nullptr || result.scale > 0;  // stipple keeps no field
    Describer all(request);
    all.tell("width", request.domain.width);
    all.tell("height", request.domain.height);
    if (request.domain.has_corner()) {
        all.tell("x0", request.domain.x0);
        all.tell("y0", request.domain.y0);
    }
    all.tell("boundary", std::string(request.domain.wraps() ? "torus" : "box"));
    all.tell("mode", std::string(name_of(request.mode)));
    if (has_pixels) all.tell("on_pixels", text_of(*request.on_pixels));
    if (has_field && !has_no_rounds) all.tell("metric", std::string(name_of(request.metric)));
    all.add("scale", has_field && !has_no_rounds);
    all.add("radius", !has_field && !has_no_rounds);
    all.add("count");
    if (!has_no_rounds) all.tell("lines_per_radius", std::uint64_t{result.lines_per_radius});
    all.add("progressive", request.progressive);
    all.add("snap", !is_cells && !has_no_rounds);
    all.add("uniform-x", !is_cells && !has_no_rounds);
    all.add("limit", !has_no_rounds);
    all.add("round-size", !has_no_rounds);
    all.add("seed");
    for (const char* const elsewhere : {"torus", "border", "lines-per-radius"})
        all.add(elsewhere, false);
    all.add_the_rest();
    return all.told();
}

Description describe_place(const Request& request) {
    Describer all(request);
    for (const char* const name : {"backend", "device", "threads"}) all.add(name);
    return all.told();
}

}  // namespace lacuna::options
