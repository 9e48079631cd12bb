#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/image.h"
#include "base/probe.h"
#include "base/record_sink.h"
#include "base/scene.h"
#include "motion/virtual_coupling.h"
#include "scenario/scenario.h"
#include "scene/prepared_scenario.h"
#include "stepping/simulation.h"

namespace fissure {

/// One scenario through one pipeline in fixed steps: settling, then one row for the initial state and one for
/// each step. Simulated time is step x dt. Build it, declare the probes, execute once.
class Run {
 public:
  /// Builds the world. `scenario` and `pipeline` must outlive the run; `prepared` is the scenario's, with
  /// nodes where the pipeline uses them. No file is read any more.
  Run(const Scenario& scenario, const PipelineSettings& pipeline, PreparedScenario prepared);

  const Scene& scene() const { return prepared_.scene; }
  std::int64_t stepCount() const { return steps_; }

  /// What a run hands out. Only `sink` is needed.
  struct Outputs {
    RecordSink& sink;
    std::vector<std::unique_ptr<Probe>>& probes;
    const RecordLayout& layout;  ///< as declareLayout() makes it from the same probes
    /// Makes the renderer from the first state; called once, and only when the scenario asks for frames.
    std::function<std::unique_ptr<FrameSource>(const State& first)> make_frame_source;
    std::function<void(std::int64_t step, std::int64_t steps)> progress;  ///< settling steps included
  };

  /// Runs to the end, or until a position of tissue or tool is not finite or 10 km away, or the tissue's
  /// kinetic energy is not finite (status non_finite, with what and when); then hands status and summary to
  /// the sink. Errors of sink and renderer pass through.
  RunStatus execute(const Outputs& outputs);

 private:
  bool isElastic() const;
  bool isExplicit() const;  ///< moved by the engine of explicit/
  std::vector<Pose> posesAt(double time_s) const;
  void makeCouplings();
  void moveCoupled(std::vector<Pose>& poses);
  void notePushes();
  void noteClamps(double time_s);
  void noteCouplings();
  bool advance(std::int64_t step);
  void emit(const Outputs& outputs, RecordRow& row, FrameSource* frames);

  const Scenario& scenario_;
  Scenario engine_scenario_;  ///< the same with rigidTools(), one a tool of the scene
  const PipelineSettings& pipeline_;
  PreparedScenario prepared_;
  /// A tool that a force law moves, or the contacts.
  struct Coupled {
    std::size_t tool = 0;            ///< of the scene
    std::optional<std::size_t> law;  ///< none: the contacts
    VirtualCoupling coupling;
  };
  std::vector<Coupled> coupled_;
  /// One a tool of the scene while contacts push one, 0: not this one.
  std::vector<double> tool_inverse_masses_1_kg_;
  std::int64_t steps_ = 0, settling_steps_ = 0;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace fissure
