#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/record_sink.h"
#include "pilot/forecast.h"
#include "pilot/pace.h"
#include "scene/prepared_scenario.h"

namespace fissure {

/// Measures a shortened run, the pilot, to forecast the wall time of the run itself. A worker makes this
/// object before the run, passes all output of the run through it, and asks it for the forecast afterwards.
class Pilot {
 public:
  /// Shortens `scenario` and the motions of `prepared`, which must be made from it: the tools take the same
  /// path in about one in `one_in` of the steps, and few snapshots and frames are kept. Both are then to be
  /// run instead of the originals; `prepared` must not outlive the pilot.
  Pilot(Scenario& scenario, PreparedScenario& prepared, int one_in);
  ~Pilot();
  Pilot(const Pilot&) = delete;
  Pilot& operator=(const Pilot&) = delete;

  void begin();  ///< to be called right before the first step, settling included
  /// To be called after each step, the run's settling steps first. Returns the speed of the tools in the next
  /// step over that in this one, see Simulation::changeTempo.
  double stepped();
  /// A sink that passes everything on to `sink`, which must outlive it, and measures the time that takes.
  RecordSink& watched(RecordSink& sink);
  /// The same for the renderer that `make` makes.
  std::unique_ptr<FrameSource> watchedFrames(const std::function<std::unique_ptr<FrameSource>()>& make);

  /// The forecast; to be called after the run has ended and its output is closed.
  Forecast forecast() const;

 private:
  class Sink;
  class Frames;

  /// Wall time, and processor time of all threads of this process, seconds. The latter hardly depends on
  /// other work of the machine.
  struct Times {
    double wall_s = 0, processor_s = 0;
  };
  static Times now();
  /// Work that is not done in every step: how often the run does it, and how long each occasion took in the
  /// pilot, by the smaller of both clocks, because parallel threads that draw take more processor time.
  struct Occasions {
    std::int64_t in_run = 0;
    std::vector<double> costs_s;

    double costOfRun_s() const;
  };
  template <class Work>
  void time(Occasions& occasions, const Work& work);

  int one_in_ = 1;
  Pace pace_;
  std::int64_t settling_steps_ = 0, settled_steps_ = 0;
  std::unique_ptr<Sink> sink_;
  double begun_s_ = 0, last_s_ = 0;  ///< processor time at begin() and after the last step
  double aside_s_ = 0;               ///< processor time since then for work that is not part of a step
  Occasions renderer_, snapshots_, drawn_frames_, kept_frames_;
  double settling_s_ = 0;
  std::vector<double> step_costs_s_;  ///< processor time of each step so far, as costOfRun() takes them
};

/// The arguments of a worker about a pilot.
struct PilotOrder {
  int one_in = 1;
  std::string forecast;  ///< file for the forecast; empty: no pilot, the whole run

  /// Makes the pilot, which shortens scenario and motions; no value for a whole run.
  std::optional<Pilot> thin(Scenario& scenario, PreparedScenario& prepared) const;
  /// Writes the forecast of a pilot that has ended to the file. Throws RunError when writing fails.
  void write(const std::optional<Pilot>& pilot) const;
};

}  // namespace fissure
