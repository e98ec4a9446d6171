// The table of options: its words, its pairs, and the defaults that its help names.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>
#include <lacuna/pictures.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.h"
#include "files/formats.h"
#include "recipes/options.h"
#include "recipes/read.h"
#include "refusal.h"

namespace lacuna::recipes {
namespace {

using tests::refusal_of;

// A command line: arguments and options with blanks between them, `NAME` or `NAME=VALUE`.
CommandLine line_of(Commands command, std::string_view text) {
    CommandLine line{command, {}};
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(text.size(), word.size() + 1));
        const std::size_t equals = std::min(word.find('='), word.size());
        const Option* const option = find_option(command, word.substr(0, equals));
        EXPECT_NE(option, nullptr) << word;
        if (option == nullptr) continue;
        line.given.push_back({option->name, {}});
        if (option->kind != Kind::flag)
            line.given.back().values.emplace_back(word.substr(std::min(equals + 1, word.size())));
    }
    return line;
}

TEST(PairsOfOptions, AreRefusedWithTheReason) {
    struct Case {
        Commands command;
        std::string given;
        std::string told;  // how the message begins; empty: the line is accepted
    };
    const std::vector<Case> cases{
        {kSample, "invert", "invert without --field: says how"},
        {kSample, "gamma=1", "gamma 1 without --field: says how"},
        {kSample, "field=a.png gamma=1", ""},
        {kSample, "scale=1", "scale 1 without --field, --ellipses or --stretch: "},
        {kSample, "scale=1 stretch=1:2@0", ""},
        {kSample, "field=a.png ellipses=b.npy", "field a.png with --ellipses: "},
        {kSample, "stretch=1:2@0 ellipses=b.npy", "stretch 1:2@0 with --ellipses: "},
        {kSample, "ellipse-columns", "ellipse-columns without --ellipses, --stretch or --along: "},
        {kSample, "field=a.png along=1 ellipse-columns", "ellipse-columns without "},
        {kStipple, "IMAGE=a.png along=4 ellipse-columns", ""},
        {kStipple, "IMAGE=a.png ellipse-columns", "ellipse-columns without --along: "},
        {kSample, "between=sum", "between sum without --class: "},
        {kSample, "radius=1 class=a:1", "radius 1 with --class: "},
        {kVerify, "radius=1 class=a:1", ""},
        {kVerify, "radius=1 field=a.png", "radius 1 with --field: "},
        {kVerify, "edge=1", "edge 1 without --inside, --outside, --avoid or --near: "},
        {kSample, "mask=a.png avoid=b.csv", "mask a.png with --avoid: "},
        {kSample, "on-pixels=9x9 count=5 mask=a.png field=a.png torus relax=0 border=0", ""},
        {kSample, "on-pixels=9x9 radius=1", "on-pixels 9x9 with --radius: its samples keep no"},
        {kSample, "on-pixels=9x9 mode=lines", "on-pixels 9x9 with --mode: "},
        {kSample, "on-pixels=9x9 relax=2", "on-pixels 9x9 with --relax: they move points"},
        {kSample, "on-pixels=9x9 keep=a.csv", "on-pixels 9x9 with --keep: "},
        {kSample, "on-pixels=9x9 count=5 inside-by-radius", "inside-by-radius with --on-pixels: "},
        {kSample, "on-pixels=9x9 dpi=9", "on-pixels 9x9 with --dpi: a sample is a pixel"},
        {kSample, "on-pixels=9x9 backend=auto threads=0", ""},
        {kSample, "on-pixels=9x9 backend=cpu", "on-pixels 9x9 with --backend: one thread of the"},
        {kSample, "on-pixels=9x9 device=1", "on-pixels 9x9 with --device: one thread of the cpu"},
        {kSample, "on-pixels=9x9 threads=2", "on-pixels 9x9 with --threads: one thread of the"},
        {kSample, "relax=3 mask=a.png", "relax 3 with --mask: "},
        {kSample, "relax=0 mask=a.png border=0.1", ""},
        {kSample, "relax=3 border=0", ""},
        {kSample, "gaussian=9 border=0.1", "gaussian 9 with --border: "},
        {kSample, "relax=3 class=a:1", "relax 3 with --class: it keeps no distances"},
        {kSample, "relax=2 stretch=1:2@0", "relax 2 with --stretch: relaxing has disks"},
        {kSample, "seeds=0..3 relax=2", "relax 2 with --seeds: "},
        {kSample, "seeds=0..3 seed=2", "seeds 0..3 with --seed: "},
        {kSample, "frame=0.1 seeds=0..3 torus radius=0.05", ""},
        {kSample, "frame=0.1 torus", "frame 0.1 without --seeds: "},
        {kSample, "frame=0.1 seeds=0..3", "frame 0.1 without --torus: "},
        {kSample, "frame=0.1 seeds=0..3 torus count=9", "frame 0.1 with --count: tiles are "},
        {kSample, "frame=0.1 seeds=0..3 torus keep=a.csv", "frame 0.1 with --keep: "},
        {kSample, "frame=0.1 seeds=0..3 torus mode=lines", "frame 0.1 with --mode=lines: "},
        {kRelax, "gaussian-distance=1", "gaussian-distance 1 without --gaussian: "},
        {kRelax, "gaussian-distance=1 gaussian=0", "gaussian-distance 1 without --gaussian: "},
        {kStipple, "frames=*.png count=9 pen-path", ""},
        {kStipple, "frames=*.png IMAGE=a.png", "frames *.png with IMAGE: "},
        {kStipple, "frames=*.png inks=cmyk", "frames *.png with --inks: "},
        {kStipple, "frames=*.png report=a.json", "frames *.png with --report: "},
        {kStipple, "IMAGE=a.png pens=1mm dot-size=1mm", "pens 1mm with --dot-size: "},
        {kStipple, "IMAGE=a.png pens=1mm along=3", "pens 1mm with --along: strokes are of one pen"},
        {kStipple, "IMAGE=a.png no-pen-path pens=1mm", ""},
        {kStipple, "IMAGE=a.png no-pen-path pen-path", "no-pen-path with --pen-path: dots then"},
        {kStipple, "IMAGE=a.png no-pen-path plot-time=1h", "no-pen-path with --plot-time: "},
        {kStipple, "IMAGE=a.png path-line along=3", "path-line with --along: "},
        {kStipple, "IMAGE=a.png seconds-per-dot=1", "seconds-per-dot 1 without --dot-size, "},
        {kStipple, "IMAGE=a.png seconds-per-metre-up=1 seconds-per-corner=0 pen-path", ""},
        {kStipple, "IMAGE=a.png seconds-per-metre-down=1 seconds-per-dot=1 path-line", ""},
        {kStipple, "IMAGE=a.png plot-time=1h scale=1", "plot-time 1h with --scale: "},
        {kOrder, "margin=1cm", "margin 1cm without --paper-size: "},
        {kOrder, "margin=0mm", ""},
        {kVerify, "tolerance=1 distances-only", "tolerance 1 with --distances-only: "},
        {kAnalyze, "json format=svg", "json with --format: "},
        {kCompare, "invert", "invert without IMAGE: is for pictures only"},
        {kCompare, "mode=cells", "mode cells without IMAGE: is for pictures only"},
        {kCompare, "IMAGE=a.png mode=cells", ""},
        {kCompare, "IMAGE=a.png mode=lines", "mode lines with IMAGE: "},
        {kCompare, "IMAGE=a.png domain=1x1", "domain 1x1 with IMAGE: "},
    };
    for (const Case& one : cases) {
        const std::string told = refusal_of([&] { refuse_pairs(line_of(one.command, one.given)); });
        const std::string expected = one.told.empty() ? "accepted" : one.told;
        EXPECT_EQ(told.substr(0, expected.size()), expected) << one.given;
    }
}

TEST(TheTableOfOptions, HasOneRowForEachOptionOfACommand) {
    for (const Commands command : {kSample, kStipple, kRelax, kOrder, kVerify, kAnalyze, kCompare,
                                   kReproduce, kDevices, kMpiSample, kMask})
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
}  // namespace lacuna::recipes
