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

// Examples of FIPS 180-4's publisher, of no, one and two blocks.
TEST(Sha256, IsThePublishedFunction) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

}  // namespace
}  // namespace fissure::hash_test
