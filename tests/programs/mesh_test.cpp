// Bodies from mesh files, seen from outside: what is said of them, what a result remembers, what damage does.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "program.h"
#include "scenarios.h"
#include "store/result_file.h"

namespace fissure::programs::mesh_test {
namespace {

namespace fs = std::filesystem;

const fs::path meshes = fs::path(FISSURE_SOURCE_DIR) / "configs/meshes/sofa_env";

/// The press of scenarios.h on the mesh in the file "organ.stl", which is laid a little into the ground.
std::string organScenario(const std::string& more = "") {
  return with(pressScenario(), "{type: sphere, radius_m: 0.03, subdivisions: 1}",
              "{type: file, file: organ.stl, unit: mm" + more + "}");
}

void copyMesh(const Folder& folder, const std::string& name) {
  fs::copy_file(meshes / name, folder / "organ.stl");
}

std::size_t linesWith(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Mesh, ValidateNamesEachDefectInALineAndRefuses) {
  const Folder folder;
  copyMesh(folder, "liver_collision_grasp.stl");
  folder.write("s.yaml", organScenario());
  const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(
      outcome.err,
      "s.yaml: bodies.sphere.shape: 1 degenerate triangle (without area, and so without a normal)\n"
      "s.yaml: bodies.sphere.shape: 3 duplicate faces (the same three corners as another one)\n"
      "s.yaml: bodies.sphere.shape: 31 boundary edges (the surface is open, but 31 of its 31 rim "
      "vertices nearly coincide with another: weld_tolerance_m: 2e-07 may close it)\n"
      "s.yaml: bodies.sphere.shape: 2 non-manifold edges (shared by more than two triangles)\n"
      "s.yaml: bodies.sphere.shape: 32 inconsistently oriented edges (its triangles disagree about the "
      "outside)\n"
      "s.yaml: bodies.sphere.shape: 16 shells (pieces that share no vertex)\n"
      "s.yaml: bodies.sphere.shape: cannot be simulated, expected a closed surface with outward faces\n");
  const Outcome run = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(run.code, 2);
  EXPECT_TRUE(isOneLine(run.err)) << run.err;
  EXPECT_EQ(runFissure(folder, {"plan", "s.yaml"}).err, run.err);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"organ.stl", "s.yaml"}));
}

// Metres taken for the file's millimetres: not only the triangles are too many.
TEST(Mesh, AWrongUnitIsNamedWithTheTrianglesThatItMakes) {
  const Folder folder;
  copyMesh(folder, "gallbladder_collision.stl");
  folder.write("s.yaml", with(organScenario(", max_edge_m: 0.002"), "unit: mm", "unit: m"));
  const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(outcome.err.find("max_edge_m 0.002 makes more than ") != std::string::npos &&
              outcome.err.find("; size beyond reason (") != std::string::npos &&
              outcome.err.find("is the unit mm?") != std::string::npos)
      << outcome.err;
}

std::string summaryText(const ResultInfo& info, const std::string& name) {
  for (const SummaryValue& value : info.pipelines.at(0).summary)
    if (value.name == name)
      if (const auto* text = std::get_if<std::string>(&value.value)) return *text;
  return "none";
}

/// The press of scenarios.h with a tool from a file of ours or others'.
std::string toolScenario(const fs::path& mesh, const std::string& pipeline = "fukuhara") {
  return with(
      with(pressScenario("[{pipeline: " + pipeline + "}]"), "{type: box, size_m: [0.04, 0.002, 0.015]}",
           "{type: file, file: " + mesh.string() + ", unit: mm}"),
      "    nodes: {resolution: [4, 4]}\n", "");
}

TEST(ToolMesh, OneThatIsNotConvexIsRefusedForBulletAlone) {
  const Folder folder;
  fs::copy_file(meshes.parent_path() / "hooked_spatula.obj", folder / "hook.obj");
  folder.write("s.yaml", toolScenario("hook.obj", "default"));
  const Outcome refused = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err,
            "s.yaml: tools.spatula.shape is not convex and closed, and run default (pipeline default) needs "
            "that, expected pipelines raycast, fukuhara and swept alone\n");
  folder.write("s.yaml", toolScenario("hook.obj"));
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  EXPECT_NE(runFissure(folder, {"plan", "s.yaml"}).out.find("252 triangles"), std::string::npos);
}

