#pragma once

#include <filesystem>
#include <string>

namespace fissure {

enum class MeshFormat { stl, obj, ply, off };

/// The contents of a mesh file, as far as they can be judged without reading its triangles.
struct MeshText {
  MeshFormat format = MeshFormat::stl;
  std::string bytes;  ///< of OBJ without its lines about materials, which would name further files
};

/// Reads a file and checks what a reader would stumble over: that it is there and no folder, its size, that
/// it begins as its format does, and that it is long enough for the counts it states. Throws InputError.
MeshText readMeshText(const std::filesystem::path& file);

}  // namespace fissure
