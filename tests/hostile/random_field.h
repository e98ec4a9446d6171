// Requests of mode exact at random with radius fields of every hostile kind: fields, masks,
// polygons drawn onto a mask, borders and points that are kept, alone and together, of some hundred
// points or fewer.
#pragma once

#include <lacuna/domains.h>
#include <lacuna/lacuna.h>
#include <lacuna/verify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "hostile/random_polygons.h"
#include "verify/field_sets.h"

namespace lacuna::tests {

using verify::any_in;

struct HostileField {
    // The request in the form of the slow checks of tests/verify; only `drawn` has `rings`.
    verify::FieldCase asked;
    bool has_field = true;  // otherwise one radius, the scale
    std::vector<PolygonRing> rings;
    double edge = 0;
    std::vector<Point> keep;
    Request options;  // the rest of the request

    // The requests are valid while this object exists and is not moved.
    Request request() const {
        Request request = options;
        request.width = asked.domain.width;
        request.height = asked.domain.height;
        request.boundary = asked.domain.torus ? Boundary::torus : Boundary::box;
        request.border = asked.border;
        request.keep = keep;
        if (asked.mask) request.mask = &*asked.mask;
        if (has_field) request.field = &asked.field;
        (has_field ? request.scale : request.radius) = asked.scale;
        return request;
    }
    Claim claim(const verify::FieldCase& seen) const {
        Claim claim = seen.claim();
        claim.keep = keep;
        if (has_field) return claim;
        claim.field = nullptr;
        claim.scale = 0;
        claim.radius = asked.scale;
        return claim;
    }
    // With the polygons instead of the mask that they were drawn onto.
    verify::FieldCase drawn() const {
        verify::FieldCase seen = asked;
        seen.mask.reset();
        seen.rings = rings;
        seen.edge = edge;
        return seen;
    }
    double least_radius() const {
        const std::vector<double>& all = asked.field.importance;
        return asked.scale / std::sqrt(*std::max_element(all.begin(), all.end()));
    }
};

// Field number k of a seed does not depend on the fields made before.
class RandomField {
public:
    RandomField(std::uint64_t seed, std::uint64_t number) : random_(seed_of(seed, number)) {}

    HostileField make() {
        HostileField made;
        choose_radii(made);
        switch (below(4)) {
            case 0:
                choose_polygons(made);
                break;
            case 1:
            case 2:
                choose_mask(made);
                break;
            default:
                break;
        }
        if (!made.asked.domain.torus && one_in(2)) choose_border(made);
        if (one_in(2)) choose_kept(made);
        made.options.seed = random_();
        made.options.threads = 1 + below(2);
        if (one_in(4)) made.options.lines_per_radius = 1 + below(5);
        if (one_in(4)) made.options.round_size = std::vector<std::uint64_t>{1, 7, 5000}[below(3)];
        return made;
    }

    // Keeps some of the points of a set, as if it had been stopped there.
    void resume(HostileField& made, const std::vector<Point>& points) {
        made.asked.name += ", resumed";
        made.keep.assign(points.begin(), points.begin() + below_size(points.size()));
        made.options.seed = random_();
    }

    std::mt19937_64& random() { return random_; }

private:
    static std::uint64_t seed_of(std::uint64_t seed, std::uint64_t number) {
        std::seed_seq mixed{seed, seed >> 32, number, number >> 32};
        std::uint32_t words[2];
        mixed.generate(words, words + 2);
        return std::uint64_t{words[0]} << 32 | words[1];
    }

    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    std::ptrdiff_t below_size(std::size_t end) {
        return end == 0 ? 0 : static_cast<std::ptrdiff_t>(random_() % end);
    }
    bool one_in(std::uint32_t many) { return below(many) == 0; }

