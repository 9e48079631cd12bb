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

/// The paths `<folder>/journals` and `<folder>/runs`.
std::filesystem::path journalFolder(const std::filesystem::path& folder);
std::filesystem::path resultFolder(const std::filesystem::path& folder);

/// The progress of a sweep, read from its journals: for each task a finished record, else its latest other
/// one. `plan` must outlive this object.
class SweepState {
 public:
  /// Reads the journals. Throws RunError when one cannot be read, or when two finished records of a task, or
  /// of its repeats, differ: simulations are deterministic, so one of them is wrong.
  SweepState(const SweepPlan& plan, const std::filesystem::path& folder);

  struct Task {
    std::optional<JournalPlace> place;  ///< place of its record; no value: none
    RunStatus status;                   ///< `missing` without a record
    bool finished = false;
    double wall_s = 0;  ///< wall time of its worker, where known
    std::string numbers_hash;
    std::string file;  ///< TaskRecord::file, with its size and time below
    long long file_bytes = 0, file_time = 0;
    long long recorded_s = 0;
  };
  const Task& task(std::size_t index) const { return tasks_[index]; }
  const SweepPlan& plan() const { return plan_; }
  /// The record of a task without its numbers, and the layout of the numbers. head() is for tasks with a
  /// place; it throws RunError when the record does not exist any more.
  struct Head {
    TaskRecord record;
    NumbersHead numbers;
    std::size_t numbers_at = 0;  ///< offset in the record
  };
  Head head(std::size_t index) const;
  /// `count` values of the record's numbers, from byte `first` of these on.
  std::vector<double> numbers(std::size_t index, const Head& head, std::size_t first,
                              std::size_t count) const;

  /// Marks a task as missing, because its output does not exist any more.
  void forget(std::size_t index);
  /// The tasks without a finished record: first those never tried, in the plan's order, then failed ones, the
  /// oldest failure first. So slow and crashing tasks do not delay others.
  std::vector<std::size_t> unfinished() const;
  /// Number of finished records that belong to no task of the plan, from an earlier form of the sweep.
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
