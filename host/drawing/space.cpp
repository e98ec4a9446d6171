// Draws sets in space: from the right, from the front and from above, side by side.
#include "drawing/space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "base/polling.h"
#include "drawing/png.h"

namespace lacuna::drawing {
namespace {

using Axes = std::array<double, 3>;

Axes axes_of(const Point3& point) {
    return {point.x, point.y, point.z};
}

// A view along an axis: which axes go to the right and up, and where the viewer is.
struct View {
    std::size_t right, up, along;
    double nearer;  // 1 if larger coordinates are nearer, or -1
};
constexpr std::array<View, 3> kViews{{{1, 2, 0, 1}, {0, 2, 1, -1}, {0, 1, 2, 1}}};

constexpr std::size_t kFine = 3;          // pixels are this much finer along a side until the end
constexpr double kLongest = 400 * kFine;  // fine pixels of the longest side
constexpr std::size_t kAround = 20 * kFine;  // fine pixels around each view
constexpr double kDot = 1. / 3;              // radius of a dot, in radii of the set
constexpr double kSmallestDot = 0.6 * kFine;
constexpr double kDepth = 2.5;  // how deep a picture shows a volume, in radii
// Cosine of the angle between the viewer and a normal, below which a dot is not drawn.
constexpr double kEdgeOn = 0.1;

struct BoxAround {
    Axes low{}, side{};
    double scale = 1;  // fine pixels a unit
};

BoxAround box_of(const files::SetInSpace& set) {
    BoxAround box;
    if (set.volume != nullptr) {
        box.side = {set.volume->width, set.volume->height, set.volume->depth};
    } else {
        Axes high = box.low = axes_of(set.mesh->vertices[set.mesh->triangles[0][0]]);
        for_each_polled(set.mesh->triangles.size(), ask, [&](std::size_t i) {
            for (const std::uint32_t vertex : set.mesh->triangles[i])
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double at = axes_of(set.mesh->vertices[vertex]).at(axis);
                    box.low.at(axis) = std::min(box.low.at(axis), at);
                    high.at(axis) = std::max(high.at(axis), at);
                }
        });
        for (std::size_t axis = 0; axis < 3; ++axis)
            box.side.at(axis) = high.at(axis) - box.low.at(axis);
    }
    const double longest = *std::max_element(box.side.begin(), box.side.end());
    box.scale = longest > 0 ? kLongest / longest : 1;
    return box;
}

// One view in fine pixels: greys, and how near what they show is.
class Panel {
public:
    Panel(const View& view, const BoxAround& box)
        : columns_(pixels(box.side.at(view.right) * box.scale)),
          rows_(pixels(box.side.at(view.up) * box.scale)),
          view_(view),
          box_(box),
          greys_(columns_ * rows_, 255),
          near_(columns_ * rows_, -std::numeric_limits<double>::infinity()) {}

    std::size_t columns() const { return columns_; }
    std::size_t rows() const { return rows_; }
    std::uint8_t grey(std::size_t column, std::size_t row) const {
        return greys_[row * columns_ + column];
    }

    // Column, row and nearness, in fine pixels.
    Axes place_of(const Point3& point) const {
        const Axes at = axes_of(point);
        const auto along = [&](std::size_t axis) {
            return (at.at(axis) - box_.low.at(axis)) * box_.scale;
        };
        return {kAround + along(view_.right),
                static_cast<double>(rows_ - kAround) - along(view_.up),
                view_.nearer * along(view_.along)};
    }
    // How deep behind the side that faces the viewer.
    double depth_of(const Axes& place) const {
        const double nearest = view_.nearer > 0 ? box_.side.at(view_.along) * box_.scale : 0;
        return nearest - place[2];
    }

    // Grey is lighter where the triangle faces the viewer.
    void fill(const std::array<Point3, 3>& corners) {
        const Axes a = place_of(corners[0]), b = place_of(corners[1]), c = place_of(corners[2]);
        const double ux = b[0] - a[0], uy = b[1] - a[1], un = b[2] - a[2];
        const double vx = c[0] - a[0], vy = c[1] - a[1], vn = c[2] - a[2];
        const double area = ux * vy - uy * vx;
        if (area == 0) return;
        const double facing =
            std::abs(area) / std::hypot(uy * vn - un * vy, un * vx - ux * vn, area);
        const auto grey = static_cast<std::uint8_t>(150 + 9 * std::lround(9 * facing));
        for_pixels({std::min({a[0], b[0], c[0]}), std::min({a[1], b[1], c[1]})},
                   {std::max({a[0], b[0], c[0]}), std::max({a[1], b[1], c[1]})},
                   [&](double x, double y, std::size_t pixel) {
                       const double s = ((x - a[0]) * vy - (y - a[1]) * vx) / area;
                       const double t = (ux * (y - a[1]) - uy * (x - a[0])) / area;
                       const double near = a[2] + s * un + t * vn;
                       if (s < 0 || t < 0 || s + t > 1 || near <= near_[pixel]) return;
                       near_[pixel] = near;
                       greys_[pixel] = grey;
                   });
    }

