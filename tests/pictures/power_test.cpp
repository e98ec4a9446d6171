// Powers that are the same on every machine.
#include "base/power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacuna {
namespace {

TEST(Power, IsThatOfTheCLibraryButForTheLastDigits) {
    for (const double base : {1e-9, 0.0004, 0.1, 0.5, 0.77, 0.999999})
        for (const double exponent : {0.0, 1e-3, 0.3, 0.5, 0.999, 1.0, 1.35, 2.2, 3.0, 17.25}) {
            const double expected = std::pow(base, exponent);
            EXPECT_NEAR(power(base, exponent), expected, 2e-6 * expected)
                << base << "^" << exponent;
        }
}

TEST(Power, IsExactWhereItMustBe) {
    EXPECT_EQ(power(0.37, 0), 1);
    EXPECT_EQ(power(0.37, 1), 0.37);
    EXPECT_EQ(power(0.37, 2), 0.37 * 0.37);
    EXPECT_EQ(power(0.37, 0.5), std::sqrt(0.37));
    EXPECT_EQ(power(0, 0.3), 0);
    EXPECT_EQ(power(0, 0), 1);
    EXPECT_EQ(power(1, 1e300), 1);
    EXPECT_EQ(power(0.999, 1e300), 0);
}

// A difference in the last digit of any of a million powers shows in their sum.
TEST(Power, HasBitsThatDoNotChange) {
    double sum = 0;
    for (int i = 0; i < 1000; ++i)
        for (int j = 0; j < 1000; ++j) sum += power(i / 999.0, j / 400.0);
    EXPECT_EQ(sum, 0x1.e9afbb07f5b29p+18);
}

}  // namespace
}  // namespace lacuna
