#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/record.h"
#include "base/record_sink.h"
#include "study/law_statistics.h"
#include "study/sweep_file.h"
#include "study/task_record.h"

namespace fissure {

/// The curves of these names over runs with this layout: "force" (magnitude), "force_elastic",
/// "force_viscous" of every law; "indentation", the way of the first tool since it first touched tissue;
/// every series with one value a step under its own name. Throws InputError about `where` for a name that is
/// none of them.
std::vector<CurveQuantity> curveQuantities(const std::vector<std::string>& names, const RecordLayout& layout,
                                           const std::string& where);

/// The times of the curves: 0, every_s, 2 every_s ... until_s.
std::vector<double> curveTimes_s(const SweepCurves& curves);

/// Keeps of a run what its sweep asks for: the summary's numbers, and curves, linear between two steps, NaN
/// after the run's end.
class RunRecorder : public RecordSink {
 public:
  struct Settings {
    std::vector<CurveQuantity> curves = {};
    std::vector<double> times_s = {};  ///< of the curves
    LawStatistics* laws = nullptr;     ///< several sets of laws; the scenario asks for force inputs then
    RecordSink* next = nullptr;        ///< gets everything too
  };
  /// What the layout and the settings refer to must outlive it.
  RunRecorder(const RecordLayout& layout, Settings settings);

  void forceInputs(const State& state) override;
  void append(const RecordRow& row) override;
  void snapshot(const State& state) override;
  void frame(double time_s, const Image& image) override;
  void finish(const RunStatus& status, const Summary& summary) override;

  /// After finish(): without task and file.
  const TaskRecord& record() const { return record_; }

 private:
  std::vector<double> valuesOf(const RecordRow& row);
  double indentation(const RecordRow& row);
  void keep(std::size_t time, const std::vector<double>& values);

  const RecordLayout& layout_;
  Settings settings_;
  std::size_t laws_ = 0;  ///< of the scenario
  std::size_t rows_ = 1;
  std::size_t width_ = 0;       ///< values of one row of laws at one time
  std::vector<double> before_;  ///< valuesOf() the step before
  double before_s_ = 0;
  std::size_t next_time_ = 0;
  bool touched_ = false;
  Vec3 touched_at_m_ = Vec3::Zero();
  TaskNumbers numbers_;
  TaskRecord record_;
};

}  // namespace fissure
