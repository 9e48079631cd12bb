#include "scenario/tolerances.h"

#include <fnmatch.h>

#include "scenario/read_nested.h"
#include "scenario/yaml_document.h"
#include "text/scalars.h"

namespace fissure {

// Not in a namespace of their own: the reader finds them by the types they describe.
template <class Io>
void describe(Io& io, ToleranceRule& rule) {
  io.required("quantity", rule.quantity);
  io.field("pipeline", rule.pipeline);
  io.field("absolute", rule.absolute);
  io.field("relative", rule.relative);
  io.field("time_shift_s", rule.time_shift_s);
  io.field("ignore", rule.ignore);
}

template <class Io>
void describe(Io& io, Tolerances& tolerances) {
  io.required("format", tolerances.format);
  io.required("tolerances", tolerances.tolerances);
}

namespace {

void requireNotNegative(const YamlNode& item, const char* key, double value) {
  if (value < 0)
    failAt(item.find(key)->origin, std::string(key) + " is " + formatReal(value) + ", expected at least 0");
}

}  // namespace

bool fitsPattern(const std::string& name, const std::string& pattern) {
  return fnmatch(pattern.c_str(), name.c_str(), FNM_NOESCAPE) == 0;
}

ToleranceRule Tolerances::of(const std::string& quantity, const std::string& pipeline) const {
  ToleranceRule found{quantity};
  for (const ToleranceRule& rule : tolerances)
    if (fitsPattern(quantity, rule.quantity) && fitsPattern(pipeline, rule.pipeline)) found = rule;
  return found;
}

Tolerances loadTolerances(const std::filesystem::path& file) {
  const YamlNode root = parseYaml(readYamlFile(file), inFile(file, 1));
  Tolerances tolerances;
  readValue(root, "", tolerances);
  if (tolerances.format != 1)
    failAt(root.find("format")->origin, "format is " + std::to_string(tolerances.format) + ", expected 1");
  const YamlNode& items = *root.find("tolerances");
  for (std::size_t i = 0; i < items.children.size(); ++i) {
    const ToleranceRule& rule = tolerances.tolerances[i];
    requireNotNegative(items.children[i], "absolute", rule.absolute);
    requireNotNegative(items.children[i], "relative", rule.relative);
    requireNotNegative(items.children[i], "time_shift_s", rule.time_shift_s);
  }
  return tolerances;
}

}  // namespace fissure
