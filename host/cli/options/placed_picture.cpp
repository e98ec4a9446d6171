// Where a picture lies in the plane: FILE@X0,Y0+WxH, or FILE@world with a world file.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "base/number_text.h"
#include "cli/options/domain_options.h"
#include "files/parse.h"
#include "files/point_files.h"
#include "files/read_whole.h"
#include "options/read.h"

namespace lacuna::cli {
namespace {

constexpr std::string_view kWorld = "world";

// The world file of map.png is map.pgw, and of a longer extension, map.jpgw or map.jgw.
std::string world_file_of(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    const std::string end = dot == std::string::npos ? "" : path.substr(dot + 1);
    if (end.size() < 3) return path + "w";
    return path.substr(0, dot + 1) + end.front() + end.back() + "w";
}

// Six numbers: the sides of a pixel in x and y, with two slopes between them, and the centre of the
// upper left pixel.
Domain extent_in_world_file(const std::string& path, const Raster& pixels) {
    const std::string name = files::name_of(path), content = files::read_whole(path);
    std::string_view text = content;
    std::array<double, 6> numbers{};
    for (double& number : numbers) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        if (files::take_number(text, number) != std::errc{} || !std::isfinite(number))
            files::refuse(name, "must be six finite numbers, as of a world file");
    }
    const auto [width, slope, other_slope, height, x, y] = numbers;
    if (slope != 0 || other_slope != 0 || !(width > 0) || !(height < 0))
        files::refuse(name, "its picture is turned or mirrored: must lie upright");
    return {.width = width * pixels.columns,
            .height = -height * pixels.rows,
            .x0 = x - width / 2,
            .y0 = y - height / 2 + height * pixels.rows};
}

}  // namespace

PlacedPicture placed_picture(const std::string& text) {
    const std::size_t at = text.rfind('@');
    if (at == std::string::npos) return {text, {}};
    const std::string place = text.substr(at + 1);
    // Other names of files may have an @, too, such as icon@2x.png.
    const bool is_rectangle = place.find(',') < place.rfind('+') &&
                              place.rfind('+') < place.rfind('x') &&
                              place.find_first_not_of("0123456789.,+-xXeE") == std::string::npos;
    if (place != kWorld && !is_rectangle) return {text, {}};
    return {text.substr(0, at), place};
}

std::optional<Domain> extent_of(const std::string& option, const PlacedPicture& picture,
                                const Raster& pixels) {
    if (!picture.place) return std::nullopt;
    if (*picture.place == kWorld) return extent_in_world_file(world_file_of(picture.path), pixels);
    Domain extent;
    options::read_domain(option, *picture.place, extent);
    return extent;
}

}  // namespace lacuna::cli
