#include "scenario/read_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/reproducible.h"
#include "base/utf8.h"
#include "scenario/compose.h"
#include "scenario/read_map.h"
#include "scenario/scenario.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"

namespace fissure {

namespace {

using Kind = YamlNode::Kind;

/// What a node is, for the first half of a message.
std::string describeNode(const YamlNode& node) {
  switch (node.kind) {
    case Kind::nothing:
      return "empty";
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map";
    case Kind::scalar:
      break;
  }
  constexpr std::size_t most_bytes = 60;
  return (node.quoted ? "the text " : "") + inQuotes(node.text, most_bytes);
}

/// The kind of a number node; anything that is no number at all throws.
ScalarKind numberKind(const YamlNode& node, const std::string& path, const std::string& expected) {
  if (node.kind != Kind::scalar || node.quoted) wrongNode(node, path, expected);
  const ScalarKind kind = scalarKind(node.text);
  if (kind == ScalarKind::leading_zero) {
    wrongNode(node, path, expected + " without a leading zero (some readers take it as octal)");
  }
  if (kind == ScalarKind::non_finite) wrongNode(node, path, "a finite number");
  if (kind != ScalarKind::integer && kind != ScalarKind::real) wrongNode(node, path, expected);
  return kind;
}

Quat readAxisAngle(const YamlNode& node, const std::string& path) {
  Vec3 axis = Vec3::Zero();
  double angle_deg = 0;
  MapReader io(node, path);
  io.field("axis", axis, Key("").required());
  io.field("angle_deg", angle_deg, Key("").required());
  io.finish();
  const double length = axis.stableNorm();
  if (!(length > 0)) failAt(node.find("axis")->origin, path + ".axis is zero, expected a direction");
  const double half_rad = std::fmod(angle_deg, 720) / 360 * std::numbers::pi;
  const Vec3 xyz = axis / length * reproducible::sin(half_rad);
  Quat turn(reproducible::cos(half_rad), xyz.x(), xyz.y(), xyz.z());
  for (double& value : turn.coeffs())  // half a turn has a w of 0, not of 6e-17
    if (std::abs(value) < std::numeric_limits<double>::epsilon()) value = 0;
  return turn.normalized();
}

}  // namespace

void wrongNode(const YamlNode& node, const std::string& path, const std::string& expected) {
  failAt(node.origin, path + " is " + describeNode(node) + ", expected " + expected);
}

void readValue(const YamlNode& node, const std::string& path, double& value) {
  numberKind(node, path, "a number");
  const std::optional<double> number = toReal(node.text);
  if (!number) wrongNode(node, path, "a number that a double can hold");
  value = *number;
}

void readValue(const YamlNode& node, const std::string& path, int& value) {
  if (numberKind(node, path, "a whole number") == ScalarKind::real) wrongNode(node, path, "a whole number");
  const std::optional<int> number = toInt(node.text);
  if (!number) wrongNode(node, path, "a whole number of at most 9 digits");
  value = *number;
}

void readValue(const YamlNode& node, const std::string& path, bool& value) {
  const bool truth = node.kind == Kind::scalar && !node.quoted && scalarKind(node.text) == ScalarKind::truth;
  if (!truth) wrongNode(node, path, "true or false");
  value = node.text == "true";
}

void readValue(const YamlNode& node, const std::string&, AnyValue& value) {
  value.yaml = flowText(node);
}

void readText(const YamlNode& node, const std::string& path, std::string& value) {
  if (node.kind != Kind::scalar) wrongNode(node, path, "a text");
  if (!node.quoted && scalarKind(node.text) != ScalarKind::text) {
    wrongNode(node, path, "a text (in quotes where it looks like a number or a truth value)");
  }
  if (!isPlainLine(node.text)) wrongNode(node, path, "one line without control characters");
  value = node.text;
}

void readValue(const YamlNode& node, const std::string& path, std::string& value) {
  readText(node, path, value);
  if (value.empty()) wrongNode(node, path, "at least one letter");
}

void readValue(const YamlNode& node, const std::string& path, Vec3& value) {
  requireList(node, path, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    readValue(node.children[i], path + "." + std::to_string(i), value[static_cast<int>(i)]);
  }
}

void readValue(const YamlNode& node, const std::string& path, Quat& value) {
  if (node.kind == Kind::map) {
    value = readAxisAngle(node, path);
    return;
  }
  const std::string expected = "a unit quaternion [x, y, z, w] or {axis: [x, y, z], angle_deg: NUMBER}";
  if (node.kind != Kind::list) wrongNode(node, path, expected);
  if (node.children.size() != 4)
    failAt(node.origin,
           path + " has " + std::to_string(node.children.size()) + " items, expected " + expected);
  std::array<double, 4> xyzw{};
  for (std::size_t i = 0; i < 4; ++i) readValue(node.children[i], path + "." + std::to_string(i), xyzw[i]);
  value = Quat(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
  const double norm = value.norm();
  if (!(std::abs(norm - 1) <= 1e-3)) {
    failAt(node.origin, path + " has length " + formatReal(norm) + ", expected " + expected);
  }
  // A quaternion that is unit up to rounding stays as it is: what was written once reads back to the same
  // bits.
  if (std::abs(norm - 1) > 4 * std::numeric_limits<double>::epsilon()) value.normalize();
}

std::size_t readChoice(const YamlNode& node, const std::string& path,
                       const std::vector<CatalogEntry>& table) {
  std::vector<std::string> names;
  for (const CatalogEntry& entry : table) names.emplace_back(entry.name);
  if (node.kind == Kind::nothing && std::find(names.begin(), names.end(), "null") != names.end()) {
    wrongNode(node, path, "a name (in quotes if it is \"null\", which means nothing in YAML)");
  }
  if (node.kind != Kind::scalar) wrongNode(node, path, "a name");
  const auto found = std::find(names.begin(), names.end(), node.text);
  if (found == names.end())
    failAt(node.origin, path + " is " + describeNode(node) + didYouMean(node.text, names));
  return static_cast<std::size_t>(found - names.begin());
}

std::size_t indexOf(const YamlNode& node, const std::string& path, const std::string& name,
                    const std::vector<CatalogEntry>& table, const std::string& expected) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const CatalogEntry& entry) { return entry.name == name; });
  if (found == table.end()) failAt(node.origin, path + " is \"" + name + "\", expected " + expected);
  return static_cast<std::size_t>(found - table.begin());
}

std::vector<std::size_t> readChoices(const YamlNode& node, const std::string& path,
                                     const std::vector<CatalogEntry>& table) {
  requireList(node, path);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < node.children.size(); ++i)
    indices.push_back(readChoice(node.children[i], itemPath(node, path, i), table));
  return indices;
}

void requireList(const YamlNode& node, const std::string& path, std::optional<std::size_t> length) {
  const std::string expected = length ? "a list of " + std::to_string(*length) : "a list";
  if (node.kind != Kind::list) wrongNode(node, path, expected);
  if (length && node.children.size() != *length) {
    failAt(node.origin,
           path + " has " + std::to_string(node.children.size()) + " items, expected " + expected);
  }
}

std::string itemPath(const YamlNode& list, const std::string& path, std::size_t index) {
  const std::optional<std::string> name = itemName(list.children[index]);
  return path + "." + (name && isName(*name) ? *name : std::to_string(index));
}

}  // namespace fissure
