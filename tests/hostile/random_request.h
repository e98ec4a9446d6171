// Random requests with everything that is hard for the paper's loop: radii as large as the domain,
// aspects of 1000, rounds of one draw and of a million, importance over eight powers of ten.
#pragma once

#include <lacuna/lacuna.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <utility>

namespace lacuna::tests {

struct HostileRequest {
    std::shared_ptr<const Field> field;  // in cells, and in exact with a radius field
    std::shared_ptr<const Mask> mask;
    Request request;
    std::shared_ptr<const Field> sparse;  // over which some of the points are relaxed, or null
    std::uint32_t iterations = 0;
};

class RandomRequests {
public:
    explicit RandomRequests(std::uint64_t seed) : random_(seed) {}

    HostileRequest next() {
        HostileRequest made;
        Request& request = made.request;
        request.mode = std::array{Mode::exact, Mode::lines, Mode::cells}[below(3)];
        request.boundary = one_in(2) ? Boundary::torus : Boundary::box;
        const double aspect = one_in(3) ? 1 : power(1, 1000);
        const double side = power(1e-6, 1e6);
        request.width = one_in(2) ? side : side * aspect;
        request.height = request.width == side ? side * aspect : side;
        request.seed = random_();
        request.threads = 1 + below(4);
        if (one_in(4)) request.limit = below(300) + 1;
        choose_round_size(request);
        if (request.mode == Mode::cells)
            choose_field(made);
        else if (request.mode == Mode::exact && one_in(2))
            choose_radius_field(made);
        else
            choose_radius(request);
        if (one_in(4)) choose_sparse(made);
        return made;
    }

private:
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    bool one_in(std::uint32_t many) { return below(many) == 0; }
    // A number from low to high; all powers are equally likely.
    double power(double low, double high) {
        const double part = static_cast<double>(random_() >> 11) * 0x1p-53;
        return std::min(high, low * std::pow(high / low, part));
    }

    void choose_round_size(Request& request) {
        if (one_in(3)) return;  // automatic
        request.round_size = static_cast<std::uint64_t>(power(1, one_in(20) ? 1e6 : 3e4));
    }

    // The reference builds the whole cdf in each round, so sets with small rounds have few points.
    double most_points(const Request& request) const {
        return request.round_size != 0 && request.round_size < 10 ? 100 : 2000;
    }

    void choose_radius(Request& request) {
        request.lines_per_radius = static_cast<std::uint32_t>(power(1, one_in(20) ? 1000 : 60));
        const double points = power(0.3, most_points(request));
        const double radius = std::sqrt(0.7 * request.width * request.height / points);
        const double largest = request.boundary == Boundary::torus
                                   ? std::min(request.width, request.height)
                                   : std::hypot(request.width, request.height);
        request.radius = std::min(radius, largest);
        if (request.mode != Mode::lines) return;
        request.snap = one_in(3);
        if (request.round_size != 0 && request.round_size < 10 && one_in(2)) {
            request.uniform_x = true;
            request.round_size = 1;
        }
    }

    void choose_field(HostileRequest& made) {
        Request& request = made.request;
        request.metric = std::array{Metric::min, Metric::mean, Metric::max}[below(3)];
        request.lines_per_radius = static_cast<std::uint32_t>(power(1, 40));
        Field field;
        field.columns = static_cast<std::uint32_t>(power(1, 60));
        field.rows = static_cast<std::uint32_t>(power(1, 60));
        const double range = power(1, 1e8);
        const bool has_two = one_in(2);
        for (std::size_t i = 0; i < std::size_t{field.columns} * field.rows; ++i) {
            const double share = has_two ? (one_in(2) ? 1 : 1 / range) : power(1 / range, 1);
            field.importance.push_back(one_in(8) ? 0 : share);
        }
        field.importance[below(static_cast<std::uint32_t>(field.importance.size()))] = 1;
        // With mean and max the reference looks at the whole lattice for each sample.
        const double points = power(1, request.metric == Metric::min ? 1e6 : 1e5);
        request.scale =
            request.lines_per_radius.value() * std::sqrt(request.width * request.height / points);
        request.limit = std::min<std::uint64_t>(request.limit.value_or(1000),
                                                static_cast<std::uint64_t>(most_points(request)));
        made.field = std::make_shared<const Field>(std::move(field));
        request.field = made.field.get();
    }

