#include <algorithm>
#include <set>
#include <string>

#include "scenario/checker.h"
#include "text/scalars.h"

namespace fissure {

namespace {

void checkAlternative(Checker check, const SphereShape& sphere) {
  check.positive("radius_m", sphere.radius_m);
  check.between("subdivisions", sphere.subdivisions, 0, 7);
}

/// NaN, of values that are bad anyway, passes.
void checkTriangles(Checker check, const std::string& key, double triangles) {
  check.require(
      !(triangles > static_cast<double>(most_triangles)), key,
      "makes " + formatReal(triangles) + " triangles, expected at most " + std::to_string(most_triangles));
}

void checkAlternative(Checker check, const BoxShape& box) {
  check.positive("size_m", box.size_m);
  for (const int count : box.cells) check.between("cells", count, 1, 128);
  if (std::all_of(box.cells.begin(), box.cells.end(), [](int count) { return count >= 1 && count <= 128; }))
    checkTriangles(check, "cells", box.triangles());
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
  const int vertices = static_cast<int>(triangles.vertices_m.size());
  check.require(vertices >= 4, "vertices_m",
                "has " + std::to_string(vertices) + " items, expected at least 4");
  const std::size_t faces = triangles.faces.size();
  check.require(faces >= 4 && faces <= most_triangles, "faces",
                "has " + std::to_string(faces) + " items, expected 4 to " + std::to_string(most_triangles));
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

/// What can be said without the file.
void checkAlternative(Checker check, const TetrahedraShape& shape) {
  check.require(!shape.file.empty(), "file", "is empty, expected the name of a mesh file");
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

}  // namespace

void checkShape(Checker check, const SurfaceShape& shape) {
  std::visit([&](const auto& alternative) { checkAlternative(check, alternative); }, shape);
}

}  // namespace fissure
