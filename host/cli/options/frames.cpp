// Finds the pictures of a sequence.
#include "cli/options/frames.h"

#include <fmt/core.h>
#include <glob.h>
#include <lacuna/errors.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string_view>

#include "base/number_text.h"
#include "cli/options/given_files.h"
#include "cli/reports/output.h"
#include "files/point_files.h"
#include "pictures/image.h"

namespace lacuna::cli {
namespace {

constexpr std::string_view kFrame = "{frame}";

// Removes a run of digits, or else one character. Zeros that begin the run are left out.
std::string_view take_piece(std::string_view& text) {
    const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
    std::string_view piece = text.substr(0, std::max<std::size_t>(digits, 1));
    text.remove_prefix(piece.size());
    while (piece.size() > 1 && piece.front() == '0') piece.remove_prefix(1);
    return piece;
}

// Whether a comes before b where runs of digits are numbers: 2.png before 10.png.
bool comes_before(std::string_view a, std::string_view b) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::string_view x = a, y = b;
    while (!x.empty() && !y.empty()) {
        const std::string_view of_x = take_piece(x), of_y = take_piece(y);
        if (is_digit(of_x[0]) && is_digit(of_y[0]) && of_x.size() != of_y.size())
            return of_x.size() < of_y.size();
        if (of_x != of_y) return of_x < of_y;
    }
    return x.empty() == y.empty() ? a < b : x.empty();
}

std::vector<std::string> files_like(const std::string& pattern) {
    glob_t found{};
    const std::unique_ptr<glob_t, decltype(&::globfree)> owner(&found, ::globfree);
    const int failure = ::glob(pattern.c_str(), 0, nullptr, &found);
    if (failure == GLOB_NOMATCH)
        throw BadRequest("frames", shown(pattern),
                         "must match pictures, as in 'in/*.png': no file is called like that");
    if (failure != 0) throw files::FileError(pattern + ": the folder cannot be read");
    std::vector<std::string> files(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    std::sort(files.begin(), files.end(), comes_before);
    return files;
}

void check_files(const std::vector<Frame>& frames) {
    std::vector<GivenFile> read, written;
    for (const Frame& frame : frames) {
        read.push_back({"--frames", frame.image});
        for (const std::string& path : frame.outputs) written.push_back({"--output", path});
    }
    check_given_files(read, written);
}

// Dots that move on keep their places in the domain, which has the picture's proportions.
void check_proportions(const std::vector<Frame>& frames) {
    std::uint64_t columns = 0, rows = 0;
    for (const Frame& frame : frames) {
        const pictures::Image image = pictures::read_image(frame.image);
        if (&frame == &frames.front()) {
            columns = image.columns;
            rows = image.rows;
        }
        if (columns * image.rows != rows * image.columns)
            throw BadRequest(
                "frames", shown(frame.image),
                fmt::format("{}x{} pixels: must have the proportions of {}, {}x{}", image.columns,
                            image.rows, shown(frames.front().image), columns, rows));
    }
}

}  // namespace

void check_names_of_frames(const std::string& value, const std::vector<std::string>& outputs,
                           const char* example, const char* each) {
    if (outputs.empty())
        throw BadRequest(
            "frames", value,
            fmt::format("needs an --output with {} in its name, such as '{}'", kFrame, example));
    for (const std::string& path : outputs)
        if (path.find(kFrame) == std::string::npos)
            throw BadRequest(
                "output", shown(path),
                fmt::format("must have {} in its name, for --frames: {}", kFrame, each));
}

void refuse_frame_in(const std::vector<std::string>& outputs) {
    refuse_place(outputs, kFrame, "--frames");
}

std::string path_of_frame(const std::string& path, const std::string& name) {
    return with_name(path, kFrame, name);
}

std::vector<Frame> frames_of(const std::string& pattern, const std::vector<std::string>& outputs) {
    check_names_of_frames(shown(pattern), outputs, "out/{frame}.svg", "a file a picture");
    std::vector<Frame> frames;
    std::map<std::string, std::string> images;  // by their names
    for (const std::string& image : files_like(pattern)) {
        const std::string name = std::filesystem::path(image).stem().string();
        const auto [other, is_new] = images.emplace(name, image);
        if (!is_new)
            throw BadRequest("frames", shown(pattern),
                             "must match one picture of each name, not " + shown(other->second) +
                                 " and " + shown(image));
        Frame& frame = frames.emplace_back(Frame{image, {}});
        for (const std::string& path : outputs) frame.outputs.push_back(path_of_frame(path, name));
    }
    check_files(frames);
    check_proportions(frames);
    return frames;
}

}  // namespace lacuna::cli
