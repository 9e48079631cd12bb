// The claims of the books on the shipped configs: what holds, what does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/geometry.h"
#include "program.h"
#include "store/read_series.h"
#include "store/result_file.h"

namespace fissure::programs::claims_test {
namespace {

double quantity(const ResultInfo& info, const std::string& pipeline, const std::string& name) {
  for (const PipelineResult& result : info.pipelines) {
    if (result.name != pipeline) continue;
    EXPECT_EQ(nameOf(result.status.end), "ok") << result.status.detail;
    for (const SummaryValue& value : result.summary) {
      if (value.name != name) continue;
      if (const double* real = std::get_if<double>(&value.value)) return *real;
      return static_cast<double>(std::get<long long>(value.value));
    }
  }
  ADD_FAILURE() << pipeline << " has no " << name;
  return std::numeric_limits<double>::quiet_NaN();  // fails every comparison
}

/// The config without frames, its press at `speed_m_s` and the given nodes on each large face.
ResultInfo press(const std::string& config, const std::string& tool, const std::string& speed_m_s, int nodes,
                 const std::vector<std::string>& more = {}) {
  const Folder folder;
  const std::string resolution = "[" + std::to_string(nodes) + ", " + std::to_string(nodes) + "]";
  std::vector<std::string> words = {
      "run",         FISSURE_SOURCE_DIR "/configs/" + config,
      "--no-frames", "--no-expect",
      "-o",          "out.h5",
      "--set",       "tools." + tool + ".motion.segments.0.speed_m_s=" + speed_m_s,
      "--set",       "tools." + tool + ".nodes.resolution=" + resolution};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = runFissure(folder, words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return readResultInfo(folder / "out.h5");
}

TEST(Claims, TheSpatulaEntersBulletsDefaultAndIsHeldByTheFullMethod) {
  for (const std::string speed : {"0.1", "2"}) {
    const ResultInfo info = press("spatula_press.yaml", "spatula", speed, 8);
    EXPECT_GT(quantity(info, "default", "max_penetration_depth_m"), 0.02);
    EXPECT_GT(quantity(info, "default_tuned", "max_penetration_depth_m"), 0.02);
    EXPECT_LE(quantity(info, "fukuhara", "max_penetration_depth_m"), 0.0005);
    EXPECT_EQ(quantity(info, "fukuhara", "max_inverted_triangles"), 0) << "no depth can hide";
    EXPECT_GT(quantity(info, "raycast", "max_inverted_triangles"), 20)
        << "without association tissue is torn over";
    EXPECT_GT(quantity(info, "raycast", "force_roughness"),
              2 * quantity(info, "fukuhara", "force_roughness"));
  }
}

/// A config run with pipeline swept alone, without frames.
ResultInfo swept(const std::string& config, const std::vector<std::string>& more = {}) {
  const Folder folder;
  std::vector<std::string> words = {
      "run", FISSURE_SOURCE_DIR "/configs/" + config, "--no-frames", "--pipeline", "swept", "-o", "out.h5"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = runFissure(folder, words);
  EXPECT_EQ(outcome.code, 0) << config << outcome.out << outcome.err;
  return readResultInfo(folder / "out.h5");
}

// Boxes, a concave tool, clamps, a slit, friction, the floor between the lobes: all expect every step proved.
TEST(Claims, SweptContactProvesEveryStep) {
  for (const std::string config :
       {"spatula_press.yaml", "spatula_edge_on.yaml", "hooked_spatula.yaml", "clamp_sphere.yaml",
        "lift_two_plates.yaml", "fissure_open.yaml", "two_organs.yaml", "spatula_coupled.yaml"}) {
    const ResultInfo info = swept(config);
    EXPECT_EQ(quantity(info, "swept", "uncertified_steps"), 0) << config;
    EXPECT_EQ(quantity(info, "swept", "truncated_steps"), 0) << config;
    EXPECT_LE(quantity(info, "swept", "max_penetration_depth_m"), 1e-5) << config;
    EXPECT_GT(quantity(info, "swept", "contact_steps"), 0) << config;
  }
}

// At ten times the speed, and by truncation alone.
TEST(Claims, SweptContactProvesEveryStepHoweverFastAndWithoutAnyRound) {
  const ResultInfo fast =
      swept("spatula_press.yaml", {"--set", "tools.spatula.motion.segments.0.speed_m_s=10"});
  EXPECT_EQ(quantity(fast, "swept", "uncertified_steps"), 0);
  const ResultInfo truncated = swept("spatula_press.yaml", {"--set", "pipelines.swept.rounds=0"});
  EXPECT_EQ(quantity(truncated, "swept", "uncertified_steps"), 0);
  EXPECT_EQ(quantity(truncated, "swept", "no_room_steps"), 0);
  EXPECT_GT(quantity(truncated, "swept", "truncated_steps"), 0);
}

// The ground's contacts follow Bullet's solve, which is shown the ground beforehand: else the sphere caves in
// under its own weight at this step, all of it inside out before the blade comes.
TEST(Claims, TissueStandsOnTheGroundOfSweptAtLongStepsToo) {
  const ResultInfo info =
      swept("spatula_friction.yaml", {"--no-expect", "--set", "time.step_s=0.016666666666666666"});
  EXPECT_EQ(quantity(info, "swept", "max_inverted_triangles"), 0);
  EXPECT_LE(quantity(info, "swept", "max_ground_depth_m"), 1e-5);
  EXPECT_GT(quantity(info, "swept", "contact_steps"), 10);
}

// All but the first state, before which the tool stood in the tissue.
TEST(Claims, ABladePutIntoTissueIsFreeAfterOneStepOfSweptContact) {
  const ResultInfo info = swept("fixtures/starts_inside.yaml");
  EXPECT_EQ(quantity(info, "swept", "uncertified_steps"), 1);
  EXPECT_EQ(quantity(info, "swept", "max_inverted_triangles"), 0);
}

TEST(Claims, BothResponsesAreSmooth) {
  for (const std::string response : {"none", "momentum"}) {
    const Folder folder;
    const Outcome outcome = runFissure(
        folder, {"run", FISSURE_SOURCE_DIR "/configs/spatula_press.yaml", "--no-frames", "--no-expect", "-o",
                 "out.h5", "--pipeline", "fukuhara", "--set", "pipelines.fukuhara.response=" + response});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_LE(quantity(readResultInfo(folder / "out.h5"), "fukuhara", "force_roughness"), 0.02) << response;
  }
}

TEST(Claims, WhereTissueDoesNotSlideTheForceIsAtMostTwiceAsRoughAsThatOfTheTissueAlone) {
  for (const std::string speed : {"0.02", "0.1"}) {
    const ResultInfo info = press("spatula_friction.yaml", "spatula", speed, 8,
                                  {"--pipeline", "fukuhara", "--pipeline", "tissue_alone"});
    EXPECT_LE(quantity(info, "fukuhara", "max_penetration_depth_m"), 0.0005);
    EXPECT_LE(quantity(info, "fukuhara", "force_roughness_hc"),
              2 * quantity(info, "tissue_alone", "force_roughness_hc"))
        << speed;
  }
}

TEST(Claims, SixteenNodesHoldToATenthOfAMillimetre) {
  const ResultInfo info = press("spatula_press.yaml", "spatula", "0.5", 16);
  EXPECT_LE(quantity(info, "fukuhara", "max_penetration_depth_m"), 0.0001);
  EXPECT_EQ(quantity(info, "fukuhara", "passed_through_samples"), 0);
}

TEST(Claims, OnALargePlateTheTunedDefaultHoldsSlowAndFailsFast) {
  const ResultInfo slow = press("plate_press.yaml", "plate", "0.5", 16);
  EXPECT_LE(quantity(slow, "default_tuned", "max_penetration_depth_m"), 0.0001);
  EXPECT_LE(quantity(slow, "fukuhara", "max_penetration_depth_m"), 0.0001);
  const ResultInfo fast = press("plate_press.yaml", "plate", "10", 16);
  EXPECT_GT(quantity(fast, "default_tuned", "max_penetration_depth_m"), 0.001);
  EXPECT_LE(quantity(fast, "fukuhara", "max_penetration_depth_m"), 0.0001);
}

/// Mean height of the tissue in each snapshot of the full method.
std::vector<double> heights_m(const std::filesystem::path& result) {
  const SeriesData positions = readSeries(result, "/pipelines/fukuhara/positions");
  const std::size_t vertices = positions.shape.at(1);
  std::vector<double> heights(positions.shape.at(0), 0);
  for (std::size_t s = 0; s < heights.size(); ++s) {
    for (std::size_t v = 0; v < vertices; ++v)
      heights[s] += positions.values.at(3 * (s * vertices + v) + 1) / static_cast<double>(vertices);
  }
  return heights;
}

// Two plates squeeze a sphere and rise by 60 mm: what they rub carries its weight, and for good. Without
// friction it stays on the ground.
TEST(Claims, TwoPlatesWithFrictionLiftASphereAndHoldIt) {
  const Folder folder;
  std::vector<std::string> words = {"run",         FISSURE_SOURCE_DIR "/configs/lift_two_plates.yaml",
                                    "-o",          "out.h5",
                                    "--force",     "--no-frames",
                                    "--no-expect", "--pipeline",
                                    "fukuhara"};
  ASSERT_EQ(runFissure(folder, words).code, 0);
  const std::vector<double> held_m = heights_m(folder / "out.h5");
  const std::size_t last = held_m.size() - 1;
  EXPECT_NEAR(held_m[last] - held_m[0], 0.06, 0.0005);
  EXPECT_NEAR(held_m[last], held_m[last - 30], 1e-6) << "held for 0.3 s";
  const SeriesData reaction = readSeries(folder / "out.h5", "/pipelines/fukuhara/reaction_force");
  const std::size_t rows = 300;
  Vec3 mean_N = Vec3::Zero();
  for (std::size_t i = reaction.values.size() - 3 * rows; i < reaction.values.size(); ++i)
    mean_N[static_cast<int>(i % 3)] += reaction.values[i] / rows;
  EXPECT_NEAR((mean_N - Vec3(0, -0.981, 0)).norm(), 0, 0.01 * 0.981);
  words.insert(words.end(), {"--set", "tools.left.friction=0", "--set", "tools.right.friction=0"});
  ASSERT_EQ(runFissure(folder, words).code, 0);
  EXPECT_LT(heights_m(folder / "out.h5").back(), 0.035);
}

// Nodes on the narrow faces hold a blade that comes edge first; without them its large faces tear the tissue.
TEST(Claims, ABladeThatComesEdgeFirstIsHeldByNodesOnItsNarrowFaces) {
  const auto edge = [](const std::string& speed_m_s, const std::string& rows) {
    const Folder folder;
    const Outcome outcome = runFissure(
        folder, {"run", FISSURE_SOURCE_DIR "/configs/spatula_edge_on.yaml", "--no-frames", "--no-expect",
                 "-o", "out.h5", "--pipeline", "fukuhara", "--set", "tools.spatula.nodes.narrow_rows=" + rows,
                 "--set", "tools.spatula.motion.segments.0.speed_m_s=" + speed_m_s});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return quantity(readResultInfo(folder / "out.h5"), "fukuhara", "max_penetration_depth_m");
  };
  for (const std::string speed_m_s : {"0.02", "0.1", "0.5", "2"}) {
    EXPECT_LE(edge(speed_m_s, "2"), 0.0001) << speed_m_s;
    EXPECT_GT(edge(speed_m_s, "0"), 0.001) << speed_m_s;
  }
}

// Let go at 2 m/s, tissue is held back by nothing: the blade feels no pull, by the law and by what the
// contacts took, and contact ends while the tissue still rises.
TEST(Claims, AWithdrawnSpatulaNeitherPullsNorSticks) {
  const Folder folder;
  const Outcome outcome = runFissure(folder, {"run", FISSURE_SOURCE_DIR "/configs/spatula_withdraw.yaml",
                                              "--no-frames", "--pipeline", "fukuhara", "-o", "out.h5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const std::string group = "/pipelines/fukuhara/";
  for (const std::string series : {"force", "reaction_force"}) {
    const SeriesData force_N = readSeries(folder / "out.h5", group + series);
    double least_N = 0, largest_N = 0;
    for (std::size_t i = 1; i < force_N.values.size(); i += 3) {
      ASSERT_FALSE(std::isnan(force_N.values[i]) && i > 3) << series;
      least_N = std::min(least_N, force_N.values[i]);
      largest_N = std::max(largest_N, force_N.values[i]);
    }
    EXPECT_GE(least_N, 0) << series << " pulls the blade down";
    EXPECT_GT(largest_N, 20) << series;
  }
  const SeriesData contacts = readSeries(folder / "out.h5", group + "contact_count");
  const std::size_t withdrawn = 410 + 42;  // steps until it moves, and until it is at the top
  for (std::size_t i = withdrawn; i < contacts.values.size(); ++i) ASSERT_EQ(contacts.values[i], 0) << i;
}

TEST(Claims, APalpatingArmIsHeldAtEveryTouch) {
  const Folder folder;
  const Outcome outcome = runFissure(
      folder, {"run", FISSURE_SOURCE_DIR "/configs/replay_palpation.yaml", "--no-frames", "-o", "out.h5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  const SeriesData force_N = readSeries(folder / "out.h5", "/pipelines/fukuhara/force");
  int touches = 0;  // upward crossings
  for (std::size_t i = 4; i < force_N.values.size(); i += 3)
    if (force_N.values[i] >= 0.3 && force_N.values[i - 3] < 0.3) ++touches;
  EXPECT_GE(touches, 5);
}

/// A fissure config through the full method and through the same without feasibility.
ResultInfo part(const std::string& config, const std::vector<std::string>& more = {}) {
  const Folder folder;
  std::vector<std::string> words = {"run",         FISSURE_SOURCE_DIR "/configs/" + config,
                                    "--no-frames", "--no-expect",
                                    "-o",          "out.h5",
                                    "--pipeline",  "fukuhara",
                                    "--pipeline",  "no_pairs"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome outcome = runFissure(folder, words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return readResultInfo(folder / "out.h5");
}

/// Both lobes parted alike by more than `least_m`, and nothing torn.
void expectPartedAlike(const ResultInfo& info, double least_m) {
  const double left_m = -quantity(info, "fukuhara", "gauge_left_x_final_m");
  const double right_m = quantity(info, "fukuhara", "gauge_right_x_final_m");
  EXPECT_GT(left_m, least_m);
  EXPECT_NEAR(left_m / right_m, 1, 0.05);
  EXPECT_LE(quantity(info, "fukuhara", "max_penetration_depth_m"), 0.0001);
  EXPECT_EQ(quantity(info, "fukuhara", "passed_through_samples"), 0);
  EXPECT_EQ(quantity(info, "fukuhara", "max_inverted_triangles"), 0);
}

void expectTornWithoutFeasibility(const ResultInfo& info) {
  EXPECT_GT(quantity(info, "no_pairs", "max_inverted_triangles"), 50);
  EXPECT_GT(quantity(info, "no_pairs", "passed_through_samples"), 50);
}

TEST(Claims, AFissureIsOpenedAlikeOnBothSidesByOneSpatulaAndByTwo) {
  const ResultInfo turned = part("fissure_open.yaml");
  expectPartedAlike(turned, 0.002);
  expectTornWithoutFeasibility(turned);
  const ResultInfo retracted = part("fissure_retract.yaml");
  expectPartedAlike(retracted, 0.01);
  expectTornWithoutFeasibility(retracted);
}

// A blade thicker than the slit goes straight down in its middle: both faces hold tissue, at the same pairs
// of nodes.
TEST(Claims, ABladeInTheMiddleOfANarrowSlitPartsBothLobesAlike) {
  const std::string down =
      "tools.spatula.motion.segments=[{move_to_m: [0, 0.04, 0], speed_m_s: 0.1}, {hold_s: 0.1}]";
  expectPartedAlike(
      part("fissure_open.yaml", {"--set", down, "--set", "bodies.lobes.shape.slit_width_m=0.001"}), 0.0005);
}

// On 128 triangles single vertices slip in between nodes 5 mm apart before any node has contact.
TEST(Claims, OnACoarseMeshVertexContactsCloseThePlateThatNodesAloneLeaveOpen) {
  const std::vector<std::string> coarse = {"--pipeline", "fukuhara", "--set",
                                           "bodies.sphere.shape.subdivisions=2"};
  const ResultInfo closed = press("plate_press.yaml", "plate", "2", 16, coarse);
  EXPECT_LE(quantity(closed, "fukuhara", "max_penetration_depth_m"), 0.0001);
  EXPECT_EQ(quantity(closed, "fukuhara", "max_inverted_triangles"), 0);
  std::vector<std::string> alone = coarse;
  alone.insert(alone.end(), {"--set", "pipelines.fukuhara.vertex_contacts=false", "--set",
                             "pipelines.fukuhara.response=none"});
  const ResultInfo open = press("plate_press.yaml", "plate", "2", 16, alone);
  EXPECT_GT(quantity(open, "fukuhara", "max_penetration_depth_m"), 0.001);
}

}  // namespace
}  // namespace fissure::programs::claims_test
