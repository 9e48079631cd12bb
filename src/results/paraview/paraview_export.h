#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "paraview/moving_mesh.h"

namespace fissure {

/// Names of the files that exportRun() writes for a run: <run>.tissue.vtkhdf and so on, a file a mesh, and
/// last <run>.xdmf, which shows them together.
std::vector<std::string> exportNames(const std::string& run, const MovingMeshes& meshes);

/// Writes them into `folder`, which exists. They hold all they show, so that they can be moved, together, and
/// outlive the result. Each appears whole or not at all, the .xdmf last; files of these names are replaced,
/// and where `remove_stale` a mesh file of an earlier export that this run has no mesh for is removed. Throws
/// RunError, and InputError where the result is damaged.
void exportRun(const std::filesystem::path& folder, const std::string& run, const MovingMeshes& meshes,
               bool remove_stale);

}  // namespace fissure
