#include "text/units.h"

#include <gtest/gtest.h>

namespace fissure::units_test {

namespace {

TEST(Units, ValuesHaveFourDigitsAndAPrefix) {
  EXPECT_EQ(withUnit(0.0230214, "m"), "23.02 mm");
  EXPECT_EQ(withUnit(-1e-6, "m"), "-1 um");
  EXPECT_EQ(withUnit(56.114, "N"), "56.11 N");
  EXPECT_EQ(withUnit(1234, "N"), "1.234 kN");
  EXPECT_EQ(withUnit(0.00099999, "m"), "1 mm");
  EXPECT_EQ(withUnit(0, "m"), "0 m");
  EXPECT_EQ(withUnit(74, "1"), "74");
  EXPECT_EQ(withUnit(0.0001031, "m3"), "0.0001031 m3");
}

TEST(Units, TimesAreRoundedToWhatTheirSizeDeserves) {
  EXPECT_EQ(timeText(0), "0.00 s");
  EXPECT_EQ(timeText(0.338), "0.34 s");
  EXPECT_EQ(timeText(0.998), "1.0 s");
  EXPECT_EQ(timeText(4.17), "4.2 s");
  EXPECT_EQ(timeText(9.96), "10 s");
  EXPECT_EQ(timeText(59.6), "1 min 0 s");
  EXPECT_EQ(timeText(130.4), "2 min 10 s");
  EXPECT_EQ(timeText(3599.7), "1 h 0 min");
  EXPECT_EQ(timeText(3900), "1 h 5 min");
}

}  // namespace
}  // namespace fissure::units_test
