// Places the dots of a picture, with dots around it if they are relaxed.
#include "stipple/place_dots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "plan/checked_request.h"
#include "stipple/dot_count.h"
#include "stipple/jump.h"

namespace lacuna::stippling {
namespace {

double sum_of(const Field& field) {
    return stippling::darkness_of(field) * static_cast<double>(field.importance.size());
}

// The pixel of a picture under pixel `i` of the picture with its margin.
std::uint32_t mirrored(std::uint32_t i, std::uint32_t margin, std::uint32_t pixels) {
    if (i < margin) return margin - 1 - i;
    return i < margin + pixels ? i - margin : 2 * pixels - 1 - (i - margin);
}

// A coordinate on the other side of the nearest edge, if it lies outside of [begin, end].
double mirrored(double at, double begin, double end) {
    if (at < begin) return std::min(2 * begin - at, end);
    return at > end ? std::max(2 * end - at, begin) : at;
}

// The least of the mean importances of the picture's four sides, without sides that are white; 0 if
// all are.
double lightest_side(const Field& field) {
    const std::size_t columns = field.columns, rows = field.rows;
    const auto mean_of = [&](std::size_t first, std::size_t step, std::size_t count) {
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) sum += field.importance[first + i * step];
        return sum / static_cast<double>(count);
    };
    double lightest = 0;
    for (const double side : {mean_of(0, 1, columns), mean_of((rows - 1) * columns, 1, columns),
                              mean_of(0, columns, rows), mean_of(columns - 1, columns, rows)})
        if (side > 0 && (lightest == 0 || side < lightest)) lightest = side;
    return lightest;
}

// The margin of a picture; of no pixels if there is none.
class Margin {
public:
    Margin(const Request& request, const options::Moves& moves, Edges edges)
        : picture_(request.domain) {
        constexpr double kSpacings = 4;
        constexpr double kMostDots = 1e7;  // with more nobody sees rows, and memory counts
        const double dots = static_cast<double>(request.count.value_or(0));
        if (edges == Edges::closed || picture_.wraps() || request.mode != Mode::stratified ||
            moves.iterations == 0 || dots > kMostDots)
            return;
        const Field& field = *request.field;
        const double columns = field.columns, rows = field.rows;
        const double lightest = lightest_side(field);
        if (lightest == 0) return;
        const double spacing = std::sqrt(sum_of(field) / (dots * lightest));
        // The margin, at most as large as the picture: (columns + 2 m) (rows + 2 m) is twice its
        // area.
        const double half = (columns + rows) / 4;
        const double most = std::sqrt(half * half + columns * rows / 4) - half;
        const double margin = std::floor(std::min(most, std::ceil(kSpacings * spacing)));
        if (margin < spacing) return;
        pixels_ = static_cast<std::uint32_t>(margin);
        width_ = picture_.width / columns * margin;
        height_ = picture_.height / rows * margin;
    }

    explicit operator bool() const { return pixels_ != 0; }

    // The domain of the picture and its margin.
    Domain domain() const {
        Domain domain = picture_;
        domain.x0 -= width_;
        domain.y0 -= height_;
        domain.width += 2 * width_;
        domain.height += 2 * height_;
        return domain;
    }

    Field around(const Field& picture) const {
        Field all{picture.columns + 2 * pixels_, picture.rows + 2 * pixels_, {}};
        all.importance.resize(std::size_t{all.columns} * all.rows);
        const auto fill_row = [&](std::size_t i) {
            const std::size_t row = mirrored(static_cast<std::uint32_t>(i), pixels_, picture.rows);
            const double* from = picture.importance.data() + row * picture.columns;
            double* to = all.importance.data() + i * all.columns;
            for (std::uint32_t column = 0; column < all.columns; ++column)
                to[column] = from[mirrored(column, pixels_, picture.columns)];
        };
        for_each_polled(all.rows, ask, fill_row, all.columns);
        return all;
    }

    bool is_around(Point point) const { return !picture_.holds(point); }
    Point into_picture(Point point) const {
        return {mirrored(point.x, picture_.x0, picture_.x0 + picture_.width),
                mirrored(point.y, picture_.y0, picture_.y0 + picture_.height)};
    }

    // Of dots of one ink those of the picture, in their order: the `count` of them that lie deepest
    // in it. These are nearly always all that lie in it. Where they are too few, the nearest dots
    // of the margin are mirrored into it.
    void add_deepest(std::span<const Point> dots, std::uint64_t count,
                     std::vector<Point>& deepest) const {
        std::vector<double> depths;  // less than 0 outside of the picture
        for (const Point& dot : dots) {
            const double x = dot.x - picture_.x0, y = dot.y - picture_.y0;
            depths.push_back(
                std::min(std::min(x, picture_.width - x), std::min(y, picture_.height - y)));
        }
        std::vector<double> sorted = depths;
        std::sort(sorted.begin(), sorted.end());
        const auto first = sorted.end() - static_cast<std::ptrdiff_t>(count);
        const double least = *first;
        auto equal = std::upper_bound(first, sorted.end(), least) - first;
        for (std::size_t i = 0; i < dots.size(); ++i)
            if (depths[i] > least || (depths[i] == least && equal-- > 0))
                deepest.push_back(into_picture(dots[i]));
    }

