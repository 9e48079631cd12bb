#include "scenario/key_tree.h"

#include <sstream>

#include "scenario/compose.h"
#include "scenario/scenario.h"
#include "text/scalars.h"
#include "text/summary_unit.h"

namespace fissure {

namespace {

std::string inJsonQuotes(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  return quoted + "\"";
}

/// "N m-1" as people write it: "N/m".
std::string unitForPeople(const std::string& udunits) {
  if (udunits == "degree" || udunits == "pixel") return udunits + "s";
  std::istringstream parts(udunits);
  std::string above, below;
  for (std::string part; parts >> part;) {
    const std::size_t minus = part.find('-');
    const std::string power = minus == std::string::npos ? "" : part.substr(minus + 1);
    std::string& text = minus == std::string::npos ? above : below;
    text += (text.empty() ? "" : " ") + part.substr(0, minus) + (power == "1" ? "" : power);
  }
  return below.empty() ? above : (above.empty() ? "1" : above) + "/" + below;
}

std::string unitOf(const KeyNode& node, const Key& key) {
  using Kind = KeyNode::Kind;
  if (node.kind != Kind::number && node.kind != Kind::integer) return "none";
  if (!key.unit().empty()) return key.unit();
  const std::string of_name = summaryUnit(node.name);
  return of_name == "1" ? "" : unitForPeople(of_name);
}

std::string defaultOf(const KeyNode& node, const Key& key) {
  if (key.sameAs()) return "what `" + std::string(key.sameAs()) + "` says";
  if (!key.otherwise().empty()) return key.otherwise();
  if (key.isRequired()) return "required";
  const bool is_text = node.kind == KeyNode::Kind::text || node.kind == KeyNode::Kind::choice;
  std::string text = node.default_json;
  if (text.empty() && node.kind == KeyNode::Kind::map) text = "the defaults of its keys";
  if (text == "[]" || text == "\"\"") text = "empty";
  if (is_text && node.lists.empty() && text.size() > 2 && text.front() == '"')
    text = text.substr(1, text.size() - 2);
  return text + (key.except().empty() ? "" : ", " + key.except());
}

std::string listOf(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "[" : ", ") + formatReal(value);
  return text + "]";
}

}  // namespace

KeyNode KeyCollector::nodeOf(const char* name, const Key& key) {
  KeyNode node;
  node.name = name;
  node.doc = key.doc();
  node.when = key.when();
  node.is_required = key.isRequired();
  node.is_alone = key.isAlone();
  node.is_item_name = key.isItemName();
  node.can_be_empty = key.canBeEmpty();
  node.range = key.range();
  node.items = key.items();
  if (key.table()) node.choices = *key.table();
  return node;
}

void KeyCollector::add(KeyNode node, const Key& key) {
  // A default that is stated in words is no value of the struct.
  if (key.isRequired() || key.sameAs() || !key.otherwise().empty()) node.default_json.clear();
  node.unit = unitOf(node, key);
  node.default_text = defaultOf(node, key);
  nodes_.push_back(std::move(node));
}

void KeyCollector::fill(KeyNode& node, double value) {
  node.kind = Kind::number;
  node.default_json = formatReal(value);
}

void KeyCollector::fill(KeyNode& node, int value) {
  node.kind = Kind::integer;
  node.default_json = std::to_string(value);
}

void KeyCollector::fill(KeyNode& node, bool value) {
  node.kind = Kind::truth;
  node.default_json = value ? "true" : "false";
}

void KeyCollector::fill(KeyNode& node, std::string& value) {
  node.kind = node.choices.empty() ? Kind::text : Kind::choice;
  node.default_json = inJsonQuotes(value);
}

void KeyCollector::fill(KeyNode& node, Vec3& value) {
  node.kind = Kind::number;
  node.lists = {3};
  node.default_json = listOf({value.x(), value.y(), value.z()});
}

void KeyCollector::fill(KeyNode& node, Quat& value) {
  node.kind = Kind::number;
  node.lists = {4};
  node.is_rotation = true;
  node.doc +=
      " It is normalised where its length is within 0.001 of 1, and else refused. In its place {axis: [x, y, "
      "z], "
      "angle_deg: NUMBER} turns counter-clockwise about an axis of any length.";
  node.default_json = listOf({value.x(), value.y(), value.z(), value.w()});
}

void KeyCollector::fill(KeyNode& node, AnyValue&) {
  node.kind = Kind::any;
}

void KeyCollector::fillChoice(KeyNode& node, std::size_t index) {
  node.kind = Kind::choice;
  node.default_json = inJsonQuotes(std::string(node.choices[index].name));
}

KeyNode scenarioKeys() {
  KeyNode root = keyTree<Scenario>("scenario"), composition = keyTree<CompositionSettings>("");
  root.children.insert(root.children.begin() + 1, composition.children.front());
  return root;
}

}  // namespace fissure
