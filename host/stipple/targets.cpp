// The targets of the options of stipple.
#include "options/targets.h"

#include "base/number_text.h"
#include "options/read.h"
#include "options/words.h"

namespace lacuna::options {
namespace {

void read_inks(const std::string& text, std::vector<Ink>& inks) {
    inks = inks_of(text);
}

void read_pen(const std::string& text, std::optional<Pens>& pens) {
    pens = read_pens("dot-size", text, false);
}

void read_pens_by_tone(const std::string& text, std::optional<Pens>& pens) {
    pens = read_pens("dot-size", text, true);
}

void read_colour(const std::string& text, Colour& colour) {
    colour = paper_of(text);
}

void read_widths(const std::string& text, std::optional<Pens>& pens) {
    pens = read_pens_there_are("pens", text);
}

void read_one_pen(const std::string& text, std::optional<double>& pen_mm) {
    pen_mm = read_length("pen", text, kLeastDot);
}

void read_style(const std::string& text, bool& circles) {
    if (!is_among(text, Words::dot_styles))
        throw BadRequest("dot-style", shown(text), "must be " + listed(Words::dot_styles));
    circles = text == "circle";
}

void read_sheet(const std::string& text, std::optional<Paper>& paper) {
    paper = read_paper("paper-size", text);
}

// The table of options has the paper before its margin.
void read_margin(const std::string& text, std::optional<Paper>& paper) {
    const double margin_mm = read_length("margin", text, 0);
    if (paper) paper->margin_mm = margin_mm;
}

void read_plot_time(const std::string& text, std::optional<double>& seconds) {
    seconds = read_time("plot-time", text);
}

void read_no_path(const std::string&, std::optional<bool>& pen_path) {
    pen_path = false;
}

void read_counts(const std::string& text, std::vector<std::uint64_t>& counts) {
    for (const std::string& part : parts_of_list(text))
        read("ink-counts", part, counts.emplace_back());
}

}  // namespace

Targets targets_of(std::optional<Pens>& pens, std::optional<Paper>& paper) {
    return {{"dot-size", take_by<read_pen>(pens)},
            {"paper-size", take_by<read_sheet>(paper)},
            {"margin", take_by<read_margin>(paper)}};
}

Targets targets_of(StippleOptions& options) {
    Targets targets{{"mode", &options.start},
                    {"metric", &options.metric},
                    {"relax", &options.relax},
                    {"inks", take_by<read_inks>(options.inks)},
                    {"black-ink", &options.black_ink},
                    {"paper-colour", take_by<read_colour>(options.paper_colour)},
                    {"ink-counts", take_by<read_counts>(options.ink_counts)},
                    {"dot-size", take_by<read_pens_by_tone>(options.pens)},
                    {"pens", take_by<read_widths>(options.pens)},
                    {"pen", take_by<read_one_pen>(options.pen_mm)},
                    {"dot-style", take_by<read_style>(options.circles)},
                    {"size-by-tone", &options.size_by_tone},
                    {"keep-inside", &options.keep_inside},
                    {"pen-path", &options.pen_path},
                    {"no-pen-path", take_by<read_no_path>(options.pen_path)},
                    {"path-line", &options.path_line},
                    {"plot-time", take_by<read_plot_time>(options.plot_seconds)},
                    {"seconds-per-dot", &options.plotter.seconds_per_dot},
                    {"seconds-per-metre-down", &options.plotter.seconds_per_metre_down},
                    {"seconds-per-metre-up", &options.plotter.seconds_per_metre_up},
                    {"seconds-per-corner", &options.plotter.seconds_per_corner}};
    targets.merge(targets_of(options.pens, options.paper));
    targets.merge(targets_of(options.request));
    targets.merge(targets_of(options.tone));
    return targets;
}

}  // namespace lacuna::options
