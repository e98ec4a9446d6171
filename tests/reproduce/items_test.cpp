// Every table and figure with few runs: its numbers, its data, its picture.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "reproduce/reproduce.h"

namespace {

using namespace lacuna;
using namespace lacuna::reproduce;

const Item& item_of(std::string_view name) {
    return *std::find_if(items().begin(), items().end(),
                         [=](const Item& item) { return item.name == name; });
}

// Dark towards the right, with a white stripe.
const Field& image() {
    static const Field field = [] {
        Field made{48, 36, {}};
        for (int row = 0; row < 36; ++row)
            for (int column = 0; column < 48; ++column)
                made.importance.push_back(row == 20 ? 0 : 0.1 + column / 60.0);
        return made;
    }();
    return field;
}

Setting few_runs(std::uint32_t runs = 2) {
    Setting setting;
    setting.runs = runs;
    setting.smallest_radius = 0.02;
    setting.image = &image();
    return setting;
}

std::vector<std::string> not_within(const Item& item, const Reproduction& made) {
    std::vector<std::string> lines;
    for (const Number& number : made.numbers)
        if (!number.within()) lines.push_back(line_of(item.name, number));
    return lines;
}

class EveryItem : public testing::TestWithParam<std::string> {};

TEST_P(EveryItem, IsMadeWithItsNumbersWithinTheirBands) {
    const Item& item = item_of(GetParam());
    const Reproduction made = item.make(few_runs());
    EXPECT_FALSE(made.numbers.empty());
    EXPECT_EQ(not_within(item, made), std::vector<std::string>{});
    EXPECT_FALSE(made.data.empty());
    const bool is_svg = made.medium == files::Medium::svg;
    EXPECT_TRUE(made.picture.starts_with(is_svg ? "<?xml" : "\x89PNG"));
}

INSTANTIATE_TEST_SUITE_P(OfThePaper, EveryItem,
                         testing::Values("table1", "table2", "fig3", "fig4", "fig5", "fig6", "fig7",
                                         "fig8"),
                         [](const auto& test) { return test.param; });

TEST(Items, AreInThePapersOrderAndOnlyFigure7NeedsAnImage) {
    std::vector<std::string_view> names;
    for (const Item& item : items()) {
        names.push_back(item.name);
        EXPECT_EQ(item.needs_image, item.name == "fig7");
    }
    EXPECT_EQ(names, (std::vector<std::string_view>{"table1", "table2", "fig3", "fig4", "fig5",
                                                    "fig6", "fig7", "fig8"}));
}

TEST(Tables, LeaveOutRowsOfSmallerRadii) {
    Setting setting = few_runs(1);
    EXPECT_EQ(table2(setting).numbers.size(), 6U);  // three counts, three times
    setting.smallest_radius = 0.01;
    EXPECT_EQ(table2(setting).numbers.size(), 12U);
    EXPECT_EQ(table1(setting).numbers.size(), 17U);  // and the time of dart throwing
}

TEST(Tables, GiveTheMeanOfAllRuns) {
    const Setting setting = few_runs(3);
    Request request;
    request.mode = Mode::exact;
    request.radius = 0.05;
    request.domain.boundary = Boundary::torus;
    double samples = 0;
    for (request.seed = 0; request.seed < 3; ++request.seed)
        samples += static_cast<double>(sample(request).points.size()) / 3;
    EXPECT_NEAR(table2(setting).numbers[2].here, samples, 1e-9);
}

TEST(Items, AreTheSameOnEveryCallButForTimes) {
    for (const char* name : {"fig5", "fig6"}) {
        const Item& item = item_of(name);
        const Reproduction one = item.make(few_runs(1));
        const Reproduction two = item.make(few_runs(1));
        EXPECT_EQ(json_of(item, one), json_of(item, two));
        EXPECT_EQ(one.picture, two.picture);
    }
}

TEST(Items, TellTheirNumbersAndDataAsJson) {
    const Item& item = item_of("fig3");
    Reproduction made = item.make(few_runs());
    made.numbers[0].here = 2;  // planted: above its band
    const auto json = nlohmann::json::parse(json_of(item, made));
    EXPECT_EQ(json["reproduces"], "fig3");
    EXPECT_EQ(json["numbers"].size(), made.numbers.size());
    EXPECT_EQ(json["numbers"][0]["within"], false);
    EXPECT_EQ(json["numbers"][0]["here"], 2);
    EXPECT_EQ(json["numbers"][0]["band"]["least"], nullptr);  // no limit
    EXPECT_EQ(json["numbers"][0]["band"]["most"], 1);
    EXPECT_EQ(json["numbers"][1]["within"], true);
    EXPECT_EQ(json["data"]["x_only"].size(), 60U);
}

TEST(Items, TellHowMuchIsDoneAndEndWhenToldTo) {
    for (const Item& item : items()) {
        Setting setting = few_runs(1);
        double last = 0;
        setting.keep_going = [&](double share) {
            EXPECT_GE(share, last) << item.name;
            EXPECT_LE(share, 1 + 1e-9) << item.name;
            last = share;
            return share < 0.05;
        };
        EXPECT_THROW(item.make(setting), Cancelled) << item.name;
    }
}

}  // namespace
