#pragma once

#include <string>
#include <vector>

#include "scenario/checker.h"
#include "scenario/scenario.h"

namespace fissure {

/// A key of a run's summary that is made of names of the scenario.
struct NamedKey {
  std::string key;
  std::vector<std::string> owners;  ///< whose names these are: "tools.clamp", "force.hc"
};

/// Every such key that a run may write: those of the probes and of replayed motions.
std::vector<NamedKey> namedSummaryKeys(const Scenario& scenario);

/// Refuses names by which two values would have the same key.
void checkSummaryKeys(Checker check, const Scenario& scenario);

}  // namespace fissure
