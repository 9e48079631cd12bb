#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "paraview/moving_mesh.h"

namespace fissure {

/// Names of the files that exportRun() writes: one file per mesh, <run>.tissue.vtkhdf and so on, and last
/// <run>.xdmf, which shows them together.
std::vector<std::string> exportNames(const std::string& run, const MovingMeshes& meshes);

/// Writes these files into `folder`, which must exist. They are independent of the result and can be moved
/// together. Each file appears complete or not at all, the .xdmf last; existing files are replaced. With
/// `remove_stale` a mesh file of an earlier export for which this run has no mesh is removed. Throws RunError
/// when writing fails and InputError when the result is damaged.
void exportRun(const std::filesystem::path& folder, const std::string& run, const MovingMeshes& meshes,
               bool remove_stale);

}  // namespace fissure
