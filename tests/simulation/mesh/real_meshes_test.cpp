#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "mesh/file_surface.h"

namespace fissure::real_meshes_test {

namespace {

using Counts = std::map<DefectKind, std::size_t>;
using enum DefectKind;

Counts countsOf(const std::vector<Defect>& defects) {
  Counts counts;
  for (const Defect& defect : defects) counts[defect.kind] = defect.count;
  return counts;
}

struct RealMesh {
  const char* name;
  const char* file;  ///< below the data folder
  LengthUnit unit;
  std::size_t triangles;
  Counts counts;  ///< all there are
};

void PrintTo(const RealMesh& mesh, std::ostream* stream) {
  *stream << mesh.file;
}

/// Meshes as others made them, with defects counted by others. FISSURE_DATA names a folder that has them;
/// those below configs/meshes are tested everywhere.
class RealMeshes : public testing::TestWithParam<RealMesh> {};

TEST_P(RealMeshes, HaveTheDefectsThatTheyAreKnownFor) {
  const RealMesh& real = GetParam();
  const char* given = std::getenv("FISSURE_DATA");
  const std::filesystem::path folder = given ? given : FISSURE_SOURCE_DIR "/configs/meshes";
  if (!given && !std::filesystem::exists(folder / real.file))
    GTEST_SKIP() << "FISSURE_DATA names no folder with meshes";
  FileShape shape;
  shape.file = real.file;
  shape.unit = real.unit;
  const FileSurface surface = loadSurface(shape, folder);
  EXPECT_EQ(surface.mesh.faces.size(), real.triangles);
  EXPECT_EQ(countsOf(surface.found), real.counts);
}

INSTANTIATE_TEST_SUITE_P(
    Sources, RealMeshes,
    testing::Values(
        RealMesh{"jaw_left", "sofa_env/scissors_jaw_left.stl", LengthUnit::mm, 90, {}},
        RealMesh{"jaw_right", "sofa_env/scissors_jaw_right.stl", LengthUnit::mm, 88, {}},
        RealMesh{"gallbladder", "sofa_env/gallbladder_collision.stl", LengthUnit::mm, 500, {}},
        RealMesh{"sheet", "sofa_env/tissue_surface.obj", LengthUnit::m, 892, {}},
        RealMesh{"vessel", "sofa_env/J2-Naviworks.stl", LengthUnit::mm, 1192, {{boundary_edges, 60}}},
        RealMesh{"atraumatic",
                 "sofa_env/atraumatic_forceps_jaw_left.stl",
                 LengthUnit::mm,
                 496,
                 {{degenerate_triangles, 3}, {sliver_triangles, 57}, {boundary_edges, 10}, {shells, 2}}},
        RealMesh{"forceps",
                 "sofa_env/forceps_jaw_right.stl",
                 LengthUnit::mm,
                 2734,
                 {{degenerate_triangles, 1},
                  {sliver_triangles, 34},
                  {duplicate_faces, 3},
                  {non_manifold_edges, 3},
                  {inconsistent_edges, 6}}},
        RealMesh{"liver",
                 "sofa_env/liver_collision_grasp.stl",
                 LengthUnit::mm,
                 479,
                 {{degenerate_triangles, 1},
                  {duplicate_faces, 3},
                  {boundary_edges, 31},
                  {non_manifold_edges, 2},
                  {inconsistent_edges, 32},
                  {shells, 16}}},
        RealMesh{"gripper",
                 "sofa_env/gripper_15deg_collision.stl",
                 LengthUnit::m,
                 193,
                 {{boundary_edges, 19}, {non_manifold_edges, 6}, {inconsistent_edges, 6}, {shells, 3}}},
        RealMesh{"spike", "erleben/spike.obj", LengthUnit::cm, 6, {}},
        RealMesh{"wedge", "erleben/wedge.obj", LengthUnit::cm, 8, {}},
        RealMesh{"cliff", "erleben/cliff.obj", LengthUnit::cm, 12, {}},
        RealMesh{"hole", "erleben/hole.obj", LengthUnit::cm, 88, {{boundary_edges, 12}}},
        RealMesh{"teddy", "bullet/teddy.obj", LengthUnit::mm, 3192, {}}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace fissure::real_meshes_test
