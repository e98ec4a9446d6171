// The list of all items, and how their files are written.
#include "reproduce/reproduce.h"

#include <array>
#include <utility>

namespace lacuna::reproduce {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kItems{
    Item{"table1", "times and counts on the box", false, table1},
    Item{"table2", "times and counts on the torus", false, table2},
    Item{"fig3", "error of a disk's area against m", false, fig3},
    Item{"fig4", "spectra against m", false, fig4},
    Item{"fig5", "6,000 of 6,900 samples: cdf against uniform-x", false, fig5},
    Item{"fig6", "conflict metrics along edges", false, fig6},
    Item{"fig7", "a stippled image", true, fig7},
    Item{"fig8", "maximality against the metric", false, fig8},
};

Json json_of(const Number& number) {
    Json json{{"what", number.what}, {"paper", number.paper}, {"here", number.here}};
    if (number.published) json["published"] = *number.published;
    if (number.band) {
        json["band"] = {{"least", number.band->least}, {"most", number.band->most}};
        json["within"] = number.within();
    }
    return json;
}

}  // namespace

std::span<const Item> items() {
    return kItems;
}

std::string json_of(const Item& item, const Reproduction& reproduction) {
    Json numbers = Json::array();
    for (const Number& number : reproduction.numbers) numbers.push_back(json_of(number));
    const Json json{{"program", "lacuna"},
                    {"reproduces", item.name},
                    {"caption", item.caption},
                    {"numbers", std::move(numbers)},
                    {"data", reproduction.data}};
    return json.dump(2) + "\n";
}

}  // namespace lacuna::reproduce
