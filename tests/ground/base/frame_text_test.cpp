#include "base/frame_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace fissure::frame_text_test {

namespace {

using Lines = std::vector<std::string>;

TEST(FrameText, NamesRunTimeAndDepth) {
  EXPECT_EQ(frameText("fukuhara", 0.25, {.depth_m = 0.00012}),
            (Lines{"fukuhara", "t = 0.250 s", "depth = 0.12 mm"}));
  EXPECT_EQ(frameText("none", 0, {}), (Lines{"none", "t = 0.000 s"}));
}

TEST(FrameText, SaysWhatTheDarkestColourStandsFor) {
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.0, .pressure_Pa = 4549.0}),
            (Lines{"a", "t = 0.000 s", "depth = 0.00 mm", "pressure up to 4.55 kPa"}));
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.0, .pressure_Pa = 0.0}).size(), 3u);
}

TEST(FrameText, SaysWhatADepthOf0Hides) {
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.0, .inversion_aware_m = 0.0139737, .ground_m = 0.00566}),
            (Lines{"a", "t = 0.000 s", "depth = 0.00 mm", "with inversion 13.97 mm",
                   "tissue 5.66 mm below ground"}));
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.001, .inversion_aware_m = 0.001, .ground_m = 1e-6}).size(), 3u);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  // A depth that shows needs no doubt beside it.
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.0, .certified = 0.0}),
            (Lines{"a", "t = 0.000 s", "depth = 0.00 mm", "overlap not excluded"}));
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.001, .certified = 0.0}).size(), 3u);
  EXPECT_EQ(frameText("a", 0, {.depth_m = 0.0, .certified = 1.0}).size(), 3u);
  EXPECT_EQ(frameText("a", 0, {.depth_m = nan, .inversion_aware_m = nan, .ground_m = nan}).size(), 3u);
}

}  // namespace
}  // namespace fissure::frame_text_test
