#include "base/error.h"

#include <gtest/gtest.h>

namespace fissure::error_test {

namespace {

struct Said {
  Origin origin;
  std::string line;
};

TEST(InputErrors, BeginWithWhereItIsWrong) {
  const std::vector<Said> all = {
      {{}, "is 3, expected 1"},
      {inFile("a/b.yaml"), "a/b.yaml: is 3, expected 1"},
      {inFile(""), ": is 3, expected 1"},
      {inFile("b.yaml", 12), "b.yaml:12: is 3, expected 1"},
      {ofOverride("time.step_s"), "--set time.step_s: is 3, expected 1"},
      {ofAxis("force.hc.k"), "axis force.hc.k: is 3, expected 1"},
      {ofAxis("force.hc.k", "sweep.yaml", 4), "sweep.yaml:4: axis force.hc.k: is 3, expected 1"},
  };
  for (const Said& said : all) {
    const InputError error(said.origin, "is 3, expected 1");
    EXPECT_EQ(error.what(), said.line);
    EXPECT_EQ(error.text(), "is 3, expected 1");
    EXPECT_EQ(error.origin().kind, said.origin.kind);
  }
}

TEST(InputErrors, AreOneLineWhateverTheyRepeat) {
  const InputError error(inFile("a\rb.csv"), "column \"x\ny\r\": unknown\n");
  EXPECT_STREQ(error.what(), "a b.csv: column \"x y \": unknown");
  EXPECT_EQ(error.text(), "column \"x y \": unknown");
  EXPECT_TRUE(error.isAbout("a\rb.csv"));
  EXPECT_STREQ(RunError("lost:\n  \x1b[2J\n").what(), "lost:    [2J");
}

TEST(InputErrors, AreAboutAFileAsAWhole) {
  EXPECT_TRUE(InputError(inFile("a.h5"), "damaged").isAbout("a.h5"));
  EXPECT_FALSE(InputError(inFile("a.h5"), "damaged").isAbout("b.h5"));
  EXPECT_FALSE(InputError(inFile("a.yaml", 3), "wrong").isAbout("a.yaml"));
  EXPECT_FALSE(InputError("a.h5: damaged").isAbout("a.h5"));
  EXPECT_FALSE(InputError(ofAxis("k", "a.yaml"), "wrong").isAbout("a.yaml"));
}

}  // namespace
}  // namespace fissure::error_test