    void choose_radii(HostileField& made) {
        made.asked = verify::hostile_case(random_());
        if (one_in(3)) made.asked.scale *= any_in(random_, 0.25, 1);
        if (one_in(2)) return;
        made.has_field = false;
        made.asked.name = "one radius";
        made.asked.field = {1, 1, {1}};
        verify::Domain& domain = made.asked.domain;
        if (one_in(4)) domain.height = domain.width * std::pow(10, any_in(random_, -2.9, 2.9));
        const double shorter = std::min(domain.width, domain.height);
        const double most = domain.torus ? shorter : std::hypot(domain.width, domain.height);
        const double least = std::sqrt(domain.width * domain.height) / 25;
        const double share = one_in(8) ? 1 : any_in(random_, 0, 1);
        made.asked.scale = std::min(most, least * std::pow(std::max(most / least, 1.0), share));
    }

    void choose_mask(HostileField& made) {
        Mask mask;
        const auto some = [&](std::uint32_t most) { return 1 + below(most); };
        const std::uint32_t kind = below(7);
        const auto fill = [&](const char* name, std::uint32_t columns, std::uint32_t rows,
                              auto is_allowed) {
            made.asked.name += name;
            mask = {columns, rows, {}};
            for (std::uint32_t row = 0; row < rows; ++row)
                for (std::uint32_t column = 0; column < columns; ++column)
                    mask.allowed.push_back(is_allowed(column, row) ? 1 : 0);
        };
        const auto noise = [&](auto, auto) { return one_in(2); };
        if (kind == 0) fill(", a mask of noise", some(40), some(40), noise);
        if (kind == 1) fill(", a fine mask of noise", 100 + some(200), 100 + some(200), noise);
        if (kind == 2)
            fill(", a checkerboard", some(20), some(20),
                 [](auto column, auto row) { return (column + row) % 2 == 0; });
        if (kind == 3) fill(", islands", 60, 60, [&](auto, auto) { return one_in(40); });
        if (kind == 4) fill(", one pixel", some(90), some(90), [](auto, auto) { return false; });
        if (kind == 5)
            one_in(2) ? fill(", a mask of a column", 1, some(50), noise)
                      : fill(", a mask of a row", some(50), 1, noise);
        if (kind == 6)
            fill(", stripes", 30, 30, [](auto column, auto row) {
                return column % 5 == 2 || (row % 7 == 3 && column > row);
            });
        open_any(made, mask);
    }

    // Sets the mask and opens one pixel, on which the field allows samples if 99 tries find such.
    void open_any(HostileField& made, Mask& mask) {
        made.asked.mask = std::move(mask);
        std::vector<std::uint8_t>& allowed = made.asked.mask->allowed;
        for (int i = 0; i < 100; ++i) {
            const Point at = verify::any_place(random_, made.asked.domain);
            if (i < 99 && !made.asked.radius_at(at)) continue;
            allowed[made.asked.pixel_of(at, made.asked.mask->columns, made.asked.mask->rows)] = 255;
            return;
        }
    }

    void choose_polygons(HostileField& made) {
        const verify::Domain& domain = made.asked.domain;
        const double longer = domain.longer_side();
        made.edge = std::clamp(made.least_radius() * std::pow(2, -any_in(random_, 1, 6)),
                               std::sqrt(domain.width * domain.height) / 600, longer / 10);
        const Rings rings = RandomPolygons(random_, domain, made.edge).next();
        made.asked.name += rings.name;
        made.rings = rings.rings;
        try {
            made.asked.mask = draw_mask(made.rings, domain.width, domain.height, made.edge);
        } catch (const BadRequest& error) {
            // The polygons are narrower than a pixel everywhere.
            if (error.option() != "inside") throw;
            made.rings.clear();
            made.asked.name += " that are lost";
        }
    }

    void choose_border(HostileField& made) {
        const double half = std::min(made.asked.domain.width, made.asked.domain.height) / 2;
        made.asked.name += ", a border";
        made.asked.border = half * std::vector<double>{1e-9, any_in(random_, 0, 0.5),
                                                       1 - 1e-3}[below(one_in(4) ? 3 : 2)];
    }

