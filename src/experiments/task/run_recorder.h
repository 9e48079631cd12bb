#pragma once

#include <vector>

#include "base/record.h"
#include "base/record_sink.h"
#include "task/law_statistics.h"
#include "task/task_record.h"

namespace fissure {

/// Keeps the output of a run that its sweep needs: the numbers of the summary, and curves, which are linear
/// between steps and NaN after the end of the run.
class RunRecorder : public RecordSink {
 public:
  struct Settings {
    std::vector<CurveQuantity> curves = {};
    std::vector<double> times_s = {};  ///< times of the curves
    LawStatistics* laws = nullptr;     ///< several sets of laws; the scenario must then ask for force inputs
    RecordSink* next = nullptr;        ///< receives all output too; may be null
  };
  /// The layout and all that the settings point to must outlive this object.
  RunRecorder(const RecordLayout& layout, Settings settings);

  void forceInputs(const State& state) override;
  void append(const RecordRow& row) override;
  void snapshot(const State& state) override;
  void frame(double time_s, const Image& image) override;
  void finish(const RunStatus& status, const Summary& summary) override;

  /// To be called after finish(): the record, without task and file.
  const TaskRecord& record() const { return record_; }

 private:
  std::vector<double> valuesOf(const RecordRow& row);
  double indentation(const RecordRow& row);
  void keep(std::size_t time, const std::vector<double>& values);

  const RecordLayout& layout_;
  Settings settings_;
  std::size_t laws_ = 0;  ///< number of the scenario's laws
  std::size_t rows_ = 1;
  std::size_t width_ = 0;       ///< number of values of one row of laws at one time
  std::vector<double> before_;  ///< valuesOf() of the step before
  double before_s_ = 0;
  std::size_t next_time_ = 0;
  bool touched_ = false;
  Vec3 touched_at_m_ = Vec3::Zero();
  TaskNumbers numbers_;
  TaskRecord record_;
};

}  // namespace fissure
