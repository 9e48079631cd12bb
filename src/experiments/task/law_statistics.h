#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/state.h"
#include "measure/statistics.h"
#include "task/law_family.h"

namespace fissure {

/// The summary values of force laws, for many sets of laws over one simulation. Without force limits of
/// devices and roughness_same_triangles, which need more data of each triangle. Steps are evaluated some at a
/// time, where nobody asks for their values.
class LawStatistics {
 public:
  /// `rows`: sets of laws, each with the scenario's laws in their order but other coefficients.
  LawStatistics(const std::vector<std::vector<ForceSettings>>& rows,
                const std::vector<ForceSettings>& scenario_laws);

  /// Takes the state of the next step.
  void add(const State& state);
  /// Evaluates the steps that wait; to be called before value() and summarize().
  void evaluate();

  std::size_t rows() const { return non_finite_at_step_.size() / names_.size(); }
  /// The value in the last state of law row x number of laws + law.
  LawValue value(std::size_t law) const { return family_.value(law); }
  /// Appends the summary values of one row, with the names that the probe of forces uses.
  void summarize(std::size_t row, Summary& summary) const;

 private:
  void addStep(std::size_t step, std::size_t first, std::size_t end);
  std::size_t placeOf(std::size_t row, std::size_t index) const {
    return family_.place(row * names_.size() + index);
  }

  std::vector<std::string> names_;
  std::vector<std::vector<LawInput>> inputs_;  ///< of steps that wait, and the storage of earlier ones
  std::vector<long long> steps_;               ///< numbers of the steps that wait
  std::size_t waiting_inputs_ = 0;
  long long evaluated_steps_ = 0;
  LawFamily family_;
  // What RunningMax and Roughness would keep of each law, at its place in the family.
  Eigen::ArrayXd max_N_, last_N_, before_last_N_, squares_, squared_differences_;
  std::vector<long long> non_finite_at_step_;  ///< -1: in none
};

}  // namespace fissure
