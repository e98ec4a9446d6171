// Cuts the domain into squares until no edge comes near to a square, or all of it is near to one.
//
// Each square has lists of the edges that still matter to it, a part of the lists of the square
// around it. Which side of the edges it lies on is found in its lowest row: it is inside if an odd
// number of edges crosses the middle of that row to the left of the square. Most of these edges
// cross all rows of some square around it: then their number is remembered, and not they.
#include "places/draw_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/polling.h"

namespace lacuna::places {
namespace {

// An edge, cut off where it is far from the domain. Otherwise distances from long edges would lose
// their digits.
struct Edge {
    Point lower;
    Point upper;
    double slope;             // change of x per unit of y
    std::uint32_t first_row;  // of the rows whose middles it crosses, counted from the bottom
    std::uint32_t end_row;

    double x_at(double y) const { return lower.x + (y - lower.y) * slope; }
};

// The first row whose middle is at or above `at`, which is in rows. It is limited to the mask, so
// that the ends of two adjoining edges always agree.
std::uint32_t first_middle_from(double at, std::uint32_t rows) {
    return static_cast<std::uint32_t>(
        std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(rows)));
}

double squared(double x, double y) {
    return x * x + y * y;
}

double squared_distance(Point at, const Edge& edge) {
    const double dx = edge.upper.x - edge.lower.x;
    const double dy = edge.upper.y - edge.lower.y;
    const double length = squared(dx, dy);
    const double along = (at.x - edge.lower.x) * dx + (at.y - edge.lower.y) * dy;
    const double share = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    return squared(at.x - (edge.lower.x + share * dx), at.y - (edge.lower.y + share * dy));
}

// Cuts the edge off where `side` of a point is negative; false if nothing is left. A cut point lies
// on the side exactly.
template <typename Side, typename Put>
bool cut_off(Point& lower, Point& upper, Side side, Put put) {
    const double below = side(lower), above = side(upper);
    if (below < 0 && above < 0) return false;
    if (below >= 0 && above >= 0) return true;
    Point& cut = below < 0 ? lower : upper;
    const double share = below / (below - above);
    cut = {lower.x + share * (upper.x - lower.x), lower.y + share * (upper.y - lower.y)};
    put(cut);
    return true;
}

// Whether something of the edge is left within `far` of the domain.
bool cut_off_far(Point& lower, Point& upper, const Canvas& canvas, double far) {
    const double right = canvas.domain.width + far, top = canvas.domain.height + far;
    return cut_off(
               lower, upper, [&](Point p) { return p.x + far; }, [&](Point& p) { p.x = -far; }) &&
           cut_off(
               lower, upper, [&](Point p) { return right - p.x; },
               [&](Point& p) { p.x = right; }) &&
           cut_off(
               lower, upper, [&](Point p) { return p.y + far; }, [&](Point& p) { p.y = -far; }) &&
           cut_off(
               lower, upper, [&](Point p) { return top - p.y; }, [&](Point& p) { p.y = top; });
}

struct Square {
    unsigned level;  // it is 2^level pixels wide, but ends where the mask ends
    double left;
    double right;
    double bottom;
    double top;
    std::uint32_t first_row;
    std::uint32_t end_row;

    Point centre() const { return {(left + right) / 2, (bottom + top) / 2}; }
    std::array<Point, 4> corners() const {
        return {Point{left, bottom}, Point{right, bottom}, Point{left, top}, Point{right, top}};
    }
    double squared_distance_to(Point at) const {
        return squared(std::max({left - at.x, 0.0, at.x - right}),
                       std::max({bottom - at.y, 0.0, at.y - top}));
    }
};

// Whether an edge meets the square, its sides included.
bool meet(const Square& square, const Edge& edge) {
    double begin = 0;
    double end = 1;
    const auto cut = [&](double at, double step, double low, double high) {
        if (step == 0) return at >= low && at <= high;
        begin = std::max(begin, ((step > 0 ? low : high) - at) / step);
        end = std::min(end, ((step > 0 ? high : low) - at) / step);
        return begin <= end;
    };
    return cut(edge.lower.x, edge.upper.x - edge.lower.x, square.left, square.right) &&
           cut(edge.lower.y, edge.upper.y - edge.lower.y, square.bottom, square.top);
}

bool is_near(const Square& square, const Edge& edge, double squared_reach) {
    if (square.squared_distance_to(edge.lower) <= squared_reach ||
        square.squared_distance_to(edge.upper) <= squared_reach || meet(square, edge))
        return true;
    const auto corners = square.corners();
    return std::any_of(corners.begin(), corners.end(), [&](Point corner) {
        return squared_distance(corner, edge) <= squared_reach;
    });
}

// Disks are convex, so it is enough to look at the corners.
bool is_all_near(const Square& square, const Edge& edge, double squared_reach) {
    const auto corners = square.corners();
    return std::all_of(corners.begin(), corners.end(), [&](Point corner) {
        return squared_distance(corner, edge) <= squared_reach;
    });
}

// Whether samples may lie in a square, as far as it is known.
enum class Answer { no, yes, in_parts };

class Drawer {
public:
    Drawer(std::span<const PolygonSet> sets, const Canvas& canvas, std::size_t most_nodes)
        : canvas_(canvas),
          scale_{canvas.columns / canvas.domain.width, canvas.rows / canvas.domain.height},
          most_nodes_(most_nodes),
          tree_(canvas.columns, canvas.rows) {
        for (const PolygonSet& set : sets) add(set);
    }

