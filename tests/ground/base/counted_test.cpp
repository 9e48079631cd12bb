#include "base/counted.h"

#include <gtest/gtest.h>

namespace fissure::counted_test {

namespace {

TEST(Counted, IsOneOrSeveral) {
  EXPECT_EQ(counted(1, "point"), "1 point");
  EXPECT_EQ(counted(0, "point"), "0 points");
  EXPECT_EQ(counted(2, "point"), "2 points");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(3, "vertex", "vertices"), "3 vertices");
}

}  // namespace
}  // namespace fissure::counted_test
