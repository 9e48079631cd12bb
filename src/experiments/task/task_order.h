#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scenario/load.h"
#include "task/curves.h"

namespace fissure {

/// The description of one simulation of a sweep for its worker.
struct TaskOrder {
  std::string name;                 ///< name of the sweep, for messages
  std::string scenario;             ///< the base scenario: LoadedScenario::composed
  std::filesystem::path directory;  ///< folder of its relative file names
  std::vector<Override> overrides;
  std::string pipeline;
  /// One set of laws per row of the record, each with the scenario's laws in their order but other
  /// coefficients; empty: one row with the scenario's own laws.
  std::vector<std::vector<ForceSettings>> laws;
  std::optional<SweepCurves> curves;
  bool frames = true;  ///< draw the pictures that the scenario asks for, where a result is kept
};

/// Turns an error about an override of an order into one about the axis of the sweep from which it comes;
/// other errors are returned unchanged.
InputError aboutAxis(const InputError& error);

/// The order as text, for a file.
std::string orderText(const TaskOrder& order);

/// Reads the text of an order. Of the laws only the coefficients are restored. Throws InputError when the
/// text is no order.
TaskOrder parseOrder(const std::string& text);

}  // namespace fissure