// It is measured as far as an open surface allows, and the result says what is not.
TEST(ToolMesh, AnOpenOneIsUsedAndWhatNeedsItsInsideIsNamed) {
  const Folder folder;
  fs::copy_file(meshes / "atraumatic_forceps_jaw_left.stl", folder / "jaw.stl");
  folder.write("s.yaml", toolScenario("jaw.stl"));
  EXPECT_NE(runFissure(folder, {"validate", "s.yaml"}).out.find("10 boundary edges"), std::string::npos);
  const Outcome run = runFissure(folder, {"run", "s.yaml", "-o", "out.h5"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(summaryText(readResultInfo(folder / "out.h5"), "not_measured"),
            "depth of tissue vertices in tools whose surface is open: spatula");
}

TEST(ToolMesh, TooManyNodesAreRefusedBeforeARun) {
  const Folder folder;
  fs::copy_file(meshes.parent_path() / "hooked_spatula.obj", folder / "hook.obj");
  folder.write("s.yaml", with(toolScenario("hook.obj"),
                              "    motion:", "    nodes: {max_spacing_m: 1e-5}\n    motion:"));
  const Outcome outcome = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err,
            "s.yaml: tools.spatula.nodes.max_spacing_m: in more than 131072 triangles, expected fewer\n");
}

TEST(ToolMesh, WhatAPipelineCannotMeetIsRefusedForIt) {
  const Folder folder;
  fs::copy_file(meshes.parent_path() / "convex_spatula.obj", folder / "tool.obj");
  folder.write("s.yaml", toolScenario("tool.obj", "prescribed"));
  EXPECT_EQ(
      runFissure(folder, {"run", "s.yaml"}).err,
      "s.yaml: tools.spatula.shape is no box, and run prescribed (pipeline prescribed) needs one, expected "
      "another pipeline\n");
  folder.write("sheet.obj", "v 0 0 0\nv 40 0 0\nv 40 0 15\nv 0 0 15\nf 1 3 2\nf 1 4 3\n");
  folder.write("s.yaml", toolScenario("sheet.obj"));
  const Outcome sheet = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(sheet.code, 2);
  EXPECT_EQ(
      sheet.err,
      "s.yaml: tools.spatula.shape gives no triangle a node (no ray back into it leaves it again), and run "
      "fukuhara (pipeline fukuhara) needs nodes, expected outward faces on both its sides, or "
      "nodes.lone_nodes\n");
}

TEST(ToolMesh, OneWhoseFacesDisagreeIsRefused) {
  const Folder folder;
  fs::copy_file(meshes / "liver_collision_grasp.stl", folder / "tool.stl");
  folder.write("s.yaml", toolScenario("tool.stl"));
  const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(
      outcome.err.find("s.yaml: tools.spatula.shape: cannot be used, expected faces that agree about the "
                       "outside\n"),
      std::string::npos)
      << outcome.err;
}

TEST(Mesh, AWrongUnitIsSuspected) {
  const Folder folder;
  copyMesh(folder, "gallbladder_collision.stl");
  folder.write("s.yaml", with(organScenario(), "unit: mm", "unit: m"));
  const Outcome outcome = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("size beyond reason (90.2 m across, expected 0.001 to 2 m: is the unit mm?)"),
            std::string::npos)
      << outcome.err;
  folder.write("s.yaml", with(organScenario(), "resolution: [4, 4]", "resolution: [32, 32]"));
  EXPECT_EQ(runFissure(folder, {"validate", "s.yaml"}).out, "s.yaml: ok\n");
}

