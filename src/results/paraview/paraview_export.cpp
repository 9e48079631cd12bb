#include "paraview/paraview_export.h"

#include <algorithm>
#include <array>
#include <memory>

#include "base/error.h"
#include "files/temporary_file.h"
#include "hdf5/output_file.h"
#include "paraview/vtk_file.h"
#include "paraview/xdmf.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> mesh_names = {"tissue", "tools", "nodes"};

std::string meshFile(const std::string& run, const std::string& mesh) {
  return run + "." + mesh + ".vtkhdf";
}

void writeText(const fs::path& target, const std::string& text) {
  TemporaryFile temporary(target);
  temporary.write(text);
  temporary.commit();
}

std::unique_ptr<ReplacementFile> writeMesh(const fs::path& target, const MovingMesh& mesh,
                                           const std::vector<double>& times_s) {
  auto replacement = std::make_unique<ReplacementFile>(target);
  writeVtkFile(replacement->file(), mesh, times_s);
  replacement->close();
  return replacement;
}

}  // namespace

std::vector<std::string> exportNames(const std::string& run, const MovingMeshes& meshes) {
  std::vector<std::string> names;
  for (const MovingMesh& mesh : meshes.meshes) names.push_back(meshFile(run, mesh.name));
  names.push_back(run + ".xdmf");
  return names;
}

void exportRun(const fs::path& folder, const std::string& run, const MovingMeshes& meshes,
               bool remove_stale) {
  std::vector<std::string> files = exportNames(run, meshes);
  const std::string document = files.back();
  files.pop_back();
  std::string file;
  try {
    std::vector<std::unique_ptr<ReplacementFile>> replacements;
    for (std::size_t i = 0; i < files.size(); ++i) {
      file = files[i];
      replacements.push_back(writeMesh(folder / file, meshes.meshes[i], meshes.times_s));
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
      file = files[i];
      replacements[i]->commit();
    }
    file = document;
    writeText(folder / file, xdmfText(meshes, files));
  } catch (const RunError& error) {
    throw RunError((folder / file).string() + ": " + error.what());
  }
  if (!remove_stale) return;
  std::error_code ignored;
  for (const char* mesh : mesh_names)
    if (const std::string name = meshFile(run, mesh);
        std::find(files.begin(), files.end(), name) == files.end())
      fs::remove(folder / name, ignored);
}

}  // namespace fissure
