#include "scenario/read.h"

#include "scenario/fields.h"
#include "scenario/read_nested.h"

namespace fissure {

Scenario readScenario(const YamlNode& root) {
  Scenario scenario;
  if (const YamlNode* format = root.find("format")) {
    // Before anything else: a newer format may well have keys that this program calls unknown.
    readValue(*format, "format", scenario.format);
    if (scenario.format != 1) {
      failAt(format->origin, "format is " + std::to_string(scenario.format) + ", expected 1");
    }
  }
  readValue(root, "", scenario);
  return scenario;
}

}  // namespace fissure
