// The options of `lacuna mask`, and its run.
#include "cli/commands/commands.h"

#include <fmt/format.h>
#include <lacuna/threshold_mask.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/number_text.h"
#include "cli/options/bind.h"
#include "cli/options/common_options.h"
#include "cli/options/frames.h"
#include "cli/reports/output.h"
#include "cli/terminal/interruption.h"
#include "cli/terminal/run_program.h"
#include "drawing/png.h"
#include "options/read.h"

namespace lacuna::cli {
namespace {

constexpr const char* kMaskDescription =
    R"(Makes a tile of thresholds for dithering, by void and cluster.

Examples:
  lacuna mask 64x64 -o mask.png                  16 bits a pixel
  lacuna mask 128x128 --bits 8 --seed 3 -o mask.png
  lacuna mask 64x64 --frames 16 -o 'mask{frame}.png'   for a film: even in space and in time

Each pixel has its rank, in proportion to the largest number that it can hold. For every level the
pixels under it are spread evenly, also across the tile's edges. Compare a picture with the tile,
repeated: white where the picture's number is greater than the tile's, and black elsewhere. So it
becomes black and white with the noise at high frequencies. The tile's numbers are at most 254 (with
16 bits 65534), so that white stays white, and black is black. 64 x 64 pixels take
0.05 s; the time grows with the square of their number. --frames makes tiles of which each is spread
as evenly, and the values of each pixel vary as fast as they can from tile to tile: their mean over
a few frames is even, too. After the last tile comes the first one again.

Exit code: 0 done, 2 bad usage, 3 a file cannot be written, 130 interrupted.
)";

struct MaskCommand {
    std::string size;
    std::uint64_t seed = 0;
    std::optional<std::uint32_t> frames;
    std::uint32_t bits = 16;
    OutputOptions output;
    bool quiet = false;
};

// WIDTHxHEIGHT in pixels.
Raster sides_of(const std::string& text) {
    Raster sides;
    if (!options::parse_raster(text, sides))
        throw BadUsage("SIZE " + shown(text) + ": must be WIDTHxHEIGHT in pixels, such as 64x64");
    return sides;
}

// The ranks as numbers of `bits` bits. Each comes equally often, to within one, but for the
// largest, which never comes: a picture's white must be greater than all of them.
std::vector<std::uint16_t> numbers_of(const ThresholdMask& mask, unsigned bits) {
    const std::uint64_t white = (1U << bits) - 1;
    std::vector<std::uint16_t> numbers;
    numbers.reserve(mask.ranks.size());
    for (const std::uint32_t rank : mask.ranks)
        numbers.push_back(static_cast<std::uint16_t>(white * rank / mask.ranks.size()));
    return numbers;
}

// The bytes of a grey PNG.
std::string encoded(const Raster& sides, unsigned bits, std::span<const std::uint16_t> numbers) {
    return drawing::encode_png(
        {.columns = sides.columns, .rows = sides.rows, .bits = bits},
        [&](std::size_t y, std::span<std::uint8_t> bytes) {
            std::size_t at = 0;
            for (const std::uint16_t number : numbers.subspan(y * sides.columns, sides.columns)) {
                if (bits == 16) bytes[at++] = static_cast<std::uint8_t>(number >> 8U);
                bytes[at++] = static_cast<std::uint8_t>(number & 0xffU);
            }
        });
}

// The paths of all frames, with the frame's number in place of {frame}: first those of frame 0.
std::vector<std::string> paths_of_frames(const MaskCommand& options) {
    const std::vector<std::string>& paths = options.output.paths;
    if (!options.frames) {
        refuse_frame_in(paths);
        return paths;
    }
    constexpr std::uint32_t kMostFrames = 16384;  // of the smallest size
    const std::string frames = std::to_string(*options.frames);
    if (*options.frames > kMostFrames) throw BadRequest("frames", frames, "must be at most 16384");
    check_names_of_frames(frames, paths, "mask{frame}.png", "a file a tile");
    const std::uint32_t last = std::max(*options.frames, 1u) - 1;
    const std::size_t digits = std::to_string(last).size();
    std::vector<std::string> all;
    for (std::uint32_t frame = 0; frame <= last; ++frame)
        for (const std::string& path : paths)
            all.push_back(path_of_frame(path, fmt::format("{:0{}}", frame, digits)));
    return all;
}

// A message names the argument as --help does.
ThresholdMask made(const Raster& sides, const MaskCommand& options) {
    try {
        return threshold_mask(sides.columns, sides.rows, options.seed, options.frames.value_or(1));
    } catch (const BadRequest& error) {
        if (error.option() != "size") throw;
        throw BadUsage("SIZE " + error.value() + ": " + error.reason());
    }
}

void run(const CommandLine& line, const MaskCommand& options) {
    const Raster sides = sides_of(options.size);
    if (options.bits != 8 && options.bits != 16)
        throw BadRequest("bits", std::to_string(options.bits), "must be 8 or 16");
    for (const std::string& path : options.output.paths)
        if (!path.ends_with(".png") && !is_stream(path))
            throw BadRequest("output", shown(path), "the extension must be .png");
    OutputOptions output = options.output;
    output.paths = paths_of_frames(options);
    const std::vector<Output> outputs = outputs_of(output, ".png", "png");
    check_given_files(files_read(line), given_files(outputs));
    Interruption interruption;
    const ThresholdMask mask = made(sides, options);
    const std::vector<std::uint16_t> numbers = numbers_of(mask, options.bits);
    const std::size_t pixels = numbers.size() / mask.frames;
    Writing writing(interruption);
    for (std::size_t i = 0; i < outputs.size(); ++i)
        writing.add(outputs[i].path, [&, frame = i * mask.frames / outputs.size()] {
            return encoded(sides, options.bits, std::span(numbers).subspan(frame * pixels, pixels));
        });
    writing.write();
    if (options.quiet || has_standard_output(outputs)) return;
    const std::string of_frames =
        options.frames ? fmt::format(" in {} frame{}", mask.frames, mask.frames == 1 ? "" : "s")
                       : "";
    print_last(fmt::format("{} thresholds of {} bits{} -> {}", numbers.size(), options.bits,
                           of_frames, fmt::join(options.output.paths, ", ")));
}

// Where the value of each option goes.
Targets targets_of(MaskCommand& all) {
    Targets targets{{"SIZE", &all.size},
                    {"seed", &all.seed},
                    {"frames", &all.frames},
                    {"bits", &all.bits},
                    {"quiet", &all.quiet}};
    targets.merge(targets_of(all.output));
    return targets;
}

}  // namespace

void add_mask(CLI::App& app) {
    const auto all = std::make_shared<MaskCommand>();
    add_command(app, options::kMask, kMaskDescription, targets_of(*all),
                [all](const CommandLine& line) { run(line, *all); });
}

}  // namespace lacuna::cli
