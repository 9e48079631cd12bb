#include <string>

#include "scenario/catalog.h"
#include "scenario/checker.h"

namespace fissure {

namespace {

void checkSolver(Checker check, const SolverSettings& s) {
  check.notNegative("velocity_correction", s.velocity_correction);
  check.between("damping", s.damping, 0, 1);
  check.notNegative("drag", s.drag);
  check.notNegative("lift", s.lift);
  check.finite("pressure", s.pressure);
  check.notNegative("volume_conservation", s.volume_conservation);
  check.between("dynamic_friction", s.dynamic_friction, 0, 1);
  check.between("pose_matching", s.pose_matching, 0, 1);
  check.between("rigid_hardness", s.rigid_hardness, 0, 1);
  check.between("soft_hardness", s.soft_hardness, 0, 1);
  check.between("anchor_hardness", s.anchor_hardness, 0, 1);
  check.positive("max_volume", s.max_volume);
  check.positive("time_scale", s.time_scale);
  check.between("velocity_iterations", s.velocity_iterations, 0, 1000);
  check.between("position_iterations", s.position_iterations, 1, 1000);
  check.between("drift_iterations", s.drift_iterations, 0, 1000);
}

void checkClusters(Checker check, const ClusterSettings& c) {
  check.between("count", c.count, 0, 65536);
  check.between("iterations", c.iterations, 1, 1000);
  check.between("rigid_hardness", c.rigid_hardness, 0, 1);
  check.between("kinematic_hardness", c.kinematic_hardness, 0, 1);
  check.between("soft_hardness", c.soft_hardness, 0, 1);
  check.between("rigid_split", c.rigid_split, 0, 1);
  check.between("kinematic_split", c.kinematic_split, 0, 1);
  check.between("soft_split", c.soft_split, 0, 1);
  check.between("node_damping", c.node_damping, 0, 1);
  check.between("linear_damping", c.linear_damping, 0, 1);
  check.between("angular_damping", c.angular_damping, 0, 1);
  check.between("matching", c.matching, 0, 1);
}

void checkFixed(Checker check, const FixedRegion& region) {
  check.require(region.below_m.has_value() != region.box.has_value(), "",
                "expected exactly one of below_m and box");
  if (region.below_m) check.finite("below_m", *region.below_m);
  if (!region.box) return;
  checkBox(check.in("box"), *region.box);
}

}  // namespace

void checkBox(Checker check, const BoxRegion& box) {
  check.finite("min_m", box.min_m);
  check.finite("max_m", box.max_m);
  check.require(!(box.min_m.array() > box.max_m.array()).any(), "min_m",
                "is above max_m, expected at most max_m in each direction");
}

void checkGauge(Checker check, const GaugeSettings& gauge) {
  checkBox(check.in("box"), gauge.box);
}

void checkBody(Checker check, const BodySettings& body) {
  checkShape(check.in("shape"), body.shape);
  check.finite("position_m", body.position_m);
  check.unit("orientation", body.orientation);
  check.positive("mass_kg", body.mass_kg);
  check.positive("margin_m", body.margin_m);
  const int distance = body.bending_distance;
  check.require(distance == 0 || (distance >= 2 && distance <= 5), "bending_distance",
                "is " + std::to_string(distance) + ", expected 0 (no bending links) or 2 to 5");
  Checker material = check.in("material");
  material.between("linear_stiffness", body.material.linear_stiffness, 0, 1);
  material.between("angular_stiffness", body.material.angular_stiffness, 0, 1);
  material.between("volume_stiffness", body.material.volume_stiffness, 0, 1);
  for (std::size_t i = 0; i < body.fixed.size(); ++i)
    checkFixed(check.in("fixed." + std::to_string(i)), body.fixed[i]);
  if (body.isElastic()) checkElastic(check.in("elastic"), body.elastic);
  checkSolver(check.in("solver"), body.solver);
  checkClusters(check.in("clusters"), body.clusters);
}

}  // namespace fissure
