// Given files that lead to one another, no command overwrites what it was given.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::test;
namespace fs = std::filesystem;

constexpr const char* kOther = "must be another file than ";

const std::string kPicture = pgm(2, 2, std::string(4, '\x40'));
// As points they are far enough apart, and as a polygon they have an inside.
const std::string kPoints = "0.1 0.1\n0.9 0.1\n0.5 0.9\n";

// A command that would overwrite `given`. In its words, F/ stands for a folder.
void expect_refused(const Words& words, const std::string& told, const std::string& given) {
    const Folder folder;
    const std::string content = given.ends_with(".txt") ? kPoints : kPicture;
    fs::create_directory(folder.path("figs"));
    write_file(folder.path(given), content);
    const Words names = folder.names();
    Words in_folder;
    for (const std::string& word : words)
        in_folder.push_back(word.starts_with("F/") ? folder.path(word.substr(2)) : word);
    const Outcome outcome = run(in_folder);
    expect_one_error(outcome, 2, {told, kOther});
    EXPECT_EQ(content_of(folder.path(given)), content) << told;
    EXPECT_EQ(folder.names(), names) << told;
}

// Sets of radius 0.3, with the further options `more`.
Words sets_of(const std::string& seeds, const Words& more) {
    Words words{"sample", "--radius", "0.3", "--seeds", seeds};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(NoFile, ThatIsReadIsOverwritten) {
    expect_refused({"compare", "F/p.png", "--count", "9", "-o", "F/p.png"}, "--output ", "p.png");
    expect_refused({"compare", "F/p.json", "--count", "9", "--json", "F/p.json"}, "--json ",
                   "p.json");
    expect_refused({"stipple", "F/p.json", "--count", "9", "-o", "F/a.svg", "--report", "F/p.json"},
                   "--report ", "p.json");
    expect_refused({"stipple", "F/p.png", "--count", "9", "-o", "F/figs/../p.png"}, "--output ",
                   "p.png");
    expect_refused(
        {"reproduce", "fig7", "--runs", "1", "--image", "F/figs/fig7.json", "-o", "F/figs"},
        "--output ", "figs/fig7.json");
    expect_refused({"relax", "F/a.txt", "-o", "F/a.txt"}, "than POINTS ", "a.txt");
    expect_refused({"relax", "F/none.txt", "F/p.png", "-o", "F/p.png"}, "than IMAGE ", "p.png");
    expect_refused({"analyze", "F/a.txt", "-o", "F/a.txt", "--format", "json"}, "than FILE ",
                   "a.txt");
}

TEST(NoFile, ThatIsReadIsOverwrittenByTheSetOfAnySeed) {
    const std::string txt = "F/{seed}.txt";
    const std::string png = "F/{seed}.png";
    expect_refused(sets_of("2..4", {"--keep", "F/3.txt", "-o", txt}), "3.txt (seed 3)", "3.txt");
    expect_refused(sets_of("2..4", {"--inside", "F/4.txt", "-o", txt}), "than --inside ", "4.txt");
    expect_refused(sets_of("2..4", {"--mask", "F/3.png", "-o", png}), "than --mask ", "3.png");
    expect_refused({"sample", "--scale", "0.2", "--field", "F/3.png", "--seeds", "2..4", "-o", png},
                   "than --field ", "3.png");
    expect_refused(sets_of("2..4", {"--keep", "F/3.txt", "-o", "F/figs/../{seed}.txt"}),
                   "than --keep ", "3.txt");
}

TEST(NoFile, OfASeedIsThatOfAnotherOrTheReport) {
    expect_refused(sets_of("0..2", {"-o", "F/{seed}.json", "--report", "F/1.json"}), "--report ",
                   "p.png");
    expect_refused(sets_of("1..11", {"-o", "F/a{seed}1.txt", "-o", "F/a{seed}.txt"}),
                   "a11.txt (seed 11)", "a11.txt");
    // Comparing all pairs of names would take minutes.
    expect_refused(sets_of("0..99999", {"-o", "F/{seed}.json", "--report", "F/99999.json"}),
                   "99999.json (seed 99999)", "p.png");
}

TEST(NoFile, OfAnySeedIsOverwrittenThroughALink) {
    const Folder folder;
    write_file(folder.path("kept.txt"), kPoints);
    fs::create_symlink("kept.txt", folder.path("3.txt"));
    fs::create_hard_link(folder.path("kept.txt"), folder.path("13.txt"));
    fs::create_symlink("22.txt", folder.path("21.txt"));  // dangling
    fs::create_directory_symlink(".", folder.path("31"));
    fs::create_directory_symlink(".", folder.path("32"));
    const Words names = folder.names();
    const auto expect = [&](const std::string& seeds, const std::string& output,
                            const std::string& told) {
        const Outcome outcome = run(sets_of(
            seeds, {"--keep", folder.path("kept.txt"), "--quiet", "-o", folder.path(output)}));
        expect_one_error(outcome, 2, {"--output ", kOther, told});
    };
    expect("2..4", "{seed}.txt", "3.txt (seed 3)");
    expect("12..14", "{seed}.txt", "13.txt (seed 13)");
    expect("21..22", "{seed}.txt", "21.txt (seed 21)");
    expect("31..32", "{seed}/a.txt", "31/a.txt (seed 31)");
    EXPECT_EQ(content_of(folder.path("kept.txt")), kPoints);
    EXPECT_EQ(folder.names(), names);
}

TEST(NoFile, ThatIsWrittenIsOverwrittenThroughALink) {
    const Folder folder;
    fs::create_symlink("a.json", folder.path("link.json"));  // dangling
    const Words sample{"sample", "--radius", "0.2"};
    const auto with = [&](Words more) {
        more.insert(more.begin(), sample.begin(), sample.end());
        return run(more);
    };
    expect_one_error(with({"-o", folder.path("a.json"), "--report", folder.path("link.json")}), 2,
                     {"--report ", kOther, "--output "});
    expect_one_error(with({"-o", folder.path("link.json"), "-o", folder.path("a.json")}), 2,
                     {"--output ", kOther});
    fs::create_directory_symlink(folder.path("."), folder.path("here"));
    expect_one_error(with({"-o", folder.path("b.txt"), "-o", folder.path("here/b.txt")}), 2,
                     {"--output ", kOther});
    EXPECT_EQ(folder.names(), (Words{"here", "link.json"}));
}

TEST(NoFile, BehindStandardInputOrOutputIsOverwritten) {
    const Folder folder;
    write_file(folder.path("p.png"), kPicture);
    Setting shell;
    shell.program = "/bin/sh";
    const std::string lacuna = "cd " + folder.path(".") + " && exec " LACUNA_PROGRAM " ";
    expect_one_error(run({"-c", lacuna + "stipple - --count 9 -o p.png < p.png"}, shell), 2,
                     {"--output p.png: must be another file than IMAGE -"});
    EXPECT_EQ(content_of(folder.path("p.png")), kPicture);
    expect_one_error(run({"-c", lacuna + "sample --radius 0.3 --report a.json > a.json"}, shell), 2,
                     {"--report a.json: must be another file than --output -"});
    write_file(folder.path("3.txt"), kPoints);
    expect_one_error(
        run({"-c", lacuna + "sample --radius 0.3 --keep - --seeds 2..4 -o {seed}.txt < 3.txt"},
            shell),
        2, {"--output 3.txt (seed 3): must be another file than --keep -"});
    EXPECT_EQ(content_of(folder.path("3.txt")), kPoints);
    write_file(folder.path("a.txt"), "0.5 0.5\n");
    const Outcome outcome = run({"-c", lacuna + "relax a.txt >> a.txt"}, shell);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(kOther), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(folder.path("a.txt")), "0.5 0.5\n");
}

TEST(NullAndTerminals, MayBeNamedTwice) {
    const Words twice{"sample",    "--radius", "0.3",       "--quiet", "-o",
                      "/dev/null", "--report", "/dev/null", "-o",      "/dev/null"};
    EXPECT_EQ(run(twice).exit_code, 0);
    const Folder folder;
    for (const char* name : {"0.txt", "1.txt"}) fs::create_symlink("/dev/null", folder.path(name));
    EXPECT_EQ(run(sets_of("0..1", {"--quiet", "-o", folder.path("{seed}.txt")})).exit_code, 0);
    Setting null;
    null.stdout_fd = open("/dev/null", O_RDWR);
    EXPECT_EQ(run({"sample", "--radius", "0.3", "-o", "/dev/null", "-o", "-"}, null).exit_code, 0);
    close(null.stdout_fd);
}

}  // namespace
