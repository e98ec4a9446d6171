// lacuna.h refuses, or accepts, the rows of tests/refusals.txt in the command's words.
#include <gtest/gtest.h>
#include <lacuna.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>

namespace {

const std::string kPicture = "P2 3 2 255 64 64 64 64 64 64";
const double kPoints[] = {0.1, 0.1, 0.9, 0.1, 0.5, 0.9};

// What the call says of the options of a command line; its file is a picture, or points.
std::string refusal_of(const std::string& request) {
    const std::string command = request.substr(0, request.find(' '));
    const std::size_t begin = request.find(" --");
    const std::string text = begin == std::string::npos ? "" : request.substr(begin);
    const char* const options = text.c_str();
    if (command == "verify") {
        const int verdict = lacuna_verify(options, nullptr, kPoints, 3);
        return verdict == -1 ? lacuna_error() : "accepted";
    }
    const std::size_t domain = text.find("--domain ");
    const std::string sides = text.substr(std::min(domain, text.size()), 20);
    const bool has_depth = std::count(sides.begin(), sides.end(), 'x') == 2;
    lacuna_set* const set = has_depth             ? lacuna_sample_volume(options, nullptr, 0)
                            : command == "sample" ? lacuna_sample(options, nullptr)
                            : command == "stipple"
                                ? lacuna_stipple(options, kPicture.data(), kPicture.size())
                                : lacuna_relax(options, nullptr, kPoints, 3);
    const bool is_refused = set == nullptr;
    lacuna_free(set);
    return is_refused ? lacuna_error() : "accepted";
}

TEST(Refusals, AreInTheCommandsWords) {
    std::ifstream table(LACUNA_ROOT "tests/refusals.txt");
    int rows = 0;
    for (std::string line; std::getline(table, line);) {
        const std::size_t begin = line.find(' '), arrow = line.find(" => ");
        if (line.starts_with("#") || line.substr(0, begin).find('c') == std::string::npos) continue;
        const std::string request = line.substr(begin + 1, arrow - begin - 1);
        std::string message = line.substr(arrow + 4);
        if (message.starts_with("--")) message.erase(0, 2);
        const std::string told = refusal_of(request);
        const std::size_t varies = message.find("<...>");
        const bool agrees = varies == std::string::npos
                                ? told == message
                                : told.starts_with(message.substr(0, varies)) &&
                                      told.ends_with(message.substr(varies + 5));
        EXPECT_TRUE(agrees) << request << "\n  is refused: " << told
                            << "\n  instead of: " << message;
        ++rows;
    }
    EXPECT_GT(rows, 150);
}

// What an outline lacks, and calls that have no use for one.
TEST(Refusals, OfOutlinesNameTheirRole) {
    const std::size_t sizes[] = {3};
    const auto said = [&](lacuna_outline outline, const char* options, bool relaxes = false) {
        lacuna_given given{};
        given.outlines = &outline;
        given.outline_count = 1;
        lacuna_set* const set =
            relaxes ? lacuna_relax(options, &given, kPoints, 3) : lacuna_sample(options, &given);
        lacuna_free(set);
        return std::string(set == nullptr ? lacuna_error() : "accepted");
    };
    const lacuna_outline whole{kPoints, sizes, 1, "inside", 0, nullptr};
    lacuna_outline one = whole;
    EXPECT_EQ(said(one, "--radius 0.1"), "accepted");
    EXPECT_EQ(said(one, "", true),
              "outlines given: are not for relax, which moves points anywhere");
    EXPECT_EQ(said(one, "--count 50 --relax 3").substr(0, 6), "relax ");
    one.role = "beside";
    EXPECT_EQ(said(one, "--radius 0.1"),
              "outlines beside: the role must be inside, outside, avoid or near");
    one = whole, one.xy = nullptr;
    EXPECT_EQ(said(one, "--radius 0.1"), "inside NULL: must be 3 points");
    one = whole, one.of_class = "reeds";
    EXPECT_EQ(said(one, "--radius 0.1"), "inside reeds: is no class of this set");
}

}  // namespace