TEST(Mesh, RepairsAreDoneWhenAskedAndListedInTheResult) {
  const Folder folder;
  copyMesh(folder, "gallbladder_collision.stl");
  std::string stl = folder.read("organ.stl");
  // Two triangles less, a third the other way round.
  stl.resize(stl.size() - 100);
  const std::uint32_t count = 498;
  std::memcpy(stl.data() + 80, &count, sizeof count);
  std::string first = stl.substr(84 + 12, 12), second = stl.substr(84 + 24, 12);
  stl.replace(84 + 12, 12, second).replace(84 + 24, 12, first);
  folder.write("organ.stl", stl);
  folder.write("s.yaml", organScenario(", repairs: [cap_holes, orient]"));
  const Outcome checked = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_EQ(linesWith(checked.out, "shape: in the file "), 2u) << checked.out;
  EXPECT_EQ(linesWith(checked.out, "shape: repaired, "), 2u) << checked.out;
  const Outcome planned = runFissure(folder, {"plan", "s.yaml"});
  EXPECT_EQ(linesWith(planned.out, "shape: repaired, "), 2u) << planned.out;
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const std::string repairs = summaryText(readResultInfo(folder / "out.h5"), "repairs");
  EXPECT_NE(repairs.find("sphere: orient: 1 triangle turned; cap_holes: "), std::string::npos) << repairs;
  folder.write("s.yaml", organScenario());
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "none.h5"}).code, 2) << "not unasked";
}

TEST(Mesh, IsAnInputOfTheScenario) {
  const Folder folder;
  copyMesh(folder, "gallbladder_collision.stl");
  folder.write("s.yaml", organScenario(", max_edge_m: 0.01"));
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "out.h5"}).code, 0);
  const ResultInfo info = readResultInfo(folder / "out.h5");
  EXPECT_EQ(summaryText(info, "repairs"), "none");
  std::string hashes;
  for (const auto& [name, value] : info.provenance)
    if (name == "input_hashes") hashes = value;
  EXPECT_NE(hashes.find("organ.stl=sha256:"), std::string::npos) << hashes;
  // The scenario that is stored runs again to the same numbers.
  folder.write("again.yaml", info.scenario_resolved);
  EXPECT_EQ(runFissure(folder, {"run", "again.yaml", "-o", "again.h5"}).code, 0);
  EXPECT_EQ(summaryText(readResultInfo(folder / "again.h5"), "final_state_hash"),
            summaryText(info, "final_state_hash"));
  // As output it is refused.
  const Outcome refused = runFissure(folder, {"run", "s.yaml", "-o", "organ.stl", "--force"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("organ.stl: is an input of the scenario"), std::string::npos) << refused.err;
}

TEST(Mesh, ChangedUnderWayIsNoticed) {
  const Folder folder;
  copyMesh(folder, "gallbladder_collision.stl");
  folder.write("s.yaml", with(organScenario(), "duration_s: 0.03", "duration_s: 2"));
  Program run(folder, {fissureProgram(), "run", "s.yaml", "-o", "out.h5"});
  ASSERT_NE(run.waitForWorker(), 0);
  std::string stl = folder.read("organ.stl");
  stl.back() = 1;  // a colour, which no reader looks at: whichever the worker has read, it is good
  folder.write("organ.stl", stl);
  EXPECT_EQ(run.wait().code, 3);
  EXPECT_NE(readResultInfo(folder / "out.h5").pipelines.at(0).status.detail.find("was changed or removed"),
            std::string::npos);
}

/// A generator of one's own: the same damage everywhere.
class Dice {
 public:
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<std::size_t>(state_ >> 33) % count;
  }

 private:
  std::uint64_t state_ = 1;
};

/// A tetrahedron of 30 mm in each format.
struct Sample {
  const char* name;
  std::string bytes;
};

std::vector<Sample> samples() {
  const std::string rows = "0 0 0\n30 0 0\n0 30 0\n0 0 30\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  const std::string header =
      " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  std::string binary = "ply\nformat binary_little_endian" + header;
  for (const float x : {0.f, 0.f, 0.f, 30.f, 0.f, 0.f, 0.f, 30.f, 0.f, 0.f, 0.f, 30.f})
    binary.append(reinterpret_cast<const char*>(&x), sizeof x);
  for (const std::array<int, 3> face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    binary += '\3';
    binary.append(reinterpret_cast<const char*>(face.data()), sizeof face);
  }
  std::string stl(80, '\0'), text = "solid t\n";
  const std::uint32_t count = 4;
  stl.append(reinterpret_cast<const char*>(&count), sizeof count);
  const float points[4][3] = {{0, 0, 0}, {30, 0, 0}, {0, 30, 0}, {0, 0, 30}};
  for (const std::array<int, 3> face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    stl += std::string(12, '\0');
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int v : face) {
      stl.append(reinterpret_cast<const char*>(points[v]), sizeof points[v]);
      text += "vertex " + std::to_string(points[v][0]) + " " + std::to_string(points[v][1]) + " " +
              std::to_string(points[v][2]) + "\n";
    }
    stl += std::string(2, '\0');
    text += "endloop\nendfacet\n";
  }
  return {{"m.off", "OFF\n4 4 6\n" + rows},
          {"m.ply", "ply\nformat ascii" + header + rows},
          {"b.ply", binary},
          {"m.obj", "v 0 0 0\nv 30 0 0\nv 0 30 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"},
          {"b.stl", stl},
          {"m.stl", text + "endsolid t\n"}};
}

