// Reads rings from text: a point on each line, and a blank line or a comment between two rings.
#include <fmt/core.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "domains/rings.h"
#include "files/parse.h"
#include "files/text_lines.h"

namespace lacuna::domains {
namespace {

// Collects rings, and remembers the line at which each began.
class Rings {
public:
    Rings(const std::string& name, Take take) : name_(name), take_(take) {}

    void add(Point point, std::size_t line) {
        if (!is_fair(point))
            files::refuse(fmt::format("{}:{}", name_, line),
                          fmt::format("({}, {}): {}", point.x, point.y, kFair));
        if (ring_.empty()) begin_ = line;
        ring_.push_back(point);
    }

    void end_ring() {
        if (ring_.empty()) return;
        open(ring_);
        if (take_ == Take::lines) {
            polygons_.rings.push_back(around_and_back(std::exchange(ring_, {})));
            return;
        }
        if (ring_.size() < 3)
            files::refuse(fmt::format("{}:{}", name_, begin_),
                          fmt::format("a ring of {} point{}: must be at least 3", ring_.size(),
                                      ring_.size() == 1 ? "" : "s"));
        polygons_.rings.push_back(std::exchange(ring_, {}));
    }

    Polygons finish() {
        end_ring();
        if (take_ == Take::insides) polygons_.rings = joined(std::move(polygons_.rings));
        return std::move(polygons_);
    }

private:
    const std::string& name_;
    Take take_;
    Polygons polygons_;
    PolygonRing ring_;
    std::size_t begin_ = 0;
};

}  // namespace

Polygons decode_rings(std::string_view bytes, const std::string& name, Take take) {
    bytes = files::without_byte_order_mark(bytes);
    Rings rings(name, take);
    for (std::size_t number = 1; !bytes.empty(); ++number) {
        const std::string_view line = files::take_line(bytes);
        if (files::is_skipped(line)) {
            rings.end_ring();
            continue;
        }
        Point point{};
        if (!files::read_line(line, point)) files::refuse_line(name, number, line);
        rings.add(point, number);
    }
    return rings.finish();
}

}  // namespace lacuna::domains
