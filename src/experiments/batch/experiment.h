#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "batch/output_slot.h"
#include "batch/provenance.h"
#include "check/scenario_input.h"
#include "compare/expectations.h"
#include "process/worker.h"
#include "store/result_file.h"

namespace fissure {

/// Rules for writing a result file.
struct OutputRules {
  bool replace = false;     ///< whether an existing file is replaced
  bool keep_parts = false;  ///< whether parts of unfinished runs are kept beside it, for salvage
};

/// One scenario with its runs, from the reserved result file to the written one.
class Experiment {
 public:
  /// Reserves `output` and writes the resolved scenario for the workers. Throws InputError as OutputClaim,
  /// RunError when writing fails.
  Experiment(CheckedScenario checked, const std::filesystem::path& output, const OutputRules& rules);

  const CheckedScenario& checked() const { return checked_; }
  const std::filesystem::path& output() const { return output_; }
  std::vector<WorkerTask> tasks() const;  ///< one task per pipeline entry, in the scenario's order

  void noteStart();
  /// Records how run `index` ended according to its worker, and checks whether its part file is complete.
  void noteEnd(std::size_t index, const RunStatus& status);
  bool ended() const { return open_ == 0; }

  /// To be called when all runs have ended: writes the result file, unless the batch was interrupted before
  /// any run had finished, and releases the slot. An interrupted batch does not replace an existing result
  /// but writes beside it, to *.interrupted.h5. Throws no RunError: error() has the reason why nothing could
  /// be written.
  void close(const std::string& command_line);

  /// The kept parts of unfinished runs that have any rows: `<output>.<run>.part`.
  const std::vector<std::filesystem::path>& keptParts() const { return kept_parts_; }
  /// One line for each run whose part could not be kept: its name and the reason.
  const std::vector<std::string>& unkeptParts() const { return unkept_parts_; }
  const std::vector<PartResult>& results() const { return results_; }
  const std::string& error() const { return error_; }
  /// Contents of the file that close() wrote.
  const std::optional<ResultInfo>& info() const { return info_; }
  /// The scenario's expectations, checked against that file; empty where the batch was interrupted.
  const std::vector<CheckedExpectation>& expectations() const { return expectations_; }

 private:
  std::filesystem::path partOf(std::size_t index) const;
  std::filesystem::path resolvedFile() const { return slot_->parts() / "resolved.yaml"; }
  bool interrupted() const;
  bool worthKeeping() const;
  void refuseChangedInputs();
  void writeResult(const std::string& command_line);
  void noteUnreadableParts();
  void keepPart(std::size_t index, const std::filesystem::path& name);
  void keepUnder(const std::filesystem::path& kept, std::size_t index);

  CheckedScenario checked_;
  std::filesystem::path output_;
  bool keep_parts_;
  std::unique_ptr<OutputSlot> slot_;  ///< null after close()
  std::vector<PartResult> results_;
  std::size_t open_;
  std::optional<ResultInfo> info_;
  std::vector<CheckedExpectation> expectations_;
  std::string error_;
  std::vector<std::filesystem::path> kept_parts_;
  std::vector<std::string> unkept_parts_;
  std::string input_hashes_;  ///< hashes at the time when the scenario was read
  RunTimes times_;
  std::optional<std::chrono::steady_clock::time_point> start_;
};

}  // namespace fissure
