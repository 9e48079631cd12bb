#include "picture/render_job.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <numeric>
#include <set>

#include "base/error.h"
#include "files/output_claim.h"
#include "picture/picture_file.h"
#include "picture/video_file.h"
#include "process/apart.h"
#include "process/interrupt.h"
#include "process/progress_display.h"
#include "scenario/load.h"
#include "text/did_you_mean.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

/// Pictures that belong together, with the beginning of their names.
struct PictureSeries {
  std::string name;
  StoredPictures pictures;
  std::vector<double> times_s;  ///< the chosen ones
};

std::vector<PipelineResult> chooseRuns(const ResultInfo& info, const RenderJob& job) {
  if (job.runs.empty()) return info.pipelines;
  std::vector<std::string> known;
  for (const PipelineResult& run : info.pipelines) known.push_back(run.name);
  std::vector<PipelineResult> chosen;
  for (const std::string& name : job.runs) {
    const auto at = std::find(known.begin(), known.end(), name);
    if (at == known.end())
      throw InputError(inFile(job.result), fmt::format("has no run \"{}\"{}", name, didYouMean(name, known)));
    const auto same = [&](const PipelineResult& run) { return run.name == name; };
    if (std::none_of(chosen.begin(), chosen.end(), same))
      chosen.push_back(info.pipelines[at - known.begin()]);
  }
  return chosen;
}

[[noreturn]] void failWithoutSnapshots(const RenderJob& job, const std::vector<PipelineResult>& runs,
                                       const Scenario& scenario) {
  const std::string which = runs.size() == 1 ? "run " + runs.front().name + " holds" : "its runs hold";
  throw InputError(inFile(job.result), which + " no snapshots to draw, expected " +
                                           (scenario.record.snapshots_every_s
                                                ? "a run that lasted until one was written"
                                                : "a scenario with record: {snapshots_every_s: ...}"));
}

/// A finished result, not a part or a few rows of one.
ResultInfo wholeResult(const fs::path& file) {
  ResultInfo info = readResultInfo(file);
  if (!info.complete)
    throw InputError(inFile(file),
                     "not complete, expected a finished result (fissure salvage makes one of a part)");
  if (info.reference)
    throw InputError(inFile(file), "a reference, which holds a few rows, expected a whole result");
  return info;
}

std::vector<double> timesOf(const std::vector<PictureSeries>& all) {
  std::set<double> times_s;
  for (const PictureSeries& series : all)
    times_s.insert(series.pictures.times_s().begin(), series.pictures.times_s().end());
  return {times_s.begin(), times_s.end()};
}

/// Chooses among the times of all series together, because a run that ended early has no later pictures.
/// Each series gets those of the chosen times that it has itself.
void chooseTimes(std::vector<PictureSeries>& all, const TimeSelection& selection) {
  const std::vector<double> chosen_s = selectTimes(timesOf(all), selection);
  for (PictureSeries& series : all) {
    const std::vector<double>& own_s = series.pictures.times_s();
    std::set_intersection(own_s.begin(), own_s.end(), chosen_s.begin(), chosen_s.end(),
                          std::back_inserter(series.times_s));
  }
}

/// What there is to draw. Reads no snapshot but the first of each run.
std::vector<PictureSeries> openSeries(const RenderJob& job) {
  const ResultInfo info = wholeResult(job.result);
  const Scenario scenario = parseStoredScenario(info.scenario_resolved, job.result).scenario;
  PictureSettings settings{scenario.record.frames.value_or(FrameSettings{}), job.camera, job.columns};
  if (job.size_px) std::tie(settings.frames.width_px, settings.frames.height_px) = *job.size_px;
  std::optional<double> ground_height_m;
  if (scenario.ground) ground_height_m = scenario.ground->height_m;
  const std::vector<PipelineResult> runs = chooseRuns(info, job);

  std::vector<PictureSeries> all;
  const auto add = [&](const std::string& name, const std::vector<PipelineResult>& some) {
    StoredPictures pictures(job.result, some, settings, ground_height_m);
    if (!pictures.times_s().empty()) all.push_back({name, std::move(pictures), {}});
  };
  if (job.separate)
    for (const PipelineResult& run : runs) add(run.name, {run});
  else if (!runs.empty())
    add(runs.size() == 1 ? runs.front().name : scenario.name, runs);
  if (all.empty()) failWithoutSnapshots(job, runs, scenario);
  chooseTimes(all, job.times);
  return all;
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw InputError(inFile(folder), "cannot make this folder: " + error.message());
}

/// Where each picture of each series goes; nothing is in the way.
std::vector<std::vector<fs::path>> claimFiles(const RenderJob& job, const std::vector<PictureSeries>& all) {
  std::vector<std::vector<fs::path>> files;
  if (job.folder) {
    const TimeTexts texts(timesOf(all));
    for (const PictureSeries& series : all) {
      std::vector<fs::path>& own = files.emplace_back();
      for (const double time_s : series.times_s)
        own.push_back(*job.folder / fmt::format("{}_{}.png", series.name, texts.of(time_s)));
      for (const fs::path& file : own) {
        refuseInput(job.result, file);
        refuseExisting(file, job.force);
      }
    }
  }
  if (job.video) {
    refuseInput(job.result, *job.video);
    refuseExisting(*job.video, job.force);
  }
  if (job.folder) makeFolder(*job.folder);
  if (job.video && job.video->has_parent_path()) makeFolder(job.video->parent_path());
  return files;
}

