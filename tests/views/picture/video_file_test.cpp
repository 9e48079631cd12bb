#include "picture/video_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "store/sample_run.h"

namespace fissure::video_file_test {

namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A bright square that moves over a dark ground of an odd size.
Image squareAt(int step) {
  Image image{33, 25, {}};
  for (int y = 0; y < 25; ++y)
    for (int x = 0; x < 33; ++x) {
      const bool inside = std::abs(x - 8 - 4 * step) < 4 && std::abs(y - 12) < 4;
      for (const int channel : {200, 120, 40})
        image.rgb.push_back(static_cast<std::uint8_t>(inside ? channel : 20));
    }
  return image;
}

void writeVideo(const fs::path& file, const std::string& kind) {
  VideoFile video(file, programOnPath("ffmpeg").value(), {kind, 33, 25, 10}, -1);
  for (int step = 0; step < 4; ++step) video.add(squareAt(step));
  video.finish();
}

/// Its pictures, as ffmpeg decodes them; 8 bits RGB.
std::string decoded(const fs::path& file) {
  const fs::path raw = file.string() + ".rgb";
  FedProcess ffmpeg(programOnPath("ffmpeg").value(),
                    {"-loglevel", "error", "-i", "file:" + file.string(), "-f", "rawvideo", "-pix_fmt",
                     "rgb24", "file:" + raw.string()},
                    -1);
  ffmpeg.finish();
  const std::string bytes = bytesOf(raw);
  fs::remove(raw);
  return bytes;
}

class VideoKind : public testing::TestWithParam<std::string> {};

TEST_P(VideoKind, SamePicturesSameBytesAndTheirColours) {
  const ScratchFolder folder;
  const fs::path file = folder / ("a: b." + GetParam());
  writeVideo(file, GetParam());
  const std::string first = bytesOf(file);
  writeVideo(file, GetParam());
  EXPECT_EQ(bytesOf(file), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  const bool even = GetParam() != "gif";
  const std::size_t width = even ? 34 : 33, height = even ? 26 : 25;
  const std::string pixels = decoded(file);
  ASSERT_EQ(pixels.size(), 4 * 3 * width * height);
  for (std::size_t step = 0; step < 4; ++step) {
    const std::size_t at = 3 * ((step * height + 12) * width + 8 + 4 * step);
    EXPECT_NEAR(static_cast<unsigned char>(pixels[at]), 200, 20) << step;
    EXPECT_NEAR(static_cast<unsigned char>(pixels[at + 1]), 120, 20) << step;
    EXPECT_NEAR(static_cast<unsigned char>(pixels[at + 2]), 40, 20) << step;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, VideoKind, testing::ValuesIn(videoKinds()),
                         [](const auto& tested) { return tested.param; });

TEST(VideoFile, DroppedBeforeItsEndLeavesNothing) {
  const ScratchFolder folder;
  {
    VideoFile video(folder / "a.mp4", programOnPath("ffmpeg").value(), {"mp4", 33, 25, 10}, -1);
    video.add(squareAt(0));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(VideoFile, WhatCannotBeWrittenIsSaidInFfmpegsWords) {
  std::signal(SIGPIPE, SIG_IGN);
  const ScratchFolder folder;
  const auto write = [&] { writeVideo(folder / "no/a.mp4", "mp4"); };
  try {
    write();
    FAIL() << "no error";
  } catch (const RunError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find((folder / "no/a.mp4").string() + ": ffmpeg: "), 0u) << text;
    EXPECT_NE(text.find("No such file or directory"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace fissure::video_file_test
