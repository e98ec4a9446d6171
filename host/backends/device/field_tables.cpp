// The tables of a radius field.
#include "backends/device/field_tables.h"

#include <cstddef>

#include "portable/radius_field.h"

namespace lacuna::device {
namespace {

void append_axis(const PixelAxis& axis, std::uint32_t number, std::uint32_t last,
                 std::vector<std::uint32_t>& axes) {
    std::uint32_t* const words = &axes[number * std::size_t{AXIS_WORDS}];
    words[AXIS_PIXELS] = axis.pixels();
    words[AXIS_SHIFT] = axis.shift();
    words[AXIS_SCALE] = static_cast<std::uint32_t>(axis.scale());
    words[AXIS_SCALE + 1] = static_cast<std::uint32_t>(axis.scale() >> 32);
    words[AXIS_LAST] = last;
    words[AXIS_LENGTH] = axis.length();
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
    tables.mask_nodes = {0};
    if (radius_field.mask() == nullptr) return tables;
    append_axis(*radius_field.mask_columns(), COLUMNS_OF_MASK, last, tables.axes);
    append_axis(*radius_field.mask_rows(), ROWS_OF_MASK, kAny, tables.axes);
    const MaskTree& mask = *radius_field.mask();
    tables.axes[COLUMNS_OF_MASK * std::size_t{AXIS_WORDS} + AXIS_ROOT] = mask.root();
    tables.mask_nodes.clear();
    for (const auto& [values, first] : mask.nodes())
        tables.mask_nodes.insert(tables.mask_nodes.end(), {values, first});
    return tables;
}

}  // namespace lacuna::device
