// Finds the pictures of a sequence.
#include "cli/options/frames.h"

#include <glob.h>
#include <lacuna/errors.h>

#include <filesystem>
#include <memory>
#include <set>
#include <string_view>

#include "base/number_text.h"
#include "cli/reports/output.h"

namespace lacuna::cli {
namespace {

constexpr std::string_view kFrame = "{frame}";

}  // namespace

std::vector<Frame> frames_of(const std::string& pattern, const std::vector<std::string>& outputs) {
    for (const std::string& path : outputs)
        if (path.find(kFrame) == std::string::npos)
            throw BadRequest("output", shown(path),
                             "must have {frame} in its name, for --frames: a file a picture");
    glob_t found{};
    const std::unique_ptr<glob_t, decltype(&::globfree)> owner(&found, ::globfree);
    if (::glob(pattern.c_str(), 0, nullptr, &found) != 0)
        throw BadRequest("frames", shown(pattern),
                         "must match pictures, as in 'in/*.png': no file is called like that");
    std::vector<Frame> frames;
    std::set<std::string> names;
    for (std::size_t i = 0; i < found.gl_pathc; ++i) {
        const std::string image = found.gl_pathv[i];
        const std::string name = std::filesystem::path(image).stem().string();
        if (!names.insert(name).second)
            throw BadRequest("frames", shown(pattern),
                             "must match one picture of each name: two are called " + shown(name));
        Frame& frame = frames.emplace_back(Frame{image, {}});
        for (const std::string& path : outputs)
            frame.outputs.push_back(with_name(path, kFrame, name));
    }
    return frames;
}

}  // namespace lacuna::cli
