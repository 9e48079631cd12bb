#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenario/catalog.h"
#include "scenario/scenario.h"

namespace fissure {

/// Collects problems below one path. NaN fails every check of a number.
class Checker {
 public:
  Checker(std::vector<Problem>& problems, std::string path) : problems_(problems), path_(std::move(path)) {}

  /// For the entry `key` of this one.
  Checker in(const std::string& key) const { return {problems_, pathOf(key)}; }

  /// `others`: paths of what else this is about.
  void fail(const std::string& key, const std::string& what, const std::vector<std::string>& others = {}) {
    problems_.push_back({pathOf(key), what, others});
  }
  void require(bool good, const std::string& key, const std::string& what) {
    if (!good) fail(key, what);
  }

  void finite(const std::string& key, double value);
  void finite(const std::string& key, const Vec3& value);
  void positive(const std::string& key, double value);                          ///< and finite
  void positive(const std::string& key, const Vec3& value);                     ///< in all three
  void notNegative(const std::string& key, double value);                       ///< and finite
  void between(const std::string& key, double value, double low, double high);  ///< both included
  void unit(const std::string& key, const Quat& value);                         ///< within 1e-6
  void oneOf(const std::string& key, const std::string& value, const std::vector<CatalogEntry>& table);

 private:
  std::string pathOf(const std::string& key) const {
    return path_.empty() || key.empty() ? path_ + key : path_ + "." + key;
  }

  std::vector<Problem>& problems_;
  std::string path_;
};

/// Of bodies, tools, runs, expectations ...: they are compared with each other.
inline constexpr std::size_t most_items = 1000;

/// Whether a list of `count` items is refused; says so.
bool tooMany(Checker check, std::size_t count);

// The parts of validate(). Bodies, what surrounds them and what is recorded:
void checkBody(Checker check, const BodySettings& body);
void checkGauge(Checker check, const GaugeSettings& gauge);
void checkTool(Checker check, const ToolSettings& tool);
void checkShape(Checker check, const SurfaceShape& shape);
void checkClamp(Checker check, const ToolSettings& clamp);
void checkMotion(Checker check, const ToolMotion& motion, const std::optional<ClampSettings>& clamp);
void checkOpenings(Checker check, const ScriptMotion& motion, const std::optional<ClampSettings>& clamp);
void checkOpenings(Checker check, const ReplayMotion& motion, const std::optional<ClampSettings>& clamp);
void checkJawNames(Checker check, const std::vector<ToolSettings>& tools);
void checkPipeline(Checker check, const PipelineSettings& pipeline);
void checkElastic(Checker check, const ElasticSettings& elastic);
void checkElasticRegion(Checker check, const ElasticRegion& region);
void checkBox(Checker check, const BoxRegion& box);
/// Relations of an elastic body with the rest of the scenario.
void checkElasticScene(Checker check, const Scenario& scenario);
void checkForce(Checker check, const ForceSettings& force);
void checkRecord(Checker check, const RecordSettings& record);
void checkExpectations(Checker check, const Scenario& scenario);

}  // namespace fissure
