#pragma once

#include <stdlib.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "base/geometry.h"

namespace fissure {

/// A folder of a test's own, removed at its end.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "fissure_mesh_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string plain(const Vec3& v) {
  char text[96];
  std::snprintf(text, sizeof text, "%.9g %.9g %.9g", v.x(), v.y(), v.z());
  return text;
}

template <class T>
std::string rawBytes(const T& value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The mesh in each format. STL repeats a triangle's corners.
inline std::string asBinaryStl(const TriangleMesh& mesh) {
  std::string bytes(80, '\0');
  bytes += rawBytes(static_cast<std::uint32_t>(mesh.faces.size()));
  for (const Face& face : mesh.faces) {
    bytes += std::string(12, '\0');
    for (const int v : face)
      for (int k = 0; k < 3; ++k) bytes += rawBytes(static_cast<float>(mesh.vertices_m[v][k]));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

inline std::string asTextStl(const TriangleMesh& mesh) {
  std::string text = "solid test\n";
  for (const Face& face : mesh.faces) {
    text += " facet normal 0 0 1\n  outer loop\n";
    for (const int v : face) text += "   vertex " + plain(mesh.vertices_m[v]) + "\n";
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid test\n";
}

inline std::string asObj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "mtllib none.mtl\nusemtl skin\n";
  for (const Vec3& v : mesh.vertices_m) text << "v " << plain(v) << "\n";
  for (const auto& [a, b, c] : mesh.faces) text << "f " << a + 1 << " " << b + 1 << " " << c + 1 << "\n";
  return text.str();
}

inline std::string indexedText(const TriangleMesh& mesh) {
  std::ostringstream text;
  for (const Vec3& v : mesh.vertices_m) text << plain(v) << "\n";
  for (const auto& [a, b, c] : mesh.faces) text << "3 " << a << " " << b << " " << c << "\n";
  return text.str();
}

inline std::string plyHeader(const TriangleMesh& mesh, const std::string& kind) {
  return "ply\nformat " + kind + " 1.0\nelement vertex " + std::to_string(mesh.vertices_m.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string asTextPly(const TriangleMesh& mesh) {
  return plyHeader(mesh, "ascii") + indexedText(mesh);
}

inline std::string asBinaryPly(const TriangleMesh& mesh) {
  std::string bytes = plyHeader(mesh, "binary_little_endian");
  for (const Vec3& v : mesh.vertices_m)
    for (int k = 0; k < 3; ++k) bytes += rawBytes(static_cast<float>(v[k]));
  for (const Face& face : mesh.faces) {
    bytes += '\3';
    for (const int v : face) bytes += rawBytes(static_cast<std::int32_t>(v));
  }
  return bytes;
}

inline std::string asOff(const TriangleMesh& mesh) {
  return "OFF\n" + std::to_string(mesh.vertices_m.size()) + " " + std::to_string(mesh.faces.size()) + " 0\n" +
         indexedText(mesh);
}

}  // namespace fissure
