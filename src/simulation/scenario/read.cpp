#include "scenario/read.h"

#include <fmt/core.h>

#include "scenario/read_nested.h"

namespace fissure {

Scenario readScenario(const YamlNode& root) {
  Scenario scenario;
  if (const YamlNode* format = root.find("format")) {
    // Before anything else: a newer format may well have keys that this program calls unknown.
    readValue(*format, "format", scenario.format);
    if (scenario.format != 1) {
      failAt(format->origin, fmt::format("format is {}, expected 1", scenario.format));
    }
  }
  readValue(root, "", scenario);
  return scenario;
}

}  // namespace fissure
