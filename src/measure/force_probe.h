#pragma once

#include <optional>

#include "base/probe.h"
#include "base/scene.h"
#include "measure/same_triangles_roughness.h"
#include "measure/statistics.h"
#include "scenario/scenario.h"

namespace fissure {

/// Series force(law, xyz) on the tools, its terms force_elastic(law), force_viscous(law),
/// adhesion_clamped(law) and, of the triangles in a colliding state (colliding_triangles), largest and mean
/// deformation(law) and its rate(law); tool_force(law, tool, xyz); where a tool has a force limit
/// saturated(law, tool), the force itself stays as it is. Scalars: the largest magnitude, the roughness, that
/// of the triangles that stay (roughness_same_triangles) and, with a limit, the steps in which a tool was
/// saturated, of every law; those of the first law under their short names too.
/// force_non_finite_at_step_<law>, the first such step, only where a law's force overflowed.
class ForceProbe : public Probe {
 public:
  /// Laws and limits from `scenario`, which has at least one law; State::forces is in their order.
  ForceProbe(const Scenario& scenario, const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Law {
    std::string name;
    RunningMax max_N;
    Roughness roughness;
    long long saturated_steps = 0;
    std::optional<long long> non_finite_at_step;
  };
  void declareTools(RecordLayout& layout);
  void sampleTools(const State& state, std::size_t law, RecordRow& row);

  std::vector<Law> laws_;
  SameTrianglesRoughness same_triangles_;
  std::vector<std::string> tools_;
  std::vector<std::optional<double>> limits_N_;  ///< one a tool; empty: no tool has one
  bool sampled_ = false;
  std::size_t force_column_ = 0;
  std::size_t terms_column_ = 0;  ///< of the series with one value a law, in the order of declare()
  std::size_t triangles_column_ = 0;
  std::size_t tool_force_column_ = 0;
  std::size_t saturated_column_ = 0;
};

}  // namespace fissure
