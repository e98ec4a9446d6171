// The tables and figures of Kalantari & Sen (2011), made anew and held against the paper.
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

#include "drawing/medium.h"
#include "files/point_files.h"
#include "reproduce/number.h"

namespace lacuna::reproduce {

struct Setting {
    std::optional<std::uint32_t> runs;      // sets a mean is taken of, >= 1; unset: each its own
    std::optional<double> smallest_radius;  // rows of the tables with a smaller one are left out
    const Field* image = nullptr;           // for the items that need one; aspect as its pixels
    // Told by one thread at a time, the calling one or another, how much is done, from 0 to 1.
    // When it says false the work ends with lacuna::Cancelled.
    std::function<bool(double share)> keep_going = [](double) { return true; };
};

struct Reproduction {
    std::vector<Number> numbers;
    nlohmann::ordered_json data;  // what the picture shows
    drawing::Medium medium;       // of the picture: svg or png
    std::string picture;          // its bytes
};

struct Item {
    std::string_view name;
    std::string_view caption;
    bool needs_image;
    Reproduction (*make)(const Setting& setting);
};

// table1, table2, fig3 to fig8: each in a file of its name.
std::span<const Item> items();

// The .json file of an item: its numbers and its data. The same but for times on every call.
std::string json_of(const Item& item, const Reproduction& reproduction);

// Throw Cancelled; fig7 BadRequest too, where so many dots do not fit the image.
Reproduction table1(const Setting& setting);
Reproduction table2(const Setting& setting);
Reproduction fig3(const Setting& setting);
Reproduction fig4(const Setting& setting);
Reproduction fig5(const Setting& setting);
Reproduction fig6(const Setting& setting);
Reproduction fig7(const Setting& setting);
Reproduction fig8(const Setting& setting);

}  // namespace lacuna::reproduce
