// A panel is what the run itself would have drawn; how a run ended can be seen.
#include "picture/stored_pictures.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/frame_text.h"
#include "render/offscreen_renderer.h"
#include "store/drawable_run.h"
#include "store/sample_run.h"

namespace fissure::stored_pictures_test {

namespace {

class StoredPicturesTest : public testing::Test {
 protected:
  StoredPicturesTest() {
    settings_.frames.width_px = 120;
    settings_.frames.height_px = 90;
  }

  /// Of the runs that were written, or of those of them that are named.
  StoredPictures open(const std::vector<std::string>& names = {}) const {
    std::vector<PipelineResult> runs;
    for (const PipelineResult& run : readResultInfo(folder_ / "r.h5").pipelines)
      if (names.empty() || std::find(names.begin(), names.end(), run.name) != names.end())
        runs.push_back(run);
    return {folder_ / "r.h5", runs, settings_, drawableScene().ground_height_m};
  }
  void write(const std::vector<DrawableRun>& runs) const { writeDrawableResult(folder_ / "r.h5", runs); }

  /// As a run draws its frames.
  Image drawnByTheRun(const std::string& name, std::size_t snapshot) const {
    const auto frames = makeOffscreenRenderer(drawableScene(), settings_.frames, drawableState(0));
    const State state = drawableState(snapshot);
    return frames->draw(state, frameText(name, state.time_s, {drawableDepth_m(snapshot), {}, {}}));
  }

  /// The panel in this column of a picture with one row.
  Image panel(const Image& picture, int column) const {
    const int width_px = settings_.frames.width_px, height_px = settings_.frames.height_px;
    Image cut{width_px, height_px, {}};
    for (int y = 0; y < height_px; ++y) {
      const auto from = picture.rgb.begin() + 3 * (y * picture.width_px + column * (width_px + 2));
      cut.rgb.insert(cut.rgb.end(), from, from + 3 * width_px);
    }
    return cut;
  }

