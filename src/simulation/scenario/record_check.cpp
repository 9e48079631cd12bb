#include <algorithm>

#include "scenario/checker.h"
#include "text/did_you_mean.h"

namespace fissure {

namespace {

void checkCamera(Checker check, const CameraSettings& camera) {
  check.finite("position_m", camera.position_m);
  check.finite("look_at_m", camera.look_at_m);
  check.finite("up", camera.up);
  check.between("field_of_view_deg", camera.field_of_view_deg, 1, 150);
  const Vec3 view = camera.look_at_m - camera.position_m;
  check.require(!(view.norm() == 0), "look_at_m", "is where the camera stands, expected another point");
  check.require(!(view.normalized().cross(camera.up.normalized()).norm() < 1e-9) || view.norm() == 0, "up",
                "is zero or along the view, expected a direction across it");
}

void checkFrames(Checker check, const FrameSettings& frames) {
  check.positive("every_s", frames.every_s);
  check.between("size_px", frames.width_px, 16, 4096);
  check.between("size_px", frames.height_px, 16, 4096);
  if (frames.camera) checkCamera(check.in("camera"), *frames.camera);
}

}  // namespace

void checkRecord(Checker check, const RecordSettings& record) {
  if (record.snapshots_every_s) check.positive("snapshots_every_s", *record.snapshots_every_s);
  if (record.frames) checkFrames(check.in("frames"), *record.frames);
}

std::vector<Problem> validate(const FrameSettings& frames) {
  std::vector<Problem> problems;
  checkFrames({problems, ""}, frames);
  return problems;
}

namespace {

void checkExpectation(Checker check, const Expectation& expected) {
  check.require(!expected.quantity.empty() && expected.quantity.rfind("timing/", 0) != 0, "quantity",
                "is \"" + expected.quantity +
                    "\", expected the name of a summary value that is the same on every machine");
  if (expected.value) check.finite("value", *expected.value);
  if (expected.tolerance) check.notNegative("tolerance", *expected.tolerance);
  if (expected.min) check.finite("min", *expected.min);
  if (expected.max) check.finite("max", *expected.max);
  check.require(expected.value.has_value() == expected.tolerance.has_value(), "",
                expected.value ? "has a value without a tolerance, expected both"
                               : "has a tolerance without a value, expected both");
  check.require(expected.value || expected.min || expected.max, "",
                "says nothing about " + expected.quantity + ", expected value and tolerance, min or max");
  check.require(!expected.min || !expected.max || *expected.min <= *expected.max, "min",
                "is above max, expected at most max");
}

}  // namespace

void checkExpectations(Checker check, const Scenario& scenario) {
  if (tooMany(check, scenario.expect.size())) return;
  std::vector<std::string> names;
  for (const PipelineSettings& entry : scenario.pipelines) names.push_back(entry.name);
  for (std::size_t i = 0; i < scenario.expect.size(); ++i) {
    Checker item = check.in(std::to_string(i));
    const std::optional<std::string>& name = scenario.expect[i].pipeline;
    checkExpectation(item, scenario.expect[i]);
    if (name && std::find(names.begin(), names.end(), *name) == names.end())
      item.fail("pipeline",
                "is \"" + *name + "\", which is no entry of pipelines" + didYouMean(*name, names));
  }
}

}  // namespace fissure
