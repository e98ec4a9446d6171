// Table 1: times and counts without the toroidal boundary condition.
#include "reproduce/tables.h"

namespace lacuna::reproduce {

Reproduction table1(const Setting& setting) {
    static const std::array rows{
        PublishedRow{
            "Ours", Way::cdf, {0.0056, 0.0913, 0.391, 26.7}, {296.2, 7030.3, 27952, 695154}},
        PublishedRow{"Uniform-x",
                     Way::uniform_x,
                     {0.0066, 0.0880, 0.337, 21.8},
                     {298.6, 7058.3, 28019, 695599}},
        PublishedRow{
            "Jones", Way::exact, {0.0423, 0.813, 3.207, 100.4}, {297.6, 7059.4, 28044, 697463}},
        PublishedRow{
            "Gamito", Way::exact, {0.0092, 0.101, 0.493, 16.7}, {297.0, 7058.8, 28047, 697451}},
    };
    return reproduce_table(setting, Boundary::box, rows, {0.01, 6946, 23});
}

}  // namespace lacuna::reproduce
