#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <type_traits>

#include "scenario/checker.h"
#include "text/scalars.h"

namespace fissure {

namespace {

void checkAlternative(Checker check, const SphereShape& sphere) {
  check.positive("radius_m", sphere.radius_m);
  check.between("subdivisions", sphere.subdivisions, 0, 7);
}

void checkAlternative(Checker check, const BoxShape& box) {
  check.positive("size_m", box.size_m);
}

constexpr double most_triangles = 131072;  // those of a sphere with 7 subdivisions

/// NaN, of values that are bad anyway, passes.
void checkTriangles(Checker check, const std::string& key, double triangles) {
  check.require(
      !(triangles > most_triangles), key,
      "makes " + formatReal(triangles) + " triangles, expected at most " + formatReal(most_triangles));
}

void checkAlternative(Checker check, const CapsuleShape& capsule) {
  check.positive("radius_m", capsule.radius_m);
  check.positive("length_m", capsule.length_m);
  check.between("subdivisions", capsule.subdivisions, 0, 7);
  if (capsule.subdivisions >= 0 && capsule.subdivisions <= 7)
    checkTriangles(check, "radius_m", capsule.triangles());
}

/// What can be said without topology; mesh/ checks that the surface is closed and oriented.
void checkAlternative(Checker check, const TrianglesShape& triangles) {
  constexpr auto max_faces = static_cast<std::size_t>(most_triangles);
  const int vertices = static_cast<int>(triangles.vertices_m.size());
  check.require(vertices >= 4, "vertices_m",
                "has " + std::to_string(vertices) + " items, expected at least 4");
  const std::size_t faces = triangles.faces.size();
  check.require(faces >= 4 && faces <= max_faces, "faces",
                "has " + std::to_string(faces) + " items, expected 4 to " + std::to_string(max_faces));
  for (std::size_t i = 0; i < triangles.vertices_m.size(); ++i) {
    check.finite("vertices_m." + std::to_string(i), triangles.vertices_m[i]);
  }
  for (std::size_t i = 0; i < faces; ++i) {
    const Face& face = triangles.faces[i];
    const bool inside = std::all_of(face.begin(), face.end(), [&](int v) { return v >= 0 && v < vertices; });
    const bool distinct = face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
    check.require(
        inside && distinct, "faces." + std::to_string(i),
        "is no triangle, expected three different vertex indices from 0 to " + std::to_string(vertices - 1));
  }
}

/// What can be said without the file.
void checkAlternative(Checker check, const FileShape& shape) {
  check.require(!shape.file.empty(), "file", "is empty, expected the name of a mesh file");
  check.notNegative("weld_tolerance_m", shape.weld_tolerance_m);
  std::set<MeshRepair> seen;
  for (std::size_t i = 0; i < shape.repairs.size(); ++i)
    check.require(seen.insert(shape.repairs[i]).second, "repairs." + std::to_string(i),
                  "is named twice, expected each repair once");
  if (shape.max_edge_m) check.positive("max_edge_m", *shape.max_edge_m);
}

void checkAlternative(Checker check, const LobesShape& lobes) {
  check.positive("size_m", lobes.size_m);
  check.positive("slit_depth_m", lobes.slit_depth_m);
  check.positive("slit_width_m", lobes.slit_width_m);
  check.positive("edge_m", lobes.edge_m);
  check.require(!(lobes.slit_depth_m >= lobes.size_m.y()), "slit_depth_m",
                "is not below the height, expected lobes that are joined below the slit");
  check.require(!(lobes.slit_width_m >= lobes.size_m.x() / 2), "slit_width_m",
                "is half the size across or more, expected a narrower slit");
  checkTriangles(check, "edge_m", lobes.triangles());
}

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

void checkBox(Checker check, const BoxRegion& box) {
  check.finite("min_m", box.min_m);
  check.finite("max_m", box.max_m);
  check.require(!(box.min_m.array() > box.max_m.array()).any(), "min_m",
                "is above max_m, expected at most max_m in each direction");
}

void checkFixed(Checker check, const FixedRegion& region) {
  check.require(region.below_m.has_value() != region.box.has_value(), "",
                "expected exactly one of below_m and box");
  if (region.below_m) check.finite("below_m", *region.below_m);
  if (!region.box) return;
  checkBox(check.in("box"), *region.box);
}

}  // namespace

void checkShape(Checker check, const SurfaceShape& shape) {
  std::visit([&](const auto& alternative) { checkAlternative(check, alternative); }, shape);
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
  checkSolver(check.in("solver"), body.solver);
  checkClusters(check.in("clusters"), body.clusters);
}

}  // namespace fissure
