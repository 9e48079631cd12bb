#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenario/catalog.h"
#include "scenario/key.h"
#include "scenario/scenario.h"

namespace fissure {

/// Collects the problems of one map of a scenario, at `path` and below. NaN fails every check of a number.
class Checker {
 public:
  Checker(std::vector<Problem>& problems, std::string path) : problems_(problems), path_(std::move(path)) {}

  /// A checker for the entry `key` of this map, with the same list of problems.
  Checker in(const std::string& key) const { return {problems_, pathOf(key)}; }

  /// Adds a problem with the value at `key`; `others` are the paths of further values that it concerns.
  void fail(const std::string& key, const std::string& what, const std::vector<std::string>& others = {}) {
    problems_.push_back({pathOf(key), what, others});
  }
  /// Adds a problem unless `good`.
  void require(bool good, const std::string& key, const std::string& what) {
    if (!good) fail(key, what);
  }

  void inRange(const std::string& key, double value, const Range& range);
  void inRange(const std::string& key, const Vec3& value, const Range& range);  ///< each of the three
  void unit(const std::string& key, const Quat& value);             ///< of unit length, within 1e-6
  void itemName(const std::string& key, const std::string& value);  ///< by isName()
  void oneLine(const std::string& key, const std::string& value);
  /// Checks the number of items of a list; returns whether it is allowed.
  bool itemCount(const std::string& key, std::size_t count, const ItemCount& expected);
  void oneOf(const std::string& key, const std::string& value, const std::vector<CatalogEntry>& table);

 private:
  std::string pathOf(const std::string& key) const {
    return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
  }

  std::vector<Problem>& problems_;
  std::string path_;
};

// The parts of validate() that check relations between values. Single values are checked by RangeCheck; here
// they may still be out of range.
void checkBody(Checker check, const BodySettings& body);
void checkTool(Checker check, const ToolSettings& tool);
void checkShape(Checker check, const SurfaceShape& shape);
void checkClamp(Checker check, const ToolSettings& clamp);
void checkMotion(Checker check, const ToolMotion& motion, const std::optional<ClampSettings>& clamp);
void checkOpenings(Checker check, const ScriptMotion& motion, const std::optional<ClampSettings>& clamp);
void checkOpenings(Checker check, const ReplayMotion& motion, const std::optional<ClampSettings>& clamp);
void checkJawNames(Checker check, const std::vector<ToolSettings>& tools);
void checkPipeline(Checker check, const PipelineSettings& pipeline);
void checkElasticRegion(Checker check, const ElasticRegion& region);
void checkBox(Checker check, const BoxRegion& box);
/// Checks the relations of an elastic body with the rest of the scenario.
void checkElasticScene(Checker check, const Scenario& scenario);
void checkForce(Checker check, const ForceSettings& force);
void checkRecord(Checker check, const RecordSettings& record);
void checkExpectations(Checker check, const Scenario& scenario);

}  // namespace fissure
