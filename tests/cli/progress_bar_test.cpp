// Given a terminal, the program shows a progress bar there and leaves no trace of it.
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "cli/pictures.h"
#include "expectations.h"
#include "program.h"

namespace {

using namespace lacuna::tests;

class Terminal {
public:
    explicit Terminal(unsigned short columns) {
        const winsize size{24, columns, 0, 0};
        if (openpty(&ours_, &theirs_, nullptr, nullptr, &size) != 0) ours_ = -1;
    }
    ~Terminal() {
        close(ours_);
        close(theirs_);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    bool exists() const { return ours_ >= 0; }
    int fd() const { return theirs_; }

    // The text that was written to the terminal since the last call.
    std::string text() const {
        std::string text;
        std::array<char, 4096> bytes{};
        for (pollfd ready{ours_, POLLIN, 0}; poll(&ready, 1, 0) > 0;) {
            const ssize_t got = read(ours_, bytes.data(), bytes.size());
            if (got <= 0) break;
            text.append(bytes.data(), static_cast<std::size_t>(got));
        }
        return text;
    }

private:
    int ours_ = -1;
    int theirs_ = -1;
};

// Long enough to be seen, short enough to be waited for, with small rounds only. In lines a small
// round is little work; in exact each round would refine all boxes.
const std::vector<std::string> kRun{"sample",    "--radius",  "0.003",  "--round-size", "4",
                                    "--backend", "reference", "--mode", "lines"};

std::string shown_by(const std::vector<std::string>& words, const Terminal& terminal,
                     std::map<std::string, std::string> environment) {
    Setting setting;
    setting.stderr_fd = terminal.fd();
    setting.environment = std::move(environment);
    setting.environment.emplace("TERM", "xterm");
    Program program(words, setting);
    std::string text;
    while (program.is_running()) {
        text += terminal.text();  // if nobody reads, the program waits when the buffer is full
        usleep(1000);
    }
    EXPECT_EQ(program.wait().exit_code, 0);
    return text + terminal.text();
}

std::string shown_on(const Terminal& terminal, const Words& more,
                     std::map<std::string, std::string> environment) {
    return shown_by(joined(kRun, more), terminal, std::move(environment));
}

TEST(ProgressBar, TellsPointsRoundsAndRateAndClearsItsLineAtTheEnd) {
    const Terminal terminal(120);
    if (!terminal.exists()) GTEST_SKIP() << "no terminals here";
    const std::string text = shown_on(terminal, {}, {{"NO_COLOR", ""}});
    EXPECT_TRUE(std::regex_search(
        text, std::regex(" [0-9]+ of about [0-9]+ points, [0-9]+ rounds, [0-9.e+]+ points/s")))
        << text;
    EXPECT_NE(text.find("\x1b[32m"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with("\r\x1b[K")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(ProgressBar, HasNoColourWhereNoColorIsSet) {
    const Terminal terminal(120);
    if (!terminal.exists()) GTEST_SKIP() << "no terminals here";
    const std::string text = shown_on(terminal, {}, {{"NO_COLOR", "1"}});
    EXPECT_NE(text.find("points/s"), std::string::npos) << text;
    EXPECT_FALSE(std::regex_search(text, std::regex("\x1b\\[[0-9]*m"))) << text;
}

TEST(ProgressBar, NeverWrapsOnANarrowTerminal) {
    const Terminal terminal(30);
    if (!terminal.exists()) GTEST_SKIP() << "no terminals here";
    const std::string text = shown_on(terminal, {}, {{"NO_COLOR", "1"}});
    EXPECT_NE(text.find(" of about "), std::string::npos) << text;
    const std::regex drawn("\r\x1b\\[K([^\r]*)");
    for (auto line = std::sregex_iterator(text.begin(), text.end(), drawn);
         line != std::sregex_iterator(); ++line)
        EXPECT_LT((*line)[1].length(), 30) << (*line)[1];
}

TEST(ProgressBar, IsNotShownWhenQuietNorOnADumbTerminal) {
    const Terminal terminal(120);
    if (!terminal.exists()) GTEST_SKIP() << "no terminals here";
    EXPECT_EQ(shown_on(terminal, {"--quiet"}, {}), "");
    EXPECT_EQ(shown_on(terminal, {}, {{"TERM", "dumb"}}), "");
    EXPECT_EQ(shown_on(terminal, {}, {{"TERM", ""}}), "");
}

TEST(Coordinates, OfAPictureFillNoTerminalUnlessTheyAreAskedFor) {
    const Terminal terminal(120);
    if (!terminal.exists()) GTEST_SKIP() << "no terminals here";
    Setting setting;
    setting.stdout_fd = terminal.fd();
    const Words dots{"stipple", kRaccoon, "--count", "3", "--quiet"};
    expect_one_error(run(dots, setting), 2, {"nothing says where the dots are to be written"});
    EXPECT_EQ(terminal.text(), "");
    expect_success(joined(dots, {"-o", "-"}), setting);
    expect_success({"sample", "--count", "3", "--quiet"}, setting);
    const std::string text = terminal.text();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 6) << text;
}

// A bar is drawn every 50 ms, and the time to go after some seconds: the work is made larger until
// it takes as long on this machine.
TEST(ProgressBar, TellsHowFarAnAnalysisIsHowLongItWillTakeAndClearsItsLineAtTheEnd) {
    const Terminal terminal(120);
    if (!terminal.exists()) GTEST_SKIP() << "no terminals here";
    const Folder folder;
    const std::string points = folder.path("a.npy");
    expect_success({"sample", "--count", "20000", "-o", points, "--quiet"});
    std::string text;
    const std::regex to_go("analysing 1 set, about [0-9]+ s to go");
    for (int frequency = 16; frequency <= 128 && !std::regex_search(text, to_go); frequency *= 2)
        text = shown_by(
            {"analyze", points, "--threads", "1", "--max-frequency", std::to_string(frequency)},
            terminal, {{"NO_COLOR", "1"}});
    EXPECT_TRUE(std::regex_search(text, to_go)) << text;
    EXPECT_TRUE(std::regex_search(text, std::regex(" [0-9]+ %  analysing 1 set"))) << text;
    EXPECT_TRUE(text.ends_with("\r\x1b[K")) << text;
    EXPECT_EQ(shown_by({"analyze", points, "--quiet"}, terminal, {}), "");
}

}  // namespace
