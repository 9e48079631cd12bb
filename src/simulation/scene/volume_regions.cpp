#include "scene/volume_regions.h"

#include <algorithm>
#include <string>

#include "base/error.h"

namespace fissure {

namespace {

Vec3 centroid_m(const TetrahedralMesh& mesh, std::size_t tetrahedron) {
  Vec3 sum_m = Vec3::Zero();
  for (const int corner : mesh.tetrahedra[tetrahedron])
    sum_m += mesh.vertices_m[static_cast<std::size_t>(corner)];
  return sum_m / 4;
}

bool holds(const ElasticRegion& region, const TetrahedralMesh& mesh, std::size_t tetrahedron) {
  if (region.tag) return mesh.tags[tetrahedron] == *region.tag;
  const Vec3 there_m = centroid_m(mesh, tetrahedron);
  return region.box ? region.box->holds(there_m) : region.capsule->holds(there_m);
}

}  // namespace

std::vector<int> volumeRegions(const BodySettings& body, const TetrahedralMesh& mesh) {
  const std::vector<ElasticRegion>& regions = body.elastic.regions;
  if (regions.empty()) return {};
  const std::string path = "bodies." + body.name + ".elastic.regions.";
  for (const ElasticRegion& region : regions)
    if (region.tag && mesh.tags.empty())
      throw InputError(path + region.name +
                       ".tag: the tetrahedra of the body's shape have no tags, expected box or capsule");
  std::vector<int> of_tetrahedra(mesh.tetrahedra.size(), 0);
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (std::size_t t = 0; t < of_tetrahedra.size(); ++t)
      if (holds(regions[r], mesh, t)) of_tetrahedra[t] = static_cast<int>(r) + 1;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (std::find(of_tetrahedra.begin(), of_tetrahedra.end(), static_cast<int>(r) + 1) == of_tetrahedra.end())
      throw InputError(path + regions[r].name +
                       " holds no tetrahedron that no later region has, expected at least one");
  return of_tetrahedra;
}

}  // namespace fissure
