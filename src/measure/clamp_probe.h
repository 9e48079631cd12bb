#pragma once

#include <optional>

#include "base/probe.h"
#include "base/scene.h"
#include "measure/statistics.h"
#include "scenario/scenario.h"

namespace fissure {

/// What a hand at a clamp would feel: series clamp_force(law, clamp, xyz) and clamp_reaction(clamp, xyz), the
/// resultants of both jaws (paper, Fig. 5), and how far the clamps are open, jaw_opening(clamp) in metres or
/// jaw_angle(clamp) in degrees, each only where a clamp of that kind is, NaN for others. Scalars, each with
/// the clamp's name before it: max_resultant_<law>_N, left_max_force_<law>_N and right_max_force_<law>_N, the
/// largest magnitudes; final_reaction_N, that of the resultant reaction at the end, where the engine says it.
class ClampProbe : public Probe {
 public:
  ClampProbe(const Scenario& scenario, const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Largest {
    RunningMax resultant_N, left_N, right_N;
  };
  void sampleForces(const State& state, RecordRow& row);

  std::vector<SceneClamp> clamps_;
  std::vector<std::string> laws_;
  std::size_t tools_;
  std::vector<Largest> largest_;                          ///< law x number of clamps + clamp
  std::vector<std::optional<double>> final_reactions_N_;  ///< no value: the engine does not say
  std::size_t force_column_ = 0;
  std::size_t reaction_column_ = 0;
  std::optional<std::size_t> opening_column_, angle_column_;  ///< where a clamp of that kind is
};

}  // namespace fissure
