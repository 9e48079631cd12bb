#pragma once

#include <cstdint>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// The tissue that the contacts of one tool press on. Normals point from the tool into the tissue, scene
/// frame. Displacements are those that the contacts cause along their normals; they are the shares by which
/// several tools divide the force of a triangle, and are kept only where there are several tools.
struct ToolTouch {
  /// [vertex] sum of the contacts' normals times their weights at the vertex.
  std::vector<Vec3> vertex_normals;
  std::vector<Vec3> face_normals;  ///< [face] sum of the normals of the contacts on the face; zero: none
  /// [vertex] the same sum of displacements; empty for a single tool.
  std::vector<double> vertex_displacements_m;
  std::vector<double> face_displacements_m;
};

/// The tissue that is in a colliding state with tools in this step, whatever detector found it, and, where
/// force laws need them, the normals of the contacts. [vertex] and [face] arrays cover all bodies,
/// concatenated in the Scene's order.
struct ContactPatch {
  std::vector<std::uint8_t> vertex_contact;  ///< [vertex] 1: the vertex belongs to a contact
  std::vector<ToolTouch> tools;              ///< one per tool; empty without force laws
  std::vector<double> face_weights;  ///< [face] share of its force that counts, 0..1; empty: all of it

  /// Sets the sizes of the arrays. `tools_with_normals`: the number of tools where force laws need normals,
  /// else 0.
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

  /// Removes all contacts; the sizes stay.
  void clear() {
    vertex_contact.assign(vertex_contact.size(), 0);
    for (ToolTouch& tool : tools) {
      tool.vertex_normals.assign(tool.vertex_normals.size(), Vec3::Zero());
      tool.face_normals.assign(tool.face_normals.size(), Vec3::Zero());
      tool.vertex_displacements_m.assign(tool.vertex_displacements_m.size(), 0);
      tool.face_displacements_m.assign(tool.face_displacements_m.size(), 0);
    }
  }

  /// Adds a contact of `tool` at a vertex, with the contact's weight there.
  void touchVertex(int tool, int vertex, double weight, const Vec3& normal, double displacement_m) {
    vertex_contact[vertex] = 1;
    if (tools.empty()) return;
    ToolTouch& touch = tools[tool];
    touch.vertex_normals[vertex] += weight * normal;
    if (tools.size() > 1) touch.vertex_displacements_m[vertex] += weight * displacement_m;
  }

  /// Adds a contact of `tool` on a face.
  void touchFace(int tool, int face, const Vec3& normal, double displacement_m) {
    if (tools.empty()) return;
    ToolTouch& touch = tools[tool];
    touch.face_normals[face] += normal;
    if (tools.size() > 1) touch.face_displacements_m[face] += displacement_m;
  }
};

}  // namespace fissure
