#include "base/hash.h"

#include <gtest/gtest.h>

namespace fissure::hash_test {

namespace {

// Test vectors of the algorithm's authors.
TEST(Fnv1a64, IsThePublishedFunction) {
  EXPECT_EQ(fnv1a64(""), "cbf29ce484222325");
  EXPECT_EQ(fnv1a64("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(fnv1a64("foobar"), "85944171f73967e8");
  EXPECT_NE(fnv1a64(std::string("\0", 1)), fnv1a64(""));
}

}  // namespace
}  // namespace fissure::hash_test
