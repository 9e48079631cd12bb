#include <algorithm>
#include <iostream>
#include <memory>

#include "base/error.h"
#include "main/comparison.h"
#include "main/exit_codes.h"
#include "main/verbs.h"
#include "picture/render_job.h"
#include "picture/video_file.h"
#include "text/scalars.h"

namespace fissure {

namespace {

struct RenderOptions {
  std::string result, folder, video, size;
  std::vector<std::string> runs;
  bool separate = false, force = false;
  std::vector<double> at_s, camera_position_m, look_at_m, up;
  std::optional<double> from_s, to_s, every_s, field_of_view_deg;
  int columns = 4;
  double frames_per_s = 25, slow_motion = 1;
};

std::pair<int, int> sizeOf(const std::string& text) {
  const std::size_t cross = std::min(text.find('x'), text.size());
  const std::optional<int> width_px = toInt(text.substr(0, cross));
  const std::optional<int> height_px = toInt(text.substr(std::min(cross + 1, text.size())));
  if (!width_px || !height_px)
    throw InputError("--size: \"" + text + "\", expected width and height in pixels, as in 640x480");
  return {*width_px, *height_px};
}

std::optional<Vec3> vectorOf(const std::vector<double>& values) {
  return values.empty() ? std::nullopt : std::optional<Vec3>(Vec3(values[0], values[1], values[2]));
}

std::filesystem::path videoOf(const std::string& text, double frames_per_s) {
  std::filesystem::path file = text;
  const std::string ending = file.extension().string();
  const std::vector<std::string>& kinds = videoKinds();
  if (ending.empty() || std::find(kinds.begin(), kinds.end(), ending.substr(1)) == kinds.end())
    throw InputError("--video: \"" + text + "\", expected a name that ends in .mp4, .webm or .gif");
  constexpr double fastest_gif = 50;  // its times are whole hundredths, and one is taken for none
  if (ending == ".gif" && frames_per_s > fastest_gif)
    throw InputError("--fps: more than 50 frames a second, expected at most 50 in a gif");
  return file;
}

RenderJob jobOf(const RenderOptions& options) {
  RenderJob job;
  const ResultChoice choice = parseChoice(options.result);
  job.result = choice.file;
  job.runs = options.runs;
  if (!choice.run.empty()) job.runs.insert(job.runs.begin(), choice.run);
  if (options.folder.empty() && options.video.empty())
    throw InputError("fissure render: expected -o DIR for pictures, --video FILE, or both");
  if (!options.folder.empty()) job.folder = options.folder;
  if (!options.video.empty()) job.video = videoOf(options.video, options.frames_per_s);
  job.separate = options.separate;
  job.force = options.force;
  job.times = {options.from_s, options.to_s, options.every_s, options.at_s};
  if (!options.size.empty()) job.size_px = sizeOf(options.size);
  job.camera = {vectorOf(options.camera_position_m), vectorOf(options.look_at_m), vectorOf(options.up),
                options.field_of_view_deg};
  job.columns = options.columns;
  job.frames_per_s = options.frames_per_s;
  job.slow_motion = options.slow_motion;
  return job;
}

int renderAndTell(const RenderJob& job) {
  const RenderOutcome made = render(job);
  if (made.interrupted) {
    std::cerr << "interrupted: finished pictures are kept, no video is\n";
    return exit_interrupted;
  }
  if (job.folder) std::cout << "pictures: " << made.pictures << " in " << job.folder->string() << "\n";
  if (made.video_error) std::rethrow_exception(made.video_error);
  if (job.video)
    std::cout << "video: " << job.video->string() << ", " << made.frames << " frames, "
              << static_cast<double>(made.frames) / job.frames_per_s << " s\n";
  return exit_good;
}

void addVector(Command command, const std::string& name, std::vector<double>& values,
               const std::string& what) {
  command.option(name, values, what).count(3).commas();
}

void addChoices(Command command, RenderOptions& options) {
  command.option("--pipeline", options.runs, "only the runs of this name; may be repeated").repeated();
  Option separate =
      command.flag("--separate", options.separate, "a picture for each run, as the run draws its frames");
  separate.without("--video");
  command.option("--columns", options.columns, "panels in a row").between(1.0, 1000.0).showDefault();
  Option at = command.option("--at", options.at_s, "the snapshots nearest to these times, seconds: 0.1,0.2");
  at.commas().repeated().between(-1e9, 1e9);
  command.option("--from", options.from_s, "not before this time, seconds").between(-1e9, 1e9).without(at);
  command.option("--to", options.to_s, "not after this time, seconds").between(-1e9, 1e9).without(at);
  command.option("--every", options.every_s, "at most one snapshot in this time, seconds")
      .between(1e-9, 1e9)
      .without(at);
}

void addLooks(Command command, RenderOptions& options) {
  command.option("--size", options.size, "WxH of a panel in pixels; default: of the scenario's frames");
  addVector(command, "--camera-position", options.camera_position_m,
            "where the camera stands: x y z, metres");
  addVector(command, "--look-at", options.look_at_m, "what it looks at: x y z, metres");
  addVector(command, "--up", options.up, "what is up in the pictures: x y z");
  command.option("--field-of-view", options.field_of_view_deg, "its vertical angle of view, degrees")
      .between(1.0, 150.0);
  command.option("--fps", options.frames_per_s, "frames of the video in a second")
      .between(1.0, 240.0)
      .showDefault();
  command
      .option("--slow-motion", options.slow_motion,
              "how many times slower than simulated; 0.5: twice as fast")
      .between(1e-3, 1e6)
      .showDefault();
}

}  // namespace

Verb addRender(Command app) {
  const auto options = std::make_shared<RenderOptions>();
  Command command =
      app.command("render", "pictures and videos of a result's snapshots, its runs side by side");
  command.example("fissure render out/press.h5 --video press.mp4 --slow-motion 4");
  command.option("RESULT", options->result, "result file, or FILE:NAME for one run of it")
      .required()
      .notEmpty();
  command.option("-o,--output", options->folder, "folder for the pictures: <name>_<time>s.png").notEmpty();
  command.option("--video", options->video, "video of them, made by ffmpeg: .mp4, .webm or .gif").notEmpty();
  addChoices(command, *options);
  addLooks(command, *options);
  command.flag("--force", options->force, "replace existing files");
  return {command, [options] { return renderAndTell(jobOf(*options)); }};
}

}  // namespace fissure
