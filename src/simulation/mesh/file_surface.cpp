#include "mesh/file_surface.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "mesh/file_mesh.h"
#include "mesh/repair.h"
#include "mesh/subdivide.h"
#include "mesh/weld.h"
#include "scenario/catalog.h"

namespace fissure {
namespace {

/// No organ and no tool is smaller or larger, in its longest direction.
constexpr double least_extent_m = 1e-3, most_extent_m = 2.0;

/// What most of them have.
constexpr double usual_least_m = 5e-3, usual_most_m = 0.5;

/// A size that no body has is a wrong unit: which one it may be. The mesh is in the file's unit.
std::vector<Defect> sizeDefects(const TriangleMesh& mesh, LengthUnit stated) {
  Eigen::AlignedBox3d bounds;
  for (const Vec3& vertex : mesh.vertices_m)
    if (vertex.allFinite()) bounds.extend(vertex);
  if (bounds.isEmpty()) return {};
  const double extent_m = bounds.sizes().maxCoeff() * metres(stated);
  if (extent_m >= least_extent_m && extent_m <= most_extent_m) return {};
  std::string text = fmt::format("size beyond reason ({:.3g} m across, expected {:.3g} to {:.3g} m", extent_m,
                                 least_extent_m, most_extent_m);
  std::string suspects;
  for (const LengthUnit unit : {LengthUnit::m, LengthUnit::cm, LengthUnit::mm}) {
    const double as_m = extent_m / metres(stated) * metres(unit);
    if (as_m < usual_least_m || as_m > usual_most_m) continue;
    suspects += (suspects.empty() ? "" : " or ") + nameIn(catalog().length_units, unit);
  }
  if (!suspects.empty()) text += ": is the unit " + suspects + "?";
  return {{DefectKind::size, 1, text + ")"}};
}

/// "; size beyond reason (...)" where the size is.
std::string sizeHint(const std::vector<Defect>& defects) {
  for (const Defect& defect : defects)
    if (defect.kind == DefectKind::size) return "; " + defect.text;
  return "";
}

std::vector<Defect> inspect(const TriangleMesh& mesh, LengthUnit unit) {
  std::vector<Defect> defects = inspectSurface(mesh, metres(unit));
  const std::vector<Defect> size = sizeDefects(mesh, unit);
  defects.insert(defects.end(), size.begin(), size.end());
  return defects;
}

bool isFinite(const TriangleMesh& mesh) {
  return std::all_of(mesh.vertices_m.begin(), mesh.vertices_m.end(),
                     [](const Vec3& v) { return v.allFinite(); });
}

/// What the shape asks for of the mesh that was `read` from `file`.
FileSurface surfaceFrom(const FileShape& shape, const std::filesystem::path& file, FileMesh read) {
  const double unit_m = metres(shape.unit);
  FileSurface surface;
  TriangleMesh& mesh = surface.mesh;
  // In the file's unit to the end: three points of a line are none any more when they have been scaled.
  mesh = std::move(read.mesh);
  weldVertices(mesh, shape.weld_tolerance_m / unit_m);
  surface.found = inspect(mesh, shape.unit);
  surface.left = surface.found;
  if (isFinite(mesh)) {
    surface.repairs = repairMesh(mesh, shape.repairs);
    if (shape.max_edge_m && !subdivide(mesh, *shape.max_edge_m / unit_m, most_triangles))
      throw InputError(inFile(file),
                       fmt::format("max_edge_m {:.3g} makes more than {} triangles, expected fewer{}",
                                   *shape.max_edge_m, most_triangles, sizeHint(surface.found)));
    surface.left = inspect(mesh, shape.unit);
  }
  surface.left.insert(surface.left.end(), read.oddities.begin(), read.oddities.end());
  for (Vec3& vertex : mesh.vertices_m) vertex *= unit_m;
  return surface;
}

}  // namespace

FileSurface loadSurface(const FileShape& shape, const std::filesystem::path& directory) {
  const std::filesystem::path file = directory / shape.file;
  return surfaceFrom(shape, file, readMeshFile(file));
}

const FileSurface& SurfaceFiles::surface(const FileShape& shape) const {
  const auto same = [&](const auto& kept) { return kept.first == shape; };
  if (const auto known = std::find_if(surfaces_.begin(), surfaces_.end(), same); known != surfaces_.end())
    return known->second;
  const std::filesystem::path file = directory_ / shape.file;
  auto mesh = meshes_.find(file);
  if (mesh == meshes_.end()) mesh = meshes_.emplace(file, readMeshFile(file)).first;
  return surfaces_.emplace_back(shape, surfaceFrom(shape, file, mesh->second)).second;
}

}  // namespace fissure
