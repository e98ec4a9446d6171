// Writes a comparison as text and as JSON.
#include "cli/reports/comparison.h"

#include <lacuna/version.h>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "cli/reports/report.h"

namespace lacuna::cli {
namespace {

constexpr std::size_t kMostNameColumns = 32;

std::string name_of(const Entry& entry) {
    const std::string name = entry.device.empty() ? entry.contestant.name : entry.device;
    return name.size() <= kMostNameColumns ? name : name.substr(0, kMostNameColumns - 3) + "...";
}

std::string milliseconds(double seconds) {
    return fmt::format("{:.{}f} ms", 1e3 * seconds, seconds < 0.1 ? 2 : 0);
}

std::string memory_text(const std::optional<std::uint64_t>& bytes) {
    return bytes ? fmt::format("{:.1f} MB", static_cast<double>(*bytes) / 1e6) : "-";
}

// Why an entry has no runs, or fewer than were asked for.
std::string failure_text(const Entry& entry) {
    if (!entry.broke_off) return "not run: " + entry.failure;
    return fmt::format("failed in run {}: {}", entry.seconds.size() + 1, entry.failure);
}

// In every row the first two columns are left-aligned, and the last may have any width.
std::string times_table(const Comparison& comparison) {
    const Entry* const yardstick = comparison.yardstick();
    constexpr const char* kRow = "{:<10} {:<32} {:>9} {:>10} {:>19} {:>10} {:>10} {:>6}  {}\n";
    std::string text = fmt::format(fmt::runtime(kRow), "backend", "device", "points", "median",
                                   "least to most", "first use", "memory", "speed", "points are");
    for (const Entry& entry : comparison.entries) {
        if (!entry.has_run()) {
            text += fmt::format("{:<10} {:<32} {}\n", entry.contestant.backend, name_of(entry),
                                failure_text(entry));
            continue;
        }
        const auto [least, most] = std::minmax_element(entry.seconds.begin(), entry.seconds.end());
        const double speed = yardstick->median_seconds() / entry.median_seconds();
        const char* const points = entry.difference      ? "NOT the same"
                                   : entry.broke_off     ? "the same until it failed"
                                   : &entry == yardstick ? "the yardstick"
                                                         : "the same";
        text += fmt::format(fmt::runtime(kRow), entry.contestant.backend, name_of(entry),
                            entry.points, milliseconds(entry.median_seconds()),
                            milliseconds(*least) + " " + milliseconds(*most),
                            milliseconds(entry.first_use_seconds()),
                            memory_text(entry.memory_bytes), fmt::format("{:.2f}", speed), points);
    }
    return text;
}

std::string verbs_table(const Comparison& comparison) {
    std::string text = fmt::format("{:<10} {:<32}", "one run", "");
    for (const Verb verb : kVerbs)
        if (verb != Verb::first_use) text += fmt::format(" {:>10}", lacuna::name_of(verb));
    text += '\n';
    for (const Entry& entry : comparison.entries) {
        if (!entry.has_run()) continue;
        text += fmt::format("{:<10} {:<32}", entry.contestant.backend, name_of(entry));
        for (std::size_t i = 0; i < kVerbs.size(); ++i)
            if (kVerbs[i] != Verb::first_use)
                text += fmt::format(" {:>10}", milliseconds(entry.verb_seconds[i]));
        text += '\n';
    }
    return text;
}

std::string text_of(const std::optional<Point>& point) {
    return point ? fmt::format("({}, {})", point->x, point->y) : "none";
}

std::string verdict(const Comparison& comparison) {
    const Entry* const yardstick = comparison.yardstick();
    if (yardstick == nullptr) return "nothing was run\n";
    std::string text = fmt::format("SHA-256 of the points, {}: {}\n", yardstick->contestant.backend,
                                   yardstick->sha256);
    for (const Entry& entry : comparison.entries)
        if (entry.difference)
            text +=
                fmt::format("{} differs first in point {}: {} instead of {}\n",
                            entry.contestant.backend, entry.difference->index,
                            text_of(entry.difference->got), text_of(entry.difference->expected));
    bool any_failed = false;
    for (const Entry& entry : comparison.entries) {
        if (!entry.has_run() || !entry.broke_off) continue;
        any_failed = true;
        text += fmt::format("{} {}\n", entry.contestant.backend, failure_text(entry));
    }
    const auto ran = std::count_if(comparison.entries.begin(), comparison.entries.end(),
                                   [](const Entry& entry) { return entry.has_run(); });
    if (comparison.agree())
        text += fmt::format("{} made these points, in every run{}\n",
                            ran == 1 ? "one" : fmt::format("all {}", ran),
                            any_failed ? " that was finished" : "");
    return text;
}

Json json_of(const std::optional<Point>& point) {
    return point ? Json{point->x, point->y} : Json(nullptr);
}

bool has_work(const Entry& entry) {
    return entry.has_run() && entry.work.launches != 0;
}

// A round's share.
std::string a_round(const Entry& entry, std::uint64_t number) {
    return fmt::format("{:.1f}", static_cast<double>(number) /
                                     static_cast<double>(std::max<std::uint64_t>(entry.rounds, 1)));
}

Json json_of(const Entry& entry, const Entry* yardstick) {
    Json json = {{"backend", entry.contestant.backend}, {"device", name_of(entry)}};
    if (!entry.failure.empty()) json[entry.broke_off ? "failed" : "not_run"] = entry.failure;
    if (!entry.has_run()) return json;
    json["count"] = entry.points;
    json["rounds"] = entry.rounds;
    json["points_sha256"] = entry.sha256;
    json["same_points"] = !entry.difference.has_value();
    if (entry.difference)
        json["first_difference"] = {{"index", entry.difference->index},
                                    {"expected", json_of(entry.difference->expected)},
                                    {"got", json_of(entry.difference->got)}};
    json["speed"] = yardstick->median_seconds() / entry.median_seconds();
    json["first_use_seconds"] = entry.first_use_seconds();
    json["memory_bytes"] = entry.memory_bytes ? Json(*entry.memory_bytes) : Json(nullptr);
    json["median_seconds"] = entry.median_seconds();
    json["seconds"] = entry.seconds;
    for (std::size_t i = 0; i < kVerbs.size(); ++i)
        if (kVerbs[i] != Verb::first_use)
            json["seconds_by_verb"][std::string(lacuna::name_of(kVerbs[i]))] =
                entry.verb_seconds[i];
    if (entry.work.launches != 0) json["work"] = cli::json_of(entry.work);
    return json;
}

}  // namespace

std::string text_of(const Comparison& comparison) {
    std::string text = times_table(comparison);
    if (comparison.yardstick() != nullptr) text += '\n' + verbs_table(comparison);
    return text + '\n' + verdict(comparison);
}

std::string work_text(const Comparison& comparison) {
    constexpr const char* kRow = "{:<10} {:<32} {:>9} {:>9} {:>9} {:>9} {:>12} {:>12}\n";
    constexpr const char* kKernel = "{:<10} {:<32} {:>9} {:>12} {:>10}\n";
    std::string text, kernels;
    for (const Entry& entry : comparison.entries) {
        if (!has_work(entry)) continue;
        const Work& work = entry.work;
        const auto share = [&](std::uint64_t number) { return a_round(entry, number); };
        text += fmt::format(fmt::runtime(kRow), entry.contestant.backend, name_of(entry),
                            share(work.launches), share(work.waits), share(work.uploads),
                            share(work.downloads), share(work.uploaded_bytes),
                            share(work.downloaded_bytes));
        for (const KernelWork& kernel : work.kernels)
            kernels += fmt::format(fmt::runtime(kKernel), entry.contestant.backend, kernel.name,
                                   share(kernel.launches), share(kernel.items),
                                   kernel.seconds == 0 ? "-" : milliseconds(kernel.seconds));
    }
    if (text.empty()) return text;
    return fmt::format(fmt::runtime(kRow), "a round", "", "launches", "waits", "uploads",
                       "downloads", "bytes up", "bytes down") +
           text + '\n' +
           fmt::format(fmt::runtime(kKernel), "a round", "kernel", "launches", "items", "one run") +
           kernels + '\n';
}

std::string json_of(const Comparison& comparison, const Request& request) {
    const Entry* const yardstick = comparison.yardstick();
    Json json = {{"program", "lacuna"},
                 {"version", LACUNA_VERSION},
                 {"mode", lacuna::name_of(request.mode)},
                 {"seed", request.seed},
                 {"radius", comparison.radius > 0 ? Json(comparison.radius) : Json(nullptr)},
                 {"same_points", comparison.agree()},
                 {"entries", Json::array()}};
    if (request.mode == Mode::cells) json["scale"] = comparison.scale;
    for (const Entry& entry : comparison.entries)
        json["entries"].push_back(json_of(entry, yardstick));
    // Device names come from drivers, which need not use UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna::cli
