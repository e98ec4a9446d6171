// Strict reading of numbers and domains.
#include "cli/options.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

namespace lacuna::cli {
namespace {

template <class Value>
std::errc parse_whole_text(std::string_view text, Value& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc{} && stop != end) return std::errc::invalid_argument;
    return error;
}

template <class Value>
void read_whole_number(const std::string& option, const std::string& text, Value& value) {
    if (parse_whole_text(text, value) == std::errc{}) return;
    throw BadRequest(
        option, shown(text),
        "must be a whole number, at most " + std::to_string(std::numeric_limits<Value>::max()));
}

}  // namespace

std::string shown(const std::string& text) {
    const auto is_plain = [](unsigned char c) { return c > ' ' && c != 0x7f; };
    const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), is_plain);
    return plain ? text : fmt::format("{:?}", text);
}

void read(const std::string& option, const std::string& text, double& value) {
    const std::errc error = parse_whole_text(text, value);
    if (error == std::errc{}) return;
    throw BadRequest(option, shown(text),
                     error == std::errc::result_out_of_range
                         ? "must be a number that a double can hold"
                         : "must be a number, such as 0.01 or 1e-2");
}

void read(const std::string& option, const std::string& text, std::uint64_t& value) {
    read_whole_number(option, text, value);
}

void read(const std::string& option, const std::string& text, std::uint32_t& value) {
    read_whole_number(option, text, value);
}

void read_domain(const std::string& option, const std::string& text, double& width,
                 double& height) {
    const std::string_view view = text;
    const std::size_t cross = view.find('x');
    if (cross == std::string_view::npos ||
        parse_whole_text(view.substr(0, cross), width) != std::errc{} ||
        parse_whole_text(view.substr(cross + 1), height) != std::errc{})
        throw BadRequest(option, shown(text),
                         "must be WIDTHxHEIGHT, two numbers such as 1x1 or 2.5x1");
}

void add_text(CLI::App& command, const std::string& option, const std::string& symbol,
              const std::function<void(const std::string&)>& take, const std::string& help) {
    command.add_option_function<std::string>("--" + option, take, help)->type_name(symbol);
}

}  // namespace lacuna::cli
