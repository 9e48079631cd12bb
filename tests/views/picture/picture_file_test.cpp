#include "picture/picture_file.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "store/sample_run.h"

namespace fissure::picture_file_test {

namespace {

namespace fs = std::filesystem;

Image gradient(int width_px, int height_px) {
  Image image{width_px, height_px, {}};
  for (int i = 0; i < 3 * width_px * height_px; ++i)
    image.rgb.push_back(static_cast<std::uint8_t>(i * 7 % 251));
  return image;
}

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// As libpng reads it, with the format that is written in the file.
Image decoded(const fs::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&png, file.c_str()) == 0 || png.format != PNG_FORMAT_RGB) return {};
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(png));
  png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr);
  return image;
}

TEST(PictureFile, HoldsEveryPixel) {
  const ScratchFolder folder;
  for (const auto& [width_px, height_px] : {std::pair{1, 1}, {31, 7}, {640, 480}}) {
    const Image image = gradient(width_px, height_px);
    writePng(folder / "a.png", image);
    const Image read = decoded(folder / "a.png");
    EXPECT_EQ(read.width_px, width_px);
    EXPECT_EQ(read.height_px, height_px);
    EXPECT_EQ(read.rgb, image.rgb);
  }
}

TEST(PictureFile, SamePictureSameBytesAndNothingElseIsLeft) {
  const ScratchFolder folder;
  writePng(folder / "a.png", gradient(50, 40));
  writePng(folder / "b.png", gradient(50, 40));
  writePng(folder / "b.png", gradient(50, 40));  // replaces
  EXPECT_EQ(bytesOf(folder / "a.png"), bytesOf(folder / "b.png"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST(PictureFile, WhatCannotBeWrittenIsOneLineAndLeavesNothing) {
  const ScratchFolder folder;
  try {
    writePng(folder / "no/a.png", gradient(2, 2));
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(), (folder / "no/a.png").string() + ": cannot write: No such file or directory");
  }
  fs::create_directory(folder / "taken");
  EXPECT_THROW(writePng(folder / "taken", gradient(2, 2)), RunError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace fissure::picture_file_test
