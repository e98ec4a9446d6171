// The tables of a radius field.
#include "backends/device/field_tables.h"

#include <cstddef>
#include <span>

#include "portable/radius_field.h"

namespace lacuna::device {
namespace {

static_assert(RadiusField::kNone == ALLOWED_NONE && RadiusField::kSome == ALLOWED_SOME &&
              RadiusField::kAll == ALLOWED_ALL);

void append_axis(const PixelAxis& axis, std::uint32_t number, std::uint32_t last,
                 std::vector<std::uint32_t>& axes) {
    std::uint32_t* const words = &axes[number * std::size_t{AXIS_WORDS}];
    words[AXIS_PIXELS] = axis.pixels();
    words[AXIS_SHIFT] = axis.shift();
    words[AXIS_SCALE] = static_cast<std::uint32_t>(axis.scale());
    words[AXIS_SCALE + 1] = static_cast<std::uint32_t>(axis.scale() >> 32);
    words[AXIS_LAST] = last;
    words[AXIS_BEGINS] = static_cast<std::uint32_t>(axes.size());
    axes.insert(axes.end(), axis.begins().begin(), axis.begins().end());
}

}  // namespace

FieldTables tables_of(const RadiusField& radius_field) {
    FieldTables tables;
    tables.axes.resize(4 * std::size_t{AXIS_WORDS}, 0);
    const std::uint32_t last = radius_field.shape().last_on_sheet;
    constexpr std::uint32_t kAny = ~std::uint32_t{0};
    append_axis(radius_field.columns(), COLUMNS_OF_FIELD, last, tables.axes);
    append_axis(radius_field.rows(), ROWS_OF_FIELD, kAny, tables.axes);
    for (const auto& [p, q, s, shift] : radius_field.ellipses())
        tables.ellipses.insert(tables.ellipses.end(), {p, q, s, shift});
    if (!radius_field.has_ellipses()) tables.ellipses.resize(4);
    std::uint32_t number = 0;
    tables.mask_bits = {0};
    if (radius_field.mask() == nullptr) return tables;
    append_axis(*radius_field.mask_columns(), COLUMNS_OF_MASK, last, tables.axes);
    append_axis(*radius_field.mask_rows(), ROWS_OF_MASK, kAny, tables.axes);
    radius_field.mask()->for_each_level([&](std::span<const std::uint8_t> level) {
        for (const std::uint32_t allowed : level) {
            if (number / ALLOWED_PER_WORD == tables.mask_bits.size()) tables.mask_bits.push_back(0);
            tables.mask_bits.back() |= allowed << number++ % ALLOWED_PER_WORD * 2;
        }
    });
    return tables;
}

}  // namespace lacuna::device