  ScratchFolder folder_;
  PictureSettings settings_;
};

TEST_F(StoredPicturesTest, EqualTheFramesOfTheRun) {
  write({{"a"}});
  StoredPictures pictures = open();
  ASSERT_EQ(pictures.times_s(), (std::vector<double>{0, 0.1, 0.2}));
  for (std::size_t k = 0; k < 3; ++k) {
    const Image picture = pictures.picture(pictures.times_s()[k]);
    EXPECT_EQ(picture.rgb, drawnByTheRun("a", k).rgb) << k;
    EXPECT_EQ(picture.rgb, open().picture(pictures.times_s()[k]).rgb) << k;
  }
  EXPECT_NE(drawnByTheRun("a", 0).rgb, drawnByTheRun("a", 1).rgb) << "the comparison above would find it";
}

TEST_F(StoredPicturesTest, EqualTheFramesThroughACameraOfTheScenario) {
  write({{"a"}});
  settings_.frames.camera = CameraSettings{{0.1, 0.2, 0.3}, {0, 0.01, 0}, {0, 1, 0}, 30};
  EXPECT_EQ(open().picture(0.1).rgb, drawnByTheRun("a", 1).rgb);
}

TEST_F(StoredPicturesTest, HandlesOfClampsAreDrawn) {
  write({{"a"}});
  Scene bare = drawableScene();
  bare.clamps.clear();
  State state = drawableState(1);
  state.clamps.clear();
  settings_.frames.camera = CameraSettings{{0.1, 0.2, 0.3}, {0, 0.03, 0}, {0, 1, 0}, 30};
  const auto frames = makeOffscreenRenderer(bare, settings_.frames, state);
  EXPECT_NE(open().picture(0.1).rgb,
            frames->draw(state, frameText("a", 0.1, {drawableDepth_m(1), {}, {}})).rgb);
}

TEST_F(StoredPicturesTest, PanelsSideBySide) {
  write({{"a"}, {"b"}});
  const Image picture = open().picture(0.2);
  EXPECT_EQ(picture.width_px, 2 * 120 + 2);
  EXPECT_EQ(panel(picture, 0).rgb, drawnByTheRun("a", 2).rgb);
  EXPECT_EQ(panel(picture, 1).rgb, drawnByTheRun("b", 2).rgb);
  settings_.columns = 1;
  StoredPictures below = open();
  EXPECT_EQ(below.size().height_px, 2 * 90 + 2);
  EXPECT_EQ(below.picture(0.2).height_px, 2 * 90 + 2);
}

// A run that crashed after its second snapshot: until then as ever, there its status, later faded.
TEST_F(StoredPicturesTest, ARunThatEndedKeepsItsLastStateAndSaysHow) {
  write({{"a"}, {"b", RunEnd::crashed, 2}});
  StoredPictures pictures = open();
  EXPECT_EQ(pictures.times_s().size(), 3u);
  EXPECT_EQ(panel(pictures.picture(0), 1).rgb, drawnByTheRun("b", 0).rgb);
  const Image last = panel(pictures.picture(0.1), 1);
  const Image later = panel(pictures.picture(0.2), 1);
  EXPECT_EQ(panel(pictures.picture(0.2), 0).rgb, drawnByTheRun("a", 2).rgb);
  const auto frames = makeOffscreenRenderer(drawableScene(), settings_.frames, drawableState(0));
  std::vector<std::string> text = frameText("b", 0.1, {drawableDepth_m(1), {}, {}});
  text.push_back("crashed");
  EXPECT_EQ(last.rgb, frames->draw(drawableState(1), text).rgb);
  const auto brightness = [](const Image& image) {
    double sum = 0;
    for (const std::uint8_t value : image.rgb) sum += value;
    return sum / static_cast<double>(image.rgb.size());
  };
  EXPECT_GT(brightness(later), brightness(last) + 5);
  EXPECT_EQ(panel(open().picture(0.2), 1).rgb, later.rgb) << "whatever was drawn before";
}

TEST_F(StoredPicturesTest, ARunWithoutSnapshotsHasAnEmptyPanelThatSaysSo) {
  write({{"a"}, {"b", RunEnd::crashed, 0}});
  const Image empty = panel(open().picture(0), 1);
  EXPECT_EQ(empty.rgb.front(), 255);
  EXPECT_LT(*std::min_element(empty.rgb.begin(), empty.rgb.end()), 100) << "text";
  EXPECT_TRUE(open({"b"}).times_s().empty());
}

TEST_F(StoredPicturesTest, OneCameraHasAllRunsInView) {
  write({{"a"}, {"b"}});
  settings_.camera.field_of_view_deg = 20;
  settings_.camera.look_at_m = Vec3(0, 0.01, 0);
  const Image both = open().picture(0.1);
  Image alone = open({"a"}).picture(0.1);
  EXPECT_EQ(panel(both, 0).rgb, alone.rgb) << "both have the same first state";
  EXPECT_NE(alone.rgb, drawnByTheRun("a", 1).rgb) << "what is stated of the camera counts";
  settings_.camera.position_m = Vec3(0.2, 0.2, 0.2);
  settings_.camera.up = Vec3(1, 0, 0);
  settings_.frames.camera = CameraSettings{{0.2, 0.2, 0.2}, {0, 0.01, 0}, {1, 0, 0}, 20};
  EXPECT_EQ(open({"a"}).picture(0.1).rgb, drawnByTheRun("a", 1).rgb);
}

TEST_F(StoredPicturesTest, ImpossibleCamerasAndSizesAreRefused) {
  write({{"a"}, {"b"}});
  settings_.frames.width_px = 15;
  EXPECT_THROW(open(), InputError);
  settings_.frames.width_px = settings_.frames.height_px = 4096;
  EXPECT_NO_THROW(open());
  settings_.columns = 1;
  std::vector<PipelineResult> many(5, readResultInfo(folder_ / "r.h5").pipelines.front());
  EXPECT_THROW(StoredPictures(folder_ / "r.h5", many, settings_, 0), InputError);
  settings_.camera.up = Vec3::Zero();
  EXPECT_THROW(open(), InputError);
  settings_.camera = {};
  settings_.camera.position_m = settings_.camera.look_at_m = Vec3(1, 1, 1);
  EXPECT_THROW(open(), InputError);
}

}  // namespace
}  // namespace fissure::stored_pictures_test
