// Draws the progress bar.
#include "cli/terminal/progress_bar.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "cli/terminal/interruption.h"

namespace lacuna::cli {
namespace {

constexpr std::chrono::milliseconds kBetweenDraws{50};
constexpr std::size_t kBarCells = 24;
constexpr std::string_view kGreen = "\x1b[32m", kPlain = "\x1b[0m", kClearLine = "\r\x1b[K";

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

// Whether escape sequences may be written, as the variable TERM says.
bool has_escapes() {
    return is_set("TERM") && std::string_view(std::getenv("TERM")) != "dumb";
}

std::size_t terminal_columns() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
    return size.ws_col;
}

// The last column stays free: some terminals wrap the line as soon as it is written.
std::size_t line_columns() {
    return terminal_columns() - 1;
}

// The time to go if the fraction `share` of the work took `seconds`. Empty at first.
std::string time_to_go(double share, double seconds) {
    constexpr double kLeastSeconds = 0.5;
    constexpr double kLeastShare = 0.02;
    if (seconds < kLeastSeconds || share < kLeastShare) return "";
    const double left = seconds / share * (1 - share);
    if (left < 90) return fmt::format(", about {:.0f} s to go", left);
    return left < 90 * 60 ? fmt::format(", about {:.0f} minutes to go", left / 60)
                          : fmt::format(", about {:.0f} hours to go", left / 3600);
}

void print(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

}  // namespace

std::string progress_line(const Progress& progress, double seconds, std::size_t columns,
                          bool colour) {
    const double expected =
        static_cast<double>(std::max<std::uint64_t>(progress.expected_points, 1));
    const double share = std::min(1.0, static_cast<double>(progress.points) / expected);
    if (progress.stage == Stage::pen_path)
        return fmt::format("a pen path through {} dots", progress.points).substr(0, columns);
    if (progress.stage == Stage::relaxing)
        return progress_line(
            share,
            fmt::format("relaxing, iteration {} of {}",
                        std::min(progress.rounds + 1, progress.all_rounds), progress.all_rounds),
            columns, colour);
    const double rate = seconds > 0 ? static_cast<double>(progress.points) / seconds : 0;
    const std::string numbers =
        fmt::format("{} of about {} points, {} rounds, {:.3g} points/s", progress.points,
                    progress.expected_points, progress.rounds, rate);
    return progress_line(share, numbers, columns, colour);
}

std::string progress_line(double done, const std::string& words, std::size_t columns, bool colour) {
    const double share = std::clamp(done, 0.0, 1.0);
    const std::string numbers = fmt::format("{:3.0f} %  {}", 100 * share, words);
    if (numbers.size() + kBarCells + 4 > columns) return numbers.substr(0, columns);

    const auto full = static_cast<std::size_t>(share * kBarCells);
    return fmt::format("[{}{:#<{}}{}{:.<{}}] {}", colour ? kGreen : "", "", full,
                       colour ? kPlain : "", "", kBarCells - full, numbers);
}

ProgressBar::ProgressBar(bool quiet, bool is_asked_for)
    : has_escapes_(has_escapes()),
      visible_(!quiet && (is_asked_for || (isatty(STDERR_FILENO) == 1 && has_escapes_))),
      colour_(has_escapes_ && !is_set("NO_COLOR")) {}

ProgressBar::~ProgressBar() {
    if (!drawn_) return;
    print(clearing());
    Interruption::clears_line(false);
}

bool ProgressBar::keep_going(const Progress& progress) {
    if (progress.stage != stage_) start_ = Clock::now();
    stage_ = progress.stage;
    if (!is_due()) return true;
    const double seconds = std::chrono::duration<double>(last_draw_ - start_).count();
    draw(progress_line(progress, seconds, line_columns(), colour_));
    return true;
}

void ProgressBar::show(double share, const std::string& words) {
    if (is_due()) draw(progress_line(share, words, line_columns(), colour_));
}

void ProgressBar::show_time_to_go(double share, const std::string& words) {
    if (!is_due()) return;
    const double seconds = std::chrono::duration<double>(last_draw_ - start_).count();
    draw(progress_line(share, words + time_to_go(share, seconds), line_columns(), colour_));
}

bool ProgressBar::is_due() {
    const Clock::time_point now = Clock::now();
    if (!visible_ || now - last_draw_ < kBetweenDraws) return false;
    last_draw_ = now;
    return true;
}

void ProgressBar::note(const std::string& what) {
    if (visible_) draw(what.substr(0, line_columns()));
}

void ProgressBar::draw(const std::string& line) {
    drawn_ = true;
    Interruption::clears_line(has_escapes_);
    print(clearing() + line);
}

std::string ProgressBar::clearing() const {
    if (has_escapes_) return std::string(kClearLine);
    return "\r" + std::string(line_columns(), ' ') + "\r";
}

}  // namespace lacuna::cli
