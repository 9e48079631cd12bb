#include "base/probe.h"

namespace fissure {

RecordLayout declareLayout(const std::vector<std::unique_ptr<Probe>>& probes) {
  RecordLayout layout;
  layout.add(
      {.name = "time", .units = "s", .long_name = "simulated time: step x dt, from the end of settling"});
  for (const auto& probe : probes) probe->declare(layout);
  return layout;
}

}  // namespace fissure
