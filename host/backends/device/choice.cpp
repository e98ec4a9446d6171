// The choice of a device, and the messages when there is none.
#include "backends/device/choice.h"

#include <lacuna/lacuna.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <vector>

namespace lacuna::device {
namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
}

std::string list(std::span<const DeviceEntry> entries) {
    std::string all;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i > 0) all += ", ";
        all += std::to_string(i) + " (" + entries[i].name;
        if (!entries[i].unusable.empty()) all += ": " + entries[i].unusable;
        all += ")";
    }
    return all;
}

// A number beyond the list may still be part of a name.
std::optional<std::size_t> as_number(std::string_view wanted, std::size_t count) {
    std::size_t number = 0;
    const char* const end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, number);
    if (error != std::errc{} || stop != end || number >= count) return std::nullopt;
    return number;
}

std::size_t first_usable(std::string_view backend, std::span<const DeviceEntry> entries) {
    const auto usable = [](const DeviceEntry& entry) { return entry.unusable.empty(); };
    const auto usable_gpu = [&](const DeviceEntry& e) { return usable(e) && e.kind == "gpu"; };
    auto found = std::find_if(entries.begin(), entries.end(), usable_gpu);
    if (found == entries.end()) found = std::find_if(entries.begin(), entries.end(), usable);
    if (found == entries.end())
        throw Unavailable("backend " + std::string(backend) +
                          ": no device can be used: " + list(entries));
    return static_cast<std::size_t>(found - entries.begin());
}

std::size_t by_name(const std::string& backend, std::span<const DeviceEntry> entries,
                    const std::string& wanted) {
    std::vector<std::size_t> matches;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (lower_case(entries[i].name).find(lower_case(wanted)) != std::string::npos)
            matches.push_back(i);
    if (matches.empty())
        throw Unavailable("device " + wanted + ": must be the number or part of the name of one " +
                          "that backend " + backend + " has: " + list(entries));
    if (matches.size() > 1)
        throw Unavailable("device " + wanted + ": is part of several names, give the number of " +
                          "one: " + list(entries));
    return matches.front();
}

}  // namespace

std::size_t choose(std::string_view backend, std::span<const DeviceEntry> entries,
                   std::string_view wanted) {
    const std::string name(backend);
    if (entries.empty())
        throw Unavailable("backend " + name + ": no device: no driver for it is installed");
    if (wanted.empty()) return first_usable(backend, entries);

    const std::optional<std::size_t> number = as_number(wanted, entries.size());
    const std::size_t chosen = number ? *number : by_name(name, entries, std::string(wanted));
    if (!entries[chosen].unusable.empty())
        throw Unavailable("device " + std::string(wanted) + ": " + entries[chosen].name +
                          " cannot be used by backend " + name + ": " + entries[chosen].unusable);
    return chosen;
}

std::string why_forked() {
    static const pid_t first = ::getpid();
    if (::getpid() == first) return "";
    return "this process was forked from one that used its driver, whose threads stayed behind: "
           "start a program instead (exec)";
}

}  // namespace lacuna::device
