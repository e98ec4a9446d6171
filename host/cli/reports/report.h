// --report: the request, the result and the time and memory it took, as JSON; the origin of a set
// for its files; and what `lacuna analyze` says.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/analyse.h"
#include "cli/options/common_options.h"
#include "files/point_files.h"
#include "pictures/importance.h"

namespace lacuna::cli {

// Names stay in the order in which they are written.
using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

// The parts of the request that decide which points are made.
Json what_decides(const Request& request, const Result& result);

// What a device was asked to do, in all and by each kernel.
Json json_of(const Work& work);
// The options that turned a picture into importance.
Json json_of_importance(const pictures::Importance& importance);

// The report of one set. Its seconds do not include writing files. `more` is merged into the
// report.
std::string report_of(const Request& request, const Finished& made);
std::string report_of(const Request& request, const Finished& made, const Json& more);
std::string report_of(const Json& request, const SpaceResult& result, const Finished& made);

// Sums over many sets of one request.
struct ManyMade {
    std::uint64_t first_seed = 0;
    std::uint64_t last_seed = 0;
    std::uint64_t sets = 0;
    std::uint64_t points = 0;   // of all sets
    std::uint64_t least = 0;    // points of the smallest set
    std::uint64_t most = 0;     // points of the largest set
    std::uint64_t maximal = 0;  // sets that are maximal
    Result last;                // the last set, without its points
    double seconds = 0;         // with the time to write files
};
std::string many_report(const Request& request, const ManyMade& made, const Json& decides);

// The report of `lacuna relax`.
std::string relax_report(const Json& request, const Finished& made, const Json& more);

// The origin of a set for files: the request, and a command line that makes the set again.
// Options that decide no point are left out (outputs, backend, device, threads), so that the bytes
// of a file are the same wherever the set was made. `more` is merged into the options.
files::Origin origin_of(const CommandLine& line, const Request& request, const Result& result,
                        const Json& more);
files::Origin origin_of(const CommandLine& line, const Request& request, const Result& result);

// The output of `lacuna analyze`: one number on each line, behind its name.
std::string text_of(const analysis::Analysis& analysis);

// All numbers and curves; numbers that do not exist are null. `files` are the names as given.
std::string json_of(const analysis::Analysis& analysis, const std::vector<std::string>& files);

}  // namespace lacuna::cli
