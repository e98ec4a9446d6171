// The command lines that are refused for their files, with exit code and message. Those that are
// refused for their options are in refusals_test.cpp.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "cli/pictures.h"
#include "cli/refusals.h"

namespace {

using namespace lacuna::tests;
namespace fs = std::filesystem;

constexpr const char* kOther = "must be another file than ";

const std::string kGrey = pgm(2, 2, std::string(4, '\x40'));
// As points they are far enough apart, and as a polygon they have an inside.
const std::string kPoints = "0.1 0.1\n0.9 0.1\n0.5 0.9\n";

TEST(Refused, OfStippleAreBadPictures) {
    const Files files{{"text.png", "hello\n"},
                      {"white.png", pgm(2, 1, bytes({255, 255}))},
                      {"black.pgm", pgm(1, 1, bytes({0}))}};
    const Refusals refusals{
        {"text.png --count 100", 3, "text.png", "begins with \"hello", "must be a picture"},
        {"white.png --count 100", 3, "white.png", "white all over"},
        {"none.png --count 100", 3, "none.png", "No such file"},
        // The most points for lattices of one step to the radius: 320 GB.
        {"black.pgm --count 5000000000 --lines-per-radius 1", 2,
         "--count 5000000000:", "needs about", "GB of memory, more than the"},
    };
    expect_refusals(files, "stipple -o a.svg --report a.json", refusals);
}

TEST(Refused, OfSampleAreFilesThatSayWherePointsMayLie) {
    const Files files{
        {"half.pgm", pgm(2, 1, bytes({255, 0}))},
        {"triangle.txt", "0 0\n1 0\n0 1\n"},
        {"line.txt", "0 0\n1 0\n"},
        {"outside.txt", "0.5 0.5\n2 0.5\n"},
        {"mesh.OBJ", "v 0 0 0\n"},
    };
    expect_refusals(files, "sample --inside triangle.txt -o a.npy",
                    {{"--radius 1e-8", 2, "--radius 1e-08: makes the least radius 1e-08"},
                     {"--on-pixels 4000000x1 --domain 1x1 --count 5", 2, "--edge 1.56",
                      " (by default a sixteenth of a pixel): must be at least 6e-08"},
                     {"--class a:1e-8", 2, "--class a: the least distance of two classes is 2e-08"},
                     {"--field raccoon.png --scale 1e-8", 2, "--scale 1e-08: makes the least"}});
    expect_refusals(files, "sample --class a:0.2 --class b:0.1 -o a.csv",
                    {{"--field a:raccoon.png", 2,
                      "lacuna: --field a:raccoon.png: must be FILE alone: a class has no field of "
                      "its own\n"},
                     {"--keep b:outside.txt", 2,
                      "lacuna: --keep b:outside.txt: must be FILE alone: its column class has each "
                      "point's class\n"}});
    const Refusals refusals{
        {"--inside mesh.OBJ", 2,
         "lacuna: --inside mesh.OBJ: is in space, but domains are flat: must end in .svg, .svgz, "
         ".geojson, .geojsonl, .json or .txt\n"},
        {"--inside triangle.txt --edge 1e-9", 2,
         "lacuna: --edge 1e-09: must be at least 6e-08, the longer side / 2^24"},
        {"--inside half.pgm", 2,
         "lacuna: --inside half.pgm: must end in .svg, .svgz, .geojson, .geojsonl, .json or "
         ".txt\n"},
        {"--inside line.txt", 3, "lacuna: line.txt:1: a ring of 2 points: must be at least 3\n"},
        {"--torus --keep outside.txt", 2,
         "lacuna: --keep point 1 at (2, 0.5): must lie in the domain, [0, 1) x [0, 1)\n"},
        {"--keep none.txt", 3, "lacuna: none.txt: No such file or directory\n"},
    };
    expect_refusals(files, "sample --radius 0.1 -o a.npy", refusals);
}

TEST(Refused, OfAnalyzeAreFilesThatCannotBeReadOrUsed) {
    const std::string domain = R"("height": 1, "points": [[0.5, 0.5]]})";
    const Files files{
        {"a.txt", "# nothing\n"},
        {"b.txt", "0.5 0.5\n1.5 0.5\n"},
        {"c.dat", "0.5 0.5\n#\n0.5 -0.5\n"},
        {"d.txt", "3\n0.5 0.5\n"},
        {"e.txt", "0.5 0.5\n#\n0.25 0.5\n"},
        {"f.gz", ""},
        {"g.png", ""},
        {"thin.json", R"({"width": 9999, )" + domain},
        {"klein.json", R"({"boundary": "klein", "points": [[0.5, 0.5]]})"},
        {"1x1.json", R"({"width": 1, )" + domain},
        {"2x1.json", R"({"width": 2, )" + domain},
        {"box.json", R"({"boundary": "box", "width": 2, )" + domain},
        {"torus.json", R"({"boundary": "torus", "width": 2, )" + domain},
        {"512.json", R"({"width": 512, "height": 512, "points": [[0.5, 0.5]]})"},
        {"points.csv", "0.1,0.1\n0.9,0.9\n"},
    };
    const Refusals refusals{
        {"missing.txt", 3, "missing.txt: No such file"},
        {"a.txt", 3, "a.txt: there is no point to analyse"},
        {"b.txt", 3,
         "b.txt: point 1 at (1.5, 0.5) lies outside the domain [0, 1] x [0, 1]: give --domain"},
        {"c.dat", 3, "c.dat: set 2: point 0 at (0.5, -0.5)"},
        {"d.txt", 3, "1 point: the first line says 3"},
        {"e.txt", 3, "e.txt:2: ", ".dat"},
        {"f.gz", 3, ".txt .csv .npy .ply .json .dat .rps"},
        {"g.png", 3, "a picture"},
        {"thin.json", 3, "thin.json: domain 9999x1: ", "1000 times"},
        {"klein.json", 3, "\"boundary\" is \"klein\"", "torus"},
        {"1x1.json 2x1.json", 3, "2x1.json: its domain is 2x1, but ", "has 1x1"},
        {"torus.json box.json", 3, "box.json: its boundary differs from", "--torus"},
        {"512.json points.csv", 3, "points.csv: gives no domain, but ", "512x512: give --domain"},
        {"- -", 3, "standard input", "only once"},
        {"points.csv -o no/b.json", 3, "no folder"},
    };
    expect_refusals(files, "analyze", refusals);
}

TEST(Refused, OfOtherCommandsAreFilesThatCannotBeReadOrUsed) {
    const Files files{
        {"a.txt", "0.25 0.25\n"},
        {"nan.txt", "0.5 0.5\n0.5 nan\n"},
        {"bad.npy", "no array\n"},
        {"outside.txt", "0.5 0.5\n0.25 1.5\n"},
        {"file", ""},
    };
    const Refusals refusals{
        {"verify missing.txt --radius 0.1", 3, "missing.txt: No such file"},
        {"verify nan.txt --radius 0.1", 3, "nan.txt:2: ", "finite"},
        {"verify bad.npy --radius 0.1", 3, "bad.npy: not a .npy file"},
        {"verify a.png --radius 0.1", 3, "a picture", ".npy"},
        {"verify a.gz --radius 0.1", 3, "the extension must be one of .txt .csv .npy"},
        {"verify a.txt --radius 1 --mask none.png", 3, "none.png"},
        {"compare none.png --count 10", 3, "none.png"},
        {"relax outside.txt --iterations 10001", 2, "--iterations 10001: ", "10000"},
        {"relax outside.txt", 3, "outside.txt: point ", "at (0.25, 1.5)", "must lie in the domain"},
        {"order outside.txt", 3, "outside.txt: point ", "at (0.25, 1.5)", "must lie in the domain"},
        {"relax none.txt", 3, "none.txt"},
        {"relax outside.txt --domain 1x2 --backend abacus", 2, "--backend abacus"},
        // Before the work starts.
        {"reproduce fig7 --image missing.png", 3, "missing.png: No such file"},
        {"reproduce table1 -o file/no", 3, "file/no", "cannot be made"},
        {"reproduce table1 -o file", 3, "file"},
    };
    expect_refusals(files, "", refusals);
}

// The work would last for minutes.
TEST(Refused, AreFilesThatCannotBeMadeBeforeTheWorkStarts) {
    const Refusals refusals{
        {"-o missing/a.txt", 3, "missing/a.txt"},
        {"-o file/a.txt", 3, "file/a.txt"},
        {"-o folder.txt", 3, "folder.txt"},
        {"--report missing/a.json", 3, "missing"},
    };
    expect_refusals({{"file", ""}, {"folder.txt/a", ""}},
                    "sample --radius 0.0005 --backend reference --round-size 64 --mode lines",
                    refusals);
}

TEST(Refused, IsToOverwriteAFileThatIsRead) {
    const Files files{
        {"a.txt", kPoints},
        {"a.json", R"({"points": [[0.5, 0.5]]})"},
        {"p.png", kGrey},
        {"p.json", kGrey},
        {"figs/fig7.json", kGrey},
        {"map.svg", "<svg viewBox='0 0 9 9'><rect id='land' width='9' height='9'/></svg>"},
    };
    const Refusals refusals{
        {"compare p.png --count 9 -o p.png", 2, "--output ", kOther},
        {"compare p.json --count 9 --json p.json", 2, "--json ", kOther},
        {"stipple p.json --count 9 -o a.svg --report p.json", 2, "--report ", kOther},
        {"stipple p.png --count 9 -o figs/../p.png", 2, "--output ", kOther},
        {"stipple p.png --count 10 -o ./p.png", 2,
         "--output ./p.png: must be another file than IMAGE p.png"},
        {"stipple - --count 9 -o p.png < p.png", 2,
         "--output p.png: must be another file than IMAGE -"},
        {"reproduce fig7 --runs 1 --image figs/fig7.json -o figs", 2, "--output ", kOther},
        {"sample --inside map.svg#land --radius 1 -o map.svg", 2, "than --inside map.svg"},
        {"sample --avoid map.svg#land:1 --radius 1 -o map.svg", 2, "than --avoid map.svg"},
        {"relax a.txt -o a.txt", 2, "--output", kOther, "than POINTS "},
        {"relax none.txt p.png -o p.png", 2, "than IMAGE ", kOther},
        {"relax a.txt >> a.txt", 2, kOther},
        {"analyze a.txt -o a.txt --format json", 2, "than FILE ", kOther},
        {"analyze a.json -o a.json", 2, "must be another file than FILE a.json"},
    };
    expect_refusals(files, "", refusals);
}

TEST(Refused, IsToOverwriteAFileThatIsReadByTheSetOfAnySeed) {
    const Refusals refusals{
        {"--radius 0.3 --keep 3.txt -o {seed}.txt", 2, "3.txt (seed 3)", kOther},
        {"--radius 0.3 --inside 4.txt -o {seed}.txt", 2, "than --inside ", kOther},
        {"--radius 0.3 --mask 3.png -o {seed}.png", 2, "than --mask ", kOther},
        {"--scale 0.2 --field 3.png -o {seed}.png", 2, "than --field ", kOther},
        {"--radius 0.3 --keep 3.txt -o figs/../{seed}.txt", 2, "than --keep ", kOther},
        {"--radius 0.3 --keep - -o {seed}.txt < 3.txt", 2,
         "--output 3.txt (seed 3): must be another file than --keep -"},
    };
    const Files files{{"3.txt", kPoints}, {"4.txt", kPoints}, {"3.png", kGrey}, {"figs/a", ""}};
    expect_refusals(files, "sample --seeds 2..4", refusals);
}

TEST(Refused, IsToWriteAFileTwice) {
    const Refusals refusals{
        {"-o a.json --report ./a.json", 2, "--report ./a.json: must be another file"},
        {"-o c.svg -o ./c.svg", 2, "--output ", "must be another file than --output "},
        {"-o - -o /dev/stdout", 2, "--output /dev/stdout: must be another file than --output -"},
        {"--report -", 2, "--report -:", "another file than --output -"},
        {"--report b.json > b.json", 2, "--report b.json: must be another file than --output -"},
        {"--seeds 0..2 -o {seed}.json --report 1.json", 2, "--report ", kOther},
        {"--seeds 1..11 -o a{seed}1.txt -o a{seed}.txt", 2, "a11.txt (seed 11)", kOther},
        // Comparing all pairs of names would take minutes.
        {"--seeds 0..99999 -o {seed}.json --report 99999.json", 2, "99999.json (seed 99999)",
         kOther},
    };
    expect_refusals({{"a11.txt", kPoints}, {"b.json", ""}}, "sample --radius 0.3", refusals);
}

TEST(Refused, IsToOverwriteAFileThroughALink) {
    const Folder folder;
    write_file(folder.path("kept.txt"), kPoints);
    fs::create_symlink("kept.txt", folder.path("3.txt"));
    fs::create_hard_link(folder.path("kept.txt"), folder.path("13.txt"));
    fs::create_symlink("22.txt", folder.path("21.txt"));  // dangling
    fs::create_directory_symlink(".", folder.path("31"));
    fs::create_directory_symlink(".", folder.path("32"));
    fs::create_symlink("a.json", folder.path("link.json"));  // dangling
    const Refusals refusals{
        {"--seeds 2..4 --keep kept.txt -o {seed}.txt", 2, "--output ", kOther, "3.txt (seed 3)"},
        {"--seeds 12..14 --keep kept.txt -o {seed}.txt", 2, "--output ", kOther,
         "13.txt (seed 13)"},
        {"--seeds 21..22 --keep kept.txt -o {seed}.txt", 2, "--output ", kOther,
         "21.txt (seed 21)"},
        {"--seeds 31..32 --keep kept.txt -o {seed}/a.txt", 2, "--output ", kOther,
         "31/a.txt (seed 31)"},
        {"-o a.json --report link.json", 2, "--report ", kOther, "--output "},
        {"-o link.json -o a.json", 2, "--output ", kOther},
        {"-o b.txt -o 31/b.txt", 2, "--output ", kOther},
    };
    expect_refusals(folder, "sample --radius 0.3", refusals);
}

}  // namespace
