#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "scenario/checker.h"
#include "scenario/rigid_tools.h"
#include "text/scalars.h"

namespace fissure {

namespace {

constexpr double slack_m = 1e-9;  // of jaws that are meant to touch the middle or to end at the hinge

/// To a micrometre, without what rounding adds.
std::string millimetres(double length_m) {
  return formatReal(std::round(1e6 * length_m) / 1e3);
}

/// Points that span a shape, in its frame; empty where only a file knows.
std::vector<Vec3> cornersOf(const SurfaceShape& shape) {
  if (const auto* triangles = std::get_if<TrianglesShape>(&shape)) return triangles->vertices_m;
  const auto* box = std::get_if<BoxShape>(&shape);
  if (!box) return {};
  std::vector<Vec3> corners;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 1) ? 0.5 : -0.5, (corner & 2) ? 0.5 : -0.5, (corner & 4) ? 0.5 : -0.5);
    corners.push_back(sign.cwiseProduct(box->size_m));
  }
  return corners;
}

/// Jaws that keep to their own side below the hinge never meet each other, however they open.
void checkSide(Checker check, const ClampSettings& clamp, const ClampPart& jaw, double side,
               const char* position) {
  const Pose pose{jaw.position_m, jaw.orientation.normalized()};
  double innermost_m = INFINITY, highest_m = -INFINITY;
  const std::vector<Vec3> corners = cornersOf(jaw.shape);
  if (corners.empty()) return;
  for (const Vec3& corner : corners) {
    const Vec3 point_m = pose.toScene(corner);
    innermost_m = std::min(innermost_m, side * point_m.x());
    highest_m = std::max(highest_m, point_m.y());
  }
  check.require(innermost_m >= -slack_m, position,
                fmt::format("puts the jaw {} mm beyond the clamp's plane x = 0, where it meets the other "
                            "one, expected it on the {}",
                            millimetres(-innermost_m), side > 0 ? "right (x >= 0)" : "left (x <= 0)"));
  check.require(clamp.opening == ClampOpening::parallel || highest_m <= clamp.hinge_height_m + slack_m,
                position,
                fmt::format("puts the jaw {} mm above the hinge, where it meets the other one when they "
                            "open, expected it below",
                            millimetres(highest_m - clamp.hinge_height_m)));
}

/// An opening is in the unit of the clamp's kind.
void checkOpening(Checker check, const ClampSettings& clamp, const std::string& in_m,
                  const std::optional<double>& opening_m, const std::string& in_deg,
                  const std::optional<double>& opening_deg) {
  const bool hinged = clamp.opening == ClampOpening::hinged;
  check.require(!hinged || !opening_m, in_m, "is given for hinged jaws, expected " + in_deg);
  check.require(hinged || !opening_deg, in_deg, "is given for parallel jaws, expected " + in_m);
}

}  // namespace

void checkClamp(Checker check, const ToolSettings& tool) {
  const ClampSettings& clamp = *tool.clamp;
  const ClampPart right{tool.shape, clamp.jaw_position_m, clamp.jaw_orientation};
  if (clamp.left_jaw) checkShape(check.in("left_jaw").in("shape"), clamp.left_jaw->shape);
  for (std::size_t i = 0; i < std::min(clamp.handle.size(), most_items); ++i)
    checkShape(check.in("handle." + std::to_string(i)).in("shape"), clamp.handle[i].shape);
  checkSide(check, clamp, right, 1, "jaw_position_m");
  if (clamp.left_jaw) checkSide(check.in("left_jaw"), clamp, *clamp.left_jaw, -1, "position_m");
}

void checkOpenings(Checker check, const ScriptMotion& motion, const std::optional<ClampSettings>& clamp) {
  const auto at = [&](Checker where, const std::string& key, const std::optional<double>& opening_m,
                      const std::optional<double>& opening_deg) {
    if (clamp) return checkOpening(where, *clamp, key + "_m", opening_m, key + "_deg", opening_deg);
    where.require(!opening_m && !opening_deg, key + (opening_m ? "_m" : "_deg"),
                  "is given for a tool that does not open, expected a clamp");
  };
  at(check, "start_opening", motion.start_opening_m, motion.start_opening_deg);
  for (std::size_t i = 0; i < motion.segments.size(); ++i)
    at(check.in("segments." + std::to_string(i)), "open_to", motion.segments[i].open_to_m,
       motion.segments[i].open_to_deg);
}

void checkOpenings(Checker check, const ReplayMotion& motion, const std::optional<ClampSettings>& clamp) {
  if (!motion.opening)
    return check.require(!clamp, "", "has no opening, expected the device axis that opens the clamp");
  if (!clamp) return check.fail("opening", "is given for a tool that does not open, expected a clamp");
  Checker opening = check.in("opening");
  const DeviceOpening& device = *motion.opening;
  opening.require(device.open_device_m != device.closed_device_m, "open_device_m",
                  "is closed_device_m too, expected another place");
  checkOpening(opening, *clamp, "open_m", device.open_m, "open_deg", device.open_deg);
  const char* key = clamp->opening == ClampOpening::hinged ? "open_deg" : "open_m";
  opening.require(device.open_m || device.open_deg, "",
                  std::string("does not say how far it opens, expected ") + key);
  opening.require(!(device.open_m || device.open_deg) || device.open() != 0, key,
                  "is 0, expected more: the clamp would never open");
}

void checkJawNames(Checker check, const std::vector<ToolSettings>& tools) {
  for (const ToolSettings& tool : tools) {
    if (!tool.clamp) continue;
    Checker named = check.in(tool.name);
    for (const std::string& jaw : jawNames(tool)) {
      named.require(isName(jaw), "name",
                    fmt::format("is \"{}\", too long for its jaw \"{}\", expected at most 58 characters",
                                tool.name, jaw));
      const bool taken = std::any_of(tools.begin(), tools.end(),
                                     [&](const ToolSettings& other) { return other.name == jaw; });
      check.in(jaw).require(!taken, "name",
                            "is that of a jaw of \"" + tool.name + "\" too, expected another");
    }
  }
}

}  // namespace fissure
