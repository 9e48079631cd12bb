// Tetrahedra from files: what a file holds comes in, in every format; what is wrong with it is one line.
#include "volume/tetrahedra_file.h"

#include <gtest/gtest.h>

#include "../mesh/mesh_files.h"
#include "base/error.h"
#include "mesh/check.h"
#include "mesh/tetrahedra_check.h"

namespace fissure::tetrahedra_file_test {

namespace {

/// Two tetrahedra on the triangle 1 2 3, in millimetres, one of them the wrong way round; vertex 2 of the
/// file is part of none.
const char* const kGmsh2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
3 7 "parenchyma"
3 9 "vessel"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 50 50 50
3 10 0 0
4 0 10 0
5 0 0 10
6 10 10 10
$EndNodes
$Elements
3
1 15 2 0 1 1
2 4 2 7 1 1 3 4 5
3 4 2 9 2 3 4 5 6
$EndElements
)";

const char* const kGmsh4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 0 2
1 0 0 0 10 10 10 1 7 0
2 0 0 0 10 10 10 1 9 0
$EndEntities
$Nodes
1 6 1 6
3 1 0 6
1
2
3
4
5
6
0 0 0
50 50 50
10 0 0
0 10 0
0 0 10
10 10 10
$EndNodes
$Elements
2 2 1 2
3 1 4 1
1 1 3 4 5
3 2 4 1
2 3 4 5 6
$EndElements
)";

const char* const kVtk = R"(# vtk DataFile Version 3.0
two tetrahedra
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 6 double
0 0 0
50 50 50
10 0 0
0 10 0
0 0 10
10 10 10
CELLS 2 10
4 0 2 3 4
4 2 3 4 5
CELL_TYPES 2
10
10
CELL_DATA 2
SCALARS region int 1
LOOKUP_TABLE default
7
9
)";

/// What readTetrahedra says of a file, or "nothing".
std::string errorOf(const std::filesystem::path& file) {
  try {
    readTetrahedra(file, 1e-3);
  } catch (const InputError& error) {
    return error.text();
  }
  return "nothing";
}

void expectTheTwo(const BoundedVolume& volume, const std::string& name) {
  ASSERT_EQ(volume.mesh.vertices_m.size(), 5u) << name;
  ASSERT_EQ(volume.mesh.tetrahedra.size(), 2u) << name;
  EXPECT_EQ(volume.mesh.vertices_m[1], Vec3(1e-3 * 10.0, 0, 0)) << name;
  EXPECT_EQ(volume.mesh.tags, (std::vector{7, 9})) << name;
  EXPECT_TRUE(inspectTetrahedra(volume.mesh, volume.surface).empty()) << name;
  EXPECT_TRUE(inspectSurface(volume.surface).empty()) << name;
  EXPECT_EQ(volume.surface.faces.size(), 6u) << name;
  const double sixth_m3 = 1e-9 * 1000 / 6;
  EXPECT_NEAR(qualityOf(volume.mesh).volume_m3, 3 * sixth_m3, 1e-20) << name;
  ASSERT_EQ(volume.notes.size(), 1u) << name;
  EXPECT_EQ(volume.notes[0], "1 vertex of no tetrahedron left out");
}

TEST(TetrahedraFile, IsReadFromEachFormatAsText) {
  const ScratchFolder folder;
  for (const auto& [name, text] :
       {std::pair("two.msh", kGmsh2), std::pair("four.MSH", kGmsh4), std::pair("grid.vtk", kVtk)})
    expectTheTwo(readTetrahedra(folder.write(name, text), 1e-3), name);
}

