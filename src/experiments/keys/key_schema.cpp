#include "keys/key_schema.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "keys/key_text.h"

namespace fissure {

namespace {

using Json = nlohmann::ordered_json;
using Kind = KeyNode::Kind;

/// Makes the schemas of keys: of whole files, or of files that only say what differs from their base.
class SchemaMaker {
 public:
  explicit SchemaMaker(bool is_whole) : is_whole_(is_whole) {}

  Json ofMap(const std::vector<KeyNode>& keys, const Json& first = Json::object()) const {
    Json properties = first, required = Json::array(), alone = Json::array();
    for (const auto& [name, schema] : first.items()) required.push_back(name);
    for (const KeyNode& key : keys) {
      if (key.is_alone) {
        alone.push_back(closed({{key.name, ofKey(key)}}, Json::array({key.name})));
        continue;
      }
      properties[key.name] = ofKey(key);
      if (key.is_required && key.when.empty()) required.push_back(key.name);
    }
    Json map = closed(properties, is_whole_ ? required : Json::array());
    if (alone.empty()) return map;
    alone.push_back(std::move(map));
    return {{"oneOf", alone}};
  }

 private:
  static Json closed(const Json& properties, const Json& required) {
    Json map = {{"type", "object"}, {"properties", properties}};
    if (!required.empty()) map["required"] = required;
    map["additionalProperties"] = false;
    return map;
  }

  Json ofKey(const KeyNode& key) const {
    Json schema = ofValue(key);
    for (std::size_t list = key.lists.size(); list-- > 0;) {
      schema = {{"type", "array"}, {"items", schema}};
      const std::size_t length = key.lists[list];
      if (length > 0) {
        schema["minItems"] = length;
        schema["maxItems"] = length;
      } else if (list == 0) {
        if (key.items.least > 0 && is_whole_) schema["minItems"] = key.items.least;
        if (key.items.most < any_number) schema["maxItems"] = key.items.most;
      }
    }
    if (key.is_rotation) schema = {{"anyOf", Json::array({schema, axisAngle()})}};
    schema["description"] = descriptionOf(key);
    if (!key.default_json.empty()) schema["default"] = Json::parse(key.default_json);
    return schema;
  }

  static Json axisAngle() {
    const Json number = {{"type", "number"}};
    const Json axis = {{"type", "array"}, {"items", number}, {"minItems", 3}, {"maxItems", 3}};
    return closed({{"axis", axis}, {"angle_deg", number}}, Json::array({"axis", "angle_deg"}));
  }

  static std::string descriptionOf(const KeyNode& key) {
    std::string text = key.doc;
    if (!key.unit.empty() && key.unit != "none") text += "\nUnit: " + key.unit;
    text += "\nDefault: " + key.default_text;
    if (!key.when.empty()) text += "\nOnly for " + key.when;
    for (const CatalogEntry& entry : key.choices)
      text.append("\n").append(entry.name).append(": ").append(entry.description);
    return text;
  }

  Json ofValue(const KeyNode& key) const {
    switch (key.kind) {
      case Kind::number:
        return ofNumber(key.range, "number");
      case Kind::integer:
        return ofNumber(key.range, "integer");
      case Kind::truth:
        return {{"type", "boolean"}};
      case Kind::text:
        if (key.is_item_name) return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-]{1,64}$"}};
        return {{"type", "string"}, {"minLength", key.can_be_empty ? 0 : 1}};
      case Kind::choice:
        return {{"enum", namesOf(key)}};
      case Kind::any:
        return Json::object();
      case Kind::variant:
        return ofVariant(key);
      case Kind::map:
      case Kind::alternative:
        break;
    }
    return ofMap(key.children);
  }

  static Json ofNumber(const Range& range, const char* type) {
    Json schema = {{"type", type}};
    if (std::isfinite(range.least))
      schema[range.least_is_outside ? "exclusiveMinimum" : "minimum"] = range.least;
    if (std::isfinite(range.most)) schema["maximum"] = range.most;
    if (range.zero_too) return {{"anyOf", Json::array({Json{{"const", 0}}, schema})}};
    return schema;
  }

  static Json namesOf(const KeyNode& key) {
    Json names = Json::array();
    for (const CatalogEntry& entry : key.choices) names.push_back(entry.name);
    return names;
  }

  Json ofVariant(const KeyNode& key) const {
    Json alternatives = Json::array();
    for (const KeyNode& one : key.children) {
      const Json type = {{"type", {{"const", one.name}, {"description", one.doc}}}};
      alternatives.push_back(ofMap(one.children, type));
    }
    // A map over a base need not say its type, and may then be of several.
    return {{is_whole_ ? "oneOf" : "anyOf", alternatives}};
  }

  bool is_whole_;
};

}  // namespace

std::string schemaOf(const KeyNode& file) {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "fissure " + file.name}};
  const Json whole = SchemaMaker(true).ofMap(file.children);
  if (file.name == "scenario") {
    schema["if"] = {{"required", Json::array({"base"})}};
    schema["then"] = SchemaMaker(false).ofMap(file.children);
    schema["else"] = whole;
  } else {
    schema.update(whole);
  }
  return schema.dump(2) + "\n";
}

}  // namespace fissure
