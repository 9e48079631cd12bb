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

/// How a result file may be made.
struct OutputRules {
  bool replace = false;     ///< an existing one
  bool keep_parts = false;  ///< what runs that did not finish have written stays beside it, for salvage
};

/// One scenario on its way to a result file: its runs, and what became of each.
class Experiment {
 public:
  /// Reserves `output` and lays down the resolved scenario for the workers. Throws InputError, RunError.
  Experiment(CheckedScenario checked, const std::filesystem::path& output, const OutputRules& rules);

  const CheckedScenario& checked() const { return checked_; }
  const std::filesystem::path& output() const { return output_; }
  std::vector<WorkerTask> tasks() const;  ///< one a pipeline entry, in the scenario's order

  void noteStart();
  /// How run `index` ended, by its worker; whether its part is whole is looked up here.
  void noteEnd(std::size_t index, const RunStatus& status);
  bool ended() const { return open_ == 0; }

  /// When all runs have ended: writes the result file, unless the batch was interrupted before any run was
  /// finished. An interrupted batch leaves an existing result alone and writes beside it, to
  /// *.interrupted.h5. Frees the slot either way. Does not throw RunError: error() says why nothing could be
  /// written.
  void close(const std::string& command_line);

  /// `<output>.<run>.part` of each run that is not whole in a result, when they are kept and something is in
  /// them.
  const std::vector<std::filesystem::path>& keptParts() const { return kept_parts_; }
  /// A line for each run whose part should have been kept and could not be: its name, and why.
  const std::vector<std::string>& unkeptParts() const { return unkept_parts_; }
  const std::vector<PartResult>& results() const { return results_; }
  const std::string& error() const { return error_; }
  const std::optional<ResultInfo>& info() const { return info_; }  ///< of the file that close() wrote
  /// What the scenario expects against what that file says; none where the batch was interrupted.
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
  std::unique_ptr<OutputSlot> slot_;  ///< until close()
  std::vector<PartResult> results_;
  std::size_t open_;
  std::optional<ResultInfo> info_;
  std::vector<CheckedExpectation> expectations_;
  std::string error_;
  std::vector<std::filesystem::path> kept_parts_;
  std::vector<std::string> unkept_parts_;
  std::string input_hashes_;  ///< when the scenario was read
  RunTimes times_;
  std::optional<std::chrono::steady_clock::time_point> start_;
};

}  // namespace fissure