TEST(TetrahedraFile, IsReadFromEachFormatInBinary) {
  const ScratchFolder folder;
  folder.write("text.msh", kGmsh2);
  const std::string folder_name = folder.path().string();
  const std::string script =
      "import meshio, numpy\n"
      "m = meshio.read('" +
      folder_name +
      "/text.msh')\n"
      "m = meshio.Mesh(m.points, [c for c in m.cells if c.type == 'tetra'],\n"
      "                cell_data={'gmsh:physical': [numpy.array([7]), numpy.array([9])],\n"
      "                           'gmsh:geometrical': [numpy.array([1]), numpy.array([2])]}\n"
      "                if len([c for c in m.cells if c.type == 'tetra']) == 2 else\n"
      "                {'gmsh:physical': [numpy.array([7, 9])], 'gmsh:geometrical': [numpy.array([1, 2])]})\n"
      "meshio.write('" +
      folder_name +
      "/binary2.msh', m, file_format='gmsh22', binary=True)\n"
      "m.cell_data = {'region': m.cell_data['gmsh:physical']}\n"
      "meshio.write('" +
      folder_name + "/binary.vtk', m, file_format='vtk', binary=True)\n";
  folder.write("write.py", script);
  ASSERT_EQ(std::system(("/usr/bin/python3 " + folder_name + "/write.py > /dev/null 2>&1").c_str()), 0);
  expectTheTwo(readTetrahedra(folder.path() / "binary2.msh", 1e-3), "binary2.msh");
  expectTheTwo(readTetrahedra(folder.path() / "binary.vtk", 1e-3), "binary.vtk");
}

TEST(TetrahedraFile, IsRefusedWithALineWhereItIsBad) {
  const ScratchFolder folder;
  const std::string two = kGmsh2;
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = two;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(errorOf(folder.write("a.txt", two)), "no known file of tetrahedra, expected .msh or .vtk");
  EXPECT_EQ(errorOf(folder.write("empty.msh", "")), "is empty, expected a mesh");
  EXPECT_NE(errorOf(folder.path() / "missing.msh"), "nothing");
  EXPECT_EQ(errorOf(folder.write("cut.msh", two.substr(0, two.size() - 20))).substr(0, 14), "cannot be read");
  const std::string grid = kVtk;
  EXPECT_EQ(errorOf(folder.write("cut.vtk", grid.substr(0, 200))).substr(0, 14), "cannot be read");
  EXPECT_EQ(errorOf(folder.write("noise.msh", "noise\n")).substr(0, 14), "cannot be read");
  EXPECT_EQ(errorOf(folder.write("noise.vtk", std::string("\x7f\0\n\n", 4))).substr(0, 14), "cannot be read");
  EXPECT_EQ(errorOf(folder.write("none.msh", replaced("3\n1 15 2 0 1 1\n2 4 2 7 1 1 3 4 5\n3 4 2 9 2 3 4 5 6",
                                                      "1\n1 15 2 0 1 1"))),
            "has no tetrahedra, expected a volume");
  EXPECT_NE(errorOf(folder.write("beyond.msh", replaced("2 3 4 5 6\n", "2 3 4 5 99\n"))), "nothing");
  EXPECT_EQ(
      errorOf(folder.write("hexahedron.msh", replaced("3 4 2 9 2 3 4 5 6", "3 5 2 9 2 1 2 3 4 5 6 1 2"))),
      "has 1 cells of type hexahedron, expected tetrahedra alone");
}

TEST(TetrahedraFile, PutsTheSurfaceFirstAndTurnsWhatIsInverted) {
  TetrahedralMesh mesh;
  // The middle comes first in the file, and is inside; four tetrahedra around it, one turned.
  mesh.vertices_m = {Vec3(0.1, 0.1, 0.1), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  mesh.tetrahedra = {{0, 2, 3, 4}, {1, 0, 3, 4}, {1, 2, 0, 4}, {2, 1, 3, 0}};
  const BoundedVolume volume = boundedBySurface(mesh);
  EXPECT_EQ(volume.surface.vertices_m.size(), 4u);
  EXPECT_EQ(volume.mesh.vertices_m[4], mesh.vertices_m[0]);
  EXPECT_TRUE(inspectTetrahedra(volume.mesh, volume.surface).empty());
  ASSERT_EQ(volume.notes.size(), 1u);
  EXPECT_EQ(volume.notes[0], "1 tetrahedron turned, whose corners ran the other way round");
}

}  // namespace

}  // namespace fissure::tetrahedra_file_test
