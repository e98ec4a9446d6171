// JSON for the command's reports.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace lacuna::cli {

// Names stay in the order in which they are written.
using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

}  // namespace lacuna::cli
