// A table of two requests whose sets are one, or one the beginning of the other. That a set is the
// same on every backend and on any number of threads is shown by tests/pinned.txt and by hostile.
#include <gtest/gtest.h>
#include <lacuna/lacuna.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "backends/radius_field_requests.h"
#include "fields.h"

namespace two_requests_test {

using namespace lacuna;
using Changes = std::vector<std::function<void(Request&)>>;

Request request_of(const Changes& changes) {
    Request request;
    request.radius = 0.03;
    for (const auto& change : changes) change(request);
    return request;
}

TEST(TwoRequests, MakeOneSetOrTheBeginningOfIt) {
    const std::vector<Point> kept{{0.5, 0.25}, {0.625, 0.25}};
    const std::vector<std::uint8_t> kinds{0, 0};
    const Field ramp = tests::ramp_field(8, 4);
    Field sixteenth = ramp;
    for (double& value : sixteenth.importance) value /= 16;
    const Mask chess = tests::chess_mask(4, 3);
    const auto limit = [](std::uint64_t most) { return [=](Request& r) { r.limit = most; }; };
    const auto keep = [&](Request& r) { r.keep = kept; };
    const auto lines = [](Request& r) { r.mode = Mode::lines; };
    const auto order = [](std::uint64_t count) {
        return [=](Request& r) { r.radius.reset(), r.count = count, r.progressive = true; };
    };
    const auto classes = [](const std::vector<double>& distances) {
        return [=](Request& r) {
            r.radius.reset();
            r.classes.distances = distances;
            r.classes.names = {"a", "b"};
            r.classes.names.resize(distances.size() == 1 ? 1 : 2);
        };
    };
    const auto in_cells = [](const Field& field, double scale) {
        return [&field, scale](Request& r) {
            r.radius.reset();
            r.mode = Mode::cells, r.metric = Metric::mean, r.field = &field, r.scale = scale;
        };
    };
    const auto narrow = [](Request& r) {
        r.radius.reset(), r.count = 35, r.seed = 16328330612595979849ULL;
        r.mode = Mode::lines, r.paper2011.snap = true, r.paper2011.round_size = 1;
        r.domain = {0.14892936738060039, 2.9166350630812974, Boundary::torus};
    };
    const auto one = classes({0.03}), two = classes({0.08, 0.06, 0.06, 0.04});
    struct Row {
        std::string name;
        Changes whole, part;
    };
    std::vector<Row> rows{
        {"the default lines", {}, {[](Request& r) { r.paper2011.lines_per_radius = 6; }}},
        {"one class", {}, {one}},
        {"one class and kept points",
         {keep},
         {one, keep, [&](Request& r) { r.keep_classes = kinds; }}},
        {"the border and the mask of one class",
         {[&](Request& r) { r.places.border = 0.1, r.places.mask = &chess; }},
         {one,
          [&](Request& r) {
              r.places.border = 0.3, r.places.borders = {0.1}, r.places.masks = {&chess};
          }}},
        {"a limit of a count, whose first radius has room for fewer points",
         {narrow},
         {narrow, limit(8)}},
        {"a sixteenth of the importance", {in_cells(ramp, 0.04)}, {in_cells(sixteenth, 0.01)}},
        {"a number of a class, which comes first as if the other were not there",
         {two,
          [](Request& r) {
              r.classes.counts = {{}, 60};
          }},
         {two, limit(60),
          [](Request& r) {
              r.classes.weights = {0, 1};
          }}},
        {"an order and a limit", {order(700)}, {order(700), limit(123)}}};
    for (const std::uint64_t count : {1U, 16U, 17U, 300U, 699U})
        rows.push_back({"an order", {order(700)}, {order(count)}});
    for (const std::uint64_t most : {1U, 2U, 100U, 1'000'000U})
        for (const Changes& mode : {Changes{}, Changes{lines}}) {
            rows.push_back({"a limit", mode, mode});
            rows.back().part.emplace_back(limit(most));
        }
    for (const auto& [name, whole, part] : rows) {
        SCOPED_TRACE(name);
        const Request asked = request_of(part);
        const Result all = sample(request_of(whole)), some = sample(asked);
        const std::uint64_t most = asked.limit.value_or(asked.count.value_or(all.points.size()));
        ASSERT_EQ(some.points.size(), std::min<std::uint64_t>(most, all.points.size()));
        EXPECT_TRUE(std::equal(some.points.begin(), some.points.end(), all.points.begin()));
        EXPECT_EQ(some.maximal, some.points.size() == all.points.size() && all.maximal);
    }
}

}  // namespace two_requests_test
