#include "task/law_statistics.h"

#include <cmath>
#include <limits>

namespace fissure {

namespace {

constexpr std::size_t kSteps = 32;          ///< that wait at most
constexpr std::size_t kInputs = 1'000'000;  ///< of all steps that wait, about: 48 MB

std::vector<ForceSettings> flat(const std::vector<std::vector<ForceSettings>>& rows,
                                const std::vector<ForceSettings>& scenario_laws) {
  std::vector<ForceSettings> laws;
  for (const std::vector<ForceSettings>& row : rows) {
    for (std::size_t i = 0; i < scenario_laws.size(); ++i) {
      ForceSettings& law = laws.emplace_back(scenario_laws[i]);
      law.coefficients = row[i].coefficients;
    }
  }
  return laws;
}

std::vector<std::string> namesOf(const std::vector<ForceSettings>& laws) {
  std::vector<std::string> names;
  for (const ForceSettings& law : laws) names.push_back(law.name);
  return names;
}

}  // namespace

LawStatistics::LawStatistics(const std::vector<std::vector<ForceSettings>>& rows,
                             const std::vector<ForceSettings>& scenario_laws)
    : names_(namesOf(scenario_laws)),
      family_(flat(rows, scenario_laws), scenario_laws),
      last_N_(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(rows.size() * scenario_laws.size()))),
      before_last_N_(last_N_),
      squares_(last_N_),
      squared_differences_(last_N_),
      non_finite_at_step_(rows.size() * scenario_laws.size(), -1) {
  max_N_ = last_N_ - std::numeric_limits<double>::infinity();
}

void LawStatistics::add(const State& state) {
  if (inputs_.size() == steps_.size()) inputs_.emplace_back();
  inputs_[steps_.size()].assign(state.law_inputs.begin(), state.law_inputs.end());
  waiting_inputs_ += state.law_inputs.size();
  steps_.push_back(state.step);
  if (steps_.size() == kSteps || waiting_inputs_ >= kInputs) evaluate();
}

void LawStatistics::evaluate() {
  family_.evaluate(
      std::span(inputs_).first(steps_.size()),
      [this](std::size_t step, std::size_t first, std::size_t end) { addStep(step, first, end); });
  evaluated_steps_ += static_cast<long long>(steps_.size());
  steps_.clear();
  waiting_inputs_ = 0;
}

// Adds one of the steps that wait to what is kept of the laws at the places from `first` to before `end`.
void LawStatistics::addStep(std::size_t step, std::size_t first, std::size_t end) {
  const auto of = [&](auto& array) {
    return array.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(end - first));
  };
  const LawValues& values = family_.valuesByPlace();
  const auto force_N = of(values.force_N);
  auto max_N = of(max_N_), last_N = of(last_N_), before_last_N = of(before_last_N_);
  max_N = (force_N > max_N || force_N.isNaN()).select(force_N, max_N);
  of(squares_) += force_N.square();
  if (evaluated_steps_ + static_cast<long long>(step) >= 2)
    of(squared_differences_) += (before_last_N - 2 * last_N + force_N).square();
  before_last_N = last_N;
  last_N = force_N;
  const auto sums_N = force_N + of(values.elastic_N) + of(values.viscous_N);
  if ((0 * sums_N).sum() == 0) return;  // else one of them is not finite, which is rare
  for (std::size_t i = first; i < end; ++i)
    if (non_finite_at_step_[i] < 0 && !std::isfinite(sums_N[static_cast<Eigen::Index>(i - first)]))
      non_finite_at_step_[i] = steps_[step];
}

void LawStatistics::summarize(std::size_t row, Summary& summary) const {
  const auto add = [&](std::size_t index, const std::string& name) {
    const auto i = static_cast<Eigen::Index>(placeOf(row, index));
    summary.push_back({"max_force" + name + "_N", evaluated_steps_ > 0 ? max_N_[i] : kMissing});
    summary.push_back({"force_roughness" + name,
                       Roughness::ofSums(evaluated_steps_, squares_[i], squared_differences_[i]).value()});
  };
  add(0, "");
  for (std::size_t i = 0; i < names_.size(); ++i) {
    add(i, "_" + names_[i]);
    const long long step = non_finite_at_step_[placeOf(row, i)];
    summary.push_back(
        {"force_non_finite_at_step_" + names_[i], step < 0 ? kMissing : static_cast<double>(step)});
  }
}

}  // namespace fissure
