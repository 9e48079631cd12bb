// Reading mesh files. The meshes are made here and written in each format.
#include "mesh/file_mesh.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/error.h"
#include "defect_lines.h"
#include "mesh/check.h"
#include "mesh/file_surface.h"
#include "mesh/primitives.h"
#include "mesh/weld.h"
#include "mesh_files.h"

namespace fissure::file_mesh_test {

namespace {

/// 32 triangles, 18 vertices, coordinates that single precision holds.
TriangleMesh ball() {
  TriangleMesh mesh = makeSphere(30, 1);
  for (Vec3& v : mesh.vertices_m) v = (1024 * v).array().round() / 1024;
  return mesh;
}

template <class Work>
std::string inputError(Work work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

class MeshFile : public testing::Test {
 protected:
  std::string refusal(const std::string& name, const std::string& bytes) {
    const std::filesystem::path file = folder_.write(name, bytes);
    std::string message = inputError([&] { readMeshFile(file); });
    const std::string where = file.string() + ": ";
    EXPECT_EQ(message.rfind(where, 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message.substr(std::min(where.size(), message.size()));
  }
  ScratchFolder folder_;
};

std::string replaced(std::string text, char what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, 1, with);
  return text;
}

// Assimp ends a line at each of these; the material library of asObj does not exist.
TEST_F(MeshFile, AnyLineEndOfObjHidesMaterials) {
  const TriangleMesh mesh = ball();
  for (const std::string end : {"\n", "\r\n", "\r", "\f"}) {
    const TriangleMesh read = readMeshFile(folder_.write("a.obj", replaced(asObj(mesh), '\n', end))).mesh;
    EXPECT_EQ(read.faces.size(), mesh.faces.size());
  }
}

// A pipe that nobody writes to: opening it would never end.
TEST_F(MeshFile, NoOtherFileIsOpened) {
  const std::filesystem::path pipe = folder_.path() / "materials";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  ::alarm(60);
  const std::string mesh = asObj(ball());
  for (const std::string line : {"\rmtllib ", "\n\tmtllib ", "\nmtllib\t", "\f mtllib "})
    EXPECT_NO_THROW(readMeshFile(folder_.write("a.obj", mesh + line + pipe.string() + "\n")));
  EXPECT_EQ(
      refusal("b.obj", mesh + "mtl\\\nlib " + pipe.string() + "\n").rfind("cannot be read as a mesh (", 0),
      0u);
  ::alarm(0);
}

// Assimp skips what follows them up to the next line feed.
TEST_F(MeshFile, OddLineEndsOfPlyAreRefused) {
  const TriangleMesh mesh = ball();
  EXPECT_EQ(readMeshFile(folder_.write("a.ply", replaced(asTextPly(mesh), '\n', "\r\n"))).mesh.faces.size(),
            mesh.faces.size());
  for (const std::string end : {"\r", "\f"}) {
    const std::string text = replaced(plyHeader(mesh, "ascii"), '\n', end);
    EXPECT_NE(refusal("b.ply", text + indexedText(mesh)).find("within a line"), std::string::npos);
    EXPECT_NE(refusal("c.ply", plyHeader(mesh, "ascii") + replaced(indexedText(mesh), '\n', end) + "\n")
                  .find("within a line"),
              std::string::npos);
  }
}

TEST_F(MeshFile, CommentsOfOffEndAtAnyLineEnd) {
  const TriangleMesh mesh = ball();
  for (const std::string end : {"\n", "\r"}) {
    const std::string text = "OFF# of nothing" + end + asOff(mesh).substr(4);
    EXPECT_EQ(readMeshFile(folder_.write("a.off", text)).mesh.faces.size(), mesh.faces.size());
  }
}

TEST_F(MeshFile, EveryFormatGivesTheSameTriangles) {
  const TriangleMesh mesh = ball();
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.stl", asBinaryStl(mesh)}, {"b.STL", asTextStl(mesh)},   {"c.obj", asObj(mesh)},
      {"d.ply", asTextPly(mesh)},   {"e.ply", asBinaryPly(mesh)}, {"f.off", asOff(mesh)}};
  for (const auto& [name, bytes] : files) {
    TriangleMesh read = readMeshFile(folder_.write(name, bytes)).mesh;
    ASSERT_EQ(read.faces.size(), mesh.faces.size()) << name;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(read.vertices_m[read.faces[f][k]], mesh.vertices_m[mesh.faces[f][k]]) << name << f;
    weldVertices(read, 0);
    EXPECT_EQ(read.vertices_m.size(), mesh.vertices_m.size()) << name;
    EXPECT_EQ(findDefects(read), std::vector<std::string>{}) << name;
  }
}

TEST_F(MeshFile, PolygonsBecomeTriangles) {
  // A cube of six squares.
  const std::string quads =
      "OFF\n8 6 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
      "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  const TriangleMesh cube = readMeshFile(folder_.write("cube.off", quads)).mesh;
  EXPECT_EQ(cube.faces.size(), 12u);
  EXPECT_EQ(findDefects(cube), std::vector<std::string>{});
  EXPECT_NEAR(signedVolume_m3(cube), 1, 1e-6);
}

TEST_F(MeshFile, SeveralSolidsAreOneSurface) {
  TriangleMesh other = ball();
  for (Vec3& v : other.vertices_m) v *= 2;
  const TriangleMesh both = readMeshFile(folder_.write("two.stl", asTextStl(ball()) + asTextStl(other))).mesh;
  EXPECT_EQ(both.faces.size(), 2 * other.faces.size());
  EXPECT_EQ(both.vertices_m[both.faces.back()[2]], other.vertices_m[other.faces.back()[2]]);
}

TEST_F(MeshFile, WhatIsNoMeshIsRefusedInOneLine) {
  EXPECT_EQ(refusal("a.stl", ""), "is empty, expected a mesh");
  EXPECT_EQ(refusal("a.txt", "solid"), "no known kind of mesh, expected .stl, .obj, .ply or .off");
  EXPECT_EQ(refusal("a.stl", "garbage"), "is no STL file, it is too short for one");
  EXPECT_EQ(refusal("a.ply", "garbage"), "is no PLY file, expected a header from ply to end_header");
  EXPECT_EQ(refusal("a.off", "garbage"), "is no OFF file");
  EXPECT_EQ(refusal("a.obj", std::string("\x7f\x45LF\0\1", 6)), "is no OBJ file, it is not text");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), "has no faces, expected a surface");
  EXPECT_NE(inputError([&] { readMeshFile(folder_.path() / "none.stl"); }).find("no such file"),
            std::string::npos);
  std::filesystem::create_directory(folder_.path() / "folder.stl");
  EXPECT_NE(inputError([&] { readMeshFile(folder_.path() / "folder.stl"); }).find("is a folder"),
            std::string::npos);
}

TEST_F(MeshFile, CountsThatLieAreRefused) {
  std::string stl = asBinaryStl(ball());
  const auto stating = [&](std::uint32_t count) { return stl.replace(80, 4, rawBytes(count)); };
  EXPECT_EQ(
      refusal("more.stl", stating(4000000000u)),
      "as a binary STL file it would hold 4000000000 triangles in 200000000084 bytes, but it has 1684 (a "
      "damaged file)");
  EXPECT_EQ(refusal("fewer.stl", stating(10)),
            "as a binary STL file it would hold 10 triangles in 584 bytes, but it has 1684 (a damaged file)");
  std::string ply = asTextPly(ball());
  const std::size_t at = ply.find("vertex 18");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(refusal("more.ply", ply.replace(at, 9, "vertex 4000000000")),
            "ends before all that its header states (a damaged file)");
  EXPECT_NE(refusal("more.off", "OFF\n3 4000000000 0\n0 0 0\n").find("states 4e+09 faces"),
            std::string::npos);
}

TEST_F(MeshFile, CornersThatDoNotExistAreRefused) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_NE(refusal("a.obj", vertices + "f 1 2 4\n").find("out of range"), std::string::npos);
  EXPECT_EQ(refusal("b.obj", vertices + "f 1 2 3\nf 1 2\n"),
            "1 of its 2 faces have fewer than three corners, expected triangles or polygons");
  std::string ply = asTextPly(ball());
  ply.replace(ply.rfind("\n3 ") + 1, 2, "3 99");
  EXPECT_EQ(refusal("c.ply", ply), "1 of its 32 faces name a vertex that does not exist (a damaged file)");
}

