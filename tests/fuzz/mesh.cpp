#include <dlfcn.h>

#include <vector>

#include "base/error.h"
#include "mesh/file_surface.h"
#include "mesh/mesh_text.h"
#include "mesh/obj_vertices.h"
#include "target.h"

namespace fissure::fuzz {

namespace {

/// Reads and mends the surface, as a scenario may ask for.
void loadAndMend(const std::filesystem::path& file) {
  FileShape shape;
  shape.file = file.filename().string();
  for (const bool mend : {false, true}) {
    shape.weld_tolerance_m = mend ? 1e-4 : 0;
    if (mend)
      for (std::size_t i = 0; i < catalog().mesh_repairs.size(); ++i)
        shape.repairs.push_back(static_cast<MeshRepair>(i));
    FileSurface surface;
    if (!accepts(file, Refusal::file, [&] { surface = loadSurface(shape, file.parent_path()); })) return;
    const auto vertices = static_cast<int>(surface.mesh.vertices_m.size());
    for (const Face& face : surface.mesh.faces)
      for (const int v : face) require(v >= 0 && v < vertices, "corners exist");
    for (const auto* defects : {&surface.found, &surface.left})
      for (const Defect& defect : *defects)
        require(isOneLine(defect.text), "a defect is one line: " + defect.text);
    for (const std::string& repair : surface.repairs)
      require(isOneLine(repair), "a repair is one line: " + repair);
  }
}

}  // namespace

/// Any bytes are read as each of the formats, by its own reader here and with Assimp in a child process.
void takeMesh(const std::string& bytes) {
  std::vector<std::filesystem::path> readable;
  for (const char* ending : {"stl", "obj", "ply", "off"}) {
    const std::filesystem::path file = put(std::string("fuzzed.") + ending, bytes);
    MeshText text;
    if (!accepts(file, Refusal::file, [&] { text = readMeshText(file); })) continue;
    require(text.bytes.size() == bytes.size(), "no byte of a mesh is lost");
    if (text.format == MeshFormat::obj) unusedVertices(text.bytes);
    // Assimp takes any text for an OBJ: without a face there is nothing to find.
    if (text.format != MeshFormat::obj || bytes.find("f ") != std::string::npos) readable.push_back(file);
  }
  if (readable.empty()) return;
  static const void* loaded = ::dlopen("libassimp.so.5", RTLD_NOW | RTLD_LOCAL);  // once, not in every child
  require(loaded != nullptr, "Assimp is installed");
  survives("libassimp", [&] {
    for (const std::filesystem::path& file : readable) loadAndMend(file);
  });
}

}  // namespace fissure::fuzz
