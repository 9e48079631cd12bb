#include "fit/simulated_model.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "base/error.h"
#include "fit/curve_rank.h"
#include "scenario/load.h"
#include "store/result_file.h"
#include "store/run_reader.h"
#include "task/law_family.h"
#include "text/units.h"

namespace fissure {

namespace {

/// A point of the curve as a mean of the two steps that it lies between, of those that are evaluated.
struct StepInterpolation {
  std::size_t before = 0, after = 0;
  double share = 0;  ///< of `after`
};

class SimulatedModel : public LawModel {
 public:
  /// `rates`: whether those of the simulation are those of the curve.
  SimulatedModel(ForceModel law, const SimulatedRun& run, std::vector<StepInterpolation> interpolations,
                 bool rates)
      : law_(law), scenario_laws_(run.laws), interpolations_(std::move(interpolations)) {
    const auto same = std::find_if(run.laws.begin(), run.laws.end(),
                                   [&](const ForceSettings& of) { return of.model == law; });
    seen_as_ = same == run.laws.end() ? run.laws.front() : *same;
    seen_as_.model = law;
    takeSteps(run);
    takeScales(
        static_cast<std::size_t>((same == run.laws.end() ? run.laws.begin() : same) - run.laws.begin()));
    if (!rates) rate_scale_m_s_ = 0;
  }
  ForceModel law() const override { return law_; }
  std::size_t size() const override { return interpolations_.size(); }
  void evaluate(const FitValues& values, std::span<double> force_N) const override {
    ForceSettings law = seen_as_;
    law.coefficients = values.coefficients;
    LawFamily family({law}, scenario_laws_);
    std::vector<double> of_steps_N;
    of_steps_N.reserve(steps_.size());
    for (const std::vector<LawInput>& step : steps_) {
      family.evaluate(step);
      of_steps_N.push_back(family.value(0).force_N);
    }
    for (std::size_t i = 0; i < interpolations_.size(); ++i)
      force_N[i] = (1 - interpolations_[i].share) * of_steps_N[interpolations_[i].before] +
                   interpolations_[i].share * of_steps_N[interpolations_[i].after];
  }
  double deformationScale_m() const override { return deformation_scale_m_; }
  double rateScale_m_s() const override { return rate_scale_m_s_; }

 private:
  /// Keeps the inputs of the steps that are asked for, and numbers these.
  void takeSteps(const SimulatedRun& run) {
    std::vector<std::size_t> first = {0};
    for (const std::size_t size : run.inputs.row_sizes)
      first.push_back(first.back() + size * run.laws.size());
    std::map<std::size_t, std::size_t> kept;
    for (StepInterpolation& between : interpolations_) {
      for (std::size_t* step : {&between.before, &between.after}) {
        const auto [entry, is_new] = kept.try_emplace(*step, steps_.size());
        if (is_new) {
          const auto inputs = run.inputs.inputs.begin();
          steps_.emplace_back(inputs + static_cast<std::ptrdiff_t>(first[*step]),
                              inputs + static_cast<std::ptrdiff_t>(first[*step + 1]));
        }
        *step = entry->second;
      }
    }
  }

  void takeScales(std::size_t law) {
    double squares_m2 = 0, squares_m2_s2 = 0, count = 0;
    for (const std::vector<LawInput>& step : steps_) {
      for (std::size_t i = law; i < step.size(); i += scenario_laws_.size(), ++count) {
        squares_m2 += step[i].deformation_m * step[i].deformation_m;
        squares_m2_s2 += step[i].rate_m_s * step[i].rate_m_s;
      }
    }
    if (!(squares_m2 > 0) || !std::isfinite(squares_m2 + squares_m2_s2))
      throw InputError("the simulation deforms no tissue where the curve is, expected one that does");
    deformation_scale_m_ = std::sqrt(squares_m2 / count);
    rate_scale_m_s_ = std::sqrt(squares_m2_s2 / count);
  }

