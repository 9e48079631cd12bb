#include "scenario/tolerances.h"

#include <fnmatch.h>

#include "scenario/key_tree.h"
#include "scenario/range_check.h"
#include "scenario/read_nested.h"

namespace fissure {

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
  requireRanges(root, tolerances);
  return tolerances;
}

KeyNode toleranceKeys() {
  return keyTree<Tolerances>("tolerances");
}

}  // namespace fissure