std::string damaged(std::string bytes, Dice& dice) {
  const char* const words[] = {"4294967295", "-1", "nan", "1e400", "2147483648", "", "x"};
  switch (dice.below(4)) {
    case 0:
      bytes.resize(dice.below(bytes.size()));
      break;
    case 1:
      bytes[dice.below(bytes.size())] = static_cast<char>(dice.below(256));
      break;
    case 2:
      for (int i = 0; i < 20; ++i) bytes[dice.below(bytes.size())] = static_cast<char>(dice.below(256));
      break;
    default: {
      const std::size_t at = bytes.find(' ', dice.below(bytes.size()));
      if (at != std::string::npos)
        bytes.replace(at + 1, std::min(bytes.find_first_of(" \n", at + 1), bytes.size()) - at - 1,
                      words[dice.below(std::size(words))]);
    }
  }
  return bytes;
}

TEST(Mesh, DamagedFilesAreRefusedOrGood) {
  const Folder folder;
  Dice dice;
  for (const Sample& sample : samples()) {
    folder.write("s.yaml", with(organScenario(), "organ.stl", sample.name));
    folder.write(sample.name, sample.bytes);
    EXPECT_EQ(runFissure(folder, {"validate", "s.yaml"}).code, 0) << sample.name << " is good";
    for (int i = 0; i < 25; ++i) {
      folder.write(sample.name, damaged(sample.bytes, dice));
      const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
      EXPECT_TRUE(outcome.code == 0 || outcome.code == 2) << sample.name << i << ": " << outcome.err;
      EXPECT_TRUE(outcome.code == 0 || outcome.err.find(sample.name) != std::string::npos ||
                  outcome.err.find("bodies.sphere.shape: ") != std::string::npos)
          << sample.name << i << ": " << outcome.err;
    }
  }
}

// The physical groups of a Gmsh file become regions: two tetrahedra, of the groups 7 and 9.
TEST(Mesh, TagsOfTetrahedraAreRegions) {
  const Folder folder;
  folder.write("organ.msh",
               "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 10 0 0\n3 0 10 0\n4 0 0 10\n"
               "5 10 10 10\n$EndNodes\n$Elements\n2\n1 4 2 7 1 1 2 3 4\n2 4 2 9 2 2 3 4 5\n$EndElements\n");
  const std::string of_shell =
      "    mass_kg: 0.1\n"
      "    material: {linear_stiffness: 0.5}\n"
      "    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}\n";
  const auto text = [&](const std::string& tag) {
    return with(with(pressScenario("[{pipeline: swept}]"), of_shell,
                     "    model: elastic\n    elastic: {regions: [{name: vessel, tag: " + tag +
                         ", preset: vessel_wall}]}\n"),
                "{type: sphere, radius_m: 0.03, subdivisions: 1}",
                "{type: tetrahedra, file: organ.msh, unit: mm}");
  };
  folder.write("s.yaml", text("9"));
  const Outcome plan = runFissure(folder, {"plan", "s.yaml"});
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_NE(plan.out.find(
                "region vessel: E 626000 Pa, nu 0.49, 1050 kg/m3; 1 tetrahedron, which alone would allow"),
            std::string::npos)
      << plan.out;
  folder.write("none.yaml", text("8"));
  const Outcome none = runFissure(folder, {"validate", "none.yaml"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("bodies.sphere.elastic.regions.vessel holds no tetrahedron"), std::string::npos)
      << none.err;
}

}  // namespace
}  // namespace fissure::programs::mesh_test
