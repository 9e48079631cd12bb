#include "measure/certifier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <random>

#include "exact_overlap.h"
#include "measure/probe_makers.h"
#include "mesh/primitives.h"
#include "surface/certificate_table.h"
#include "surface/oracles.h"

namespace fissure::certifier_test {

using test::at;

TriangleMesh boxMesh(const Vec3& size) {
  return makeBox(size);
}

/// A square without thickness, x and z within `half`.
TriangleMesh sheet(double half) {
  return {{{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}}, {{0, 2, 1}, {0, 3, 2}}};
}

Scene sceneOf(const std::vector<TriangleMesh>& bodies, const std::vector<TriangleMesh>& tools,
              bool closed = true) {
  Scene scene = test::makeScene(bodies, {});
  for (const TriangleMesh& tool : tools) {
    SceneTool made;
    made.name = "tool" + std::to_string(scene.tools.size());
    made.surface = tool;
    made.closed = closed;
    scene.tools.push_back(made);
  }
  return scene;
}

/// Whether any tool overlaps any body, in the scene's frame.
bool overlaps(const Scene& scene, const State& state) {
  for (std::size_t t = 0; t < scene.tools.size(); ++t)
    for (const SceneBody& body : scene.bodies) {
      TriangleMesh tissue = body.rest;
      for (std::size_t i = 0; i < tissue.vertices_m.size(); ++i)
        tissue.vertices_m[i] = state.positions_m[static_cast<std::size_t>(body.first_vertex) + i];
      if (test::exactOverlap(tissue, test::moved(scene.tools[t].surface, state.tools[t].pose),
                             scene.tools[t].closed))
        return true;
    }
  return false;
}

/// One state after the other; the verdict of each.
std::vector<bool> proved(const Scene& scene, const std::vector<State>& states) {
  Certifier certifier(scene);
  std::vector<bool> all;
  for (const State& state : states) all.push_back(!certifier.certify(state));
  return all;
}

const TriangleMesh kSphere = makeSphere(0.03, 2);

TEST(Certifier, ProvesAToolThatStaysOutside) {
  const Scene scene = sceneOf({kSphere}, {boxMesh({0.05, 0.001, 0.02})});
  EXPECT_EQ(proved(scene, {test::restState(scene, {at(0, 0.04, 0)}),
                           test::restState(scene, {at(0.01, 0.0312, 0.01)}),
                           test::restState(scene, {at(-0.2, 0.0312, 0)})}),
            (std::vector{true, true, true}));
}

// Surfaces that never cross prove nothing of what starts inside.
TEST(Certifier, DoesNotProveANeedleThatLiesWhollyInside) {
  const Scene scene = sceneOf({kSphere}, {boxMesh({0.0005, 0.01, 0.0005})});
  const State inside = test::restState(scene, {at(0, 0.001, 0)});
  EXPECT_EQ(proved(scene, {inside, inside}), (std::vector{false, false}));
  Certifier certifier(scene);
  const auto objection = certifier.certify(inside);
  ASSERT_TRUE(objection);
  EXPECT_EQ(objection->what, "tool0 may lie inside " + scene.bodies[0].name + " at its end");
}

TEST(Certifier, DoesNotProveTissueThatLiesInsideATool) {
  const Scene scene = sceneOf({makeSphere(0.002, 1)}, {boxMesh({0.02, 0.02, 0.02})});
  EXPECT_EQ(proved(scene, {test::restState(scene, {at(0, 0, 0)})}), (std::vector{false}));
  const Scene open = sceneOf({makeSphere(0.002, 1)}, {boxMesh({0.02, 0.02, 0.02})}, false);
  EXPECT_EQ(proved(open, {test::restState(open, {at(0, 0, 0)})}), (std::vector{true}));  // it has no inside
}

// Inside-out tissue encloses what is in it, too.
TEST(Certifier, DoesNotProveANeedleInsideOfTissueThatIsInsideOut) {
  TriangleMesh inside_out = kSphere;
  for (Vec3& vertex : inside_out.vertices_m) vertex = -vertex;
  const Scene scene = sceneOf({inside_out}, {boxMesh({0.0005, 0.01, 0.0005})});
  EXPECT_EQ(proved(scene, {test::restState(scene, {at(0, 0.001, 0)})}), (std::vector{false}));
}

// The winding numbers of a sheet and of an inverted one around it would cancel.
TEST(Certifier, DoesNotProveAToolInsideTwoPartsOfWhichOneIsInsideOut) {
  TriangleMesh inside_out = boxMesh({0.056, 0.056, 0.056});
  for (Face& face : inside_out.faces) std::swap(face[1], face[2]);
  for (Vec3& vertex : inside_out.vertices_m) vertex.x() += 0.012;
  const TriangleMesh both = test::together(boxMesh({0.06, 0.06, 0.06}), inside_out);
  const Scene scene = sceneOf({both}, {boxMesh({0.004, 0.002, 0.004})});
  const State inside = test::restState(scene, {at(0.008, 0.002, 0.008)});
  EXPECT_TRUE(overlaps(scene, inside));
  EXPECT_EQ(proved(scene, {inside}), (std::vector{false}));
  const Scene tool = sceneOf({makeSphere(0.002, 1)}, {both});
  EXPECT_EQ(proved(tool, {test::restState(tool, {at(-0.008, 0, 0)})}), (std::vector{false}));
}

// The step in which it leaves is proved at its end; from there, paths are followed.
TEST(Certifier, ProvesFromTheStepInWhichOverlapEnds) {
  const Scene scene = sceneOf({kSphere}, {boxMesh({0.05, 0.001, 0.02})});
  EXPECT_EQ(
      proved(scene, {test::restState(scene, {at(0, 0.02, 0)}), test::restState(scene, {at(0, 0.025, 0)}),
                     test::restState(scene, {at(0, 0.035, 0)}), test::restState(scene, {at(0, 0.034, 0)}),
                     test::restState(scene, {at(0, 0.02, 0)}), test::restState(scene, {at(0, 0.034, 0)})}),
      (std::vector{false, false, true, true, false, true}));
}

// Neither before nor after is there any overlap.
TEST(Certifier, DoesNotProveAStepThatJumpsThroughTheBody) {
  for (const bool closed : {true, false}) {
    const Scene scene = sceneOf({kSphere}, {closed ? boxMesh({0.02, 0.0002, 0.02}) : sheet(0.01)}, closed);
    const std::vector<State> states{test::restState(scene, {at(0, 0.04, 0)}),
                                    test::restState(scene, {at(0, -0.04, 0)}),
                                    test::restState(scene, {at(0, -0.041, 0)})};
    EXPECT_EQ(proved(scene, states), (std::vector{true, false, true}));
    for (const State& state : states) EXPECT_FALSE(overlaps(scene, state));
    Certifier certifier(scene);
    certifier.certify(states[0]);
    const auto objection = certifier.certify(states[1]);
    ASSERT_TRUE(objection);
    EXPECT_NEAR(objection->time, 0.125, 0.01);
    EXPECT_NE(objection->what.find(" may meet "), std::string::npos) << objection->what;
  }
}

TEST(Certifier, NamesTheBodyAndTheToolThatMeetFirst) {
  TriangleMesh second = kSphere;
  for (Vec3& vertex : second.vertices_m) vertex.x() += 0.2;
  const Scene scene =
      sceneOf({kSphere, second}, {boxMesh({0.02, 0.001, 0.02}), boxMesh({0.02, 0.001, 0.02})});
  Certifier certifier(scene);
  EXPECT_FALSE(certifier.certify(test::restState(scene, {at(0, 0.04, 0), at(0.2, 0.04, 0)})));
  const auto objection = certifier.certify(test::restState(scene, {at(0, 0.02, 0), at(0.2, 0.01, 0)}));
  ASSERT_TRUE(objection);
  EXPECT_EQ(objection->body, 1U);
  EXPECT_EQ(objection->tool, 1U);
  EXPECT_NE(objection->what.find(scene.bodies[1].name), std::string::npos) << objection->what;
  EXPECT_NE(objection->what.find("tool1"), std::string::npos) << objection->what;
}

TEST(Certifier, DoesNotProveWhatIsNotFinite) {
  const Scene scene = sceneOf({kSphere}, {boxMesh({0.02, 0.001, 0.02})});
  State bad = test::restState(scene, {at(0, 0.04, 0)});
  const State good = bad;
  bad.positions_m[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(proved(scene, {good, bad, good}), (std::vector{true, false, true}));
  bad.positions_m[3].y() = 1e9;
  EXPECT_EQ(proved(scene, {good, bad, good}), (std::vector{true, false, true}));
}

// What a run says of its proofs.
TEST(Certifier, TellsARunHowManyStepsAreProvedAndWhatIsInTheWayOfTheFirstThatIsNot) {
  const Scene scene = sceneOf({kSphere}, {boxMesh({0.02, 0.001, 0.02})});
  const auto summaryOf = [&](const std::vector<double>& heights_m, std::vector<double>& flags) {
    const std::unique_ptr<Probe> probe = makeCertificateProbe(scene);
    RecordLayout layout;
    probe->declare(layout);
    RecordRow row(layout.columns());
    for (std::size_t i = 0; i < heights_m.size(); ++i) {
      State state = test::restState(scene, {at(0, heights_m[i], 0)});
      state.step = static_cast<std::int64_t>(i);
      probe->sample(state, row);
      flags.push_back(row[layout.find("certified")->first_column]);
    }
    Summary summary;
    probe->summarize(summary);
    std::map<std::string, std::string> texts;
    for (const SummaryValue& value : summary) {
      if (const auto* text = std::get_if<std::string>(&value.value)) texts[value.name] = *text;
      if (const auto* count = std::get_if<long long>(&value.value))
        texts[value.name] = std::to_string(*count);
      if (const auto* real = std::get_if<double>(&value.value))
        texts[value.name] = std::isnan(*real) ? "missing" : std::to_string(static_cast<int>(*real));
    }
    return texts;
  };
  using Texts = std::map<std::string, std::string>;
  std::vector<double> flags;
  EXPECT_EQ(summaryOf({}, flags), (Texts{{"certified_steps", "missing"}, {"uncertified_steps", "missing"}}));
  EXPECT_EQ(summaryOf({0.04, 0.035}, flags), (Texts{{"certified_steps", "2"}, {"uncertified_steps", "0"}}));
  flags.clear();
  Texts texts = summaryOf({0.04, 0.035, -0.04, -0.05}, flags);
  EXPECT_EQ(flags, (std::vector<double>{1, 1, 0, 1}));
  EXPECT_NE(texts["first_uncertified"].find(" of the step"), std::string::npos) << texts["first_uncertified"];
  texts.erase("first_uncertified");
  EXPECT_EQ(texts,
            (Texts{{"certified_steps", "3"}, {"uncertified_steps", "1"}, {"first_uncertified_step", "2"}}));
}

/// FISSURE_CERTIFICATE_SEQUENCES states how many.
int sequences() {
  const char* given = std::getenv("FISSURE_CERTIFICATE_SEQUENCES");
  return given == nullptr ? 300 : std::atoi(given);
}

// Tools and tissue of all kinds thrown at each other, many of them by a hair: whatever is proved is free of
// overlap in exact arithmetic.
TEST(Certifier, NeverProvesAnOverlap) {
  std::mt19937 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  long long steps = 0, certified = 0, overlapping = 0, free_but_unproved = 0;
  for (int sequence = 0; sequence < sequences(); ++sequence) {
    std::vector<TriangleMesh> bodies{sequence % 2 == 0 ? makeSphere(0.02, 1) : boxMesh({0.03, 0.03, 0.03})};
    if (sequence % 7 == 0) {
      bodies.push_back(makeSphere(0.01, 0));
      for (Vec3& vertex : bodies.back().vertices_m) vertex.x() += 0.035;
    }
    const bool closed = sequence % 5 != 0;
    std::vector<TriangleMesh> tools;
    if (!closed)
      tools.push_back(sheet(uniform(0.002, 0.03)));
    else if (sequence % 3 == 0)
      tools.push_back(boxMesh({0.0004, uniform(0.005, 0.03), 0.0004}));
    else if (sequence % 3 == 1)
      tools.push_back(boxMesh({0.04, 0.001, 0.01}));
    else
      tools.push_back(makeSphere(uniform(0.001, 0.03), 0));
    if (sequence % 11 == 0) tools.push_back(boxMesh({0.002, 0.03, 0.002}));
    const Scene scene = sceneOf(bodies, tools, closed);
    const double noise = std::pow(10.0, uniform(-6, -2)), speed = std::pow(10.0, uniform(-4, -1.5));
    std::vector<Pose> poses;
    std::vector<Vec3> velocities;
    for (std::size_t t = 0; t < tools.size(); ++t) {
      poses.push_back(test::randomPose(random, 0.04));
      if (sequence % 4 == 0) poses.back().orientation.setIdentity();  // coplanar faces, parallel edges
      velocities.push_back(-speed * poses.back().position_m.normalized());
    }
    State state = test::restState(scene, poses);
    Certifier certifier(scene);
    for (int step = 0; step < 12; ++step) {
      state.step = step;
      const bool is_proved = !certifier.certify(state);
      const bool is_overlapping = overlaps(scene, state);
      ++steps;
      certified += is_proved;
      overlapping += is_overlapping;
      free_but_unproved += !is_proved && !is_overlapping;
      ASSERT_FALSE(is_proved && is_overlapping) << "sequence " << sequence << ", step " << step;
      for (std::size_t t = 0; t < tools.size(); ++t) {
        Pose& pose = state.tools[t].pose;
        pose.position_m += velocities[t];
        if (sequence % 4 != 0)
          pose.orientation =
              (pose.orientation * Quat(Eigen::AngleAxisd(uniform(-0.2, 0.2), Vec3::UnitX()))).normalized();
      }
      if (sequence % 3 != 0)
        for (Vec3& vertex : state.positions_m) vertex += test::randomIn(random, noise);
    }
  }
  test::addCertificateRow("steps of sequences", steps, overlapping, 0, free_but_unproved);
  EXPECT_GT(certified, steps / 4);
  EXPECT_GT(overlapping, steps / 4);
  EXPECT_LT(free_but_unproved, steps / 10);  // those that jumped through
}

}  // namespace fissure::certifier_test
