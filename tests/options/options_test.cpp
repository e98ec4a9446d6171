// The table of options: its words, and the defaults that its help names.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/pictures.h>

#include <cstddef>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>

#include "base/number_text.h"
#include "files/formats.h"
#include "options/options.h"
#include "options/read.h"

namespace lacuna::options {
namespace {

TEST(TheTableOfOptions, HasOneRowForEachOptionOfACommand) {
    for (const Commands command : {kSample, kStipple, kRelax, kOrder, kVerify, kAnalyze, kCompare,
                                   kReproduce, kDevices, kMpiSample, kMask, kAgain})
        for (const Option* option : options_of(command)) {
            EXPECT_EQ(find_option(command, option->name), option) << option->name;
            EXPECT_EQ(option->symbol.empty() && !option->is_argument(), option->kind == Kind::flag)
                << option->name;
        }
}

TEST(TheTableOfOptions, NamesTheDefaults) {
    const auto names = [](Commands command, std::string_view option, const std::string& value) {
        return help_of(*find_option(command, option)).find("default " + value) != std::string::npos;
    };
    const RelaxOptions relax;
    EXPECT_TRUE(names(kRelax, "iterations", std::to_string(relax.iterations)));
    EXPECT_TRUE(names(kStipple, "relax", std::to_string(relax.iterations)));
    EXPECT_TRUE(names(kRelax, "gaussian-distance", shortest(relax.gaussian_distance)));
    EXPECT_TRUE(names(kStipple, "black-ink", shortest(kBlackInk)));
}

TEST(TheTableOfWords, HasTheWordsOfTheLibrary) {
    for (const Mode mode : {Mode::exact, Mode::lines, Mode::cells, Mode::stratified, Mode::pixels})
        EXPECT_TRUE(is_among(name_of(mode), Words::modes));
    EXPECT_EQ(name_of(Mode::stratified), "stratified");
    EXPECT_EQ(name_of(Metric::max), "max");
    EXPECT_EQ(listed(Words::metrics), "min, mean or max");
    const auto extensions = [](Words list) {
        std::string text;
        for (const std::string_view word : words_of(list))
            text += (text.empty() ? "." : " .") + std::string(word);
        return text;
    };
    EXPECT_EQ(extensions(Words::formats), files::written_extensions());
    EXPECT_EQ(extensions(Words::report_formats), ".json " + files::picture_extensions());
    EXPECT_EQ(extensions(Words::chart_formats), files::picture_extensions());
}

TEST(APathForAShell, NeverLooksLikeAnOption) {
    EXPECT_EQ(quoted_path("-x y.svg"), "'./-x y.svg'");
    EXPECT_EQ(quoted_path("-"), "-");
    EXPECT_EQ(quoted_path("x.svg"), "x.svg");
}

// Python and the page write some lists down: types and menus cannot come from a table.
TEST(TheTableOfWords, IsThatOfPythonAndOfThePage) {
    const auto content_of = [](const std::string& file) {
        std::ifstream in(LACUNA_ROOT + file);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    const auto literal = [](Words list) {
        std::string text;
        for (const std::string_view word : words_of(list))
            text += (text.empty() ? "Literal[\"" : ", \"") + std::string(word) + "\"";
        return text + "]";
    };
    const std::string arguments = content_of("python/lacuna/_arguments.py");
    EXPECT_NE(arguments.find("Mode = " + literal(Words::modes)), std::string::npos);
    EXPECT_NE(arguments.find("Metric = " + literal(Words::metrics)), std::string::npos);
    EXPECT_NE(content_of("python/lacuna/_stipple.py").find(literal(Words::dot_modes)),
              std::string::npos);
    const std::string page = content_of("web/page/index.html");
    for (const std::string_view paper : words_of(Words::papers)) {
        const auto sheet = read_paper("paper-size", std::string(paper));
        const std::string control = "<option data-size=\"" + shortest(sheet.width_mm) + " " +
                                    shortest(sheet.height_mm) + "\">" + std::string(paper) + "<";
        EXPECT_NE(page.find(control), std::string::npos) << control;
    }
    // The menu of inks gives each name the colour that the table gives it.
    const std::size_t menu = page.find("id=\"ink-kind\"");
    const std::string inks = page.substr(menu, page.find("</select>", menu) - menu);
    const std::regex named("[\",]([a-z]+)=(#[0-9a-f]{6})");
    for (std::sregex_iterator found(inks.begin(), inks.end(), named), end; found != end; ++found)
        EXPECT_EQ(paper_of((*found)[1]), paper_of((*found)[2])) << (*found)[1];
    const std::regex control("data-option=\"([^\"]+)\"");
    std::size_t controls = 0;
    for (std::sregex_iterator found(page.begin(), page.end(), control), end; found != end;
         ++found) {
        const std::string option = (*found)[1];
        EXPECT_TRUE(find_option(kStipple, option) != nullptr ||
                    find_option(kSample, option) != nullptr)
            << option;
        ++controls;
    }
    EXPECT_GT(controls, 20u);
}

}  // namespace
}  // namespace lacuna::options
