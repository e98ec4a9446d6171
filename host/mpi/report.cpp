// What the ranks' work has cost.
#include "mpi/report.h"

#include <lacuna/version.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "cli/reports/report.h"

namespace lacuna::mpi {
namespace {

using cli::Json;
using Figures = std::vector<std::pair<std::string, double>>;

double peak_memory_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    constexpr double kBytesPerUnit = 1024;  // Linux counts it in KiB
    return static_cast<double>(usage.ru_maxrss) * kBytesPerUnit;
}

Figures seconds_of(const cli::Stopwatch& stopwatch, const MpiRanks& ranks, const NpySink& sink) {
    Figures seconds;
    for (const Verb verb : cli::kVerbs)
        seconds.emplace_back(name_of(verb), stopwatch.seconds(verb));
    // Includes the wait for other ranks.
    seconds.emplace_back("exchange", ranks.cost().seconds);
    seconds.emplace_back("write", sink.seconds());
    return seconds;
}

Figures counts_of(const ResultOnRanks& result, const MpiRanks& ranks, const NpySink& sink) {
    const Border::Tally& border = result.outcome.border;
    const auto number = [](std::uint64_t value) { return static_cast<double>(value); };
    return {{"samples", number(result.outcome.own_samples)},
            {"border_samples", number(border.samples)},
            {"border_candidates_sent", number(border.sent)},
            {"border_bytes_sent", number(ranks.cost().bytes)},
            {"border_messages_sent", number(border.messages)},
            {"most_border_messages_in_a_round", number(border.most_messages)},
            {"rounds_looked_at_as_a_whole", number(border.whole_looks)},
            {"sums", number(ranks.cost().sums)},
            {"file_bytes_sent", number(sink.bytes_sent())},
            {"peak_memory_bytes", peak_memory_bytes()}};
}

template <typename Number>
Json of_all_ranks(const Figures& own, const MpiRanks& ranks) {
    const std::size_t count = ranks.count();
    std::vector<double> values;
    for (const auto& [name, value] : own) values.push_back(value);
    const auto width = static_cast<int>(values.size());
    std::vector<double> all(ranks.rank() == 0 ? values.size() * count : 0);
    MPI_Gather(values.data(), width, MPI_DOUBLE, all.data(), width, MPI_DOUBLE, 0,
               ranks.communicator());
    Json json;
    for (std::size_t i = 0; i < own.size() && ranks.rank() == 0; ++i) {
        std::vector<double> figures;
        for (std::size_t rank = 0; rank < count; ++rank)
            figures.push_back(all[rank * values.size() + i]);
        std::sort(figures.begin(), figures.end());
        json[own[i].first] = {{"least", static_cast<Number>(figures.front())},
                              {"median", static_cast<Number>(figures[count / 2])},
                              {"most", static_cast<Number>(figures.back())}};
    }
    return json;
}

}  // namespace

std::string report_of(const Request& request, const ResultOnRanks& result,
                      const cli::Stopwatch& stopwatch, double seconds, const MpiRanks& ranks,
                      const NpySink& sink, const std::string& sha256) {
    const Json seconds_by_rank = of_all_ranks<double>(seconds_of(stopwatch, ranks, sink), ranks);
    const Json by_rank = of_all_ranks<std::uint64_t>(counts_of(result, ranks, sink), ranks);
    if (ranks.rank() != 0) return "";
    Result made;
    made.lines_per_radius = result.lines_per_radius;
    Json asked = cli::what_decides(request, made);
    asked.update(Json{{"backend", request.run_on.backend},
                      {"device", request.run_on.device},
                      {"threads", request.run_on.threads}});
    Json report{{"program", "lacuna-mpi"},
                {"version", LACUNA_VERSION},
                {"request", asked},
                {"count", result.outcome.samples},
                {"radius", result.radius},
                {"maximal", result.outcome.maximal},
                {"rounds", result.outcome.rounds},
                {"draws", result.outcome.draws},
                {"ranks", ranks.count()},
                {"seconds", {{"total", seconds}}},
                {"seconds_by_rank", seconds_by_rank},
                {"by_rank", by_rank},
                {"backend", result.backend},
                {"device", result.device},
                {"points_sha256", sha256}};
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lacuna::mpi
