#pragma once

#include <filesystem>
#include <string>

namespace fissure {

enum class MeshFormat { stl, obj, ply, off };

/// The contents of a mesh file, as far as they can be judged without reading its triangles.
struct MeshText {
  MeshFormat format = MeshFormat::stl;
  std::string bytes;  ///< of OBJ with its lines about materials, which name further files, as comments
};

/// Reads a file and checks what a reader would stumble over: that it is a regular file, its size, that
/// it begins as its format does, and that it is long enough for the counts it states. Throws InputError.
MeshText readMeshText(const std::filesystem::path& file);

}  // namespace fissure
