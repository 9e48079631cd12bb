#include "study/tradeoff_limits.h"

#include <gtest/gtest.h>

namespace fissure::tradeoff_limits_test {

namespace {

std::string limitErrorFor(const std::string& text) {
  try {
    parseErrorLimits(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(TradeoffLimits, ReadsSizesWithUnits) {
  const std::vector<ErrorLimit> limits =
      parseErrorLimits("depth=0.1mm, force = 2 %,reaction=50mN,shape=20um");
  ASSERT_EQ(limits.size(), 4u);
  EXPECT_EQ(limits[0].quantity, ErrorQuantity::depth);
  EXPECT_DOUBLE_EQ(limits[0].size.absolute(1), 1e-4);
  EXPECT_TRUE(limits[1].size.relative);
  EXPECT_DOUBLE_EQ(limits[1].size.absolute(10), 0.2);
  EXPECT_DOUBLE_EQ(limits[2].size.absolute(1), 0.05);
  EXPECT_DOUBLE_EQ(limits[3].size.absolute(1), 2e-5);
  EXPECT_EQ(textOf(limits[0].size, limits[0].quantity), "100 um");
  EXPECT_EQ(textOf(limits[1].size, limits[1].quantity), "2 %");
}

TEST(TradeoffLimits, RefusesOthersInOneLine) {
  EXPECT_EQ(limitErrorFor("dept=0.1mm"), "--max-error: no error of \"dept\", did you mean \"depth\"?");
  EXPECT_EQ(limitErrorFor("depth"),
            "--max-error: \"depth\" has no \"=\", expected limits as depth=0.1mm,force=2%");
  EXPECT_EQ(limitErrorFor("depth=0.1"),
            "--max-error: depth is \"0.1\", expected a size above 0 with its unit, as 0.1mm or 2%");
  for (const char* bad : {"", "depth=", "depth=1N", "force=1mm", "depth=-1mm", "depth=0mm", "depth=nanmm",
                          "force=inf%", "depth=1mm,depth=2mm", "depth=1mm,"})
    EXPECT_TRUE(limitErrorFor(bad).starts_with("--max-error: ")) << bad;
}

}  // namespace fissure::tradeoff_limits_test
