#pragma once

#include <filesystem>
#include <string>

namespace fissure {

enum class MeshFormat { stl, obj, ply, off };

/// The contents of a mesh file, as far as they can be judged without reading its triangles.
struct MeshText {
  MeshFormat format = MeshFormat::stl;
  /// Whole contents; in OBJ the lines about materials, which name further files, are made comments.
  std::string bytes;
};

/// Reads a mesh file and checks it as far as a reader depends on it: that it is a regular file of an allowed
/// size, begins as its format does, and is long enough for the counts that it states. Throws InputError about
/// the file otherwise.
MeshText readMeshText(const std::filesystem::path& file);

}  // namespace fissure
