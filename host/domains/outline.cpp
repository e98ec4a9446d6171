// Turns curves into lines.
#include "domains/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/polling.h"
#include "domains/rings.h"
#include "domains/svg_path.h"

namespace lacuna::domains {
namespace {

constexpr int kMostHalvings = 12;               // for a quarter of an ellipse
constexpr std::size_t kMostPieces = 1U << 14U;  // for one curve

Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
Point operator*(double factor, Point a) {
    return {factor * a.x, factor * a.y};
}
double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}
double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}
double length(Point a) {
    return std::sqrt(dot(a, a));
}

}  // namespace

std::optional<double> Affine::scale() const {
    constexpr double kRounding = 1e-9;
    const double along = xx * xx + yx * yx, up = xy * xy + yy * yy;
    const double most = kRounding * std::max(along, up);
    if (std::abs(along - up) > most || std::abs(xx * xy + yx * yy) > most) return std::nullopt;
    return std::sqrt(along);
}

void Outline::add(Point point) {
    ask_after();
    is_fair_ = is_fair_ && domains::is_fair(point);
    ring_.push_back(point);
    ++points_;
}

void Outline::move_to(Point to) {
    end();
    current_ = begin_ = to;
}

// A path that ends without being closed is closed, too, unless it is a line.
void Outline::end() {
    has_open_lines_ |= is_open();
    if (take_ == Take::insides || !is_open()) return close();
    rings_.push_back(there_and_back(std::move(ring_)));
    ring_ = {};
    current_ = begin_;
}

void Outline::close() {
    open(ring_);
    if (take_ != Take::insides && !ring_.empty())
        rings_.push_back(around_and_back(std::move(ring_)));
    else if (ring_.size() >= 3)
        rings_.push_back(std::move(ring_));
    else
        points_ -= ring_.size();
    ring_ = {};
    current_ = begin_;
}

std::vector<PolygonRing> Outline::take_rings() {
    move_to({0, 0});
    has_open_lines_ = false;
    return std::exchange(rings_, {});
}

void Outline::line_to(Point to) {
    if (ring_.empty()) add(transform_.of(current_));
    add(transform_.of(to));
    current_ = to;
}

// The number of equal steps at which the chords stay within the tolerance (Wang's formula). `bend`
// is the error with one piece, by the bound on the curve's second derivative.
std::size_t Outline::pieces(double bend) const {
    const double wanted = std::ceil(std::sqrt(bend / tolerance_));
    return static_cast<std::size_t>(std::clamp(wanted, 1.0, static_cast<double>(kMostPieces)));
}

void Outline::quadratic_to(Point control, Point to) {
    const Point third = (1 / 3.0) * control;
    cubic_to((1 / 3.0) * current_ + 2 * third, (1 / 3.0) * to + 2 * third, to);
}

void Outline::cubic_to(Point first, Point second, Point to) {
    if (ring_.empty()) add(transform_.of(current_));
    const Point a = transform_.of(current_);
    const Point b = transform_.of(first);
    const Point c = transform_.of(second);
    const Point d = transform_.of(to);
    is_fair_ = is_fair_ && domains::is_fair(b) && domains::is_fair(c) && domains::is_fair(d);
    if (!is_fair_) return;
    const double bend = 0.75 * std::max(length(a - 2 * b + c), length(b - 2 * c + d));
    const std::size_t count = pieces(bend);
    for (std::size_t i = 1; i < count; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(count);
        const double s = 1 - t;
        add((s * s * s) * a + (3 * s * s * t) * b + (3 * s * t * t) * c + (t * t * t) * d);
    }
    add(d);
    current_ = to;
}

// Draws an arc of the unit circle of at most a quarter. Halves are found by square roots, which are
// the same on every machine; sines are not.
void Outline::quarter_to(const Affine& circle, Point from, Point to, int halvings) {
    if (halvings == 0) {
        add(circle.of(to));
        return;
    }
    const Point sum = from + to;
    const Point middle = (1 / length(sum)) * sum;
    quarter_to(circle, from, middle, halvings - 1);
    quarter_to(circle, middle, to, halvings - 1);
}

// Finds the middle of the ellipse (SVG 1.1, F.6). Radii that are too small are enlarged.
void Outline::arc_to(Ellipse ellipse, bool is_large, bool is_positive, Point to) {
    const Point from = current_;
    double rx = std::abs(ellipse.rx);
    double ry = std::abs(ellipse.ry);
    if (rx == 0 || ry == 0 || from == to) return line_to(to);
    const Affine turn = turned_by(ellipse.degrees);
    const Affine back{turn.xx, turn.yx, turn.xy, turn.yy, 0, 0};
    // Half of the way, in coordinates in which the ellipse is the unit circle.
    const Point way = back.of(0.5 * (to - from));
    Point half{way.x / rx, way.y / ry};
    const double reach = length(half);
    if (!std::isfinite(reach)) {
        is_fair_ = false;
        return;
    }
    if (reach > 1) {
        rx *= reach;
        ry *= reach;
        half = (1 / reach) * half;
    }
    const double squared = dot(half, half);
    constexpr double kTiny = 1e-18;  // if the way is this short on the circle, the arc is straight
    if (squared < kTiny && !is_large) return line_to(to);
    const double aside = std::sqrt(std::max(0.0, 1 - squared)) / std::sqrt(squared);
    const double side = is_large == is_positive ? -1 : 1;
    const Point middle = (side * aside) * Point{half.y, -half.x};  // from the middle of the way
    const Affine stretched{rx, 0, 0, ry, 0, 0};
    const Point centre = 0.5 * (from + to) + turn.of(stretched.of((-1.0) * middle));
    const Affine shape = Affine{1, 0, 0, 1, centre.x, centre.y}.after(turn).after(stretched);
    const Affine circle = transform_.after(shape);

    if (ring_.empty()) add(transform_.of(current_));
    // The chord of a quarter is off by at most (pi/2)^2/8 of the longer radius. Each halving
    // divides that by 4.
    double off = 0.31 * (std::abs(circle.xx) + std::abs(circle.xy) + std::abs(circle.yx) +
                         std::abs(circle.yy));
    int halvings = 0;
    for (; halvings < kMostHalvings && off > tolerance_; ++halvings) off /= 4;

    // Tolerance that keeps the arc large or small as its flag says, in spite of rounding.
    constexpr double kRounding = -1e-9;
    const double direction = is_positive ? 1 : -1;
    Point at = middle - half;
    const Point end = middle + half;
    const int most_quarters = is_large ? 3 : 1;
    for (int quarters = 0; quarters < most_quarters; ++quarters) {
        const bool is_last = direction * cross(at, end) > 0 && dot(at, end) >= kRounding;
        if (is_last && (quarters > 0 || !is_large)) break;
        const Point next = direction * Point{-at.y, at.x};
        quarter_to(circle, at, next, halvings);
        at = next;
    }
    quarter_to(circle, at, end, halvings);
    ring_.back() = transform_.of(to);  // exactly `to`, without rounding errors
    current_ = to;
}

}  // namespace lacuna::domains
