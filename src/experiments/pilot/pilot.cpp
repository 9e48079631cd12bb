#include "pilot/pilot.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>

#include "base/steps.h"
#include "files/write_file.h"
#include "pilot/paced_motion.h"

namespace fissure {

namespace {

/// Snapshots and frames of a pilot: the first, which may take longer, and some more.
constexpr std::int64_t most_occasions = 4;

/// Tissue that jumps have set in motion still moves in the windows, and its steps cost more than in the run:
/// at one step in ten up to about twice as much (results/plan), at one in two next to nothing.
constexpr double excess_per_speed = 0.1;

std::int64_t stepsIn(double duration_s, const TimeSettings& time) {
  return static_cast<std::int64_t>(stepsToCover(duration_s, time.step_s));
}

/// Processor time of the processes that this one has started and that have ended.
double ofChildren_s() {
  rusage usage = {};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

Pilot::Times Pilot::now() {
  timespec processor = {};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &processor);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return {std::chrono::duration<double>(wall).count(),
          static_cast<double>(processor.tv_sec) + 1e-9 * static_cast<double>(processor.tv_nsec)};
}

/// The first is taken once, the mean of the others for all others.
double Pilot::Occasions::costOfRun_s() const {
  if (costs_s.empty()) return 0;
  const auto count = static_cast<double>(in_run);
  if (costs_s.size() == 1) return count * costs_s.front();
  const double others_s = std::accumulate(costs_s.begin() + 1, costs_s.end(), 0.0);
  return costs_s.front() + (count - 1) * others_s / static_cast<double>(costs_s.size() - 1);
}

template <class Work>
void Pilot::time(Occasions& occasions, const Work& work) {
  const Times before = now();
  work();
  const Times after = now();
  const double processor_s = after.processor_s - before.processor_s;
  occasions.costs_s.push_back(std::min(processor_s, after.wall_s - before.wall_s));
  aside_s_ += processor_s;
}

class Pilot::Sink : public RecordSink {
 public:
  Sink(Pilot& pilot, RecordSink& sink) : pilot_(pilot), sink_(sink) {}

  void forceInputs(const State& state) override { sink_.forceInputs(state); }
  void append(const RecordRow& row) override { sink_.append(row); }
  void snapshot(const State& state) override {
    pilot_.time(pilot_.snapshots_, [&] { sink_.snapshot(state); });
  }
  void frame(double time_s, const Image& image) override {
    pilot_.time(pilot_.kept_frames_, [&] { sink_.frame(time_s, image); });
  }
  void finish(const RunStatus& status, const Summary& summary) override { sink_.finish(status, summary); }

 private:
  Pilot& pilot_;
  RecordSink& sink_;
};

class Pilot::Frames : public FrameSource {
 public:
  Frames(Pilot& pilot, std::unique_ptr<FrameSource> frames) : pilot_(pilot), frames_(std::move(frames)) {}

  Image draw(const State& state, const std::vector<std::string>& lines) override {
    Image image;
    pilot_.time(pilot_.drawn_frames_, [&] { image = frames_->draw(state, lines); });
    return image;
  }
  std::vector<std::pair<std::string, std::string>> versions() const override { return frames_->versions(); }

 private:
  Pilot& pilot_;
  std::unique_ptr<FrameSource> frames_;
};

Pilot::Pilot(Scenario& scenario, PreparedScenario& prepared, int one_in) : one_in_(one_in) {
  renderer_.in_run = 1;
  TimeSettings& time = scenario.time;
  const double duration_s = time.duration_s.value_or(prepared.longestMotion_s());
  pace_ = paceOf(stepsIn(duration_s, time), one_in);
  settling_steps_ = stepsIn(time.settle_s, time);
  step_costs_s_.push_back(0);
  for (std::unique_ptr<Motion>& motion : prepared.motions)
    motion = std::make_unique<PacedMotion>(std::move(motion), pace_, time.step_s);
  time.duration_s = static_cast<double>(pace_.steps()) * time.step_s;
  const auto thin = [&](double& every_s) {
    const std::int64_t in_run = timesDue(pace_.stepsOfRun(), time.step_s, every_s);
    const std::int64_t kept = std::min(in_run, most_occasions);
    every_s = *time.duration_s / static_cast<double>(std::max<std::int64_t>(1, kept - 1));
    return in_run;
  };
  RecordSettings& record = scenario.record;
  if (record.snapshots_every_s) snapshots_.in_run = thin(*record.snapshots_every_s);
  if (record.frames) drawn_frames_.in_run = kept_frames_.in_run = thin(record.frames->every_s);
}

Pilot::~Pilot() = default;

void Pilot::begin() {
  begun_s_ = last_s_ = now().processor_s;
}

double Pilot::stepped() {
  const double now_s = now().processor_s;
  const double cost_s = now_s - last_s_ - aside_s_;
  if (settling_steps_ > settled_steps_) {
    ++settled_steps_;
    settling_s_ += cost_s;
  } else {
    step_costs_s_.push_back(cost_s);
  }
  last_s_ = now_s;
  aside_s_ = 0;
  if (settled_steps_ < settling_steps_) return 1;
  return pace_.speedChangeAfter(static_cast<std::int64_t>(step_costs_s_.size()) - 1);
}

RecordSink& Pilot::watched(RecordSink& sink) {
  sink_ = std::make_unique<Sink>(*this, sink);
  return *sink_;
}

std::unique_ptr<FrameSource> Pilot::watchedFrames(const std::function<std::unique_ptr<FrameSource>()>& make) {
  std::unique_ptr<FrameSource> frames;
  time(renderer_, [&] { frames = make(); });
  return std::make_unique<Frames>(*this, std::move(frames));
}

Forecast Pilot::forecast() const {
  Forecast forecast;
  forecast.pilot_steps = pace_.steps();
  forecast.run_steps = pace_.stepsOfRun();
  // Start, scene and world, TetGen and the end.
  const double beside_s = now().processor_s + ofChildren_s() - (last_s_ - begun_s_);
  const double rest_s = beside_s + settling_s_ + renderer_.costOfRun_s() + snapshots_.costOfRun_s() +
                        drawn_frames_.costOfRun_s() + kept_frames_.costOfRun_s();
  const double steps_s = costOfRun(pace_, step_costs_s_);
  forecast.run_s = forecast.low_s = forecast.high_s = rest_s + steps_s;
  if (pace_.steps() == pace_.stepsOfRun()) return forecast;  // nothing is foretold
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
    forecast.high_s = std::max(forecast.high_s, rest_s + costOfRun(pace_, step_costs_s_, 2, half));
  forecast.low_s = rest_s + steps_s / (1 + excess_per_speed * (one_in_ - 1));
  forecast.run_s = (forecast.low_s + forecast.high_s) / 2;
  return forecast;
}

std::optional<Pilot> PilotOrder::thin(Scenario& scenario, PreparedScenario& prepared) const {
  if (forecast.empty()) return std::nullopt;
  return std::optional<Pilot>(std::in_place, scenario, prepared, one_in);
}

void PilotOrder::write(const std::optional<Pilot>& pilot) const {
  if (pilot) writeFile(forecast, forecastText(pilot->forecast()));
}

}  // namespace fissure
