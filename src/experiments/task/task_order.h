#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "scenario/load.h"
#include "task/curves.h"

namespace fissure {

/// What a worker is told about one simulation of a sweep.
struct TaskOrder {
  std::string name;                 ///< of the sweep, for messages
  std::string scenario;             ///< LoadedScenario::composed of the base
  std::filesystem::path directory;  ///< where its file names start
  std::vector<Override> overrides;
  std::string pipeline;
  /// One set of laws a row of the record, each with the scenario's laws in their order, other coefficients;
  /// empty: one row, the scenario's own laws.
  std::vector<std::vector<ForceSettings>> laws;
  std::optional<SweepCurves> curves;
};

/// An error about an override of an order is one about the axis of the sweep that it comes from; others stay.
InputError aboutAxis(const InputError& error);

/// The order as text, for a file.
std::string orderText(const TaskOrder& order);

/// Of each law of an order that was read only the coefficients mean something. Throws InputError.
TaskOrder parseOrder(const std::string& text);

}  // namespace fissure
