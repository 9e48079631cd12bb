#include <algorithm>
#include <cmath>

#include "measure/penetration.h"
#include "measure/probe_makers.h"
#include "measure/soundness.h"
#include "measure/statistics.h"
#include "measure/touch.h"

namespace fissure {

namespace {

/// Series penetration_depth, inversion_aware_depth, passed_through, inverted_triangles, stand_off; their
/// worst and last values as scalars. Scalars contact_steps and untouched_tools (Touch), sample_coverage_m and
/// those of Soundness; steps_per_measurement where it is not 1. In steps between two measurements the series
/// have no numbers, and contacts of the engine are noted.
class PenetrationProbe : public Probe {
 public:
  /// Throws InputError as PenetrationMeter does.
  PenetrationProbe(const Scene& scene, const MeasureSettings& settings);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  void look(const State& state);
  std::string untouchedTools() const;

  PenetrationMeter meter_;
  int every_ = 1;  ///< steps between two measurements
  Touch touch_;
  Soundness soundness_;
  std::vector<Soundness::BodyStep> body_steps_;
  std::string not_measured_;  ///< one line; empty: all was
  Penetration last_;
  bool sampled_ = false;
  RunningMax max_depth_m_, max_inversion_aware_m_;
  long long max_inverted_ = 0;
  std::size_t depth_column_ = 0;
  std::size_t inversion_aware_column_ = 0;
  std::size_t passed_column_ = 0;
  std::size_t inverted_column_ = 0;
  std::size_t stand_off_column_ = 0;
};

}  // namespace

PenetrationProbe::PenetrationProbe(const Scene& scene, const MeasureSettings& settings)
    : meter_(scene, settings),
      every_(stepsPerMeasurement(settings)),
      touch_(scene),
      soundness_(scene),
      body_steps_(scene.bodies.size()) {
  for (const SceneTool& tool : scene.tools)
    if (!tool.closed) not_measured_ += (not_measured_.empty() ? "" : ", ") + tool.name;
  if (!not_measured_.empty())
    not_measured_ = "depth of tissue vertices in tools whose surface is open: " + not_measured_;
}

void PenetrationProbe::declare(RecordLayout& layout) {
  depth_column_ = layout.add({.name = "penetration_depth",
                              .units = "m",
                              .long_name = "deepest tool sample in tissue or tissue vertex in a tool",
                              .axes = {}});
  inversion_aware_column_ = layout.add(
      {.name = "inversion_aware_depth",
       .units = "m",
       .long_name = "deepest tool sample in tissue, inverted tissue included, or tissue vertex in a tool",
       .axes = {}});
  passed_column_ =
      layout.add({.name = "passed_through",
                  .units = "1",
                  .long_name = "tool samples that have passed right through a body since the start",
                  .type = ValueType::count,
                  .axes = {}});
  inverted_column_ = layout.add({.name = "inverted_triangles",
                                 .units = "1",
                                 .long_name = "tissue triangles that do not bound their body from outside",
                                 .type = ValueType::count,
                                 .axes = {}});
  stand_off_column_ =
      layout.add({.name = "stand_off",
                  .units = "m",
                  .long_name = "distance between tool and tissue while nothing penetrates, up to 10 mm",
                  .axes = {}});
}

void PenetrationProbe::sample(const State& state, RecordRow& row) {
  if (!state.isOneOf(every_)) return touch_.addUnmeasured(state, meter_);
  last_ = meter_.measure(state);
  sampled_ = true;
  look(state);
  max_depth_m_.add(last_.depth_m);
  max_inversion_aware_m_.add(last_.inversion_aware_m);
  max_inverted_ = std::max(max_inverted_, last_.inverted_triangles);
  row[depth_column_] = last_.depth_m;
  row[inversion_aware_column_] = last_.inversion_aware_m;
  row[passed_column_] = static_cast<double>(last_.passed_through);
  row[inverted_column_] = static_cast<double>(last_.inverted_triangles);
  row[stand_off_column_] = last_.stand_off_m;
}

// Who met whom, and what tissue does by itself.
void PenetrationProbe::look(const State& state) {
  touch_.add(state, meter_, last_);
  if (std::isnan(last_.depth_m)) return;
  for (std::size_t b = 0; b < body_steps_.size(); ++b)
    body_steps_[b] = {meter_.inverted()[b], touch_.isTouched(b), touch_.wasTouched(b)};
  soundness_.add(state, body_steps_);
}

std::string PenetrationProbe::untouchedTools() const {
  std::string names;
  for (const std::string& name : touch_.untouchedTools()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

void PenetrationProbe::summarize(Summary& summary) const {
  summary.push_back({"max_penetration_depth_m", max_depth_m_.value()});
  summary.push_back({"final_penetration_depth_m", sampled_ ? last_.depth_m : kMissing});
  summary.push_back(countOrMissing("passed_through_samples", sampled_, last_.passed_through));
  summary.push_back(countOrMissing("max_inverted_triangles", sampled_, max_inverted_));
  summary.push_back({"max_inversion_aware_depth_m", max_inversion_aware_m_.value()});
  summary.push_back({"tool_samples", meter_.sampleCount()});
  summary.push_back({"sample_coverage_m", meter_.coverage_m()});
  summary.push_back(countOrMissing("contact_steps", sampled_, touch_.steps()));
  if (every_ > 1) summary.push_back({"steps_per_measurement", static_cast<long long>(every_)});
  if (const std::string untouched = sampled_ ? untouchedTools() : ""; !untouched.empty())
    summary.push_back({"untouched_tools", untouched});
  soundness_.summarize(summary);
  if (!not_measured_.empty()) summary.push_back({"not_measured", not_measured_});
}

std::unique_ptr<Probe> makePenetrationProbe(const Scene& scene, const MeasureSettings& settings) {
  return std::make_unique<PenetrationProbe>(scene, settings);
}

}  // namespace fissure
