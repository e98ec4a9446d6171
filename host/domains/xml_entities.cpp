// Replaces entities before the text is parsed, as XML 1.0 (section 4.4) says.
#include "domains/xml_entities.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>

#include "base/polling.h"
#include "files/parse.h"

namespace lacuna::domains {
namespace {

constexpr std::array<std::string_view, 5> kPredefined{"lt", "gt", "amp", "quot", "apos"};
constexpr std::string_view kXmlBlanks = " \t\r\n";
constexpr std::size_t kDeepestEntity = 16;   // entities within each other
constexpr std::size_t kMostAdded = 1 << 24;  // bytes that entities may add to a file

bool is_in_xml_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.' || c == ':' || static_cast<unsigned char>(c) >= 128;
}

// Takes the text up to and including `end`, or all of it.
std::string_view take_through(std::string_view& rest, std::string_view end) {
    const std::size_t found = rest.find(end);
    const std::string_view taken =
        rest.substr(0, found == std::string_view::npos ? found : found + end.size());
    rest.remove_prefix(taken.size());
    return taken;
}

std::string_view take_name(std::string_view& rest) {
    const auto* const end = std::find_if_not(rest.begin(), rest.end(), is_in_xml_name);
    const std::string_view name = rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
    rest.remove_prefix(name.size());
    return name;
}

void skip_blanks(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kXmlBlanks), rest.size()));
}

// Takes a text in quotes, and gives what stands between them.
std::string_view take_quoted(std::string_view& rest) {
    const std::string_view quote = rest.substr(0, 1);
    rest.remove_prefix(1);
    std::string_view text = take_through(rest, quote);
    if (text.ends_with(quote)) text.remove_suffix(1);
    return text;
}

// Skips a declaration and its `>`, which may also stand in quotes.
void skip_declaration(std::string_view& rest) {
    while (!rest.empty()) {
        rest.remove_prefix(std::min(rest.find_first_of("\"'>"), rest.size()));
        if (rest.starts_with('>')) return rest.remove_prefix(1);
        if (!rest.empty()) take_quoted(rest);
    }
}

std::string utf8(std::uint32_t code) {
    if (code < 0x80) return {static_cast<char>(code)};
    std::string bytes;
    const auto add = [&](std::uint32_t first, unsigned shift) {
        bytes += static_cast<char>(first | code >> shift);
        while (shift > 0) {
            shift -= 6;
            bytes += static_cast<char>(0x80U | (code >> shift & 0x3fU));
        }
    };
    if (code < 0x800)
        add(0xc0, 6);
    else if (code < 0x10000)
        add(0xe0, 12);
    else
        add(0xf0, 18);
    return bytes;
}

// The text of a definition, in which `&#38;` and its like stand for characters.
std::string with_characters(std::string_view text) {
    std::string all;
    while (!text.empty()) {
        std::string_view rest = text;
        all += take_through(rest, "&");
        if (rest.starts_with('#') && all.ends_with('&')) {
            const bool is_hexadecimal = rest.substr(1).starts_with('x');
            const char* const begin = rest.data() + (is_hexadecimal ? 2 : 1);
            std::uint32_t code = 0;
            const auto [end, error] =
                std::from_chars(begin, rest.data() + rest.size(), code, is_hexadecimal ? 16 : 10);
            if (error == std::errc{} && end != rest.data() + rest.size() && *end == ';' &&
                code <= 0x10ffff) {
                all.pop_back();
                all += utf8(code);
                rest.remove_prefix(static_cast<std::size_t>(end + 1 - rest.data()));
            }
        }
        text = rest;
    }
    return all;
}

class Replacer {
public:
    Replacer(std::string_view xml, const std::string& file) : xml_(xml), file_(file) {}

    std::string all() {
        std::string_view rest = xml_;
        replace_in_content(rest, 0);
        return std::move(made_);
    }

private:
    [[noreturn]] void refuse(std::string_view what, const std::string& why) const {
        files::refuse(file_, fmt::format("{}: {}", files::excerpt(what), why));
    }

    void replace_in_content(std::string_view rest, std::size_t depth) {
        while (!rest.empty()) {
            const std::size_t begin = std::min(rest.find_first_of("<&"), rest.size());
            ask_after(begin + 1);
            made_ += rest.substr(0, begin);
            rest.remove_prefix(begin);
            if (rest.starts_with("<!--"))
                made_ += take_through(rest, "-->");
            else if (rest.starts_with("<![CDATA["))
                made_ += take_through(rest, "]]>");
            else if (rest.starts_with("<?"))
                made_ += take_through(rest, "?>");
            else if (rest.starts_with("<!DOCTYPE"))
                read_doctype(rest);
            else if (rest.starts_with('<'))
                replace_in_tag(rest, depth);
            else if (!rest.empty())
                replace_one(rest, depth, false);
        }
    }

