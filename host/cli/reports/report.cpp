// Writes the report, and the origin of a set.
#include "cli/reports/report.h"

#include <fmt/core.h>
#include <lacuna/version.h>

#include <sys/resource.h>

#include <cstdint>
#include <string>

#include "checks/classes.h"
#include "cli/options/domain_options.h"
#include "cli/reports/made_set.h"
#include "files/point_files.h"
#include "options/describe.h"

namespace lacuna::cli {
namespace {

Json json_of(const options::Description& description) {
    Json json = Json::object();
    for (const auto& [name, value] : description)
        json[name] = std::visit([](const auto& one) { return Json(one); }, value);
    return json;
}

Json json_of(const Request& request, const Result& result) {
    Json json = what_decides(request, result);
    json.update(json_of(options::describe_place(request)));
    return json;
}

Json json_of(const Stopwatch& stopwatch, double total_seconds) {
    Json seconds;
    for (const Verb verb : kVerbs) seconds[std::string(name_of(verb))] = stopwatch.seconds(verb);
    const auto add_if_spent = [&](const auto& verbs) {
        for (const Verb verb : verbs)
            if (stopwatch.seconds(verb) > 0)
                seconds[std::string(name_of(verb))] = stopwatch.seconds(verb);
    };
    add_if_spent(kRelaxVerbs);
    add_if_spent(kStippleVerbs);
    seconds["total"] = total_seconds;
    return seconds;
}

std::int64_t peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    constexpr std::int64_t kBytesPerUnit = 1024;  // Linux counts it in KiB
    return usage.ru_maxrss * kBytesPerUnit;
}

// Device names come from drivers, which need not use UTF-8.
std::string text_of(const Json& report) {
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

Json what_decides(const Request& request, const Result& result) {
    return json_of(options::describe(request, result));
}

Json json_of(const Work& work) {
    Json json{{"launches", work.launches},
              {"waits", work.waits},
              {"uploads", work.uploads},
              {"downloads", work.downloads},
              {"uploaded_bytes", work.uploaded_bytes},
              {"downloaded_bytes", work.downloaded_bytes},
              {"kernels", Json::object()}};
    for (const KernelWork& kernel : work.kernels)
        json["kernels"][kernel.name] = {
            {"launches", kernel.launches}, {"items", kernel.items}, {"seconds", kernel.seconds}};
    return json;
}

std::string report_of(const Request& request, const Finished& made) {
    return report_of(request, made, Json::object());
}

std::string report_of(const Request& request, const Finished& made, const Json& more) {
    const Result& result = made.result;
    Json report{{"program", "lacuna"},
                {"version", LACUNA_VERSION},
                {"request", json_of(request, result)},
                {"count", result.points.size()}};
    const bool have_sizes = has_sizes(request.classes);
    const std::vector<double> radii =
        have_sizes ? radii_of_classes(request, result) : std::vector<double>{};
    for (const files::Layer& one : layers_of(request.classes, result)) {
        Json& kind = report["classes"].emplace_back(Json{{"name", one.ink.name}});
        if (have_sizes) kind["radius"] = radii[report["classes"].size() - 1];
        kind["count"] = one.dots;
    }
    report["radius"] = result.radius;
    if (result.scale > 0) report["scale"] = result.scale;
    report.update(
        {{"maximal", result.maximal}, {"rounds", result.rounds}, {"draws", result.draws}});
    if (result.work.launches != 0) report["work"] = json_of(result.work);
    report.update({{"seconds", json_of(made.stopwatch, made.seconds)},
                   {"backend", result.backend},
                   {"device", result.device},
                   {"peak_memory_bytes", peak_memory_bytes()},
                   {"points_sha256", files::sha256_of(result.points)}});
    report.update(more, true);
    return text_of(report);
}

std::string report_of(const Json& request, const SpaceResult& result, const Finished& made) {
    return text_of({{"program", "lacuna"},
                    {"version", LACUNA_VERSION},
                    {"request", request},
                    {"count", result.points.size()},
                    {"radius", result.radius},
                    {"maximal", result.maximal},
                    {"rounds", result.rounds},
                    {"draws", result.draws},
                    {"seconds", json_of(made.stopwatch, made.seconds)},
                    {"backend", result.backend},
                    {"device", result.device},
                    {"peak_memory_bytes", peak_memory_bytes()},
                    {"points_sha256", files::sha256_in_space(result.points)}});
}

std::string many_report(const Request& request, const ManyMade& made, const Json& decides) {
    Json asked = json_of(request, made.last);
    asked.update(decides);
    asked.erase("seed");
    asked["seeds"] = {{"first", made.first_seed}, {"last", made.last_seed}};
    return text_of({{"program", "lacuna"},
                    {"version", LACUNA_VERSION},
                    {"request", asked},
                    {"sets", made.sets},
                    {"maximal_sets", made.maximal},
                    {"count", made.points},
                    {"count_a_set", {{"least", made.least}, {"most", made.most}}},
                    {"seconds", {{"total", made.seconds}}},
                    {"backend", made.last.backend},
                    {"device", made.last.device},
                    {"peak_memory_bytes", peak_memory_bytes()}});
}

Json json_of_importance(const pictures::Importance& importance) {
    Json json{{"invert", importance.invert},
              {"gamma", importance.gamma},
              {"black", importance.black},
              {"white", importance.white},
              {"auto_levels", importance.auto_levels},
              {"min_importance", importance.min_importance}};
    if (importance.turn != 0) json["turn"] = importance.turn;
    if (const auto& [left, top, columns, rows] = importance.crop; columns != 0)
        json["crop"] = fmt::format("{},{},{},{}", left, top, columns, rows);
    if (importance.light) json["light"] = true;
    if (importance.on_black) json["background"] = "black";
    if (importance.along != 1) json["along"] = importance.along;
    if (importance.sharpen != 0) json["sharpen"] = {importance.sharpen, importance.sharpen_amount};
    return json;
}

std::string relax_report(const Json& request, const Finished& made, const Json& more) {
    Json seconds;
    for (const Verb verb : kRelaxVerbs)
        seconds[std::string(name_of(verb))] = made.stopwatch.seconds(verb);
    seconds["total"] = made.seconds;
    Json report{{"program", "lacuna"},
                {"version", LACUNA_VERSION},
                {"request", request},
                {"count", made.result.points.size()},
                {"seconds", seconds},
                {"peak_memory_bytes", peak_memory_bytes()},
                {"points_sha256", files::sha256_of(made.result.points)}};
    report.update(more, true);
    return text_of(report);
}

files::Origin origin_of(const CommandLine& line, const Request& request, const Result& result) {
    return origin_of(line, request, result, Json::object());
}

files::Origin origin_of(const CommandLine& line, const Request& request, const Result& result,
                        const Json& more) {
    Json options = what_decides(request, result);
    options.update(more);
    // File names are bytes, which need not be UTF-8.
    return {.version = LACUNA_VERSION,
            .command = line.text(request.seed),
            .mode = request.mode,
            .seed = request.seed,
            .maximal = result.maximal,
            .options = options.dump(-1, ' ', false, Json::error_handler_t::replace),
            .levels = result.levels,
            .scale = result.scale};
}

}  // namespace lacuna::cli
