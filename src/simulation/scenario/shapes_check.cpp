#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>

#include "scenario/checker.h"
#include "text/scalars.h"

namespace fissure {

namespace {

void checkAlternative(Checker, const SphereShape&) {}

/// NaN, of values that are bad anyway, passes.
void checkTriangles(Checker check, const std::string& key, double triangles) {
  check.require(
      !(triangles > static_cast<double>(most_triangles)), key,
      fmt::format("makes {} triangles, expected at most {}", formatReal(triangles), most_triangles));
}

void checkAlternative(Checker check, const BoxShape& box) {
  if (std::all_of(box.cells.begin(), box.cells.end(), [](int count) { return count >= 1 && count <= 128; }))
    checkTriangles(check, "cells", box.triangles());
}

void checkAlternative(Checker check, const CapsuleShape& capsule) {
  if (capsule.subdivisions >= 0 && capsule.subdivisions <= 7)
    checkTriangles(check, "radius_m", capsule.triangles());
}

/// What can be said without topology; mesh/ checks that the surface is closed and oriented.
void checkAlternative(Checker check, const TrianglesShape& triangles) {
  const int vertices = static_cast<int>(triangles.vertices_m.size());
  const std::size_t faces = triangles.faces.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const Face& face = triangles.faces[i];
    const bool inside = std::all_of(face.begin(), face.end(), [&](int v) { return v >= 0 && v < vertices; });
    const bool distinct = face[0] != face[1] && face[1] != face[2] && face[2] != face[0];
    check.require(
        inside && distinct, "faces." + std::to_string(i),
        fmt::format("is no triangle, expected three different vertex indices from 0 to {}", vertices - 1));
  }
}

/// What can be said without the file.
void checkAlternative(Checker check, const FileShape& shape) {
  check.require(!shape.file.empty(), "file", "is empty, expected the name of a mesh file");
  std::set<MeshRepair> seen;
  for (std::size_t i = 0; i < shape.repairs.size(); ++i)
    check.require(seen.insert(shape.repairs[i]).second, "repairs." + std::to_string(i),
                  "is named twice, expected each repair once");
}

/// What can be said without the file.
void checkAlternative(Checker check, const TetrahedraShape& shape) {
  check.require(!shape.file.empty(), "file", "is empty, expected the name of a mesh file");
}

void checkAlternative(Checker check, const LobesShape& lobes) {
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