    std::optional<MaskTree> draw() {
        const State all{0, active_.size(), false, false};
        const MaskTree::Piece root = piece_of(tree_.root() + 2, 0, 0, all);
        if (tree_.nodes().size() > most_nodes_) return std::nullopt;
        tree_.set_root(root);
        return std::move(tree_);
    }

private:
    struct Kind {
        bool forbidden;
        bool near;
        bool keeps_distance;
        double reach;
    };
    // A part of a stack.
    struct List {
        std::size_t begin;
        std::size_t end;
    };
    // A set that has not decided about a square.
    struct Active {
        std::uint32_t kind;
        bool is_odd;  // whether an odd number of edges that are in no list lies to the left
        List near;    // edges that come near to the square
        List left;    // edges that cross some of its rows to the left of it
    };
    struct State {
        std::size_t begin;  // of the sets in active_
        std::size_t end;
        bool is_allowed;  // whether the square lies inside of a set that is not forbidden
        bool is_near;     // whether it lies near enough to a set
    };

    void add(const PolygonSet& set) {
        const double spare = canvas_.domain.longer_side() * 0x1p-27;
        const bool near = set.role == Role::near;
        const Kind kind{is_forbidden(set.role), near, set.distance > 0,
                        near ? std::max(0.0, set.distance - spare) : set.distance + spare};
        Active active{
            static_cast<std::uint32_t>(kinds_.size()), false, {near_.size(), 0}, {left_.size(), 0}};
        for (const PolygonRing& ring : set.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                add(from_corner(ring[i]), from_corner(ring[(i + 1) % ring.size()]),
                    canvas_.domain.longer_side() + kind.reach);
        active.near.end = near_.size();
        active.left.end = left_.size();
        active_.push_back(active);
        kinds_.push_back(kind);
        has_inside_ |= set.role == Role::inside;
        has_near_ |= near;
    }

    // Edges and squares are seen from the domain's corner.
    Point from_corner(Point point) const {
        return {point.x - canvas_.domain.x0, point.y - canvas_.domain.y0};
    }
    void add(Point lower, Point upper, double far) {
        ask_after();
        if (lower.y > upper.y) std::swap(lower, upper);
        Edge edge{lower, upper, (upper.x - lower.x) / (upper.y - lower.y),
                  first_middle_from(lower.y * scale_.y, canvas_.rows),
                  first_middle_from(upper.y * scale_.y, canvas_.rows)};
        const bool is_near = cut_off_far(lower, upper, canvas_, far);
        const bool crosses = edge.first_row < edge.end_row;
        if (is_near) {
            edge.lower = lower;
            edge.upper = upper;
        } else if (!crosses ||
                   edge.x_at((edge.first_row + 0.5) / scale_.y) > canvas_.domain.width / 2) {
            return;
        }
        (is_near ? near_ : left_).push_back(static_cast<std::uint32_t>(edges_.size()));
        edges_.push_back(edge);
    }

    Square square_at(unsigned level, std::uint32_t column, std::uint32_t row) const {
        const std::uint32_t side = 1U << level;
        const std::uint32_t end_column = std::min(column + side, canvas_.columns);
        const std::uint32_t end_row = std::min(row + side, canvas_.rows);
        return {level,          column / scale_.x,  end_column / scale_.x,
                row / scale_.y, end_row / scale_.y, row,
                end_row};
    }

    // The four quarters of a square of 2^level pixels that lie on the mask.
    template <typename Use>
    void for_quarters(unsigned level, std::uint32_t column, std::uint32_t row, Use use) const {
        const std::uint32_t half = 1U << (level - 1);
        for (const std::uint32_t y : {0U, half})
            for (const std::uint32_t x : {0U, half})
                if (column + x < canvas_.columns && row + y < canvas_.rows)
                    use(column + x, row + y);
    }

    // The piece of a square that its sets have not decided.
    MaskTree::Piece piece_of(unsigned level, std::uint32_t column, std::uint32_t row,
                             const State& state) {
        std::array<MaskTree::Piece, MaskTree::kSlots> slots{};
        if (tree_.nodes().size() > most_nodes_) return {};
        for_quarters(level, column, row, [&](std::uint32_t x, std::uint32_t y) {
            const Restored restored(*this);
            State half{};
            const Answer answer = narrow(state, square_at(level - 1, x, y), half);
            for_quarters(level - 1, x, y, [&](std::uint32_t i, std::uint32_t j) {
                const Restored again(*this);
                State quarter{};
                const Answer own = answer == Answer::in_parts
                                       ? narrow(half, square_at(level - 2, i, j), quarter)
                                       : answer;
                MaskTree::Piece& slot = slots[portable::slot_of(i, j, level - 2)];
                if (own == Answer::in_parts)
                    slot = piece_of(level - 2, i, j, quarter);
                else
                    slot.value = own == Answer::yes ? ALLOWED_ALL : ALLOWED_NONE;
            });
        });
        return tree_.join(level - 2, column, row, slots);
    }

    // What the sets of a square say about a part of it. Those that do not decide are in `part`.
    Answer narrow(const State& state, const Square& square, State& part) {
        part = {active_.size(), active_.size(), state.is_allowed, state.is_near};
        bool may_be_allowed = state.is_allowed || !has_inside_;
        bool may_be_near = state.is_near || !has_near_;
        for (std::size_t i = state.begin; i < state.end; ++i) {
            const Active active = active_[i];
            const bool forbidden = kinds_[active.kind].forbidden;
            if (kinds_[active.kind].near) {
                const Answer answer = part.is_near ? Answer::yes : narrow_near(active, square);
                part.is_near |= answer == Answer::yes;
                may_be_near |= answer != Answer::no;
                continue;
            }
            if (!forbidden && part.is_allowed) continue;
            const Answer answer = narrow(active, square);
            if (forbidden && answer == Answer::no) return Answer::no;
            if (!forbidden && answer == Answer::yes) part.is_allowed = true;
            if (!forbidden && answer != Answer::no) may_be_allowed = true;
        }
        if (!may_be_allowed || !may_be_near) return Answer::no;
        part.end = active_.size();
        return part.begin == part.end ? Answer::yes : Answer::in_parts;
    }

    // Pushes the set with shorter lists, unless it decides about all of the square.
    Answer narrow(const Active& outer, const Square& square) {
        ask_after(1 + outer.near.end - outer.near.begin + outer.left.end - outer.left.begin);
        const Kind& kind = kinds_[outer.kind];
        Active active{outer.kind, outer.is_odd, {near_.size(), 0}, {left_.size(), 0}};
        const Point centre = square.centre();
        constexpr double kRounding = 1e-12;  // of the longer side, more than that of coordinates
        const double reach = kind.reach + kRounding * canvas_.domain.longer_side() +
                             std::sqrt(squared(square.right - centre.x, square.top - centre.y));
        for (std::size_t i = outer.near.begin; i < outer.near.end; ++i) {
            const Edge& edge = edges_[near_[i]];
            if (squared_distance(centre, edge) <= reach * reach) {
                const double own = kind.reach * kind.reach;
                if (kind.keeps_distance && is_all_near(square, edge, own)) return Answer::no;
                if (is_near(square, edge, own)) {
                    near_.push_back(near_[i]);
                    continue;
                }
            }
            if (is_left(edge, square, centre.x)) push_left(near_[i], square, active);
        }
        for (std::size_t i = outer.left.begin; i < outer.left.end; ++i)
            push_left(left_[i], square, active);
        active.near.end = near_.size();
        active.left.end = left_.size();
        if (active.near.begin != active.near.end) {
            if (square.level == 0) return Answer::no;
            active_.push_back(active);
            return Answer::in_parts;
        }
        bool is_inside = active.is_odd;
        for (std::size_t i = active.left.begin; i < active.left.end; ++i) {
            const Edge& edge = edges_[left_[i]];
            is_inside ^= edge.first_row <= square.first_row && square.first_row < edge.end_row;
        }
        return is_inside != kind.forbidden ? Answer::yes : Answer::no;
    }

    // The same for a set that samples must be near to: yes if all of the square is near one edge.
    Answer narrow_near(const Active& outer, const Square& square) {
        ask_after(1 + outer.near.end - outer.near.begin);
        const double reach = kinds_[outer.kind].reach * kinds_[outer.kind].reach;
        Active active{outer.kind, false, {near_.size(), 0}, {left_.size(), left_.size()}};
        for (std::size_t i = outer.near.begin; i < outer.near.end; ++i) {
            const Edge& edge = edges_[near_[i]];
            if (is_all_near(square, edge, reach)) return Answer::yes;
            if (is_near(square, edge, reach)) near_.push_back(near_[i]);
        }
        active.near.end = near_.size();
        if (active.near.begin == active.near.end || square.level == 0) return Answer::no;
        active_.push_back(active);
        return Answer::in_parts;
    }

    // Whether an edge that does not meet the square crosses some of its rows to the left of it. The
    // part of the edge in these rows lies all on one side.
    bool is_left(const Edge& edge, const Square& square, double middle) const {
        const std::uint32_t first = std::max(edge.first_row, square.first_row);
        const std::uint32_t end = std::min(edge.end_row, square.end_row);
        if (first >= end) return false;
        const std::uint32_t row = first + (end - first) / 2;
        return edge.x_at((row + 0.5) / scale_.y) < middle;
    }

    void push_left(std::uint32_t number, const Square& square, Active& active) {
        const Edge& edge = edges_[number];
        if (edge.first_row >= square.end_row || edge.end_row <= square.first_row) return;
        if (edge.first_row <= square.first_row && edge.end_row >= square.end_row)
            active.is_odd = !active.is_odd;
        else
            left_.push_back(number);
    }

    // Shortens the stacks again.
    class Restored {
    public:
        explicit Restored(Drawer& drawer)
            : drawer_(drawer),
              active_(drawer.active_.size()),
              near_(drawer.near_.size()),
              left_(drawer.left_.size()) {}
        ~Restored() {
            shorten(drawer_.active_, active_);
            shorten(drawer_.near_, near_);
            shorten(drawer_.left_, left_);
        }
        Restored(const Restored&) = delete;
        Restored& operator=(const Restored&) = delete;

    private:
        template <typename Item>
        static void shorten(std::vector<Item>& stack, std::size_t size) {
            stack.erase(stack.begin() + static_cast<std::ptrdiff_t>(size), stack.end());
        }

        Drawer& drawer_;
        std::size_t active_;
        std::size_t near_;
        std::size_t left_;
    };

    const Canvas& canvas_;
    Point scale_;  // pixels per unit of the domain
    std::size_t most_nodes_;
    MaskTree tree_;
    bool has_inside_ = false;
    bool has_near_ = false;
    std::vector<Kind> kinds_;
    std::vector<Edge> edges_;
    // Stacks: of sets, and of numbers of edges.
    std::vector<Active> active_;
    std::vector<std::uint32_t> near_;
    std::vector<std::uint32_t> left_;
};

// How far off a distance may be because coordinates are doubles.
double rounding_of(Point a, Point b, Point c) {
    double largest = 0;
    for (const Point point : {a, b, c})
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return 0x1p-51 * largest;
}

}  // namespace

std::optional<MaskTree> draw_tree(std::span<const PolygonSet> sets, const Canvas& canvas,
                                  std::size_t most_nodes) {
    return Drawer(sets, canvas, most_nodes).draw();
}

bool allow(std::span<const PolygonSet> sets, Point at, bool may_touch) {
    bool has_inside = false, is_allowed = false, has_near = false, is_near = false;
    for (const PolygonSet& set : sets) {
        const bool forbidden = is_forbidden(set.role);
        has_inside |= set.role == Role::inside;
        has_near |= set.role == Role::near;
        bool is_inside = false, is_too_near = false, is_within = false, is_on_edge = false;
        for (const PolygonRing& ring : set.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point from = ring[i], to = ring[(i + 1) % ring.size()];
                const double away = squared_distance(at, {from, to, 0, 0, 0});
                const double rounding = may_touch ? rounding_of(at, from, to) : 0;
                const double least = std::max(0.0, set.distance - rounding);
                const double most = set.distance + rounding;
                is_on_edge |= may_touch && away <= rounding * rounding;
                is_too_near |= away < least * least;
                is_within |= away <= most * most;
                if ((from.y > at.y) == (to.y > at.y)) continue;
                is_inside ^= at.x < from.x + (at.y - from.y) / (to.y - from.y) * (to.x - from.x);
            }
        is_near |= set.role == Role::near && is_within;
        if (set.role == Role::near) continue;
        if (forbidden && ((is_inside && !is_on_edge) || is_too_near)) return false;
        is_allowed |= !forbidden && (is_inside || is_on_edge) && !is_too_near;
    }
    return (is_allowed || !has_inside) && (is_near || !has_near);
}

}  // namespace lacuna::places