    // Of the first `count` dots, which began in the picture, those that left it go to where the
    // nearest dots of the margin came in: so each dot of a frame keeps its index.
    std::vector<Point> kept_in_picture(std::span<const Point> dots, std::size_t count) const {
        std::vector<Point> kept(dots.begin(), dots.begin() + static_cast<std::ptrdiff_t>(count));
        std::vector<Point> came;
        for (const Point& dot : dots.subspan(count))
            if (!is_around(dot)) came.push_back(dot);
        for (Point& dot : kept) {
            if (!is_around(dot)) continue;
            const auto way = [&](Point to) { return std::hypot(to.x - dot.x, to.y - dot.y); };
            const auto nearest = std::min_element(
                came.begin(), came.end(), [&](Point a, Point b) { return way(a) < way(b); });
            if (nearest == came.end()) {
                dot = into_picture(dot);
                continue;
            }
            dot = *nearest;
            came.erase(nearest);
        }
        return kept;
    }

private:
    Domain picture_;
    std::uint32_t pixels_ = 0;  // of the margin, on each side
    double width_ = 0;          // of the margin on the left and on the right
    double height_ = 0;         // of the margin above and below
};

options::Made placed(const Request& request, std::span<const InkPart> inks,
                     std::vector<Point> start, const options::Moves& moves, Observer& observer) {
    if (!inks.empty()) return make_in_inks(request, inks, moves, observer);
    check_moves(request, moves);
    options::Made made{.result = {.points = std::move(start)}};
    if (made.result.points.empty()) made.result = sample(request, observer);
    if (moves.are_asked_for()) move_points(made, request, moves, observer);
    return made;
}

// The dots of the picture and its margin, and how many of each ink there are.
struct Wide {
    options::Made made{};
    std::vector<std::uint64_t> counts{};
};

Wide placed_around(const Margin& margin, const Request& request, std::span<const InkPart> inks,
                   std::span<const Point> start, const options::Moves& moves, Observer& observer) {
    std::vector<Field> fields;
    fields.reserve(inks.size() + 1);
    const auto widen = [&](const Field*& field, std::uint64_t dots) {
        const double own = sum_of(*field);
        field = &fields.emplace_back(margin.around(*field));
        return static_cast<std::uint64_t>(
            std::llround(sum_of(*field) / own * static_cast<double>(dots)));
    };
    Wide wide;
    std::vector<InkPart> parts(inks.begin(), inks.end());
    for (InkPart& part : parts) wide.counts.push_back(part.dots = widen(part.field, part.dots));
    Request all = request;
    all.domain = margin.domain();
    if (inks.empty()) wide.counts.push_back(*(all.count = widen(all.field, *all.count)));
    std::vector<Point> first;
    if (!start.empty()) {
        std::vector<Point> inside, around;
        for (const Point& dot : sample(all, observer).points)
            (margin.is_around(dot) ? around : inside).push_back(dot);
        first = jumped(start, inside, *request.field, request.domain);
        first.insert(first.end(), around.begin(), around.end());
    }
    wide.made = placed(all, parts, std::move(first), moves, observer);
    return wide;
}

}  // namespace

options::Made place_dots(const Request& request, std::span<const InkPart> inks,
                         std::span<const Point> start, const options::Moves& moves, Edges edges,
                         Observer& observer) {
    const Margin margin(request, moves, edges);
    if (!margin) {
        std::vector<Point> first;
        if (!start.empty())
            first = jumped(start, sample(request, observer).points, *request.field, request.domain);
        options::Made made = placed(request, inks, std::move(first), moves, observer);
        if (moves.are_asked_for()) options::note_moves(request, made.result);
        return made;
    }
    check_request(request);
    auto [made, counts] = placed_around(margin, request, inks, start, moves, observer);
    std::span<const Point> rest = made.result.points;
    std::vector<Point> dots;
    if (!start.empty()) dots = margin.kept_in_picture(rest, start.size());
    for (std::size_t k = 0; k < counts.size() && start.empty(); ++k) {
        margin.add_deepest(rest.first(counts[k]), inks.empty() ? *request.count : inks[k].dots,
                           dots);
        rest = rest.subspan(counts[k]);
    }
    made.result.points = std::move(dots);
    options::note_moves(request, made.result);
    return std::move(made);
}

}  // namespace lacuna::stippling
