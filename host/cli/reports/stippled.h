// What is said of a stippling: in the summary at the end, and in lines on standard error before it.
#pragma once

#include <lacuna/stipple.h>

#include <string>
#include <vector>

#include "cli/reports/output.h"
#include "drawing/picture.h"
#include "options/options.h"

namespace lacuna::cli {

using options::CommandLine;

// The dots of each layer, and whether the library has chosen their number.
std::string note_on_count(const StippleOptions& options, const Stippling& made);

// With a pen: the length of its path, and how long a plotter takes, in all and for each layer.
std::string plot_text(const StippleOptions& options, const files::PointSet& set,
                      const drawing::Style& style, const Stippling& made);

// Says that nearly all of a picture is black, where its levels were not thought of.
void warn_of_darkness(const CommandLine& line, const std::string& image, const Stippling& made);

// Says that dots have widths that no pen has, where an .svg of them is made for one.
void warn_of_widths(const drawing::Shown& shown, const Stippling& made,
                    const std::vector<Output>& outputs);

}  // namespace lacuna::cli