    void replace_in_tag(std::string_view& rest, std::size_t depth) {
        while (!rest.empty()) {
            const std::size_t end = rest.find_first_of("\"'>");
            made_ += rest.substr(0, end);
            rest.remove_prefix(std::min(end, rest.size()));
            if (rest.empty()) return;
            const char mark = rest.front();
            made_ += mark;
            if (mark == '>') return rest.remove_prefix(1);
            const bool is_closed = rest.find(mark, 1) != std::string_view::npos;
            replace_in_value(take_quoted(rest), depth);
            if (is_closed) made_ += mark;
        }
    }

    // The value of an attribute. What an entity brings into it ends it never.
    void replace_in_value(std::string_view rest, std::size_t depth) {
        while (!rest.empty()) {
            const char c = rest.front();
            if (c == '&') {
                replace_one(rest, depth, true);
                continue;
            }
            if (depth > 0 && (c == '"' || c == '\'' || c == '<'))
                made_ += c == '"' ? "&quot;" : c == '<' ? "&lt;" : "&apos;";
            else
                made_ += c;
            rest.remove_prefix(1);
        }
    }

    // Replaces the entity at which the text begins. An `&` that begins none stays.
    void replace_one(std::string_view& rest, std::size_t depth, bool is_in_value) {
        made_ += '&';
        rest.remove_prefix(1);
        std::string_view after = rest;
        const std::string_view name = take_name(after);
        if (name.empty() || !after.starts_with(';') ||
            std::find(kPredefined.begin(), kPredefined.end(), name) != kPredefined.end())
            return;
        const std::string whole = fmt::format("&{};", name);
        const auto found = values_.find(name);
        if (found == values_.end())
            refuse(whole,
                   "is not defined in this file: must be a text that its DTD gives, or a "
                   "character");
        if (!found->second) refuse(whole, "is defined by another file, which is not read");
        if (depth == kDeepestEntity) refuse(whole, "more than 16 entities within each other");
        made_.pop_back();
        rest = after.substr(1);
        if (made_.size() + found->second->size() > xml_.size() + kMostAdded)
            refuse(whole, "entities make the file longer by more than 16 MiB");
        if (is_in_value)
            replace_in_value(*found->second, depth + 1);
        else
            replace_in_content(*found->second, depth + 1);
    }

    // Leaves the DTD out.
    void read_doctype(std::string_view& rest) {
        for (;;) {
            rest.remove_prefix(std::min(rest.find_first_of("\"'[>"), rest.size()));
            if (rest.empty() || rest.starts_with('>')) return skip_declaration(rest);
            if (rest.starts_with('[')) break;
            take_quoted(rest);
        }
        rest.remove_prefix(1);
        for (skip_blanks(rest); !rest.empty() && !rest.starts_with(']'); skip_blanks(rest)) {
            if (rest.starts_with("<!--")) {
                take_through(rest, "-->");
            } else if (rest.starts_with("<?")) {
                take_through(rest, "?>");
            } else if (rest.starts_with("<!ENTITY")) {
                read_entity(rest);
            } else if (rest.starts_with("<!")) {
                const std::string_view before = rest;
                skip_declaration(rest);
                const std::string_view one = before.substr(0, before.size() - rest.size());
                if (one.starts_with("<!ATTLIST") && one.find_first_of("\"'") != one.npos)
                    refuse(one, "values of attributes that a DTD gives are not read");
            } else {
                refuse(rest.substr(0, rest.find(';') + 1), "is not read in a DTD");
            }
        }
        skip_declaration(rest);
    }

    // The first definition of a name counts.
    void read_entity(std::string_view& rest) {
        rest.remove_prefix(std::string_view("<!ENTITY").size());
        skip_blanks(rest);
        const bool is_parameter = rest.starts_with('%');
        if (!is_parameter) {
            const std::string name(take_name(rest));
            skip_blanks(rest);
            std::optional<std::string> value;
            if (rest.starts_with('"') || rest.starts_with('\''))
                value = with_characters(take_quoted(rest));
            values_.emplace(name, value);
        }
        skip_declaration(rest);
    }

    std::string_view xml_;
    const std::string& file_;
    std::map<std::string, std::optional<std::string>, std::less<>> values_;  // none: elsewhere
    std::string made_;
};

}  // namespace

std::string with_entities(std::string_view xml, const std::string& file) {
    // UTF-16 and UTF-32, which pugixml reads, have bytes of 0 from the beginning.
    if (xml.substr(0, 4).find('\0') != std::string_view::npos) {
        std::string narrow(xml);
        narrow.erase(std::remove(narrow.begin(), narrow.end(), '\0'), narrow.end());
        for (const std::string_view one : {"<!ENTITY", "<!ATTLIST"})
            if (narrow.find(one) != std::string::npos)
                files::refuse(file, fmt::format("{}: is read in UTF-8 only", one));
        return std::string(xml);
    }
    return Replacer(xml, file).all();
}

}  // namespace lacuna::domains
