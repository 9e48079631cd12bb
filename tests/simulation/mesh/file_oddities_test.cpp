// What is odd about a mesh file that its triangles do not show.
#include <gtest/gtest.h>

#include "mesh/file_mesh.h"
#include "mesh/file_surface.h"
#include "mesh/obj_vertices.h"
#include "mesh_files.h"

namespace fissure::file_oddities_test {

namespace {

/// The corners of a cube of 40 mm, one of them lifted by `lift`: the square on top is bent then.
std::string corners(const char* before, double lift) {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const double x = (i & 1) ? 40 : 0, y = (i & 2) ? 40 : 0, z = (i & 4) ? 40 : 0;
    text += before + plain(Vec3(x, y, i == 7 ? z + lift : z)) + "\n";
  }
  return text;
}

const char* const obj_faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
const char* const counted_faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";

std::string plyText(double lift, const std::string& more, int vertices) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face 6\n"
         "property list uchar int vertex_indices\nend_header\n" +
         corners("", lift) + more + counted_faces;
}

class FileOddities : public testing::Test {
 protected:
  std::vector<std::string> odditiesOf(const std::string& name, const std::string& bytes) {
    std::vector<std::string> texts;
    for (const Defect& oddity : readMeshFile(folder_.write(name, bytes)).oddities) {
      EXPECT_FALSE(spoilsBody(oddity.kind));
      EXPECT_FALSE(spoilsTool(oddity.kind));
      texts.push_back(oddity.text);
    }
    return texts;
  }
  ScratchFolder folder_;
};

using Texts = std::vector<std::string>;

TEST_F(FileOddities, ACubeOfSquaresHasNone) {
  EXPECT_EQ(odditiesOf("a.obj", corners("v ", 0) + obj_faces), Texts{});
  EXPECT_EQ(odditiesOf("a.off", "OFF\n8 6 0\n" + corners("", 0) + counted_faces), Texts{});
  EXPECT_EQ(odditiesOf("a.ply", plyText(0, "", 8)), Texts{});
}

TEST_F(FileOddities, NonPlanarPolygonsAreNamedWithTheFirst) {
  // The upper square's lifted corner bends it; two more of its corner's squares only shear in their plane.
  const Texts found = odditiesOf("a.obj", corners("v ", 4) + obj_faces);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].rfind(
                "1 non-planar polygon (their triangles are the reader's choice; the first is face 1 of the "
                "file, counted from 0, bent by 1.7",
                0),
            0u)
      << found[0];
  EXPECT_EQ(odditiesOf("a.off", "OFF\n8 6 0\n" + corners("", 4) + counted_faces), found);
  EXPECT_EQ(odditiesOf("a.ply", plyText(4, "", 8)), found);
  EXPECT_EQ(odditiesOf("b.obj", corners("v ", 0.01) + obj_faces), Texts{}) << "a hundredth of a millimetre";
}

TEST_F(FileOddities, UnusedVerticesAreNamedWithTheFirst) {
  EXPECT_EQ(odditiesOf("a.obj", "# a cube\n" + corners("v ", 0) + "v 1 2 3\nv 4 5 6\n" + obj_faces),
            Texts{"2 vertices of the file in no face (the first is in line 10)"});
  EXPECT_EQ(odditiesOf("a.off", "OFF\n9 6 0\n" + corners("", 0) + "1 2 3\n" + counted_faces),
            Texts{"1 vertex of the file in no face (the first is vertex 8, counted from 0)"});
  EXPECT_EQ(odditiesOf("a.ply", plyText(0, "1 2 3\n", 9)),
            Texts{"1 vertex of the file in no face (the first is vertex 8, counted from 0)"});
}

TEST_F(FileOddities, AreLeftOfASurface) {
  folder_.write("a.obj", corners("v ", 4) + "v 1 2 3\n" + obj_faces);
  FileShape shape;
  shape.file = "a.obj";
  shape.unit = LengthUnit::mm;
  const FileSurface surface = loadSurface(shape, folder_.path());
  std::vector<DefectKind> kinds;
  for (const Defect& defect : surface.left) kinds.push_back(defect.kind);
  EXPECT_EQ(kinds, (std::vector<DefectKind>{DefectKind::non_planar_polygons, DefectKind::unused_vertices}));
}

TEST(UnusedVertices, FacesNameThemInEveryWay) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto unused = [](const std::string& text) { return unusedVertices(text).count; };
  EXPECT_EQ(unused(three + "f 1 2 3\n"), 0u);
  EXPECT_EQ(unused(three + "f 1/1/1 2//2 3/3"), 0u);
  EXPECT_EQ(unused(three + "f -3 -2 -1\n"), 0u);
  EXPECT_EQ(unused(three + "f 1 \\\n 2 \\\r\n3\r\n"), 0u);
  EXPECT_EQ(unused("f 1 2 3\n" + three), 0u) << "before its vertices";
  EXPECT_EQ(unused(three + "vn 0 0 1\nvt 0 0\nf 1 1 2\n"), 1u);
  EXPECT_EQ(unused(three + "l 1 2 3\n"), 3u) << "lines are no surface";
  EXPECT_EQ(unused(three + "f 0 9 x -7\n"), 3u);
  EXPECT_EQ(unusedVertices("v 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rf 1 2 3\r").first_line, 4);
  EXPECT_EQ(unusedVertices("\n" + three + "f 1 3 3\n").first_line, 3);
}

}  // namespace
}  // namespace fissure::file_oddities_test
