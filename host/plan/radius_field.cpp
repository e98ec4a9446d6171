// Radii and masks in whole numbers.
#include "plan/radius_field.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/number_text.h"
#include "plan/ellipse.h"

namespace lacuna {
namespace {

// The border in the middle of all borders of pixels between begin and end; 0 if there is none.
std::uint32_t middle_border(const PixelAxis& axis, std::uint32_t begin, std::uint32_t end) {
    const auto [first, last] = pixels_of(axis, begin, end);
    return first == last ? 0 : axis.begin_of(first + (last - first + 1) / 2);
}

}  // namespace

PixelAxis::PixelAxis(std::uint32_t length, std::uint32_t pixels)
    : length_(length), pixels_(pixels), shift_(0) {
    __extension__ using Wide = unsigned __int128;
    while ((Wide{pixels} << shift_) / length < std::uint64_t{1} << 33) ++shift_;
    scale_ = static_cast<std::uint64_t>(((Wide{pixels} << shift_) + length - 1) / length);
}

bool RadiusField::Radii::are_mixed() const {
    return portable::are_radii_mixed(least, greatest_and_zeros);
}

RadiusField::Radii RadiusField::merge_radii(Radii a, Radii b) {
    return {portable::least_of_radii(a.least, b.least),
            portable::greatest_of_radii(a.greatest_and_zeros, b.greatest_and_zeros)};
}

std::vector<RadiusField::Radii> RadiusField::radii_of(const Field* field, double scale,
                                                      const Poll& poll) {
    // A radius beyond the diagonal covers everything, so it is cut there. It is rounded up by at
    // least 2^-10 units, more than doubles lose when converted back; by what is lost at a corner;
    // and by two more units if there are kept samples, because their coordinates may be off by a
    // unit along both axes.
    const double most = std::ceil(std::hypot(shape_.width, shape_.height));
    const std::uint32_t more = shape_.has_kept ? 3 : 1;
    const double unit = shape_.unit();
    const auto radius_of = [&](double importance) -> Radii {
        if (importance <= 0) return {0, HAS_ZEROS};
        const double units = std::min((scale / std::sqrt(importance) + shape_.lost) / unit, most);
        const std::uint32_t radius = static_cast<std::uint32_t>(units + 1.0 / 1024) + more;
        return {radius, radius};
    };
    if (field == nullptr) return {radius_of(1)};
    std::vector<Radii> radii(field->importance.size());
    const std::vector<Stretch>& stretches = field->stretches;
    ellipses_.resize(stretches.size());
    const GridOfEllipses grid{shape_.unit_x, shape_.unit_y, more, most, shape_.lost};
    const auto stretched = [&](double importance, const Stretch& stretch, std::size_t pixel) {
        if (importance <= 0) return Radii{0, HAS_ZEROS};
        const RoundedEllipse found =
            rounded(lacuna::stretched(scale / std::sqrt(importance), stretch), grid);
        ellipses_[pixel] = found.ellipse;
        return Radii{found.inner, found.outer};
    };
    // Columns in a tile: the values that are written stay in the cache from row to row.
    constexpr std::uint32_t kTile = 64;
    const std::uint32_t columns = field->columns;
    const std::uint32_t rows = field->rows;
    const auto fill_tile = [&](std::size_t tile) {
        const std::uint32_t first = static_cast<std::uint32_t>(tile) * kTile;
        const std::uint32_t end = std::min(first + kTile, columns);
        for (std::uint32_t row = 0; row < rows; ++row) {
            const std::size_t line = std::size_t{rows - 1 - row} * columns;
            for (std::uint32_t column = first; column < end; ++column) {
                const std::size_t pixel = std::size_t{column} * rows + row;
                const double importance = field->importance[line + column];
                radii[pixel] = stretches.empty()
                                   ? radius_of(importance)
                                   : stretched(importance, stretches[line + column], pixel);
            }
        }
    };
    for_each_polled((columns + kTile - 1) / kTile, poll, fill_tile, std::size_t{kTile} * rows);
    return radii;
}

RadiusField::RadiusField(const Field* field, double scale, const Mask* mask, const Shape& shape,
                         const Poll& poll)
    : shape_(shape),
      columns_(shape.width, field == nullptr ? 1 : field->columns),
      rows_(shape.height, field == nullptr ? 1 : field->rows),
      radii_(columns_.pixels(), rows_.pixels(), radii_of(field, scale, poll), poll) {
    border_ellipses();
    if (mask != nullptr) {
        mask_columns_.emplace(shape.width, mask->columns);
        mask_rows_.emplace(shape.height, mask->rows);
        mask_ = mask->drawn ? std::shared_ptr<const MaskTree>(mask->drawn, &mask->drawn->tree)
                            : std::make_shared<const MaskTree>(*mask, poll);
    }
    least_radius_ = std::numeric_limits<std::uint32_t>::max();
    for (const Radii& radii : radii_.values())
        least_radius_ = std::min(least_radius_, radii.least - 1);
    ++least_radius_;
}

// Where no sample may lie, a kept one may, at the border to another pixel. On a torus that may be a
// pixel beyond the seam; on a box no kept point lies where only such a pixel is open.
void RadiusField::border_ellipses() {
    const auto columns = std::int64_t{columns_.pixels()}, rows = std::int64_t{rows_.pixels()};
    const std::vector<portable::Ellipse> own = ellipses_;
    for (std::int64_t pixel = 0; pixel < static_cast<std::int64_t>(own.size()); ++pixel) {
        portable::Ellipse& ellipse = ellipses_[static_cast<std::size_t>(pixel)];
        for (std::int64_t i = 0; i < 18 && ellipse.s == 0; ++i) {
            std::int64_t column = pixel / rows + i % 9 / 3 - 1, row = pixel % rows + i % 3 - 1;
            if (i >= 9) {
                column = (column + columns) % columns;
                row = (row + rows) % rows;
            }
            if (column >= 0 && column < columns && row >= 0 && row < rows)
                ellipse = own[static_cast<std::size_t>(column * rows + row)];
        }
    }
}

Under RadiusField::under(const Box& on_copy) const {
    const Box box = on_domain(on_copy);
    const std::uint32_t end = box.x + box.width;
    const PixelRange columns = pixels_of(columns_, box.x, end);
    const PixelRange rows = pixels_of(rows_, box.begin, box.end);
    const Radii radii = radii_.over(columns, rows);
    const bool is_one = columns.first == columns.last && rows.first == rows.last;
    const std::uint8_t allowed = mask_ ? mask_->over(pixels_of(*mask_columns_, box.x, end),
                                                     pixels_of(*mask_rows_, box.begin, box.end))
                                       : ALLOWED_ALL;
    if (allowed == ALLOWED_NONE) return {0, 0, true};
    return {radii.least, radii.greatest(),
            (is_one || !radii.are_mixed()) && allowed == ALLOWED_ALL};
}

bool RadiusField::is_mask_mixed(const Box& on_copy) const {
    const Box box = on_domain(on_copy);
    return mask_ && mask_->over(pixels_of(*mask_columns_, box.x, box.x + box.width),
                                pixels_of(*mask_rows_, box.begin, box.end)) == ALLOWED_SOME;
}

bool RadiusField::are_radii_mixed(const Box& box) const {
    return radii_
        .over(pixels_of(columns_, box.x, box.x + box.width), pixels_of(rows_, box.begin, box.end))
        .are_mixed();
}

std::uint32_t RadiusField::cut_x(const Box& on_copy) const {
    const Box box = on_domain(on_copy);
    const std::uint32_t end = box.x + box.width;
    std::uint32_t cut = is_mask_mixed(box) ? middle_border(*mask_columns_, box.x, end) : 0;
    if (cut == 0 && are_radii_mixed(box)) cut = middle_border(columns_, box.x, end);
    if (cut == 0 && box.width > 1) cut = box.x + box.width / 2;
    return cut == 0 ? 0 : on_copy.x - box.x + cut;
}

std::uint32_t RadiusField::cut_y(const Box& on_copy) const {
    const Box box = on_domain(on_copy);
    std::uint32_t cut = is_mask_mixed(box) ? middle_border(*mask_rows_, box.begin, box.end) : 0;
    if (cut == 0 && are_radii_mixed(box)) cut = middle_border(rows_, box.begin, box.end);
    return cut;
}

}  // namespace lacuna
