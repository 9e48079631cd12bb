#include <fmt/core.h>

#include <algorithm>

#include "scenario/range_check.h"
#include "text/did_you_mean.h"

namespace fissure {

namespace {

void checkCamera(Checker check, const CameraSettings& camera) {
  const Vec3 view = camera.look_at_m - camera.position_m;
  check.require(!(view.norm() == 0), "look_at_m", "is where the camera stands, expected another point");
  check.require(!(view.normalized().cross(camera.up.normalized()).norm() < 1e-9) || view.norm() == 0, "up",
                "is zero or along the view, expected a direction across it");
}

}  // namespace

void checkRecord(Checker check, const RecordSettings& record) {
  if (record.frames && record.frames->camera)
    checkCamera(check.in("frames").in("camera"), *record.frames->camera);
}

std::vector<Problem> validate(const FrameSettings& frames) {
  std::vector<Problem> problems;
  checkRanges({problems, ""}, frames);
  if (frames.camera) checkCamera({problems, "camera"}, *frames.camera);
  return problems;
}

namespace {

void checkExpectation(Checker check, const Expectation& expected) {
  check.require(
      !expected.quantity.empty() && expected.quantity.rfind("timing/", 0) != 0, "quantity",
      fmt::format("is \"{}\", expected the name of a summary value that is the same on every machine",
                  expected.quantity));
  check.require(expected.value.has_value() == expected.tolerance.has_value(), "",
                expected.value ? "has a value without a tolerance, expected both"
                               : "has a tolerance without a value, expected both");
  check.require(
      expected.value || expected.min || expected.max, "",
      fmt::format("says nothing about {}, expected value and tolerance, min or max", expected.quantity));
  check.require(!expected.min || !expected.max || *expected.min <= *expected.max, "min",
                "is above max, expected at most max");
}

}  // namespace

void checkExpectations(Checker check, const Scenario& scenario) {
  if (scenario.expect.size() > most_items) return;
  std::vector<std::string> names;
  for (const PipelineSettings& entry : scenario.pipelines) names.push_back(entry.name);
  for (std::size_t i = 0; i < scenario.expect.size(); ++i) {
    Checker item = check.in(std::to_string(i));
    const std::optional<std::string>& name = scenario.expect[i].pipeline;
    checkExpectation(item, scenario.expect[i]);
    if (name && std::find(names.begin(), names.end(), *name) == names.end())
      item.fail("pipeline",
                fmt::format("is \"{}\", which is no entry of pipelines{}", *name, didYouMean(*name, names)));
  }
}

}  // namespace fissure
