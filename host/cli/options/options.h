// Options whose values are read strictly: text that is not a value as a whole is a BadRequest.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "cli/app_fwd.h"

namespace lacuna::cli {

// A value for an error message: quoted if it is empty or has blanks, and escaped, so that it stays
// on one line.
std::string shown(const std::string& text);

// Text for a terminal, on one line: control characters, invisible characters and bytes that are not
// UTF-8 are escaped.
std::string printable(std::string_view text);

// Each throws BadRequest(option, text, what is allowed). The library checks ranges.
void read(const std::string& option, const std::string& text, double& value);
// Whole numbers may be 20000, 2e4, 20k or 1.5M, and 20,000 with a comma, an underscore, an
// apostrophe or a blank between groups of three digits.
void read(const std::string& option, const std::string& text, std::uint64_t& value);
void read(const std::string& option, const std::string& text, std::uint32_t& value);

template <class Value>
void read(const std::string& option, const std::string& text, std::optional<Value>& value) {
    read(option, text, value.emplace());
}

// A domain as WIDTHxHEIGHT.
void read_domain(const std::string& option, const std::string& text, double& width, double& height);

// Adds an option whose text is passed to `take`. CLI11's own conversions would accept octal and
// hexadecimal numbers and blanks.
void add_text(CLI::App& command, const std::string& option, const std::string& symbol,
              const std::function<void(const std::string&)>& take, const std::string& help);

template <class Value>
void add_number(CLI::App& command, const std::string& option, const std::string& symbol,
                Value& value, const std::string& help) {
    add_text(
        command, option, symbol,
        [option, &value](const std::string& text) { read(option, text, value); }, help);
}

}  // namespace lacuna::cli
