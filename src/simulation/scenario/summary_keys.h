#pragma once

#include <string>
#include <vector>

#include "scenario/checker.h"
#include "scenario/scenario.h"

namespace fissure {

/// A key of a run's summary that contains names from the scenario.
struct NamedKey {
  std::string key;
  /// The items with these names: "tools.clamp", "force.hc".
  std::vector<std::string> owners;
};

/// All such keys that a run may write: those of the probes and of replayed motions.
std::vector<NamedKey> namedSummaryKeys(const Scenario& scenario);

/// Adds a problem for names with which two values of the summary would have the same key.
void checkSummaryKeys(Checker check, const Scenario& scenario);

}  // namespace fissure
