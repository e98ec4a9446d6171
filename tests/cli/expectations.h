// Expectations of tests about the command's output.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace lacuna::tests {

using Words = std::vector<std::string>;

inline std::string line_of(const std::string& text, const std::string& label) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(label)) return line;
    return "no line " + label + " in: " + text;
}

inline void expect_has(const std::string& text, const Words& pieces) {
    for (const std::string& piece : pieces)
        EXPECT_NE(text.find(piece), std::string::npos) << piece << " in: " << text;
}

inline Words joined(Words first, const Words& then) {
    first.insert(first.end(), then.begin(), then.end());
    return first;
}

inline void expect_success(const Words& arguments, const Setting& setting = {}) {
    const Outcome outcome = run(arguments, setting);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

// The only output is one line on standard error.
inline void expect_one_error(const Outcome& outcome, int code, const Words& pieces) {
    EXPECT_EQ(outcome.exit_code, code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with("lacuna: ")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
    expect_has(outcome.err, pieces);
}

}  // namespace lacuna::tests