    // A dot that lies on the surface with this normal; (0, 0, 0): it faces the viewer.
    void dot(const Axes& place, double radius, std::uint8_t grey, const Axes& normal = {}) {
        const double across = normal.at(view_.right), up = -normal.at(view_.up);
        const double slope = std::hypot(across, up);
        const double facing = slope == 0 ? 1 : std::abs(normal.at(view_.along));
        if (facing < kEdgeOn) return;
        const double more = slope == 0 ? 0 : (1 / (facing * facing) - 1) / (slope * slope);
        const auto squared = [&](double x, double y) {
            const double dx = x - place[0], dy = y - place[1];
            const double along = dx * across + dy * up;
            return dx * dx + dy * dy + more * along * along;
        };
        bool is_hidden = false;
        for_pixels({place[0], place[1]}, {place[0], place[1]},
                   [&](double, double, std::size_t pixel) {
                       is_hidden = place[2] < near_[pixel] - std::max(radius, 3 / facing);
                   });
        if (is_hidden) return;
        for_pixels({place[0] - radius, place[1] - radius}, {place[0] + radius, place[1] + radius},
                   [&](double x, double y, std::size_t pixel) {
                       if (squared(x, y) <= radius * radius) greys_[pixel] = grey;
                   });
    }

private:
    static std::size_t pixels(double side) {
        const auto count = static_cast<std::size_t>(std::ceil(side)) + 2 * kAround;
        return (count + kFine - 1) / kFine * kFine;
    }
    // Calls visit(x, y, index) with the middle of each pixel that the rectangle touches.
    template <class Visit>
    void for_pixels(const std::array<double, 2>& low, const std::array<double, 2>& high,
                    const Visit& visit) const {
        const auto pixel = [](double at, std::size_t count) {
            return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
        };
        ask_after();
        for (std::size_t row = pixel(low[1], rows_); row <= pixel(high[1], rows_); ++row)
            for (std::size_t column = pixel(low[0], columns_); column <= pixel(high[0], columns_);
                 ++column)
                visit(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5,
                      row * columns_ + column);
    }

    std::size_t columns_, rows_;
    const View& view_;
    const BoxAround& box_;
    std::vector<std::uint8_t> greys_;
    std::vector<double> near_;
};

void draw_surface(const files::SetInSpace& set, double radius, Panel& panel) {
    for (const auto& [a, b, c] : set.mesh->triangles)
        panel.fill({set.mesh->vertices[a], set.mesh->vertices[b], set.mesh->vertices[c]});
    for (std::size_t i = 0; i < set.points.size(); ++i)
        panel.dot(panel.place_of(set.points[i]), radius, 0,
                  i < set.kept() ? Axes{} : axes_of(set.normals[i - set.kept()]));
}

// Points fade with their depth; the nearest are drawn last, each within a light rim.
void draw_volume(const files::SetInSpace& set, double radius, Panel& panel) {
    std::vector<Axes> places;
    for (const Point3& point : set.points) {
        const Axes place = panel.place_of(point);
        if (panel.depth_of(place) < kDepth * radius / kDot) places.push_back(place);
    }
    std::sort(places.begin(), places.end(),
              [](const Axes& a, const Axes& b) { return a[2] < b[2]; });
    for (const Axes& place : places) {
        const double share = panel.depth_of(place) / (kDepth * radius / kDot);
        panel.dot(place, radius + kFine, 255);
        panel.dot(place, radius, static_cast<std::uint8_t>(std::lround(245 * std::max(0., share))));
    }
}

std::string draw_in_space(const files::SetInSpace& set) {
    const BoxAround box = box_of(set);
    const double radius = std::max(kSmallestDot, kDot * set.radius * box.scale);
    std::vector<Panel> panels;
    std::size_t columns = 0, rows = 0;
    for (const View& view : kViews) {
        Panel& panel = panels.emplace_back(view, box);
        if (set.mesh != nullptr)
            draw_surface(set, radius, panel);
        else
            draw_volume(set, radius, panel);
        columns += panel.columns() / kFine;
        rows = std::max(rows, panel.rows() / kFine);
    }
    return encode_png(
        {.columns = static_cast<std::uint32_t>(columns), .rows = static_cast<std::uint32_t>(rows)},
        [&](std::size_t row, std::span<std::uint8_t> bytes) {
            std::size_t at = 0;
            for (const Panel& panel : panels) {
                // Views stand in the middle of the picture's height.
                const std::size_t above = (rows - panel.rows() / kFine) / 2;
                for (std::size_t column = 0; column < panel.columns(); column += kFine, ++at) {
                    bytes[at] = 255;
                    if (row < above || row - above >= panel.rows() / kFine) continue;
                    unsigned sum = 0;
                    for (std::size_t k = 0; k < kFine * kFine; ++k)
                        sum += panel.grey(column + k % kFine, (row - above) * kFine + k / kFine);
                    bytes[at] = static_cast<std::uint8_t>(sum / (kFine * kFine));
                }
            }
        });
}

}  // namespace

std::string encode(const files::SetInSpace& set, const files::Format& format) {
    return format.name() == "png" ? draw_in_space(set) : files::encode(set, format);
}

}  // namespace lacuna::drawing
