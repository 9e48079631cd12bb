#pragma once

#include <string>
#include <vector>

#include "base/record.h"
#include "base/state.h"
#include "measure/statistics.h"
#include "task/law_family.h"

namespace fissure {

/// What a run's summary says about its force laws, for many sets of laws over one simulation. The force
/// limits of devices and the roughness of the triangles that stay are not among it: they need more of each
/// triangle.
class LawStatistics {
 public:
  /// `rows`: sets of as many laws as the scenario has, in its order, with other coefficients.
  LawStatistics(const std::vector<std::vector<ForceSettings>>& rows,
                const std::vector<ForceSettings>& scenario_laws);

  void add(const State& state);

  std::size_t rows() const { return laws_.size() / names_.size(); }
  /// Of the last state: row x number of laws + law.
  const std::vector<LawValue>& values() const { return family_.values(); }
  /// Of one row, under the names ForceProbe gives them.
  void summarize(std::size_t row, Summary& summary) const;

 private:
  struct Law {
    RunningMax max_N;
    Roughness roughness;
    long long non_finite_at_step = -1;
  };

  std::vector<std::string> names_;
  LawFamily family_;
  std::vector<Law> laws_;  ///< row by row
};

}  // namespace fissure
