// Draws a comparison: a bar for each entry, divided into its verbs.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "cli/reports/comparison.h"
#include "drawing/canvas.h"
#include "drawing/plot.h"

namespace lacuna::cli {
namespace {

using drawing::Anchor;
using drawing::Canvas;
using drawing::Rectangle;

// The verbs' colours. The last is for time outside of all verbs.
constexpr std::array<Colour, kVerbs.size()> kColours{
    drawing::kBlue,      drawing::kSky,    drawing::kGreen,      drawing::kOrange,
    drawing::kVermilion, drawing::kPurple, Colour{150, 150, 150}};
constexpr double kWidth = 640;
constexpr double kLeft = 150;
constexpr double kRight = 90;
constexpr double kTop = 64;
constexpr double kBarHeight = 22;
constexpr double kBetween = 14;
constexpr double kBottom = 40;

// The verbs' parts of the median. The last entry, first use, is replaced by the time outside of all
// verbs. A device that waits for each verb takes longer: the verbs then share the median.
std::array<double, kVerbs.size()> parts_of(const Entry& entry) {
    std::array<double, kVerbs.size()> parts = entry.verb_seconds;
    parts.back() = 0;
    const double verbs = std::accumulate(parts.begin(), parts.end(), 0.0);
    const double all = entry.median_seconds();
    if (verbs > all)
        for (double& part : parts) part *= all / verbs;
    parts.back() = std::max(0.0, all - verbs);
    return parts;
}

void fill(Canvas& canvas, const Rectangle& box, Colour colour) {
    const double y = box.top + box.height / 2;
    const std::array<drawing::Position, 2> ends{{{box.left, y}, {box.right(), y}}};
    canvas.line(ends, {colour, box.height}, box);
}

class Chart {
public:
    Chart(Canvas& canvas, const std::vector<const Entry*>& entries)
        : canvas_(canvas), entries_(entries) {
        for (const Entry* entry : entries)
            longest_ =
                std::max(longest_, *std::max_element(entry->seconds.begin(), entry->seconds.end()));
    }

    void draw() {
        draw_legend();
        draw_axis();
        for (std::size_t i = 0; i < entries_.size(); ++i)
            draw_bar(*entries_[i],
                     kTop + kBetween + static_cast<double>(i) * (kBarHeight + kBetween));
    }

private:
    double x_of(double seconds) const {
        return kLeft + seconds / longest_ * (kWidth - kLeft - kRight);
    }

    void draw_legend() {
        double x = kLeft;
        for (std::size_t i = 0; i < kVerbs.size(); ++i) {
            fill(canvas_, {x, 40, 10, 10}, kColours[i]);
            const std::string name =
                i + 1 < kVerbs.size() ? std::string(lacuna::name_of(kVerbs[i])) : "other";
            canvas_.text({x + 14, 49}, name, {10});
            x += 26 + 5.5 * static_cast<double>(name.size());
        }
        canvas_.text({kLeft, 24},
                     "Milliseconds a set, without first use: median, and least to most",
                     {12, Anchor::start, {0, 0, 0}, true});
    }

    void draw_axis() {
        const double bottom =
            kTop + kBetween + static_cast<double>(entries_.size()) * (kBarHeight + kBetween);
        for (const double tick : drawing::ticks_of(0, 1e3 * longest_, 6)) {
            const double x = x_of(tick / 1e3);
            const std::array<drawing::Position, 2> line{{{x, kTop}, {x, bottom}}};
            canvas_.line(line, {{220, 220, 220}, 0.75}, {0, 0, kWidth, bottom + kBottom});
            canvas_.text({x, bottom + 14}, fmt::format("{:g}", tick), {10, Anchor::middle});
        }
    }

    void draw_bar(const Entry& entry, double top) {
        const auto parts = parts_of(entry);
        double done = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const double left = x_of(done);
            done += parts[i];
            fill(canvas_, {left, top, x_of(done) - left, kBarHeight}, kColours[i]);
        }
        const double middle = top + kBarHeight / 2;
        const auto [least, most] = std::minmax_element(entry.seconds.begin(), entry.seconds.end());
        const std::array<drawing::Position, 2> spread{
            {{x_of(*least), middle}, {x_of(*most), middle}}};
        canvas_.line(spread, {{0, 0, 0}, 1.5}, {0, 0, kWidth, middle + kBarHeight});
        const std::string name =
            entry.contestant.device.empty()
                ? entry.contestant.backend
                : fmt::format("{} {}", entry.contestant.backend, entry.contestant.device);
        canvas_.text({kLeft - 8, middle + 4}, name, {12, Anchor::end});
        canvas_.text({std::max(x_of(*most), x_of(done)) + 6, middle + 4},
                     fmt::format("{:.3g}{}", 1e3 * entry.median_seconds(),
                                 entry.difference  ? ", NOT the same points"
                                 : entry.broke_off ? ", then failed"
                                                   : ""),
                     {11});
    }

    Canvas& canvas_;
    const std::vector<const Entry*>& entries_;
    double longest_ = 1e-9;
};

}  // namespace

std::string draw_chart(const Comparison& comparison, files::Medium medium) {
    std::vector<const Entry*> entries;
    for (const Entry& entry : comparison.entries)
        if (entry.has_run()) entries.push_back(&entry);
    const double height =
        kTop + kBetween + static_cast<double>(entries.size()) * (kBarHeight + kBetween) + kBottom;
    const auto canvas = drawing::make_canvas(medium, kWidth, height);
    Chart(*canvas, entries).draw();
    return canvas->finish();
}

}  // namespace lacuna::cli
