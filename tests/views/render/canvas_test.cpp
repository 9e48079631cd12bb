#include "render/canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "render/font.h"
#include "render/ground.h"
#include "render/overlay.h"

namespace fissure::canvas_test {

namespace {

const Colour black{0, 0, 0};

Image whiteImage(int width_px, int height_px) {
  return {width_px, height_px, std::vector<std::uint8_t>(3u * width_px * height_px, 255)};
}

/// Ink in pixels: 1 for a black one.
double inkOf(const Image& image) {
  double ink = 0;
  for (const std::uint8_t value : image.rgb) {
    ink += (255 - value) / (3.0 * 255);
  }
  return ink;
}

TEST(Canvas, DiscAndStrokeCoverTheirArea) {
  Image disc = whiteImage(40, 40);
  drawDisc(disc, {20.3, 19.6}, 10, black);
  EXPECT_NEAR(inkOf(disc), M_PI * 100, 0.01 * M_PI * 100);
  Image stroke = whiteImage(60, 40);
  drawStroke(stroke, {10.5, 11.25}, {40.5, 23.75}, 4, black);
  const double area = std::hypot(30, 12.5) * 4 + M_PI * 4;
  EXPECT_NEAR(inkOf(stroke), area, 0.015 * area);
}

TEST(Canvas, DrawsAtTheStatedPixelAndBlends) {
  Image image = whiteImage(8, 6);
  fillRectangle(image, {2, 3}, {4, 4}, {0, 100, 200, 255});
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const std::uint8_t* pixel = &image.rgb[3 * (y * 8 + x)];
      const bool inside = y == 3 && (x == 2 || x == 3);
      EXPECT_EQ(pixel[0], inside ? 0 : 255);
      EXPECT_EQ(pixel[1], inside ? 100 : 255);
    }
  }
  fillRectangle(image, {0, 0}, {1, 1}, {0, 0, 0, 51});  // a fifth
  EXPECT_EQ(image.rgb[0], 204);
}

TEST(Canvas, CutsOffWhatLiesOutside) {
  Image image = whiteImage(5, 3);
  drawStroke(image, {-1e9, 1.5}, {1e9, 1.5}, 1, black);
  EXPECT_NEAR(inkOf(image), 5, 1e-9);
  const Image before = image;
  drawDisc(image, {-20, 1}, 3, black);
  drawDisc(image, {1e300, 1}, 3, black);
  drawDisc(image, {std::numeric_limits<double>::quiet_NaN(), 1}, 3, black);
  fillRectangle(image, {-9, -9}, {0, 30}, black);
  EXPECT_EQ(image.rgb, before.rgb);
}

TEST(Canvas, DownsampleAveragesAndTurnsUpsideUp) {
  // 1 x 2 pixels twice as fine: the upper pixel's four samples are 10, 20, 30, 41 (mean 25.25), the lower's
  // are 7.
  std::vector<std::uint8_t> rgba;
  for (const int value : {7, 7, 7, 7, 30, 41, 10, 20}) {
    rgba.insert(rgba.end(), 4, static_cast<std::uint8_t>(value));
  }
  const Image image = downsample(rgba, 1, 2, 2);
  EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{25, 25, 25, 7, 7, 7}));
  EXPECT_EQ(downsample({rgba.data(), 8}, 1, 2, 1).rgb, (std::vector<std::uint8_t>(6, 7)));
}

TEST(Font, EveryPrintableCharacterHasItsOwnGlyphInTheCell) {
  std::set<std::string> seen;
  for (char character = ' '; character <= '~'; ++character) {
    std::string shape;
    for (const auto& line : font::strokes(character)) {
      EXPECT_GE(line.size(), 2u) << character;
      for (const Point2& point : line) {
        EXPECT_TRUE(point.x() >= 0 && point.x() <= 4 && point.y() >= 0 && point.y() <= 9) << character;
        shape += std::to_string(point.x()) + "," + std::to_string(point.y()) + " ";
      }
      shape += "/";
    }
    EXPECT_EQ(shape.empty(), character == ' ') << character;
    EXPECT_TRUE(seen.insert(shape).second) << character;
  }
  EXPECT_EQ(font::strokes('\n'), font::strokes('?'));
  EXPECT_EQ(font::strokes('\xe4'), font::strokes('?'));
}