  ForceModel law_;
  std::vector<ForceSettings> scenario_laws_;
  ForceSettings seen_as_;
  std::vector<StepInterpolation> interpolations_;
  std::vector<std::vector<LawInput>> steps_;
  double deformation_scale_m_ = 0, rate_scale_m_s_ = 0;
};

std::size_t firstTouchedRow(const ForceInputs& inputs) {
  const std::vector<std::size_t>& sizes = inputs.row_sizes;
  return static_cast<std::size_t>(
      std::find_if(sizes.begin(), sizes.end(), [](std::size_t size) { return size > 0; }) - sizes.begin());
}

/// Steps from the first in contact to the deepest that go deeper than all before.
std::vector<std::size_t> deepeningSteps(const SimulatedRun& run) {
  std::vector<std::size_t> steps;
  for (std::size_t step = firstTouchedRow(run.inputs); step < run.inputs.row_sizes.size(); ++step)
    if (steps.empty() || run.way_m[step] > run.way_m[steps.back()]) steps.push_back(step);
  return steps;
}

/// Between which two of `steps` `at` lies, by their ascending `values`; false where it is outside.
bool interpolationAt(double at, const std::vector<double>& values, const std::vector<std::size_t>& steps,
                     StepInterpolation& between) {
  if (values.empty() || !(at >= values.front()) || at > values.back()) return false;
  const auto after =
      static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), at) - values.begin());
  const std::size_t before = after == 0 ? 0 : after - 1;
  const double gap = values[after] - values[before];
  between = {steps[before], steps[after], gap > 0 ? (at - values[before]) / gap : 0};
  return true;
}

double meanSquare(const std::vector<double>& values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
         static_cast<double>(values.size());
}

/// `interpolations`: one per point of `curve`.
std::string rateNote(const MeasuredCurve& curve, const SimulatedRun& run,
                     const std::vector<StepInterpolation>& interpolations) {
  if (curve.rate_m_s.empty()) return "";
  std::vector<double> simulated_m_s;
  for (const StepInterpolation& between : interpolations) {
    const std::size_t after = std::max(between.after, between.before + 1);
    if (after < run.way_m.size())
      simulated_m_s.push_back((run.way_m[after] - run.way_m[between.before]) /
                              (run.inputs.times_s[after] - run.inputs.times_s[between.before]));
  }
  if (simulated_m_s.empty()) return "";
  const double measured_m2_s2 = meanSquare(curve.rate_m_s) - meanSquare(curve.rate_noise_m_s);
  const double measured = std::sqrt(std::max(0.0, measured_m2_s2)),
               simulated = std::sqrt(meanSquare(simulated_m_s));
  if (measured <= 2 * simulated && simulated <= 2 * measured) return "";
  return fmt::format(
      "typical rates are {} m/s in the curve and {} m/s in the simulation, whose count: expected a "
      "simulation as fast, or --match time",
      fourDigits(measured), fourDigits(simulated));
}

}  // namespace

std::string onlyRun(const ResultInfo& info, const std::filesystem::path& file) {
  if (info.pipelines.size() == 1) return info.pipelines.front().name;
  std::string names;
  for (const PipelineResult& run : info.pipelines) names += (names.empty() ? "" : ", ") + run.name;
  throw InputError(inFile(file), fmt::format("{} runs ({}), expected FILE:NAME to choose one",
                                             info.pipelines.size(), names));
}

