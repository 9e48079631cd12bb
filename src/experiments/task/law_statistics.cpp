#include "task/law_statistics.h"

#include <cmath>

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
      laws_(rows.size() * scenario_laws.size()) {}

void LawStatistics::add(const State& state) {
  if (inputs_.size() == steps_.size()) inputs_.emplace_back();
  inputs_[steps_.size()].assign(state.law_inputs.begin(), state.law_inputs.end());
  waiting_inputs_ += state.law_inputs.size();
  steps_.push_back(state.step);
  if (steps_.size() == kSteps || waiting_inputs_ >= kInputs) evaluate();
}

void LawStatistics::evaluate() {
  const LawValues& values = family_.valuesByPlace();
  family_.evaluate(std::span(inputs_).first(steps_.size()),
                   [&](std::size_t step, std::size_t first, std::size_t end) {
                     for (std::size_t i = first; i < end; ++i) {
                       const LawValue value = values.at(i);
                       laws_[i].max_N.add(value.force_N);
                       laws_[i].roughness.add(value.force_N);
                       if (laws_[i].non_finite_at_step < 0 &&
                           !std::isfinite(value.force_N + value.elastic_N + value.viscous_N))
                         laws_[i].non_finite_at_step = steps_[step];
                     }
                   });
  steps_.clear();
  waiting_inputs_ = 0;
}

void LawStatistics::summarize(std::size_t row, Summary& summary) const {
  const auto add = [&](std::size_t index, const std::string& name) {
    const Law& law = lawOf(row, index);
    summary.push_back({"max_force" + name + "_N", law.max_N.value()});
    summary.push_back({"force_roughness" + name, law.roughness.value()});
  };
  add(0, "");
  for (std::size_t i = 0; i < names_.size(); ++i) {
    add(i, "_" + names_[i]);
    const long long step = lawOf(row, i).non_finite_at_step;
    summary.push_back(
        {"force_non_finite_at_step_" + names_[i], step < 0 ? kMissing : static_cast<double>(step)});
  }
}

}  // namespace fissure