TEST_F(MeshFile, CutFilesAreRefusedOrHaveHoles) {
  // OBJ states no counts: one that ends after a line is a smaller mesh, which is not closed.
  for (const auto& [name, bytes] : {std::pair{"a.stl", asBinaryStl(ball())},
                                    {"b.stl", asTextStl(ball())},
                                    {"c.ply", asTextPly(ball())},
                                    {"d.ply", asBinaryPly(ball())},
                                    {"d.off", asOff(ball())}})
    for (const double share : {0.1, 0.5, 0.9})
      EXPECT_NE(refusal(name, bytes.substr(0, static_cast<std::size_t>(share * bytes.size()))), "no error")
          << name << share;
}

FileShape shapeOf(const std::string& name, LengthUnit unit) {
  FileShape shape;
  shape.file = name;
  shape.unit = unit;
  return shape;
}

TEST_F(MeshFile, IsScaledByItsUnit) {
  folder_.write("ball.off", asOff(ball()));
  EXPECT_EQ(loadSurface(shapeOf("ball.off", LengthUnit::mm), folder_.path()).mesh.vertices_m[0].x(),
            30 * 1e-3);
  EXPECT_EQ(loadSurface(shapeOf("ball.off", LengthUnit::cm), folder_.path()).mesh.vertices_m[0].x(),
            30 * 1e-2);
  EXPECT_EQ(loadSurface(shapeOf("ball.off", LengthUnit::m), folder_.path()).mesh.vertices_m[0].x(), 30);
}

