// Makes points from pixels or from a request, like the command's stipple and sample.
#include "lacuna_web.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "analysis/radial.h"
#include "analysis/spectrum.h"
#include "drawing/page.h"
#include "drawing/pen/pen_path.h"
#include "drawing/picture_svg.h"
#include "drawing/tones.h"
#include "files/point_files.h"
#include "pictures/image.h"
#include "pictures/whole_samples.h"
#include "plan/plan.h"
#include "recipes/settle.h"

namespace lacuna::files {

// Declared here, because the table of formats in host/files/formats.cpp needs cairo.
std::string encode_csv(const PointSet& set);
std::string encode_npy(const PointSet& set);

}  // namespace lacuna::files

namespace lacuna::web {
namespace {

class Teller : public Observer {
public:
    Teller(const Tell& tell, double from, double to) : tell_(tell), from_(from), to_(to) {}

    bool keep_going(const Progress& progress) override {
        const double share =
            static_cast<double>(progress.points) /
            static_cast<double>(std::max<std::uint64_t>(1, progress.expected_points));
        tell_(from_ + (to_ - from_) * std::min(1.0, share));
        return true;
    }

private:
    const Tell& tell_;
    double from_;
    double to_;
};

// The fraction of the progress bar for placing points. The bar moves evenly, because an iteration
// of relax takes about a tenth of the time of placing.
double share_of_placing(std::uint32_t relax) {
    return 10.0 / (10.0 + relax);
}

// What host/pictures reads from a picture file with these bytes in its channels.
pictures::Image image_of(const Pixels& pixels, const pictures::Weights& weights) {
    constexpr std::int32_t kWhite = 255;
    constexpr unsigned kChannels = 4;
    pictures::Image image{pixels.columns, pixels.rows, {}, 1, "the picture"};
    image.luminance.resize(std::size_t{pixels.columns} * pixels.rows);
    pictures::Reading reading;
    reading.weights = weights;
    pictures::fill_row_from(pixels.rgba.data(), kChannels, false, image.luminance, kWhite, reading);
    return image;
}

// The importance of the picture, or of each of its inks.
std::vector<Field> fields_of(const Pixels& pixels, const StippleOptions& options) {
    using pictures::kAll;
    if (options.inks.empty())
        return {pictures::importance_of(image_of(pixels, pictures::kLuminance), options.tone)};
    pictures::Colours colours{image_of(pixels, {kAll, 0, 0}), image_of(pixels, {0, kAll, 0}),
                              image_of(pixels, {0, 0, kAll})};
    return pictures::separated(std::move(colours), options.inks, options.tone, kBlackInk);
}

RelaxOptions relax_options_of(const Set& set, std::uint32_t iterations) {
    RelaxOptions options;
    options.width = set.width;
    options.height = set.height;
    options.boundary = set.boundary;
    options.iterations = iterations;
    return options;
}

void relax_points(Set& set, const Field* field, std::uint32_t iterations, const Tell& tell) {
    if (iterations == 0) return;
    Teller teller(tell, share_of_placing(iterations), 1);
    set.points = relax(set.points, field, relax_options_of(set, iterations), teller).points;
    set.maximal = false;
    set.radius = 0;
}

// Makes a set. `relax` is only the number of iterations that follow, for the progress bar.
Set placed(const Request& request, std::uint32_t relax, const Tell& tell) {
    Teller teller(tell, 0, share_of_placing(relax));
    Result result = lacuna::sample(request, teller);
    Set set;
    set.points = std::move(result.points);
    set.width = request.width;
    set.height = request.height;
    set.radius = result.radius;
    set.boundary = request.boundary;
    set.mode = request.mode;
    set.seed = request.seed;
    set.maximal = result.maximal;
    return set;
}

// The dots of all inks, relaxed.
Set dots_of_inks(const drawing::Tones& tones, const Request& request, std::uint32_t iterations,
                 const Tell& tell) {
    Set set;
    set.width = request.width;
    set.height = request.height;
    set.mode = request.mode;
    set.seed = request.seed;
    set.layers = tones.layers;
    Teller teller(tell, 0, 1);
    set.points = place_inks(drawing::parts_of(tones), request.seed,
                            relax_options_of(set, iterations), teller)
                     .points;
    return set;
}

// Orders the dots of each ink along a short path of its own.
void order_for_a_pen(Set& set) {
    std::vector<Point> ordered;
    ordered.reserve(set.points.size());
    files::PointSet dots{set.points};
    dots.layers = set.layers;
    drawing::for_each_layer(dots, {}, [&](std::size_t, const auto& part, const auto&) {
        for (const std::uint32_t index : pen::pen_path(part.points, [] { return true; }))
            ordered.push_back(part.points[index]);
    });
    set.points = std::move(ordered);
}

drawing::Style style_of(const StippleOptions& options, double width, double height) {
    drawing::Style style;
    style.sheet = options.sheet;
    // Named papers are turned to suit the picture.
    if (style.sheet && width > height) std::swap(style.sheet->width_mm, style.sheet->height_mm);
    style.for_a_pen = options.pen_path;
    return style;
}

void check_inks(const StippleOptions& options, const Request& request) {
    if (options.metric)
        throw BadRequest("metric", std::string(name_of(*options.metric)),
                         "is not for inks, whose dots begin stratified");
    check_request(request);
}

}  // namespace

Set Stippler::placed_dots(const StippleOptions& options, const Request& request, const Tell& tell) {
    const pictures::Importance& tone = options.tone;
    const Key key{{tone.black, tone.white, tone.gamma, static_cast<double>(tone.sharpen),
                   options.size_by_tone},
                  tone.auto_levels,
                  tone.invert,
                  *request.count,
                  request.mode,
                  request.metric,
                  request.seed};
    if (placed_.points.empty() || key != key_) {
        placed_.points.clear();
        placed_ = placed(request, options.relax, tell);
        key_ = key;
    }
    return placed_;
}

Set Stippler::stipple(const Pixels& pixels, const StippleOptions& options, const Tell& tell) {
    drawing::Tones tones{
        .sizing = {options.size_by_tone, {}},
        .keep_inside = options.keep_inside,
        .spread = options.relax != 0 ? drawing::Spread::even : drawing::Spread::random};
    if (options.dot_size_mm) tones.sizing.pens = {*options.dot_size_mm, *options.dot_size_mm};
    drawing::set_fields(tones, fields_of(pixels, options), options.inks);
    const Field& density = tones.has_inks() ? tones.sum : tones.densities().front();
    Request request;
    recipes::settle({.is_picture = true,
                     .has_inks = tones.has_inks(),
                     .metric = options.metric,
                     .relax = options.relax},
                    request);
    request.field = &density;
    request.seed = options.seed;
    const double longer = std::max(pixels.columns, pixels.rows);
    request.width = pixels.columns / longer;
    request.height = pixels.rows / longer;
    const drawing::Style style = style_of(options, request.width, request.height);
    request.count = options.count
                        ? options.count
                        : drawing::suiting_count(tones, request.width, request.height, style);
    Set set;
    if (tones.has_inks()) {
        check_inks(options, request);
        drawing::share_dots(tones, *request.count);
        set = dots_of_inks(tones, request, options.relax, tell);
    } else {
        set = placed_dots(options, request, tell);
        relax_points(set, &density, options.relax, tell);
    }
    set.style = style;
    set.has_columns = options.sheet || options.dot_size_mm;
    files::PointSet dots{set.points, set.width, set.height};
    drawing::pull_inside(tones, dots, set.boundary, style, set.points);
    if (options.pen_path) order_for_a_pen(set);
    dots.points = set.points;
    set.diameters = drawing::diameters_of(tones, dots, set.boundary, style);
    return set;
}

Set sample(Request request, std::uint32_t relax, const Tell& tell) {
    const bool is_default = request.mode == Mode::exact;
    recipes::settle(
        {.mode = is_default ? std::nullopt : std::optional(request.mode), .relax = relax}, request);
    Set set = placed(request, relax, tell);
    relax_points(set, nullptr, relax, tell);
    return set;
}

Proof prove(const Set& set, double radius) {
    Claim claim;
    claim.radius = radius;
    claim.width = set.width;
    claim.height = set.height;
    claim.boundary = set.boundary;
    return lacuna::prove(set.points, claim);
}

Spectrum spectrum(const Set& set, double most, const Tell& tell) {
    const auto count = static_cast<double>(set.points.size());
    const int reach = static_cast<int>(std::ceil(most * std::sqrt(count))) + 3;
    const analysis::Domain domain{set.width, set.height, set.boundary == Boundary::torus};
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

std::string encode(const Set& set, const std::string& format, const std::string& command) {
    const files::Origin origin{LACUNA_VERSION, command,  set.boundary,
                               set.mode,       set.seed, set.maximal};
    drawing::Style style = set.style;
    style.diameters = set.diameters;
    files::PointSet points{set.points, set.width, set.height, set.radius, &origin};
    points.layers = set.layers;
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
