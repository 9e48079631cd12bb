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

/// Runs one scenario with one pipeline in fixed steps: settling, then one row of the record for the initial
/// state and one for each step. Simulated time is step x dt. Build it, declare the probes, execute it once.
class Run {
 public:
  /// Builds the world; reads no files. `scenario` and `pipeline` must outlive the run; `prepared` must be
  /// that of the scenario, with nodes where the pipeline uses them.
  Run(const Scenario& scenario, const PipelineSettings& pipeline, PreparedScenario prepared);

  const Scene& scene() const { return prepared_.scene; }
  /// Number of recorded steps, without settling.
  std::int64_t stepCount() const { return steps_; }

  /// The receivers of a run's output. The functions may be empty.
  struct Outputs {
    RecordSink& sink;
    std::vector<std::unique_ptr<Probe>>& probes;
    const RecordLayout& layout;  ///< made by declareLayout() from the same probes
    /// Makes the renderer, from the first state; called once, and only if the scenario asks for frames.
    std::function<std::unique_ptr<FrameSource>(const State& first)> make_frame_source;
    /// Called after steps; settling steps are counted too.
    std::function<void(std::int64_t step, std::int64_t steps)> progress;
  };

  /// As Simulation::changeTempo(); to be called between two steps, for instance from Outputs::progress.
  void changeTempo(double factor);

  /// Runs to the end, or until a position of tissue or tool is not finite or farther than 10 km away, or the
  /// tissue's kinetic energy is not finite (status non_finite, with the reason and the time). Then passes
  /// status and summary to the sink, and returns the status. Exceptions of sink and renderer are not caught.
  RunStatus execute(const Outputs& outputs);

 private:
  bool isElastic() const;
  bool isExplicit() const;  ///< whether the engine of explicit/ moves the tissue
  std::vector<Pose> posesAt(double time_s) const;
  void makeCouplings();
  void moveCoupled(std::vector<Pose>& poses);
  void notePushes();
  void noteClamps(double time_s);
  void noteCouplings();
  bool advance(std::int64_t step);
  void emit(const Outputs& outputs, RecordRow& row, FrameSource* frames);

  const Scenario& scenario_;
  Scenario engine_scenario_;  ///< the same scenario with rigidTools(), one per tool of the scene
  const PipelineSettings& pipeline_;
  PreparedScenario prepared_;
  /// A tool on a virtual coupling.
  struct Coupled {
    std::size_t tool = 0;            ///< index in Scene::tools
    std::optional<std::size_t> law;  ///< force law that moves it; no value: contacts do
    VirtualCoupling coupling;
  };
  std::vector<Coupled> coupled_;
  /// [tool] while contacts push any tool, else empty; 0: contacts do not push this one.
  std::vector<double> tool_inverse_masses_1_kg_;
  std::int64_t steps_ = 0, settling_steps_ = 0;
  std::unique_ptr<Simulation> simulation_;
};

}  // namespace fissure
