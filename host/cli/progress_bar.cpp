// Draws the progress bar.
#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace lacuna::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenDraws{50};
constexpr std::size_t kBarCells = 24;
constexpr std::string_view kGreen = "\x1b[32m", kPlain = "\x1b[0m", kClearLine = "\r\x1b[K";

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

bool is_capable_terminal() {
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) == 1 && terminal != nullptr &&
           std::string_view(terminal) != "dumb";
}

std::size_t terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

void show(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace

std::string progress_line(const Progress& progress, double seconds, std::size_t columns,
                          bool colour) {
    const double expected =
        static_cast<double>(std::max<std::uint64_t>(progress.expected_points, 1));
    const double share = std::min(1.0, static_cast<double>(progress.points) / expected);
    const double rate = seconds > 0 ? static_cast<double>(progress.points) / seconds : 0;
    const std::string numbers =
        fmt::format("{:3.0f} %  {} of about {} points, {} rounds, {:.3g} points/s", 100 * share,
                    progress.points, progress.expected_points, progress.rounds, rate);
    if (numbers.size() + kBarCells + 4 > columns) return numbers.substr(0, columns);

    const auto full = static_cast<std::size_t>(share * kBarCells);
    return fmt::format("[{}{:#<{}}{}{:.<{}}] {}", colour ? kGreen : "", "", full,
                       colour ? kPlain : "", "", kBarCells - full, numbers);
}

ProgressBar::ProgressBar(bool quiet)
    : visible_(!quiet && is_capable_terminal()), colour_(!is_set("NO_COLOR")) {}

ProgressBar::~ProgressBar() {
    if (drawn_) show(std::string(kClearLine));
}

bool ProgressBar::keep_going(const Progress& progress) {
    const Clock::time_point now = Clock::now();
    if (!visible_ || now - last_draw_ < kBetweenDraws) return true;
    last_draw_ = now;
    drawn_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    // The last column stays free: some terminals wrap as soon as it is written.
    const std::string line = progress_line(progress, seconds, terminal_columns() - 1, colour_);
    show(std::string(kClearLine) + line);
    return true;
}

}  // namespace lacuna::cli
