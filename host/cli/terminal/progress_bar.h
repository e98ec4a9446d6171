// The progress bar: one line on standard error, redrawn in place, if that is a terminal.
#pragma once

#include <lacuna/lacuna.h>
#include <chrono>
#include <cstddef>
#include <string>

namespace lacuna::cli {

// The line, at most `columns` characters wide. It has no escape sequences but those for colour.
std::string progress_line(const Progress& progress, double seconds, std::size_t columns,
                          bool colour);

// The same for other work; `share` is the fraction done, 0 to 1. `words` are put beside the bar.
std::string progress_line(double share, const std::string& words, std::size_t columns, bool colour);

// Shows nothing if `quiet`, or if standard error is no terminal or a dumb one, unless
// `is_asked_for`; then a dumb one gets no escape sequences. Clears its line when destroyed, so that
// errors and results start on an empty line.
class ProgressBar : public Observer {
public:
    explicit ProgressBar(bool quiet, bool is_asked_for = false);
    ~ProgressBar() override;
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    bool keep_going(const Progress& progress) override;

    // For work other than sampling.
    void show(double share, const std::string& words);
    // The same with an estimate of the time to go, for work that advances at an even speed.
    void show_time_to_go(double share, const std::string& words);
    // For work whose progress is not known: shows words instead of the bar.
    void note(const std::string& what);

private:
    using Clock = std::chrono::steady_clock;

    // Whether it is time to draw again; if so, notes the time.
    bool is_due();
    void draw(const std::string& line);
    std::string clearing() const;  // what clears the line

    bool has_escapes_;
    bool visible_;
    bool colour_;
    bool drawn_ = false;
    Stage stage_ = Stage::sampling;
    Clock::time_point start_ = Clock::now();  // of the stage
    Clock::time_point last_draw_ = start_;
};

}  // namespace lacuna::cli
