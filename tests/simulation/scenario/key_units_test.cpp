#include <gtest/gtest.h>

#include <set>
#include <string>

#include "scenario/key_tree.h"
#include "text/summary_unit.h"

namespace fissure::key_units_test {

namespace {

void addNumbers(const KeyNode& node, std::set<std::string>& names) {
  using Kind = KeyNode::Kind;
  if (node.kind == Kind::number || node.kind == Kind::integer) names.insert(node.name);
  for (const KeyNode& child : node.children) addNumbers(child, names);
}

// Words are longer than units.
TEST(KeyUnits, EveryKeyWithAUnitEndingHasOne) {
  std::set<std::string> names;
  addNumbers(scenarioKeys(), names);
  for (const char* key : {"stiffness_N_m", "field_of_view_deg", "size_px", "speed_m_s", "slit_width_m", "k"})
    EXPECT_TRUE(names.contains(key)) << key << " was not walked over";
  const std::set<std::string> words = {"rotate_to"};
  for (const std::string& name : names) {
    const std::size_t last = name.rfind('_');
    if (last == std::string::npos || name.size() - last > 4 || words.contains(name)) continue;
    EXPECT_NE(summaryUnit(name), "1") << name << ": its ending is not in base/summary_unit.cpp";
  }
}

}  // namespace

}  // namespace fissure::key_units_test
