#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sweep/journal.h"
#include "sweep/sweep_plan.h"
#include "task/task_record.h"

namespace fissure {

/// `<folder>/journals`, `<folder>/runs`.
std::filesystem::path journalFolder(const std::filesystem::path& folder);
std::filesystem::path resultFolder(const std::filesystem::path& folder);

/// How far a sweep is, read from its journals alone: of each task a finished record, else its latest other
/// one. `plan` must outlive it.
class SweepState {
 public:
  /// Throws RunError when a journal cannot be read, or when two finished records of a task, or of its
  /// repeats, differ: simulations are deterministic, so one of them is wrong.
  SweepState(const SweepPlan& plan, const std::filesystem::path& folder);

  struct Task {
    std::optional<JournalPlace> place;  ///< nothing: it has no record
    RunStatus status;                   ///< `missing` without a record
    bool finished = false;
    double wall_s = 0;  ///< of its worker, where that is known
    std::string numbers_hash;
    std::string file;  ///< TaskRecord::file and what goes with it
    long long file_bytes = 0, file_time = 0;
    long long recorded_s = 0;
  };
  const Task& task(std::size_t index) const { return tasks_[index]; }
  const SweepPlan& plan() const { return plan_; }
  /// Its record without the numbers, and what the numbers are, both of a task with a place. Throws RunError
  /// when it is no longer there.
  struct Head {
    TaskRecord record;
    NumbersHead numbers;
    std::size_t numbers_at = 0;  ///< in the record
  };
  Head head(std::size_t index) const;
  /// Values of the record's numbers, from the byte `first` of these on.
  std::vector<double> numbers(std::size_t index, const Head& head, std::size_t first,
                              std::size_t count) const;

  /// Makes a task missing again, because what it left is no longer there.
  void forget(std::size_t index);
  /// Tasks without a finished record: those that were never tried, in the plan's order, then those that
  /// failed, the longest ago first. So slow and crashing ones keep no other from its turn.
  std::vector<std::size_t> unfinished() const;
  /// Finished records that no task of the plan asks for: of an earlier form of the sweep.
  std::size_t unplannedRecords() const { return unplanned_records_; }
  /// See Journals::damaged().
  const std::vector<std::filesystem::path>& damaged() const { return journals_.damaged(); }

 private:
  void take(std::size_t index, const TaskRecord& record, const JournalPlace& place);
  void compareRepeats() const;

  const SweepPlan& plan_;
  Journals journals_;
  std::vector<Task> tasks_;
  std::size_t unplanned_records_ = 0;
};

}  // namespace fissure
