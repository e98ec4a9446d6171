// Reads the declarations of CSS, as far as they decide where a shape is and how wide its stroke is.
#include "domains/svg_style.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "files/parse.h"

namespace lacuna::domains {
namespace {

constexpr std::size_t kProperties = static_cast<std::size_t>(Property::count);

constexpr std::array<std::string_view, kProperties> kNames{"display",
                                                           "visibility",
                                                           "opacity",
                                                           "fill",
                                                           "fill-rule",
                                                           "transform",
                                                           "clip-path",
                                                           "mask",
                                                           "filter",
                                                           "transform-origin",
                                                           "stroke",
                                                           "stroke-width",
                                                           "stroke-opacity",
                                                           "vector-effect",
                                                           "mask-image",
                                                           "transform-box",
                                                           "translate",
                                                           "rotate",
                                                           "scale",
                                                           "offset-path",
                                                           "all",
                                                           "d",
                                                           "x",
                                                           "y",
                                                           "width",
                                                           "height",
                                                           "cx",
                                                           "cy",
                                                           "r",
                                                           "rx",
                                                           "ry"};

constexpr std::string_view kBlanks = " \t\n\r\f";

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string lower(std::string_view text) {
    std::string all(text);
    std::transform(all.begin(), all.end(), all.begin(), files::lower_case);
    return all;
}

std::string without_comments(std::string_view css) {
    std::string text;
    while (!css.empty()) {
        const std::size_t begin = css.find("/*");
        text += css.substr(0, begin);
        if (begin == std::string_view::npos) break;
        const std::size_t end = css.find("*/", begin + 2);
        css.remove_prefix(end == std::string_view::npos ? css.size() : end + 2);
        text += ' ';
    }
    return text;
}

// The position of the first of `wanted` outside of quotes and brackets, or the end.
std::size_t find_outside(std::string_view text, std::string_view wanted) {
    char quote = 0;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\\') {
            ++i;
        } else if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (depth == 0 && wanted.find(c) != std::string_view::npos) {
            return i;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '(' || c == '[' || c == '{') {
            ++depth;
        } else if (c == ')' || c == ']' || c == '}') {
            depth = std::max(0, depth - 1);
        }
    }
    return text.size();
}

// Takes what stands before the next separator, and the separator.
std::string_view take_part(std::string_view& rest, char separator) {
    const std::size_t end = find_outside(rest, std::string_view(&separator, 1));
    const std::string_view part = rest.substr(0, end);
    rest.remove_prefix(std::min(rest.size(), end + 1));
    return trimmed(part);
}

std::optional<Property> property_of(std::string_view name) {
    const auto* const found = std::find(kNames.begin(), kNames.end(), lower(name));
    if (found == kNames.end()) return std::nullopt;
    return static_cast<Property>(found - kNames.begin());
}

bool is_of_stroke(Property property) {
    return property >= Property::stroke && property <= Property::vector_effect;
}

bool is_in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 128;
}

std::string_view local_name(pugi::xml_node node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
}

}  // namespace

std::string_view name_of(Property property) {
    return kNames[static_cast<std::size_t>(property)];
}

void Style::give(Property property, std::string_view value, const Rank& rank) {
    Declaration& given = given_[static_cast<std::size_t>(property)];
    if (given.value.empty() || given.rank <= rank) given = {lower(trimmed(value)), rank};
}

std::vector<StyleSheets::Declaration> StyleSheets::declarations_of(std::string_view text) const {
    std::vector<Declaration> all;
    while (!text.empty()) {
        const std::string_view part = take_part(text, ';');
        const std::size_t colon = part.find(':');
        if (colon == std::string_view::npos) continue;
        const auto property = property_of(trimmed(part.substr(0, colon)));
        if (!property || (!with_strokes_ && is_of_stroke(*property))) continue;
        std::string_view value = trimmed(part.substr(colon + 1));
        const std::size_t mark = find_outside(value, "!");
        const bool is_important =
            mark < value.size() && lower(trimmed(value.substr(mark + 1))) == "important";
        if (is_important) value = trimmed(value.substr(0, mark));
        if (!value.empty()) all.push_back({*property, std::string(value), is_important});
    }
    return all;
}

