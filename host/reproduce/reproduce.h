// The tables and figures of Kalantari & Sen (2011), made again and compared with the paper.
#pragma once

#include <lacuna/lacuna.h>

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/medium.h"
#include "files/point_files.h"
#include "reproduce/number.h"

namespace lacuna::reproduce {

struct Setting {
    std::optional<std::uint32_t> runs;      // sets for each mean, >= 1; unset: the item's default
    std::optional<double> smallest_radius;  // rows of the tables with a smaller radius are left out
    const Field* image = nullptr;           // for items that need one; its pixels give the aspect
    // Called by one thread at a time, not always the caller's, with the finished fraction, 0 to 1.
    // If it returns false, the work ends with lacuna::Cancelled.
    std::function<bool(double share)> keep_going = [](double) { return true; };
};

struct Reproduction {
    std::vector<Number> numbers;
    nlohmann::ordered_json data;  // the data that the picture shows
    files::Medium medium;         // format of the picture: svg or png
    std::string picture;          // the picture's bytes
};

struct Item {
    std::string_view name;
    std::string_view caption;
    bool needs_image;
    Reproduction (*make)(const Setting& setting);
};

// table1, table2, fig3 to fig8: each has a file of that name.
std::span<const Item> items();

// The .json file of an item: its numbers and data. Except for times it is the same on every call.
std::string json_of(const Item& item, const Reproduction& reproduction);

// These throw Cancelled. fig7 also throws BadRequest, if the image has no room for its dots.
Reproduction table1(const Setting& setting);
Reproduction table2(const Setting& setting);
Reproduction fig3(const Setting& setting);
Reproduction fig4(const Setting& setting);
Reproduction fig5(const Setting& setting);
Reproduction fig6(const Setting& setting);
Reproduction fig7(const Setting& setting);
Reproduction fig8(const Setting& setting);

}  // namespace lacuna::reproduce
