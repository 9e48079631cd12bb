#include "picture/panels.h"

#include <gtest/gtest.h>

#include "render/palette.h"

namespace fissure::panels_test {

namespace {

Image plain(int width_px, int height_px, std::uint8_t value) {
  Image image{width_px, height_px, {}};
  image.rgb.assign(static_cast<std::size_t>(3 * width_px * height_px), value);
  return image;
}

int at(const Image& image, int x, int y) {
  return image.rgb.at(static_cast<std::size_t>(3 * (y * image.width_px + x)));
}

TEST(Panels, OneIsThePictureItself) {
  const Image panel = plain(5, 3, 7);
  const Image joined = joinPanels({panel}, 4);
  EXPECT_EQ(joined.width_px, 5);
  EXPECT_EQ(joined.height_px, 3);
  EXPECT_EQ(joined.rgb, panel.rgb);
}

// Panels of 5 x 3 pixels in two columns: 5 + 2 + 5 and 3 + 2 + 3.
TEST(Panels, RowByRowWithLinesBetween) {
  const Image joined = joinPanels({plain(5, 3, 10), plain(5, 3, 20), plain(5, 3, 30)}, 2);
  ASSERT_EQ(joined.width_px, 12);
  ASSERT_EQ(joined.height_px, 8);
  EXPECT_EQ(at(joined, 0, 0), 10);
  EXPECT_EQ(at(joined, 4, 2), 10);
  EXPECT_EQ(at(joined, 7, 0), 20);
  EXPECT_EQ(at(joined, 11, 2), 20);
  EXPECT_EQ(at(joined, 0, 5), 30);
  EXPECT_EQ(at(joined, 4, 7), 30);
  for (const auto& [x, y] : {std::pair{5, 0}, {6, 7}, {0, 3}, {11, 4}})
    EXPECT_EQ(at(joined, x, y), palette::grid.r) << x << " " << y;
  EXPECT_EQ(at(joined, 9, 6), palette::background.r) << "a free cell";
}

TEST(Panels, JoinedSizeIsThatOfThePicture) {
  for (const int count : {1, 2, 3, 5})
    for (const int columns : {1, 2, 4}) {
      const Image joined =
          joinPanels(std::vector<Image>(static_cast<std::size_t>(count), plain(6, 4, 1)), columns);
      const PictureSize size = joinedSize({6, 4}, count, columns);
      EXPECT_EQ(size.width_px, joined.width_px);
      EXPECT_EQ(size.height_px, joined.height_px);
    }
  EXPECT_EQ(joinedSize({4096, 4096}, 1000000, 1).height_px, 4096LL * 1000000 + 2LL * 999999);
}

TEST(Panels, FadedIsTwoThirdsOnTheWayToTheBackground) {
  EXPECT_EQ(at(faded(plain(1, 1, 0)), 0, 0), 170);
  EXPECT_EQ(at(faded(plain(1, 1, 255)), 0, 0), 255);
}

}  // namespace
}  // namespace fissure::panels_test