/// The video of a job, where it has one. What goes wrong with it is kept until its end when there are
/// pictures to be written.
class VideoOfJob {
 public:
  VideoOfJob(const RenderJob& job, const PictureSeries& series, int stop_descriptor) {
    if (!job.video) return;
    shown_ = timesShown(series.times_s, job.frames_per_s, job.slow_motion);
    keeping(job.folder.has_value(), [&] {
      const auto ffmpeg = programOnPath("ffmpeg");
      if (!ffmpeg)
        throw InputError(inFile(*job.video),
                         "needs ffmpeg, which is not installed (Debian: apt-get install ffmpeg)");
      const PictureSize size = series.pictures.size();
      const std::string kind = job.video->extension().string().substr(1);
      file_.emplace(*job.video, *ffmpeg,
                    VideoSettings{kind, static_cast<int>(size.width_px), static_cast<int>(size.height_px),
                                  job.frames_per_s},
                    stop_descriptor);
    });
    go_on_ = job.folder.has_value();
  }

  bool shows(std::size_t picture) const { return file_ && shown_[picture] > 0; }
  void add(std::size_t picture, const Image& image) {
    keeping(go_on_, [&] {
      for (std::size_t i = 0; i < shown_[picture]; ++i) file_->add(image);
    });
  }
  /// Number of its frames; 0: no video.
  std::size_t finish() {
    if (file_) keeping(go_on_, [&] { file_->finish(); });
    return error_ ? 0 : std::accumulate(shown_.begin(), shown_.end(), std::size_t{0});
  }
  const std::exception_ptr& error() const { return error_; }

 private:
  template <typename Work>
  void keeping(bool keep, const Work& work) {
    try {
      work();
    } catch (const std::runtime_error&) {
      file_.reset();
      if (!keep) throw;
      error_ = std::current_exception();
    }
  }

  bool go_on_ = false;
  std::vector<std::size_t> shown_;  ///< of each picture: how many frames show it
  std::optional<VideoFile> file_;
  std::exception_ptr error_;
};

std::string progressText(std::size_t done, std::size_t all, double elapsed_s) {
  std::string text = fmt::format("{}/{} pictures", done, all);
  if (done > 0)
    text += ", " + durationText(elapsed_s / static_cast<double>(done) * static_cast<double>(all - done)) +
            " left";
  return text;
}

/// True when all was drawn, false after an interruption.
bool draw(std::vector<PictureSeries>& all, const std::vector<std::vector<fs::path>>& files, VideoOfJob& video,
          Interrupt& interrupt) {
  ProgressDisplay display(std::cerr, STDERR_FILENO);
  std::size_t count = 0, done = 0;
  for (const PictureSeries& series : all) count += series.times_s.size();
  for (std::size_t s = 0; s < all.size(); ++s) {
    for (std::size_t i = 0; i < all[s].times_s.size(); ++i, ++done) {
      if (interrupt.requested()) return false;
      display.show([&](double elapsed_s) { return progressText(done, count, elapsed_s); });
      if (files.empty() && !video.shows(i)) continue;
      const Image image = all[s].pictures.picture(all[s].times_s[i]);
      if (!files.empty()) writePng(files[s][i], image);
      if (video.shows(i)) video.add(i, image);
    }
  }
  return true;
}

RenderOutcome drawAll(const RenderJob& job, std::vector<PictureSeries>& all,
                      const std::vector<std::vector<fs::path>>& files) {
  RenderOutcome outcome;
  Interrupt interrupt;
  try {
    VideoOfJob video(job, all.front(), interrupt.descriptor());
    outcome.interrupted = !draw(all, files, video, interrupt);
    if (outcome.interrupted) return outcome;
    for (const std::vector<fs::path>& own : files) outcome.pictures += own.size();
    outcome.frames = video.finish();
    outcome.video_error = video.error();
  } catch (const RunError&) {
    outcome.video_error = std::current_exception();
  }
  if (!outcome.video_error || (!interrupt.requested() && job.folder)) return outcome;
  if (!interrupt.requested()) std::rethrow_exception(outcome.video_error);
  try {
    std::rethrow_exception(outcome.video_error);
  } catch (const RunError&) {
    outcome.interrupted = true;  // ffmpeg was
  } catch (const InputError&) {
    // it was missing from the start
  }
  return outcome;
}

}  // namespace

RenderOutcome render(const RenderJob& job) {
  tryReading(job.result, [&] {
    for (const PictureSeries& series : openSeries(job))
      for (const double time_s : series.times_s) series.pictures.check(time_s);
  });
  std::vector<PictureSeries> all = openSeries(job);
  return drawAll(job, all, claimFiles(job, all));
}

}  // namespace fissure