TEST_F(MeshFile, ASizeBeyondReasonSuspectsTheUnit) {
  folder_.write("ball.off", asOff(ball()));  // 60 of something across
  TriangleMesh small = ball();
  for (Vec3& v : small.vertices_m) v *= 0.001;
  folder_.write("small.off", asOff(small));
  const auto sizes = [&](const FileShape& shape) {
    std::vector<std::string> texts;
    for (const Defect& defect : loadSurface(shape, folder_.path()).left)
      if (defect.kind == DefectKind::size) texts.push_back(defect.text);
    return texts;
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(sizes(shapeOf("ball.off", LengthUnit::mm)), Lines{});
  EXPECT_EQ(sizes(shapeOf("ball.off", LengthUnit::m)),
            Lines{"size beyond reason (60 m across, expected 0.001 to 2 m: is the unit mm?)"});
  EXPECT_EQ(sizes(shapeOf("small.off", LengthUnit::mm)),
            Lines{"size beyond reason (6e-05 m across, expected 0.001 to 2 m: is the unit m?)"});
  EXPECT_EQ(sizes(shapeOf("small.off", LengthUnit::cm)),
            Lines{"size beyond reason (0.0006 m across, expected 0.001 to 2 m: is the unit m?)"});
}

TEST_F(MeshFile, NonFiniteVerticesAreToldAndNotRepaired) {
  TriangleMesh bad = ball();
  bad.vertices_m[3] = Vec3::Constant(std::nan(""));
  folder_.write("bad.ply", asBinaryPly(bad));
  FileShape shape = shapeOf("bad.ply", LengthUnit::mm);
  shape.repairs = {MeshRepair::orient, MeshRepair::cap_holes};  // of no use here
  const FileSurface surface = loadSurface(shape, folder_.path());
  ASSERT_EQ(surface.left.size(), 1u);
  EXPECT_EQ(surface.left[0].text, "1 non-finite vertex (a coordinate is infinite or not a number)");
  EXPECT_TRUE(surface.repairs.empty());
}

TEST(Weld, JoinsEqualVerticesOnly) {
  TriangleMesh soup;
  const TriangleMesh mesh = makeSphere(1, 2);
  for (const Face& face : mesh.faces) {
    const int first = static_cast<int>(soup.vertices_m.size());
    for (const int v : face) soup.vertices_m.push_back(mesh.vertices_m[v]);
    soup.faces.push_back({first, first + 1, first + 2});
  }
  TriangleMesh welded = soup;
  weldVertices(welded, 0);
  EXPECT_EQ(welded.vertices_m.size(), mesh.vertices_m.size());
  EXPECT_EQ(findDefects(welded), std::vector<std::string>{});
  EXPECT_NEAR(signedVolume_m3(welded), signedVolume_m3(mesh), 1e-14);
  // One corner off by a billionth stays apart.
  soup.vertices_m[17].x() += 1e-9;
  TriangleMesh nearly = soup;
  weldVertices(nearly, 0);
  EXPECT_EQ(nearly.vertices_m.size(), mesh.vertices_m.size() + 1);
  EXPECT_NE(findDefects(nearly), std::vector<std::string>{});
  weldVertices(nearly, 1e-8);
  EXPECT_EQ(nearly.vertices_m.size(), mesh.vertices_m.size());
  EXPECT_EQ(findDefects(nearly), std::vector<std::string>{});
}

TEST(Weld, ToleranceIsADistanceInEveryDirection) {
  // Pairs of points around a cell's corners, a little nearer and a little farther than the tolerance.
  constexpr double tolerance = 0.1;
  for (int i = 0; i < 200; ++i) {
    const Vec3 at(0.013 * i, -0.027 * i, 0.4 - 0.031 * i);
    const Vec3 way = Vec3(std::sin(1.3 * i), std::cos(2.1 * i), std::sin(0.7 * i + 1)).normalized();
    TriangleMesh near{{at, at + 0.999 * tolerance * way}, {}};
    weldVertices(near, tolerance);
    EXPECT_EQ(near.vertices_m.size(), 1u) << i;
    TriangleMesh far{{at, at + 1.001 * tolerance * way}, {}};
    weldVertices(far, tolerance);
    EXPECT_EQ(far.vertices_m.size(), 2u) << i;
  }
}

TEST(Weld, TakesMinusZeroForZeroAndLeavesNanAlone) {
  const double nan = std::nan("");
  TriangleMesh mesh{{{0.0, 1, 0}, {-0.0, 1, -0.0}, {nan, 0, 0}, {nan, 0, 0}}, {}};
  weldVertices(mesh, 0);
  EXPECT_EQ(mesh.vertices_m.size(), 3u);
}

}  // namespace
}  // namespace fissure::file_mesh_test