    // A point within 2^-28 of the longer side of several pixels has the least of their radii.
    std::optional<double> radius_of_kept(const HostileField& made, Point at) const {
        const verify::FieldCase& asked = made.asked;
        const verify::Domain& domain = asked.domain;
        if (!(at.x >= asked.border && domain.width - at.x >= asked.border && at.x >= 0 &&
              at.x < domain.width && at.y >= asked.border && at.y >= 0 && at.y < domain.height &&
              domain.height - at.y >= asked.border))
            return std::nullopt;
        const double blur = domain.longer_side() * 0x1p-28;
        std::optional<double> radius;
        bool is_open = false;
        for (const double dx : {-blur, 0.0, blur})
            for (const double dy : {-blur, 0.0, blur}) {
                const Point there{at.x + dx, at.y + dy};
                is_open |= !asked.mask || asked.mask->allowed[asked.pixel_of(
                                              there, asked.mask->columns, asked.mask->rows)] != 0;
                const auto one = asked.radius_at(there);
                if (one) radius = std::min(radius.value_or(*one), *one);
            }
        return is_open ? radius : std::nullopt;
    }

    // A point to keep: at a corner, on a border of pixels or close enough to count for both pixels,
    // at Request::border, anywhere, or at exactly the least distance from another kept point.
    Point any_kept(const HostileField& made, const std::vector<Point>& others) {
        const verify::FieldCase& asked = made.asked;
        const verify::Domain& domain = asked.domain;
        const auto along = [&](double side, std::uint32_t pixels, std::uint32_t mask_pixels) {
            switch (below(6)) {
                case 0:
                    return one_in(2) ? 0.0 : std::nextafter(side, 0);
                case 1:
                    return one_in(2) ? asked.border : side - asked.border;
                case 2:
                case 3: {
                    const std::uint32_t count = one_in(2) ? pixels : mask_pixels;
                    const double border = side * below(count + 1) / count;
                    const double near = 0.999 * domain.longer_side() * 0x1p-28;
                    return border + std::vector<double>{0, 0, near, -near, near / 8}[below(5)];
                }
                default:
                    return any_in(random_, 0, side);
            }
        };
        Point at{along(domain.width, asked.field.columns, asked.mask ? asked.mask->columns : 1),
                 along(domain.height, asked.field.rows, asked.mask ? asked.mask->rows : 1)};
        if (others.empty() || !one_in(4)) return at;
        at = others[below(static_cast<std::uint32_t>(others.size()))];
        (one_in(2) ? at.x : at.y) += radius_of_kept(made, at).value();
        return at;
    }

    void choose_kept(HostileField& made) {
        const std::uint32_t tries = 1 + below(one_in(3) ? 200 : 12);
        std::vector<double> radii;
        for (std::uint32_t i = 0; i < tries; ++i) {
            const Point at = any_kept(made, made.keep);
            const auto radius = radius_of_kept(made, at);
            bool is_free = radius.has_value();
            for (std::size_t k = 0; is_free && k < made.keep.size(); ++k)
                is_free =
                    made.asked.domain.distance(at, made.keep[k]) >= std::min(*radius, radii[k]);
            if (!is_free) continue;
            made.keep.push_back(at);
            radii.push_back(*radius);
        }
        if (!made.keep.empty()) made.asked.name += ", kept points";
    }

    std::mt19937_64 random_;
};

// A message about the field. The seed and the number, not the message, are needed to make it again.
inline std::string describe(const HostileField& made) {
    const verify::FieldCase& asked = made.asked;
    const auto size = [](const auto& picture) {
        return std::to_string(picture.columns) + "x" + std::to_string(picture.rows);
    };
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << asked.name << ": " << asked.domain.width << "x" << asked.domain.height
        << (asked.domain.torus ? " torus" : " box") << (made.has_field ? ", scale " : ", radius ")
        << asked.scale << ", field " << size(asked.field);
    if (asked.mask) out << ", mask " << size(*asked.mask);
    if (!made.rings.empty()) out << ", " << made.rings.size() << " rings, edge " << made.edge;
    out << ", border " << asked.border << ", " << made.keep.size() << " kept, round size "
        << made.options.round_size << ", seed " << made.options.seed;
    return out.str();
}

}  // namespace lacuna::tests
