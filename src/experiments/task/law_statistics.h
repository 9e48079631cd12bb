#pragma once

#include <string>
#include <vector>

#include "base/record.h"
#include "base/state.h"
#include "measure/statistics.h"
#include "task/law_family.h"

namespace fissure {

/// The summary values of force laws, for many sets of laws over one simulation. Without force limits of
/// devices and roughness_same_triangles, which need more data of each triangle.
class LawStatistics {
 public:
  /// `rows`: sets of laws, each with the scenario's laws in their order but other coefficients.
  LawStatistics(const std::vector<std::vector<ForceSettings>>& rows,
                const std::vector<ForceSettings>& scenario_laws);

  /// Takes the state of the next step.
  void add(const State& state);

  std::size_t rows() const { return laws_.size() / names_.size(); }
  /// [row x number of laws + law] values in the last state.
  const std::vector<LawValue>& values() const { return family_.values(); }
  /// Appends the summary values of one row, with the names that the probe of forces uses.
  void summarize(std::size_t row, Summary& summary) const;

 private:
  struct Law {
    RunningMax max_N;
    Roughness roughness;
    long long non_finite_at_step = -1;
  };

  std::vector<std::string> names_;
  LawFamily family_;
  std::vector<Law> laws_;  ///< [row x number of laws + law]
};

}  // namespace fissure
