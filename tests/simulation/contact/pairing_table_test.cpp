// The table of nodes, partners and thicknesses of box tools against its definition, pair by pair, and against
// an independent pairing by rays.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "contact/grid_nodes.h"
#include "contact/ray.h"
#include "mesh/primitives.h"

namespace fissure::pairing_table_test {

namespace {

struct Tool {
  Vec3 size_m;
  std::array<int, 2> resolution;
};

/// All orders of edges of spatula, foil, needle, plate, cube and a cuboid with two equal edges, at many
/// resolutions.
std::vector<Tool> tools() {
  std::vector<Tool> all;
  for (Vec3 size_m : {Vec3(0.04, 0.015, 0.002), Vec3(0.04, 0.015, 0.00002), Vec3(0.08, 0.0005, 0.0004),
                      Vec3(0.08, 0.08, 0.005), Vec3(0.01, 0.01, 0.01), Vec3(0.03, 0.002, 0.002)}) {
    std::sort(size_m.begin(), size_m.end());
    do {
      for (const std::array<int, 2>& resolution :
           {std::array{1, 1}, std::array{1, 7}, std::array{7, 1}, std::array{2, 2}, std::array{8, 8},
            std::array{5, 3}, std::array{3, 11}, std::array{16, 16}})
        all.push_back({size_m, resolution});
    } while (std::next_permutation(size_m.begin(), size_m.end()));
  }
  return all;
}

int axisOf(const Vec3& normal) {
  int axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return axis;
}

/// The other node that faces this one: on the opposite side, with no way between them but through the tool.
/// -1: there is none, -2: there are several.
int facingNode(const ToolNodes& nodes, int node) {
  int found = -1;
  for (int other = 0; other < nodes.size(); ++other) {
    const Vec3 across = nodes.positions_m[other] - nodes.positions_m[node];
    const double through = -across.dot(nodes.normals[node]);
    if (through <= 0 || (across + through * nodes.normals[node]).norm() > 1e-15) continue;
    found = found == -1 ? other : -2;
  }
  return found;
}

TEST(PairingTable, NodesStandOnTheTwoLargestSidesOfTheBox) {
  for (const Tool& tool : tools()) {
    const ToolNodes nodes = makeGridNodes(tool.size_m, tool.resolution);
    ASSERT_EQ(nodes.size(), 2 * tool.resolution[0] * tool.resolution[1]);
    ASSERT_EQ(nodes.normals.size(), nodes.positions_m.size());
    ASSERT_EQ(nodes.partners.size(), nodes.positions_m.size());
    ASSERT_EQ(nodes.thicknesses_m.size(), nodes.positions_m.size());
    const int axis = axisOf(nodes.normals[0]);
    EXPECT_EQ(tool.size_m[axis], tool.size_m.minCoeff()) << "across the thinnest way";
    for (int i = 0; i < nodes.size(); ++i) {
      const Vec3& position = nodes.positions_m[i];
      EXPECT_EQ(nodes.normals[i], Vec3(nodes.normals[i][axis] * Vec3::Unit(axis)));
      EXPECT_EQ(std::abs(nodes.normals[i][axis]), 1);
      EXPECT_EQ(position[axis], 0.5 * nodes.normals[i][axis] * tool.size_m[axis]) << "outward, on the side";
      EXPECT_TRUE((position.cwiseAbs().array() <= 0.5 * tool.size_m.array()).all());
    }
  }
}

// A regular grid from border to border, the first number along the longer edge; one node alone stands in the
// middle.
TEST(PairingTable, NodesAreARegularGridThatReachesTheBorder) {
  for (const Tool& tool : tools()) {
    const ToolNodes nodes = makeGridNodes(tool.size_m, tool.resolution);
    const int axis = axisOf(nodes.normals[0]);
    int along = (axis + 1) % 3, across = (axis + 2) % 3;
    if (tool.size_m[along] == tool.size_m[across] ? along > across : tool.size_m[along] < tool.size_m[across])
      std::swap(along, across);
    for (const double side : {1.0, -1.0}) {
      for (const auto& [direction, count] :
           {std::pair(along, tool.resolution[0]), std::pair(across, tool.resolution[1])}) {
        std::multiset<double> places;
        for (int i = 0; i < nodes.size(); ++i)
          if (nodes.normals[i][axis] == side) places.insert(nodes.positions_m[i][direction]);
        const std::set<double> rows(places.begin(), places.end());
        ASSERT_EQ(rows.size(), static_cast<std::size_t>(count));
        for (const double row : rows)
          EXPECT_EQ(places.count(row), places.size() / static_cast<std::size_t>(count));
        const double half_m = 0.5 * tool.size_m[direction];
        EXPECT_EQ(*rows.begin(), count == 1 ? 0 : -half_m);
        EXPECT_EQ(*rows.rbegin(), count == 1 ? 0 : half_m);
        int k = 0;
        for (const double row : rows)
          EXPECT_NEAR(row, count == 1 ? 0 : half_m * (2.0 * k++ / (count - 1) - 1), 1e-15);
      }
    }
  }
}

TEST(PairingTable, PartnersAreTheNodesThatFaceEachOtherAcrossTheTool) {
  for (const Tool& tool : tools()) {
    const ToolNodes nodes = makeGridNodes(tool.size_m, tool.resolution);
    for (int i = 0; i < nodes.size(); ++i) {
      const int partner = nodes.partners[i];
      ASSERT_EQ(partner, facingNode(nodes, i));
      ASSERT_GE(partner, 0);
      EXPECT_EQ(nodes.partners[partner], i) << "mutual";
      EXPECT_EQ(nodes.normals[partner], Vec3(-nodes.normals[i]));
      EXPECT_EQ(nodes.thicknesses_m[i], tool.size_m.minCoeff());
      EXPECT_EQ((nodes.positions_m[i] - nodes.positions_m[partner]).norm(), nodes.thicknesses_m[i]);
    }
  }
}

// From each node along -n, where the ray comes out of the box: there stands the partner, the thickness away.
// Nodes on the border send their rays along the narrow sides and through edges and corners of the box.
TEST(PairingTable, ARayThroughTheToolComesOutAtThePartner) {
  for (const Tool& tool : tools()) {
    const ToolNodes nodes = makeGridNodes(tool.size_m, tool.resolution);
    const TriangleMesh box = makeBox(tool.size_m);
    for (int i = 0; i < nodes.size(); ++i) {
      const Ray ray(nodes.positions_m[i], -nodes.normals[i], 1);
      double nearest_m = 2;
      for (const Face& face : box.faces) {
        const auto hit = ray.intersect(box.vertices_m[static_cast<std::size_t>(face[0])],
                                       box.vertices_m[static_cast<std::size_t>(face[1])],
                                       box.vertices_m[static_cast<std::size_t>(face[2])]);
        if (hit && hit->cosine > 0) nearest_m = std::min(nearest_m, hit->distance_m);
      }
      ASSERT_NEAR(nearest_m, nodes.thicknesses_m[i], 1e-17);
      const Vec3 out_m = nodes.positions_m[i] - nearest_m * nodes.normals[i];
      EXPECT_LE((out_m - nodes.positions_m[nodes.partners[i]]).norm(), 1e-17);
    }
  }
}

}  // namespace
}  // namespace fissure::pairing_table_test
