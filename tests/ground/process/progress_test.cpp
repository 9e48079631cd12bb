#include "process/progress.h"

#include <gtest/gtest.h>

namespace fissure::progress_test {

namespace {

TEST(Progress, ReadsTheLineOfAWorker) {
  EXPECT_EQ(parseProgress("progress 12 500"), (Progress{12, 500}));
  EXPECT_EQ(parseProgress("progress 0 1"), (Progress{0, 1}));
  EXPECT_EQ(parseProgress("progress 500 500"), (Progress{500, 500}));
}

TEST(Progress, RefusesEverythingElse) {
  for (const char* line :
       {"", "progress", "progress ", "progress 1", "progress 1 ", "progress -1 5", "progress 6 5",
        "progress 1 0", "progress 1 5 ", "progress 1 5 7", "progress a b", "Progress 1 5", "progress  1 5",
        "progress 1.5 5", "progress 99999999999999999999 5", "xprogress 1 5"})
    EXPECT_FALSE(parseProgress(line)) << line;
}

TEST(Progress, SaysHowFar) {
  EXPECT_EQ(describe({12, 500}), "after step 12 of 500");
  EXPECT_EQ(describe({0, 500}), "before its first step");
  EXPECT_EQ(describe({}), "before its first step");
}

}  // namespace
}  // namespace fissure::progress_test