    // Radii differ by up to a factor of 10^6.
    void choose_radius_field(HostileRequest& made) {
        Request& request = made.request;
        if (one_in(4)) request.lines_per_radius = below(5) + 1;
        if (request.boundary == Boundary::box && one_in(3))
            request.border = power(1e-6, 0.49) * std::min(request.width, request.height);
        const bool has_mask = one_in(3);
        if (has_mask) choose_mask(made);
        const double points = power(0.3, most_points(request));
        const double radius = std::sqrt(0.7 * request.width * request.height / points);
        if (has_mask && one_in(2)) {
            request.radius = radius;
            return;
        }
        Field field;
        field.columns = static_cast<std::uint32_t>(power(1, 60));
        field.rows = static_cast<std::uint32_t>(power(1, 60));
        const double range = power(1, 1e12);
        const bool has_two = one_in(2);
        double sum = 0;
        for (std::size_t i = 0; i < std::size_t{field.columns} * field.rows; ++i) {
            const double share = has_two ? (one_in(2) ? 1 : 1 / range) : power(1 / range, 1);
            field.importance.push_back(one_in(8) ? 0 : share);
            sum += field.importance.back();
        }
        sum += field.importance[0] == 0 ? 1 : 0;
        if (field.importance[0] == 0) field.importance[0] = 1;
        request.scale = radius * std::sqrt(sum / static_cast<double>(field.importance.size()));
        request.limit = request.limit.value_or(3000);
        made.field = std::make_shared<const Field>(std::move(field));
        request.field = made.field.get();
    }

    void choose_mask(HostileRequest& made) {
        Mask mask;
        mask.columns = static_cast<std::uint32_t>(power(1, 100));
        mask.rows = static_cast<std::uint32_t>(power(1, 100));
        const std::uint32_t many = 2 + below(30);
        for (std::size_t i = 0; i < std::size_t{mask.columns} * mask.rows; ++i)
            mask.allowed.push_back(one_in(many) ? 1 : 0);
        mask.allowed[below(static_cast<std::uint32_t>(mask.allowed.size()))] = 255;
        made.mask = std::make_shared<const Mask>(std::move(mask));
        made.request.mask = made.mask.get();
    }

    // A picture with so few pixels that most points begin far from importance.
    void choose_sparse(HostileRequest& made) {
        Field field;
        field.columns = static_cast<std::uint32_t>(power(1, 80));
        field.rows = static_cast<std::uint32_t>(power(1, 80));
        const std::size_t pixels = std::size_t{field.columns} * field.rows;
        field.importance.assign(pixels, 0);
        const double range = power(1, 1e6);
        for (std::uint32_t many = 1 + below(6); many != 0; --many)
            field.importance[random_() % pixels] = power(1 / range, 1);
        made.sparse = std::make_shared<const Field>(std::move(field));
        made.iterations = 1 + below(3);
    }

    std::mt19937_64 random_;
};

// A message about the request. The seed and the number, not the message, make it again.
inline std::string describe(const HostileRequest& made) {
    const Request& request = made.request;
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << name_of(request.mode) << ", " << request.width << "x" << request.height
        << (request.boundary == Boundary::torus ? " torus" : " box");
    if (request.radius) out << ", radius " << *request.radius;
    if (made.field)
        out << ", " << made.field->columns << "x" << made.field->rows << " pixels, scale "
            << *request.scale << ", metric " << name_of(request.metric);
    out << ", m " << *request.lines_per_radius << ", round size " << request.round_size
        << ", limit " << request.limit.value_or(0) << ", seed " << request.seed << ", threads "
        << request.threads << (request.snap ? ", snap" : "")
        << (request.uniform_x ? ", uniform-x" : "");
    if (made.sparse)
        out << ", relaxed over " << made.sparse->columns << "x" << made.sparse->rows << " pixels, "
            << made.iterations << " iterations";
    return out.str();
}

}  // namespace lacuna::tests
