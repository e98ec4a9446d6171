// The progress bar: one line on a terminal's standard error, redrawn in place.
#pragma once

#include <lacuna/lacuna.h>
#include <chrono>
#include <cstddef>
#include <string>

namespace lacuna::cli {

// The line for a terminal of so many columns, never wider than that; no escape but for colour.
std::string progress_line(const Progress& progress, double seconds, std::size_t columns,
                          bool colour);

// The same for any work of which `share`, 0 to 1, is done; `words` stand beside the bar.
std::string progress_line(double share, const std::string& words, std::size_t columns, bool colour);

// Shows nothing when told to be quiet or, unless it is asked for, when standard error is no
// terminal. Clears its line when destroyed, so that errors and results start on a clean one.
class ProgressBar : public Observer {
public:
    explicit ProgressBar(bool quiet, bool is_asked_for = false);
    ~ProgressBar() override;
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    bool keep_going(const Progress& progress) override;

    // For work other than sampling.
    void show(double share, const std::string& words);
    // With a time to go, once one can be told: for work that goes on as it has gone so far.
    void show_time_to_go(double share, const std::string& words);
    // For work whose share is not known: words in place of the bar.
    void note(const std::string& what);

private:
    using Clock = std::chrono::steady_clock;

    // Whether it is time to draw again.
    bool is_due();
    void draw(const std::string& line);

    bool visible_;
    bool colour_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_draw_ = start_;
};

}  // namespace lacuna::cli