TEST(Font, EveryVisibleCharacterLeavesInkWithinItsWidth) {
  for (char character = '!'; character <= '~'; ++character) {
    Image image = whiteImage(40, 40);
    font::drawText(image, {10, 25}, std::string(1, character), 2, black);
    EXPECT_GT(inkOf(image), 2) << character;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        if (x < 8 || x > 21) {
          EXPECT_EQ(image.rgb[3 * (y * 40 + x)], 255) << character;
        }
      }
    }
  }
  EXPECT_EQ(font::textWidth_px("", 2), 0);
  EXPECT_EQ(font::textWidth_px("ab", 2), 2 * (5.5 + 4));
}

TEST(Ground, GridLiesOnCentimetresAndFadesOut) {
  const GroundPlane plane = makeGroundPlane({{-0.03, 0, -0.03}, {0.035, 0.06, 0.03}}, -0.01);
  EXPECT_EQ(plane.spacing_m, 0.01);
  ASSERT_GT(plane.grid.size(), 0);
  ASSERT_EQ(plane.fill.size() % 3, 0);
  const auto is_on_centimetre = [&](int at, int axis) {
    const double cm =
        100 * plane.grid.xyz_m[3 * static_cast<std::size_t>(at) + static_cast<std::size_t>(axis)];
    return std::abs(cm - std::round(cm)) < 1e-4;
  };
  for (int i = 0; i < plane.grid.size(); i += 2) {
    const bool along_z = is_on_centimetre(i, 0) && is_on_centimetre(i + 1, 0);
    const bool along_x = is_on_centimetre(i, 2) && is_on_centimetre(i + 1, 2);
    EXPECT_TRUE(along_z || along_x) << i;
  }
  double farthest_m = 0;
  int farthest = 0;
  for (int i = 0; i < plane.grid.size(); ++i) {
    const float* p = &plane.grid.xyz_m[3 * static_cast<std::size_t>(i)];
    EXPECT_NEAR(p[1], -0.01, 1e-9);
    if (const double distance_m = std::hypot(p[0] - 0.0025, p[2]); distance_m > farthest_m) {
      farthest_m = distance_m;
      farthest = i;
    }
  }
  EXPECT_EQ(plane.grid.rgba[4 * static_cast<std::size_t>(farthest)], palette::background.r);
  // A scene of a kilometre does not ask for ten thousand million cells.
  EXPECT_LT(makeGroundPlane({{0, 0, 0}, {1000, 0, 0}}, 0).fill.size(), 6 * 1000);
}

TEST(ScaleBar, IsTenMillimetresWhereThatFits) {
  CameraSettings settings;
  settings.position_m = {0, 0, 0.2};
  const Camera camera = makeCamera(settings, 640, 480);
  EXPECT_EQ(scaleBarLength_m(camera), 0.01);
  Image image = whiteImage(640, 480);
  drawScaleBar(image, camera);
  // Both ends from the projection itself: the row with most ink is as long as 10 mm at the focus.
  const double expected_px = camera.project({0.01, 0, 0})->x_px - camera.project({0, 0, 0})->x_px;
  double longest_px = 0;
  for (int y = 0; y < 480; ++y) {
    double ink = 0;
    for (int x = 0; x < 640; ++x) {
      ink += (255 - image.rgb[3 * (y * 640 + x)]) / (255.0 - palette::ink.r);
    }
    longest_px = std::max(longest_px, ink);
  }
  EXPECT_NEAR(longest_px, expected_px, 3.0);  // plus the width of the end marks
}

TEST(ScaleBar, ChangesLengthForFarAndNearScenes) {
  for (const auto& [distance_m, length_m] :
       {std::pair{2.0, 0.1}, std::pair{0.01, 0.0005}, std::pair{100.0, 5.0}}) {
    CameraSettings settings;
    settings.position_m = {0, 0, distance_m};
    const Camera camera = makeCamera(settings, 640, 480);
    EXPECT_NEAR(scaleBarLength_m(camera), length_m, 1e-12);
    const double share = length_m / camera.pixelSize_m(distance_m) / 640;
    EXPECT_TRUE(share >= 1 / 24.0 && share <= 1 / 3.0);
  }
}

}  // namespace
}  // namespace fissure::canvas_test
