#pragma once

#include <cstdint>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// What one tool's contacts press on. Normals point from the tool into the tissue. The displacements are how
/// far the contacts push the tissue along them: by them tools share a triangle's force, so they are kept only
/// where there are several tools.
struct ToolTouch {
  std::vector<Vec3> vertex_normals;  ///< sum of the contacts' normals, each times its weight at the vertex
  std::vector<Vec3> face_normals;    ///< sum of the normals of the contacts on this face; zero: none
  std::vector<double> vertex_displacements_m;  ///< the same sums of displacements; empty: the only tool
  std::vector<double> face_displacements_m;
};

/// Which tissue is in a colliding state with the tools in this step, whatever detector found it, and, where
/// force laws ask for it, along which normals. Arrays run over all bodies, concatenated in the Scene's order.
struct ContactPatch {
  std::vector<std::uint8_t> vertex_contact;  ///< 1: the vertex belongs to a contact
  std::vector<ToolTouch> tools;              ///< one a tool; empty where no force law asks
  std::vector<double> face_weights;  ///< share of each face's force that counts, 0..1; empty: all of it

  /// `tools_with_normals`: the number of tools where force laws ask for normals, else 0.
  void resize(int vertices, int faces, std::size_t tools_with_normals) {
    vertex_contact.resize(vertices);
    tools.resize(tools_with_normals);
    for (ToolTouch& tool : tools) {
      tool.vertex_normals.resize(vertices);
      tool.face_normals.resize(faces);
      tool.vertex_displacements_m.resize(tools.size() > 1 ? vertices : 0);
      tool.face_displacements_m.resize(tools.size() > 1 ? faces : 0);
    }
  }

  void clear() {
    vertex_contact.assign(vertex_contact.size(), 0);
    for (ToolTouch& tool : tools) {
      tool.vertex_normals.assign(tool.vertex_normals.size(), Vec3::Zero());
      tool.face_normals.assign(tool.face_normals.size(), Vec3::Zero());
      tool.vertex_displacements_m.assign(tool.vertex_displacements_m.size(), 0);
      tool.face_displacements_m.assign(tool.face_displacements_m.size(), 0);
    }
  }

  /// A contact of `tool` at a vertex, with its weight there.
  void touchVertex(int tool, int vertex, double weight, const Vec3& normal, double displacement_m) {
    vertex_contact[vertex] = 1;
    if (tools.empty()) return;
    ToolTouch& touch = tools[tool];
    touch.vertex_normals[vertex] += weight * normal;
    if (tools.size() > 1) touch.vertex_displacements_m[vertex] += weight * displacement_m;
  }

  /// A contact of `tool` on a face.
  void touchFace(int tool, int face, const Vec3& normal, double displacement_m) {
    if (tools.empty()) return;
    ToolTouch& touch = tools[tool];
    touch.face_normals[face] += normal;
    if (tools.size() > 1) touch.face_displacements_m[face] += displacement_m;
  }
};

}  // namespace fissure
