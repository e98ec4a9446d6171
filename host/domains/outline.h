// Collects the rings of a drawing: transforms them, and turns curves into short lines.
#pragma once

#include <lacuna/domains.h>

#include <cstddef>
#include <optional>
#include <vector>

#include "domains/rings.h"

namespace lacuna::domains {

// Maps (x, y) to (xx x + xy y + x0, yx x + yy y + y0).
struct Affine {
    double xx = 1, xy = 0, yx = 0, yy = 1, x0 = 0, y0 = 0;

    Point of(Point point) const {
        return {xx * point.x + xy * point.y + x0, yx * point.x + yy * point.y + y0};
    }
    // The factor of all lengths; none if lengths in some directions grow by others.
    std::optional<double> scale() const;
    // The map that applies `inner` first and then this one.
    Affine after(const Affine& inner) const {
        const Point origin = of({inner.x0, inner.y0});
        return {xx * inner.xx + xy * inner.yx,
                xx * inner.xy + xy * inner.yy,
                yx * inner.xx + yy * inner.yx,
                yx * inner.xy + yy * inner.yy,
                origin.x,
                origin.y};
    }
};

// Radii and rotation of an ellipse, as in an arc of SVG.
struct Ellipse {
    double rx;
    double ry;
    double degrees;  // from the x axis to the axis of rx
};

class Outline {
public:
    // Lines are at most `tolerance` away from their curve. Only a curve so large that it would take
    // over 2^14 lines is less accurate.
    Outline(double tolerance, Take take) : tolerance_(tolerance), take_(take) {}

    void set_transform(const Affine& transform) { transform_ = transform; }

    // Coordinates are given before the transform. Each piece begins where the last one ended.
    void move_to(Point to);
    void line_to(Point to);
    void quadratic_to(Point control, Point to);
    void cubic_to(Point first, Point second, Point to);
    void arc_to(Ellipse ellipse, bool is_large, bool is_positive, Point to);
    // Closes the ring. A ring of fewer than three points encloses nothing and is dropped, unless
    // lines are taken.
    void close();

    Point current() const { return current_; }
    Point begin() const { return begin_; }
    std::size_t points() const { return points_; }
    // Whether all coordinates were finite, and none too large.
    bool is_fair() const { return is_fair_; }
    // Whether a piece of the shape is not closed.
    bool has_open_lines() const { return has_open_lines_ || is_open(); }
    // Ends the shape: the next one begins at (0, 0).
    std::vector<PolygonRing> take_rings();

private:
    void add(Point point);
    std::size_t pieces(double bend) const;
    void quarter_to(const Affine& circle, Point from, Point to, int halvings);

    bool is_open() const { return ring_.size() > 1 && ring_.front() != ring_.back(); }
    void end();  // of a path that is not closed

    double tolerance_;
    Take take_;
    Affine transform_;
    Point current_{0, 0};
    Point begin_{0, 0};
    PolygonRing ring_;
    std::vector<PolygonRing> rings_;
    std::size_t points_ = 0;
    bool is_fair_ = true;
    bool has_open_lines_ = false;
};

}  // namespace lacuna::domains