SimulatedRun readSimulatedRun(const std::filesystem::path& file, const std::string& run) {
  const ResultInfo info = readResultInfo(file);
  const std::string name = run.empty() ? onlyRun(info, file) : run;
  SimulatedRun read;
  read.laws = parseStoredScenario(info.scenario_resolved, file).scenario.force;
  read.inputs = readForceInputs(file, name);
  const RunReader reader(file, name);
  const StoredQuantity* position = reader.find("tool_position");
  const std::size_t steps = read.inputs.times_s.size();
  if (position == nullptr || position->rows != steps || position->columns() < 3 ||
      read.laws.size() != read.inputs.laws.size())
    throw InputError(inFile(file), fmt::format("run {} has other tool positions than force_inputs", name));
  const std::vector<double> positions_m = reader.all(*position);
  std::vector<Vec3> tool_m;
  for (std::size_t row = 0; row < steps; ++row)
    tool_m.emplace_back(Vec3::Map(&positions_m[row * position->columns()]));
  const auto same = std::find_if(info.pipelines.begin(), info.pipelines.end(),
                                 [&](const PipelineResult& one) { return one.name == name; });
  double contact_s = std::numeric_limits<double>::quiet_NaN();
  for (const SummaryValue& value : same->summary)
    if (const auto* number = std::get_if<double>(&value.value);
        number && value.name == "first_contact_time_s")
      contact_s = *number;
  read.way_m = waySinceContact(tool_m, read.inputs, contact_s);
  return read;
}

std::vector<double> waySinceContact(const std::vector<Vec3>& tool_m, const ForceInputs& inputs,
                                    double contact_s) {
  const std::size_t touched = firstTouchedRow(inputs);
  std::vector<double> way_m(tool_m.size(), 0);
  if (touched == tool_m.size()) return way_m;
  Vec3 from_m = tool_m[touched];
  if (touched > 0) {
    const double before_s = inputs.times_s[touched - 1], after_s = inputs.times_s[touched];
    if (before_s < contact_s && contact_s < after_s)
      from_m = tool_m[touched - 1] +
               (contact_s - before_s) / (after_s - before_s) * (tool_m[touched] - tool_m[touched - 1]);
  }
  for (std::size_t row = touched; row < tool_m.size(); ++row) way_m[row] = (tool_m[row] - from_m).norm();
  return way_m;
}

SimulatedFit makeSimulatedFit(ForceModel law, const SimulatedRun& run, const MeasuredCurve& curve,
                              MatchBy by) {
  const std::vector<double>& measured = by == MatchBy::time ? curve.time_s : curve.depth_m;
  const std::string what = by == MatchBy::time ? "times" : "depths";
  if (measured.empty()) throw InputError(fmt::format("the curve has no {}, expected a column of them", what));
  std::vector<std::size_t> steps;
  if (by == MatchBy::depth) steps = deepeningSteps(run);
  for (std::size_t step = 0; by == MatchBy::time && step < run.inputs.times_s.size(); ++step)
    steps.push_back(step);
  std::vector<double> values;
  for (const std::size_t step : steps)
    values.push_back(by == MatchBy::time ? run.inputs.times_s[step] : run.way_m[step]);
  std::vector<StepInterpolation> interpolations;
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    StepInterpolation between;
    if (!interpolationAt(measured[i], values, steps, between)) continue;
    interpolations.push_back(between);
    reached.push_back(i);
  }
  if (interpolations.empty())
    throw InputError(fmt::format(
        "the simulation reaches none of its {}: {}", what,
        values.empty() ? "it meets no tissue"
                       : fmt::format("it has {} to {} {}", fourDigits(values.front()),
                                     fourDigits(values.back()), by == MatchBy::time ? "s" : "m")));
  MeasuredCurve kept = pointsOf(curve, reached);
  if (reached.size() < measured.size())
    kept.warnings.push_back(fmt::format("left out {} of {} points that the simulation does not reach",
                                        measured.size() - reached.size(), measured.size()));
  const bool by_depth = by == MatchBy::depth;
  const std::string back = by_depth ? wayBackNote(kept) : "";
  if (!back.empty()) kept.warnings.push_back(back);
  const bool rates =
      std::any_of(kept.rate_m_s.begin(), kept.rate_m_s.end(), [](double rate) { return rate != 0; });
  const std::string rate_note = by_depth ? rateNote(kept, run, interpolations) : "";
  return {std::make_unique<SimulatedModel>(law, run, std::move(interpolations), !by_depth || rates),
          std::move(kept), rate_note};
}

}  // namespace fissure
