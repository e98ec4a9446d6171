// The grid of cells of the Gaussian energy, row by row.
#include "portable/gaussian.h"

BODY u32 cell_of(const DescentArguments a, const u32 x, const u32 y) {
    return gaussian_cell(y, a.domain.rows, a.domain.height) * a.domain.columns +
           gaussian_cell(x, a.domain.columns, a.domain.width);
}
