#pragma once

#include <cstdint>
#include <vector>

#include "base/geometry.h"

namespace fissure {

/// Which tissue is in a colliding state with the tools in this step, whatever detector found it, and, where
/// force laws ask for it, along which normals. Normals point from the tool into the tissue. Arrays run over
/// all bodies, concatenated in the Scene's order.
struct ContactPatch {
  std::vector<std::uint8_t> vertex_contact;  ///< 1: the vertex belongs to a contact
  std::vector<Vec3>
      vertex_normals;  ///< sum of the normals of the vertex's contacts, each times its weight there
  std::vector<Vec3> face_normals;  ///< sum of the normals of the contacts on this face; zero: none

  bool hasNormals() const { return !face_normals.empty(); }

  void resize(int vertices, int faces, bool with_normals) {
    vertex_contact.resize(vertices);
    if (!with_normals) return;
    vertex_normals.resize(vertices);
    face_normals.resize(faces);
  }
  void clear() {
    vertex_contact.assign(vertex_contact.size(), 0);
    vertex_normals.assign(vertex_normals.size(), Vec3::Zero());
    face_normals.assign(face_normals.size(), Vec3::Zero());
  }
};

}  // namespace fissure
