// Which side of a pair may hold tissue, over the steps in which a blade turns in a slit
// (contact/METHOD.md 4).
#include "contact/node_association.h"

#include <gtest/gtest.h>

namespace fissure::node_association_test {

namespace {

/// A blade 2 mm thick with one node on each large face, and what it has met before.
class PairOfNodes : public testing::Test {
 protected:
  PairOfNodes() : association_(scene()) {}

  static Scene scene() {
    Scene scene;
    scene.tools.resize(1);
    scene.tools[0].nodes = {.positions_m = {Vec3(0.001, 0, 0), Vec3(-0.001, 0, 0)},
                            .normals = {Vec3(1, 0, 0), Vec3(-1, 0, 0)},
                            .partners = {1, 0},
                            .thicknesses_m = {0.002, 0.002}};
    return scene;
  }

  struct Depth {
    int node;
    double depth_m;
  };
  /// The verdicts of one step in which these nodes have candidates.
  std::vector<NodeState> judge(const std::vector<Depth>& depths) {
    std::vector<NodeCandidate> candidates;
    for (const Depth& d : depths) {
      const ContactConstraint anywhere{.position_m = Vec3::Zero(), .normal = Vec3::UnitX()};
      candidates.push_back({.node = d.node, .constraint = anywhere, .depth_m = d.depth_m});
    }
    association_.judge(candidates);
    std::vector<NodeState> verdicts;
    for (const NodeCandidate& candidate : candidates) verdicts.push_back(candidate.state);
    return verdicts;
  }

  NodeAssociation association_;
};

using States = std::vector<NodeState>;

TEST_F(PairOfNodes, BothHoldTheWallsOfASlitAsLongAsTheseDoNotOverlap) {
  EXPECT_EQ(judge({{0, 0.0005}, {1, 0.0015}}), (States{NodeState::feasible, NodeState::feasible}));
  EXPECT_EQ(judge({{0, 0.0006}, {1, 0.0015}}), (States{NodeState::feasible, NodeState::infeasible}));
}

// The blade has turned: one side has left its wall, the other goes on into its own, deeper than the blade is
// thick.
TEST_F(PairOfNodes, TheSideThatHasLetGoDoesNotVetoTheOneThatPushes) {
  judge({{0, 0.0005}, {1, 0.0005}});
  EXPECT_EQ(judge({{0, 0.0005}}), (States{NodeState::feasible}));
  EXPECT_EQ(judge({{0, 0.005}}), (States{NodeState::feasible}));
}

// The same pair, when it is the other side that has let go: its deep candidate is the far side of what the
// first one holds.
TEST_F(PairOfNodes, TheSideThatHasLetGoIsVetoedByTheOneThatHolds) {
  judge({{0, 0.0005}, {1, 0.0005}});
  judge({{1, 0.0005}});
  EXPECT_EQ(judge({{0, 0.005}}), (States{NodeState::infeasible}));
  EXPECT_EQ(judge({{0, 0.005}}), (States{NodeState::infeasible})) << "until both are free";
  judge({});
  EXPECT_EQ(judge({{0, 0.005}}), (States{NodeState::feasible}));
}

}  // namespace
}  // namespace fissure::node_association_test
