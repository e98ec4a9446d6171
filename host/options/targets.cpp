// The targets of a request, of moves and of tones; reading texts into them, and values from them.
#include "options/targets.h"

#include "base/number_text.h"
#include "options/read.h"
#include "options/words.h"

namespace lacuna::options {
namespace {

// Reads the text of an option into its target.
struct Reader {
    const std::string& option;
    const std::string& text;

    template <class Number>
    void operator()(Number* number) const {
        read(option, text, *number);
    }
    void operator()(bool* flag) const { *flag = true; }
    void operator()(std::optional<bool>* flag) const { *flag = true; }
    void operator()(Boundary* boundary) const { *boundary = Boundary::torus; }
    void operator()(std::string* value) const { *value = text; }
    void operator()(std::vector<std::string>* values) const { values->push_back(text); }
    void operator()(std::optional<Mode>* mode) const { *mode = named<Mode>(text); }
    void operator()(std::optional<Metric>* metric) const { *metric = named<Metric>(text); }
    void operator()(const Take& take) const { take.read(text, take.to); }
};

// The value of a member.
struct Writer {
    template <class Member>
    Value operator()(Member* member) const {
        return value(*member);
    }
    Value operator()(std::vector<std::string>*) const { return nullptr; }
    Value operator()(const Take&) const { return nullptr; }

    static Value value(bool flag) { return flag; }
    static Value value(double number) { return number; }
    static Value value(std::uint64_t number) { return number; }
    static Value value(std::uint32_t number) { return std::uint64_t{number}; }
    static Value value(Boundary boundary) { return boundary == Boundary::torus; }
    static Value value(Mode mode) { return std::string(name_of(mode)); }
    static Value value(Metric metric) { return std::string(name_of(metric)); }
    static Value value(const std::string& text) { return text; }
    template <class Member>
    static Value value(const std::optional<Member>& member) {
        return member ? value(*member) : nullptr;
    }
};

// As on a command line; a flag has no text.
std::string text_of(const Value& value) {
    if (const auto* const number = std::get_if<double>(&value)) return shortest(*number);
    if (const auto* const number = std::get_if<std::uint64_t>(&value))
        return std::to_string(*number);
    const auto* const text = std::get_if<std::string>(&value);
    return text == nullptr ? "" : *text;
}

void read_sides(const std::string& text, Request& request) {
    read_domain("domain", text, request.domain);
}

void read_pixels(const std::string& text, Request& request) {
    read_raster("on-pixels", text, request.on_pixels.emplace());
}

}  // namespace

Targets targets_of(Request& request) {
    return {{"radius", &request.radius},
            {"count", &request.count},
            {"scale", &request.scale},
            {"domain", take_by<read_sides>(request)},
            {"on-pixels", take_by<read_pixels>(request)},
            {"torus", &request.domain.boundary},
            {"border", &request.places.border},
            {"limit", &request.limit},
            {"seed", &request.seed},
            {"progressive", &request.progressive},
            {"lines-per-radius", &request.paper2011.lines_per_radius},
            {"uniform-x", &request.paper2011.uniform_x},
            {"snap", &request.paper2011.snap},
            {"round-size", &request.paper2011.round_size},
            {"threads", &request.run_on.threads},
            {"backend", &request.run_on.backend},
            {"device", &request.run_on.device}};
}

Targets targets_of(Moves& moves) {
    return {{"relax", &moves.iterations},
            {"gaussian", &moves.gaussian},
            {"gaussian-distance", &moves.gaussian_distance}};
}

Targets targets_of(Tone& tone) {
    return {{"invert", &tone.invert},
            {"black", &tone.black},
            {"white", &tone.white},
            {"background", take_by<read_background>(tone)},
            {"auto-levels", &tone.auto_levels},
            {"sharpen", take_by<read_sharpen>(tone)},
            {"along", &tone.along},
            {"light", &tone.light},
            {"gamma", &tone.gamma},
            {"min-importance", &tone.min_importance},
            {"turn", &tone.turn},
            {"crop", take_by<read_crop>(tone)}};
}

void check_word(const Option& option, const std::string& text) {
    if (option.kind == Kind::word && !is_among(text, option.traits.words))
        throw BadRequest(std::string(option.name), shown(text),
                         "must be " + listed(option.traits.words));
}

void read(const Option& option, const std::string& text, const Target& target) {
    check_word(option, text);
    const std::string name(option.name);
    std::visit(Reader{name, text}, target);
}

void read(const CommandLine& line, const Targets& targets) {
    for (const auto& [name, values] : line.given) {
        const Option& option = *find_option(line.command, name);
        const auto target = targets.find(name);
        if (target == targets.end()) continue;
        if (option.kind == Kind::flag) read(option, "", target->second);
        for (const std::string& value : values) read(option, value, target->second);
    }
    refuse_pairs(line.command, line.given);
}

Value value_of(const Target& target) {
    return std::visit(Writer{}, target);
}

std::vector<GivenOption> given_in(Commands command, const Targets& targets, const Targets& usual) {
    std::vector<GivenOption> given;
    for (const Option* option : options_of(command)) {
        const auto found = targets.find(option->name);
        if (found == targets.end()) continue;
        const Value value = value_of(found->second);
        if (value == value_of(usual.at(option->name)) || value == Value(false)) continue;
        given.push_back({option->name, {}});
        if (option->kind != Kind::flag) given.back().values.push_back(text_of(value));
    }
    return given;
}

}  // namespace lacuna::options
