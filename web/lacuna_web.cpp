// Makes points from pixels or a request, as the command line does that is given.
#include "lacuna_web.h"

#include <lacuna/stipple.h>
#include <lacuna/version.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "analysis/radial.h"
#include "analysis/spectrum.h"
#include "base/number_text.h"
#include "drawing/picture_svg.h"
#include "files/point_files.h"
#include "options/make.h"
#include "options/settle.h"
#include "options/targets.h"
#include "pictures/image.h"
#include "pictures/importance.h"
#include "pictures/whole_samples.h"

namespace lacuna::files {

// Declared here, because the table of formats in host/files/formats.cpp needs cairo.
std::string encode_csv(const PointSet& set);
std::string encode_npy(const PointSet& set);

}  // namespace lacuna::files

namespace lacuna::web {
namespace {

// The progress bar moves evenly: an iteration of relax takes about a tenth of the time of placing.
class Teller : public Observer {
public:
    // `relax` is the number of iterations that follow.
    Teller(const Tell& tell, std::uint32_t relax) : tell_(tell), placing_(10.0 / (10.0 + relax)) {}

    bool keep_going(const Progress& progress) override {
        const double share = std::min(
            1.0, static_cast<double>(progress.points) /
                     static_cast<double>(std::max<std::uint64_t>(1, progress.expected_points)));
        tell_(progress.stage == Stage::sampling ? placing_ * share
                                                : placing_ + (1 - placing_) * share);
        return true;
    }

private:
    const Tell& tell_;
    double placing_;
};

// What host/pictures reads from a picture file with these bytes in its channels.
pictures::Image image_of(const Pixels& pixels, const pictures::Weights& weights,
                         pictures::Backdrop backdrop) {
    constexpr std::int32_t kWhite = 255;
    constexpr unsigned kChannels = 4;
    pictures::Image image{pixels.columns, pixels.rows, {}, 1, "the picture"};
    image.luminance.resize(std::size_t{pixels.columns} * pixels.rows);
    pictures::Reading reading;
    reading.weights = weights;
    reading.backdrop = backdrop;
    pictures::fill_row_from(pixels.rgba.data(), kChannels, false, image.luminance, kWhite, reading);
    return image;
}

// The importance of the picture, or of each of its inks.
std::vector<Field> fields_of(const Pixels& pixels, const StippleOptions& options) {
    using pictures::kAll;
    const pictures::Backdrop behind = pictures::backdrop_of(options.tone);
    if (options.inks.empty())
        return {
            pictures::importance_of(image_of(pixels, pictures::kLuminance, behind), options.tone)};
    pictures::Colours colours{image_of(pixels, {kAll, 0, 0}, behind),
                              image_of(pixels, {0, kAll, 0}, behind),
                              image_of(pixels, {0, 0, kAll}, behind)};
    return pictures::separated(std::move(colours), options.inks, options.tone,
                               options.black_ink.value_or(kBlackInk), options.paper_colour);
}

void take(const Request& request, Result result, Set& set) {
    set.points = std::move(result.points);
    set.domain = request.domain;
    set.radius = result.radius;
    set.mode = request.mode;
    set.seed = request.seed;
    set.maximal = result.maximal;
}

// What the options of a command line say.
struct Asked {
    StippleOptions stipple;  // of sample, the request alone
    options::Choices given;  // of sample
    std::string mask;        // of sample: the name of the picture, if that is its mask
};

// Throws BadRequest for what the command or this module does not have, which read() leaves out.
// Notes whether there is a domain.
void check_names(const options::CommandLine& line, const options::Targets& targets,
                 options::Choices& noted) {
    for (const auto& [name, values] : line.given) {
        noted.has_domain |= name == "domain";
        const options::Option* option = options::find_option(line.command, name);
        const std::string value = values.empty() ? "given" : shown(values.front());
        const auto refuse = [&name = name, &value](const char* why) {
            throw BadRequest(std::string(name), value, why);
        };
        if (option == nullptr) refuse("is no option of this command");
        if (option->is_argument()) continue;  // the picture, which is given as pixels
        if (!targets.contains(name)) refuse("is possible with the program lacuna alone");
        const bool is_flag = option->kind == options::Kind::flag;
        if (is_flag && !values.empty()) refuse("must have no value");
        if (!is_flag && values.empty()) refuse("must have a value");
    }
}

// Puts the options into the order of the table and reads them.
Asked asked_by(options::CommandLine& line) {
    Asked asked;
    options::Targets targets;
    if (line.command == options::kStipple) {
        targets = options::targets_of(asked.stipple);
    } else {
        targets = {
            {"mode", &asked.given.mode}, {"relax", &asked.given.relax}, {"mask", &asked.mask}};
        targets.merge(options::targets_of(asked.stipple.request));
    }
    check_names(line, targets, asked.given);
    line.sort();
    options::read(line, targets);
    return asked;
}

Set stipple(const Pixels& pixels, const StippleOptions& options, const Tell& tell) {
    const std::uint32_t relax = options::relax_of({.is_picture = true, .relax = options.relax});
    Teller teller(tell, relax);
    Stippling made = lacuna::stipple(fields_of(pixels, options), options, teller);
    Set set;
    set.style = drawing::shown(made).style;
    take(made.request, std::move(made.result), set);
    set.layers = std::move(made.layers);
    set.diameters = std::move(made.diameters);
    // A line has no dots, but files have columns for them: as wide as the pen of all inks.
    const bool have_pens = std::any_of(options.inks.begin(), options.inks.end(),
                                       [](const Ink& ink) { return ink.pen_mm != 0; });
    if (options.path_line && options.pens && !have_pens)
        set.diameters.assign(set.points.size(), made.line_width);
    set.ellipses = std::move(made.ellipses);
    set.has_columns = options.paper || options.pens;
    if (made.plot_seconds != 0)
        set.plot =
            "pen path " +
            rounded(made.path_length *
                        drawing::millimetres_per_unit(files::PointSet{{}, set.domain}, set.style) /
                        1000,
                    4) +
            " m, about " + time_text(made.plot_seconds);
    const double dots = static_cast<double>(set.points.size()) / made.dots_for_ink;
    if (const double ink = options.path_line ? std::sqrt(dots) : dots; ink < 0.5)
        set.plot += ", " + rounded(100 * ink, 2) + " % of the picture's ink";
    return set;
}

// Where samples may lie: as decode_mask() reads a picture file.
Mask mask_of(const Pixels& pixels) {
    const pictures::Image image = image_of(pixels, pictures::kLuminance, pictures::Backdrop::black);
    Mask mask{image.columns, image.rows, {}};
    for (const auto luminance : image.luminance) mask.allowed.push_back(luminance == 0 ? 0 : 1);
    return mask;
}

Set sample(const Pixels& pixels, const Asked& asked, const Tell& tell) {
    Request request = asked.stipple.request;
    std::optional<Mask> mask;
    if (!asked.mask.empty()) {
        mask = mask_of(pixels);
        request.places.mask = &*mask;
        request.domain = domain_like(mask->columns, mask->rows, request.domain.boundary);
    }
    const std::uint32_t relax = options::relax_of(asked.given);
    options::settle(asked.given, request);
    Teller teller(tell, relax);
    Set set;
    take(request, options::make(request, {.iterations = relax}, teller).result, set);
    if (relax != 0) set.radius = 0;  // dots are drawn as large as their number lets them be
    set.mask = std::move(mask);
    return set;
}

}  // namespace

std::string command_of(options::CommandLine line) {
    const std::uint64_t seed = asked_by(line).stipple.request.seed;
    return line.text(seed);
}

Set make(const Pixels& pixels, options::CommandLine line, const Tell& tell) {
    const Asked asked = asked_by(line);
    Set set = line.command == options::kStipple ? stipple(pixels, asked.stipple, tell)
                                                : sample(pixels, asked, tell);
    set.command = line.text(set.seed);
    return set;
}

Proof prove(const Set& set, double radius) {
    Claim claim;
    claim.radius = radius;
    claim.domain = set.domain;
    claim.places.mask = set.mask ? &*set.mask : nullptr;
    return lacuna::prove(set.points, claim);
}

Spectrum spectrum(const Set& set, double most, const Tell& tell) {
    const auto count = static_cast<double>(set.points.size());
    const int reach = static_cast<int>(std::ceil(most * std::sqrt(count))) + 3;
    const analysis::Domain domain = verify::domain_of(set.domain);
    analysis::Spectrum found{domain, {reach, reach}, 1, count, {}};
    found.powers = analysis::periodogram(set.points, domain, found.range, [&](double share) {
        tell(share);
        return true;
    });
    Spectrum result;
    result.side = static_cast<std::uint32_t>(2 * reach + 1);
    result.powers.reserve(std::size_t{result.side} * result.side);
    for (int y = reach; y >= -reach; --y)
        for (int x = -reach; x <= reach; ++x)
            result.powers.push_back(static_cast<float>(found.power(x, y)));
    for (const analysis::Annulus& annulus : analysis::radial_of(found).annuli) {
        result.radial.push_back(annulus.frequency);
        result.radial.push_back(annulus.power);
    }
    return result;
}

std::string encode(const Set& set, const std::string& format) {
    const files::Origin origin{LACUNA_VERSION, set.command, set.mode, set.seed, set.maximal};
    drawing::Style style = set.style;
    style.diameters = set.diameters;
    files::PointSet points{set.points, set.domain, set.radius, &origin};
    points.layers = set.layers;
    points.ellipses = set.ellipses;
    files::Dots dots;
    if (set.has_columns) {
        dots = drawing::dots_of(points, style);
        points.dots = &dots;
    }
    if (format == "csv") return files::encode_csv(points);
    if (format == "npy") return files::encode_npy(points);
    return drawing::draw_svg(points, style);
}

}  // namespace lacuna::web
