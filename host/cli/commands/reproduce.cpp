// The options of `lacuna reproduce`, and its run.
#include "cli/commands/commands.h"

#include <fmt/core.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/options/bind.h"
#include "cli/options/common_options.h"
#include "cli/reports/output.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/progress_bar.h"
#include "cli/terminal/run_program.h"
#include "files/point_files.h"
#include "pictures/image.h"
#include "pictures/importance.h"
#include "reproduce/reproduce.h"

namespace lacuna::cli {
namespace {

constexpr const char* kReproduceDescription =
    R"(Makes the tables and figures of Kalantari & Sen (2011) again and compares their numbers.

Examples:
  lacuna reproduce table2                       numbers on standard output
  lacuna reproduce fig5 -o figures              fig5.json and fig5.svg in the folder figures too
  lacuna reproduce table1 --runs 5 --smallest-radius 0.005     in seconds, but less exact
  lacuna reproduce all --image raccoon.png -o figures          some minutes on two cores

WHAT is table1, table2, fig3, fig4, fig5, fig6, fig7, fig8, or all. Figure 7 stipples a
picture of your own, --image: the paper's are not free.

Each line has one number: the paper's value, the value made here, their difference, the band in
which the value must lie, and whether it does. Statements that the paper makes in words stand in
quotes, with the band in which they are true. Times depend on the machine and are not checked; all
other numbers are the same on every machine.

Exit code: 0 all numbers are within their bands, 1 one is not, 2 bad usage, 3 a file cannot be read
or written, 4 the system refuses threads, 130 interrupted (143 by SIGTERM).
)";

struct ReproduceCommand {
    std::vector<std::string> what;
    std::optional<std::string> folder;
    std::string image;
    std::optional<std::uint32_t> runs;
    std::optional<double> smallest_radius;
    bool quiet = false;
};

// A table or figure with its results.
struct MadeItem {
    const reproduce::Item& item;
    reproduce::Reproduction reproduction;

    std::string picture_name() const {
        return fmt::format("{}.{}", item.name,
                           reproduction.medium == files::Medium::svg ? "svg" : "png");
    }
    std::string data_name() const { return fmt::format("{}.json", item.name); }
};

// The items asked for, in the paper's order and without duplicates.
std::vector<const reproduce::Item*> chosen(const std::vector<std::string>& what) {
    std::vector<const reproduce::Item*> items;
    const auto is_asked = [&](std::string_view name) {
        return std::find(what.begin(), what.end(), name) != what.end();
    };
    for (const reproduce::Item& item : reproduce::items())
        if (is_asked(item.name) || is_asked("all")) items.push_back(&item);
    return items;
}

void check(const CommandLine& line, const ReproduceCommand& options,
           const std::vector<const reproduce::Item*>& items) {
    if (options.runs && *options.runs == 0) throw BadRequest("runs", "0", "must be at least 1");
    constexpr double kLargestRadius = 0.05;  // in the paper's tables
    const double smallest = options.smallest_radius.value_or(kLargestRadius);
    if (!(smallest > 0 && smallest <= kLargestRadius))
        throw BadRequest("smallest-radius", fmt::format("{}", smallest),
                         "must be over 0 and at most 0.05, the tables' largest");
    const auto needs_image = [](const reproduce::Item* item) { return item->needs_image; };
    const auto first = std::find_if(items.begin(), items.end(), needs_image);
    if (first != items.end() && options.image.empty())
        throw BadRequest("image", "missing",
                         fmt::format("{} stipples a picture: give one, such as --image FILE.png",
                                     (*first)->name));
    if (!options.folder) return;
    // Checked before the work starts, so that an error does not cost minutes.
    std::error_code error;
    std::filesystem::create_directories(*options.folder, error);
    if (error)
        throw files::FileError(
            fmt::format("{}: cannot be made: {}", *options.folder, error.message()));
    std::vector<GivenFile> written;
    for (const reproduce::Item* item : items)
        for (const std::string_view extension : {"json", "svg", "png"}) {
            const std::filesystem::path folder = *options.folder;
            written.push_back(
                {"--output", (folder / fmt::format("{}.{}", item->name, extension)).string()});
            check_writable(written.back().path);
        }
    check_given_files(files_read(line), written);
}

std::vector<MadeItem> make(const std::vector<const reproduce::Item*>& items,
                           reproduce::Setting& setting, ProgressBar& bar) {
    std::vector<MadeItem> all;
    for (const reproduce::Item* item : items) {
        setting.keep_going = [&](double share) {
            bar.show(share, fmt::format("{} ({} of {})", item->name, all.size() + 1, items.size()));
            return true;
        };
        all.push_back({*item, item->make(setting)});
    }
    return all;
}

void add(Writing& writing, const std::vector<MadeItem>& all, const std::filesystem::path& folder) {
    for (const MadeItem& made : all) {
        writing.add((folder / made.data_name()).string(),
                    [&made] { return reproduce::json_of(made.item, made.reproduction); });
        writing.add((folder / made.picture_name()).string(),
                    [&made] { return made.reproduction.picture; });
    }
}

void run(const CommandLine& line, const ReproduceCommand& options) {
    const auto items = chosen(options.what);
    check(line, options, items);
    std::optional<Field> image;
    if (!options.image.empty())
        image = pictures::importance_of(
            pictures::read_image(options.image, pictures::kLargestAspect), {});
    reproduce::Setting setting{options.runs, options.smallest_radius, image ? &*image : nullptr};
    Interruption interruption;
    std::vector<MadeItem> all;
    {
        ProgressBar bar(options.quiet);
        all = make(items, setting, bar);
    }
    Writing writing(interruption);
    if (options.folder) add(writing, all, *options.folder);
    std::string lines;
    bool all_within = true;
    for (const MadeItem& made : all) {
        for (const reproduce::Number& number : made.reproduction.numbers)
            lines += reproduce::line_of(made.item.name, number) + "\n";
        all_within = all_within && reproduce::all_within(made.reproduction.numbers);
    }
    writing.add("-", [&] { return lines; });
    writing.write();
    if (!all_within) throw CheckFailed();
}

void take_folder(const std::string& text, std::optional<std::string>& folder) {
    folder = text;
}

// Where the value of each option goes.
Targets targets_of(ReproduceCommand& all) {
    return {
        {"WHAT", &all.what}, {"output", take_by<take_folder>(all.folder)}, {"image", &all.image},
        {"runs", &all.runs}, {"smallest-radius", &all.smallest_radius},    {"quiet", &all.quiet}};
}

}  // namespace

void add_reproduce(CLI::App& app) {
    const auto all = std::make_shared<ReproduceCommand>();
    add_command(app, options::kReproduce, kReproduceDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
