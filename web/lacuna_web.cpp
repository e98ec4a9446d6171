// Makes points from pixels or from a request, like the command's stipple and sample.
#include "lacuna_web.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "analysis/radial.h"
#include "analysis/spectrum.h"
#include "drawing/dot_count.h"
#include "drawing/dot_size.h"
#include "drawing/pen/pen_path.h"
#include "drawing/picture_svg.h"
#include "files/point_files.h"
#include "pictures/image.h"
#include "pictures/whole_samples.h"

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

// The importance that host/pictures makes of a picture file with these bytes in its channels.
Field field_of(const Pixels& pixels, const pictures::Importance& tone) {
    constexpr std::int32_t kWhite = 255;
    constexpr unsigned kChannels = 4;
    pictures::Image image{pixels.columns, pixels.rows, {}, 1, "the picture"};
    image.luminance.resize(std::size_t{pixels.columns} * pixels.rows);
    pictures::fill_row_from(pixels.rgba.data(), kChannels, false, image.luminance, kWhite);
    return pictures::importance_of(std::move(image), tone);
}

void relax_points(Set& set, const Field* field, std::uint32_t iterations, const Tell& tell) {
    if (iterations == 0) return;
    RelaxOptions options;
    options.width = set.width;
    options.height = set.height;
    options.boundary = set.boundary;
    options.iterations = iterations;
    Teller teller(tell, share_of_placing(iterations), 1);
    set.points = relax(set.points, field, options, teller).points;
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

void order_for_a_pen(std::vector<Point>& points) {
    const std::vector<std::uint32_t> order = pen::pen_path(points, [] { return true; });
    std::vector<Point> ordered;
    ordered.reserve(points.size());
    for (const std::uint32_t index : order) ordered.push_back(points[index]);
    points = std::move(ordered);
}

drawing::Style style_of(const StippleOptions& options, double width, double height) {
    drawing::Style style;
    style.sheet = options.sheet;
    // Named papers are turned to suit the picture.
    if (style.sheet && width > height) std::swap(style.sheet->width_mm, style.sheet->height_mm);
    style.for_a_pen = options.pen_path;
    return style;
}

}  // namespace

Set Stippler::stipple(const Pixels& pixels, const StippleOptions& options, const Tell& tell) {
    const Field field = field_of(pixels, options.tone);
    Request request;
    const bool keeps_distance = options.relax == 0 || options.metric;
    request.mode = keeps_distance ? Mode::cells : Mode::stratified;
    request.field = &field;
    request.seed = options.seed;
    request.metric = options.metric.value_or(Metric::min);
    const double longer = std::max(field.columns, field.rows);
    request.width = field.columns / longer;
    request.height = field.rows / longer;
    const drawing::Style style = style_of(options, request.width, request.height);
    std::optional<drawing::Sizing::Pens> pens;
    if (options.dot_size_mm) pens = {*options.dot_size_mm, *options.dot_size_mm};
    request.count = options.count
                        ? options.count
                        : drawing::default_count(field, request.width, request.height, pens, style);

    const pictures::Importance& tone = options.tone;
    const Key key{{tone.black, tone.white, tone.gamma},
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
    Set set = placed_;
    relax_points(set, &field, options.relax, tell);
    set.style = style;
    set.has_columns = options.sheet || options.dot_size_mm;
    if (options.pen_path) order_for_a_pen(set.points);
    if (options.dot_size_mm)
        set.diameters.assign(set.points.size(),
                             *options.dot_size_mm /
                                 drawing::millimetres_per_unit({{}, set.width, set.height}, style));
    else
        set.diameters = drawing::dot_diameters(
            set.points, field, set.width, set.height,
            options.relax != 0 ? drawing::Spread::even : drawing::Spread::random);
    return set;
}

Set sample(Request request, std::uint32_t relax, const Tell& tell) {
    if (relax != 0 && request.count && request.mode == Mode::exact) request.mode = Mode::stratified;
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
