#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "main/output_slot.h"
#include "main/provenance.h"
#include "main/scenario_input.h"
#include "process/worker.h"
#include "store/result_file.h"

namespace fissure {

/// One scenario on its way to a result file: its runs, and what became of each.
class Experiment {
 public:
  /// Reserves `output` and lays down the resolved scenario for the workers. Throws InputError, RunError.
  Experiment(CheckedScenario checked, const std::filesystem::path& output, bool replace);

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

  const std::vector<PartResult>& results() const { return results_; }
  const std::string& error() const { return error_; }
  const std::optional<ResultInfo>& info() const { return info_; }  ///< of the file that close() wrote

 private:
  std::filesystem::path partOf(std::size_t index) const;
  std::filesystem::path resolvedFile() const { return slot_->parts() / "resolved.yaml"; }
  bool interrupted() const;
  bool worthKeeping() const;
  void refuseChangedInputs();

  CheckedScenario checked_;
  std::filesystem::path output_;
  std::unique_ptr<OutputSlot> slot_;  ///< until close()
  std::vector<PartResult> results_;
  std::size_t open_;
  std::optional<ResultInfo> info_;
  std::string error_;
  std::string input_hashes_;  ///< when the scenario was read
  RunTimes times_;
  std::optional<std::chrono::steady_clock::time_point> start_;
};

}  // namespace fissure