// An element or *, then classes and ids, and nothing between or after them.
bool StyleSheets::read_selector(std::string_view text, Selector& selector) {
    const auto take_name = [&] {
        std::size_t count = 0;
        while (count < text.size() && is_in_name(text[count])) ++count;
        const std::string_view name = text.substr(0, count);
        text.remove_prefix(count);
        return std::string(name);
    };
    if (text.empty()) return false;
    if (text.starts_with('*'))
        text.remove_prefix(1);
    else
        selector.element = take_name();
    while (text.starts_with('.') || text.starts_with('#')) {
        std::vector<std::string>& names = text.front() == '.' ? selector.classes : selector.ids;
        text.remove_prefix(1);
        names.push_back(take_name());
        if (names.back().empty()) return false;
    }
    return text.empty();
}

void StyleSheets::read(std::string_view css, const Refuse& refuse) {
    const std::string text = without_comments(css);
    std::string_view rest = text;
    for (;;) {
        rest = trimmed(rest);
        if (rest.starts_with("<!--")) rest.remove_prefix(4);
        if (rest.starts_with("-->")) rest.remove_prefix(3);
        rest = trimmed(rest);
        if (rest.empty()) return;
        const std::size_t end = find_outside(rest, "{;");
        const std::string_view head = trimmed(rest.substr(0, end));
        const bool has_block = end < rest.size() && rest[end] == '{';
        rest.remove_prefix(std::min(rest.size(), end + 1));
        if (!has_block) {  // an at-rule without a block
            if (lower(head).starts_with("@import"))
                refuse(files::excerpt(head) + ": other style sheets are not read");
            continue;
        }
        const std::string_view block = take_part(rest, '}');
        if (head.starts_with('@')) {
            // Fonts and animations hide and move nothing in a still picture.
            const std::string kind = lower(head.substr(1, head.find_first_of(" \t\n\r\f(") - 1));
            if (kind.ends_with("keyframes") || kind == "font-face" || kind == "page") continue;
            for (const char& c : block)
                if (c == ':' || c == '{')
                    refuse(files::excerpt(head) + ": conditions of a style sheet are not read");
            continue;
        }
        const std::vector<Declaration> declarations = declarations_of(block);
        if (declarations.empty()) continue;
        for (std::string_view selectors = head; !selectors.empty();) {
            const std::string_view one = take_part(selectors, ',');
            Selector selector;
            if (!read_selector(one, selector))
                refuse(
                    fmt::format("the selector {} sets {}: only elements, classes and ids are "
                                "read, such as g, .hidden or #layer",
                                files::excerpt(one), name_of(declarations.front().property)));
            rules_.push_back({std::move(selector), declarations});
        }
    }
}

bool StyleSheets::fits(const Selector& selector, pugi::xml_node node) {
    if (!selector.element.empty() && selector.element != local_name(node)) return false;
    const std::string_view own_id = node.attribute("id").value();
    for (const std::string& id : selector.ids)
        if (id != own_id) return false;
    for (const std::string& name : selector.classes) {
        bool has = false;
        for (std::string_view rest = node.attribute("class").value(); !has && !rest.empty();) {
            rest = trimmed(rest);
            const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
            has = rest.substr(0, end) == name;
            rest.remove_prefix(end);
        }
        if (!has) return false;
    }
    return true;
}

Style StyleSheets::style_of(pugi::xml_node node) const {
    Style style;
    for (std::size_t i = 0; i < static_cast<std::size_t>(Property::end_of_attributes); ++i)
        if (const pugi::xml_attribute found = node.attribute(kNames[i].data()))
            style.give(static_cast<Property>(i), found.value(), {false, 0, 0, 0});
    for (std::size_t i = 0; i < rules_.size(); ++i) {
        const auto& [selector, declarations] = rules_[i];
        if (!fits(selector, node)) continue;
        const int specific =
            static_cast<int>(selector.ids.size() * 10'000 + selector.classes.size() * 100 +
                             (selector.element.empty() ? 0U : 1U));
        for (const auto& [property, value, is_important] : declarations)
            style.give(property, value, {is_important, 1, specific, i});
    }
    if (const pugi::xml_attribute own = node.attribute("style"))
        for (const auto& [property, value, is_important] :
             declarations_of(without_comments(own.value())))
            style.give(property, value, {is_important, 2, 0, 0});
    return style;
}

}  // namespace lacuna::domains
