#include "picture/stored_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/frame_text.h"
#include "render/offscreen_renderer.h"
#include "render/overlay.h"

namespace fissure {

namespace {

constexpr long long most_px = 16384;  // what H.264 takes

void validateOrThrow(const FrameSettings& frames) {
  const std::vector<Problem> problems = validate(frames);
  if (!problems.empty())
    throw InputError(fmt::format("pictures: {} {}", problems.front().path, problems.front().message));
}

Camera chosenCamera(const PictureSettings& settings, const std::vector<Vec3>& points_m) {
  const CameraChoice& choice = settings.camera;
  FrameSettings frames = settings.frames;
  validateOrThrow(frames);
  if (!choice.position_m && !choice.look_at_m && !choice.up && !choice.field_of_view_deg)
    return frameCamera(frames, points_m);
  if (!frames.camera) {
    const double angle_deg = choice.field_of_view_deg.value_or(CameraSettings{}.field_of_view_deg);
    frames.camera = settingsOf(defaultCamera(points_m, frames.width_px, frames.height_px, angle_deg));
  }
  frames.camera->position_m = choice.position_m.value_or(frames.camera->position_m);
  frames.camera->look_at_m = choice.look_at_m.value_or(frames.camera->look_at_m);
  frames.camera->up = choice.up.value_or(frames.camera->up);
  frames.camera->field_of_view_deg = choice.field_of_view_deg.value_or(frames.camera->field_of_view_deg);
  validateOrThrow(frames);
  return makeCamera(*frames.camera, frames.width_px, frames.height_px);
}

}  // namespace

/// One run in these pictures.
class StoredPictures::Panel {
 public:
  Panel(const std::filesystem::path& file, const PipelineResult& run, std::optional<double> ground_height_m)
      : name_(run.name), end_(run.status.end), reader_(file, run.name), scene_(reader_.scene()) {
    scene_.ground_height_m = ground_height_m;
    if (!times_s().empty()) first_ = reader_.at(0);
  }

  const std::vector<double>& times_s() const { return reader_.times_s(); }
  /// Empty where there are no snapshots.
  std::vector<Vec3> points_m() const {
    return times_s().empty() ? std::vector<Vec3>() : pointsInView(scene_, first_);
  }
  void setCamera(const Camera& camera) { camera_ = camera; }

  void check(double time_s) const {
    if (const auto snapshot = snapshotAt(time_s)) {
      reader_.at(*snapshot);
      reader_.depths(*snapshot);
    }
  }

  /// Drawn anew only when it is not the one before.
  const Image& at(double time_s) {
    const Shown shown = {snapshotAt(time_s), !times_s().empty() && time_s > times_s().back()};
    if (!drawn_ || shown != *drawn_) {
      image_ = draw(shown);
      drawn_ = shown;
    }
    return image_;
  }

 private:
  struct Shown {
    std::optional<std::size_t> snapshot;
    bool over = false;  ///< that was the last one
    bool operator==(const Shown&) const = default;
  };

  std::optional<std::size_t> snapshotAt(double time_s) const {
    const auto later = std::upper_bound(times_s().begin(), times_s().end(), time_s);
    if (later == times_s().begin()) return std::nullopt;
    return static_cast<std::size_t>(later - times_s().begin()) - 1;
  }

  Image draw(const Shown& shown) {
    if (!shown.snapshot) {
      Image image = emptyPicture(camera_.width_px, camera_.height_px);
      drawLines(image, {name_, nameOf(end_), "no snapshot"});
      return image;
    }
    if (!renderer_) renderer_ = makeOffscreenRenderer(scene_, camera_, first_);
    const State state = reader_.at(*shown.snapshot);
    std::vector<std::string> lines = frameText(name_, state.time_s, reader_.depths(*shown.snapshot));
    const bool last = *shown.snapshot + 1 == times_s().size();
    if (shown.over || (last && end_ != RunEnd::ok))
      lines.push_back(end_ == RunEnd::ok ? "ended" : nameOf(end_));
    if (!shown.over) return renderer_->draw(state, lines);
    Image image = faded(renderer_->draw(state, {}));
    drawLines(image, lines);
    return image;
  }

  std::string name_;
  RunEnd end_;
  SnapshotReader reader_;
  Scene scene_;
  State first_;
  Camera camera_;
  std::unique_ptr<FrameSource> renderer_;
  std::optional<Shown> drawn_;
  Image image_;
};

StoredPictures::~StoredPictures() = default;
StoredPictures::StoredPictures(StoredPictures&&) noexcept = default;

StoredPictures::StoredPictures(const std::filesystem::path& file, const std::vector<PipelineResult>& runs,
                               const PictureSettings& settings, std::optional<double> ground_height_m)
    : settings_(settings) {
  std::vector<Vec3> points_m;
  std::set<double> times_s;
  for (const PipelineResult& run : runs) {
    const Panel& panel = panels_.emplace_back(file, run, ground_height_m);
    const std::vector<Vec3> own_m = panel.points_m();
    points_m.insert(points_m.end(), own_m.begin(), own_m.end());
    times_s.insert(panel.times_s().begin(), panel.times_s().end());
  }
  times_s_.assign(times_s.begin(), times_s.end());
  const Camera camera = chosenCamera(settings, points_m);
  for (Panel& panel : panels_) panel.setCamera(camera);
  size_ = joinedSize({camera.width_px, camera.height_px}, static_cast<int>(runs.size()), settings.columns);
  if (size_.width_px > most_px || size_.height_px > most_px)
    throw InputError(
        fmt::format("the panels together have {0} x {1} px, expected at most {2} x {2}: a smaller --size, "
                    "other --columns",
                    size_.width_px, size_.height_px, most_px));
}

void StoredPictures::check(double time_s) const {
  for (const Panel& panel : panels_) panel.check(time_s);
}

Image StoredPictures::picture(double time_s) {
  std::vector<Image> images;
  for (Panel& panel : panels_) images.push_back(panel.at(time_s));
  return joinPanels(images, settings_.columns);
}

}  // namespace fissure
