#include "render/offscreen_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

#include "base/error.h"
#include "mesh/primitives.h"
#include "render/camera.h"
#include "render/osmesa.h"
#include "render/palette.h"

namespace fissure::offscreen_renderer_test {

namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

Colour pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = &image.rgb[3 * (static_cast<std::size_t>(y) * image.width_px + x)];
  return {p[0], p[1], p[2]};
}

/// Largest difference over the channels.
int difference(Colour a, Colour b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

int countNear(const Image& image, Colour colour, int tolerance) {
  int count = 0;
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      count += difference(pixel(image, x, y), colour) <= tolerance ? 1 : 0;
    }
  }
  return count;
}

/// Steel is grey, whatever its light; flesh is not, nor is it steel where the tool only shines through.
bool isSteel(Colour c) {
  return std::abs(c.r - c.g) < 16 && std::abs(c.g - c.b) < 16 && c.r > 60 && c.r < 205;
}
bool isFlesh(Colour c) {
  return c.r > c.g + 25 && c.r > c.b + 25;
}

/// A sphere of 30 mm around the origin, a spatula of 40 x 2 x 15 mm in front of it, and a camera 0.25 m in
/// front of the origin, looking along -z.
class OffscreenRenderer : public testing::Test {
 protected:
  OffscreenRenderer() {
    SceneBody body;
    body.rest = makeSphere(0.03, 3);
    scene_.bodies.push_back(body);
    SceneTool tool;
    tool.surface = makeBox({0.04, 0.002, 0.015});
    scene_.tools.push_back(tool);
    state_.positions_m = body.rest.vertices_m;
    state_.tools.resize(1);
    state_.tools[0].pose.position_m = {0.01, 0.005, 0.05};
    // Its large face towards the camera.
    state_.tools[0].pose.orientation = Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
    settings_.width_px = 320;
    settings_.height_px = 240;
    settings_.camera = CameraSettings{{0, 0, 0.25}, {0, 0, 0}, {0, 1, 0}, 35};
  }

  void addNodes(const std::vector<Vec3>& positions_m) {
    ToolNodes& nodes = scene_.tools[0].nodes;
    nodes.positions_m = positions_m;
    nodes.normals.assign(positions_m.size(), Vec3::UnitY());
    nodes.partners.assign(positions_m.size(), -1);
    nodes.thicknesses_m.assign(positions_m.size(), 0.002);
  }

  Image draw(const std::vector<std::string>& lines = {}) {
    return makeOffscreenRenderer(scene_, settings_, state_)->draw(state_, lines);
  }

  PicturePoint project(const Vec3& point_m) const {
    return *makeCamera(*settings_.camera, settings_.width_px, settings_.height_px).project(point_m);
  }

  Colour colourAt(const Image& image, const Vec3& point_m) const {
    const PicturePoint at = project(point_m);
    return pixel(image, static_cast<int>(at.x_px), static_cast<int>(at.y_px));
  }

  Scene scene_;
  State state_;
  FrameSettings settings_;
};

// In the clamp's frame, which is the jaws' no more than it is the scene's.
TEST_F(OffscreenRenderer, DrawsHandlesWhereTheirClampIs) {
  const Vec3 place_m(-0.06, 0.03, 0);
  EXPECT_FALSE(isSteel(colourAt(draw(), place_m)));
  scene_.clamps = {{.name = "clamp", .handle = makeBox({0.01, 0.01, 0.01})}};
  for (Vec3& v : scene_.clamps[0].handle.vertices_m) v += Vec3(0, 0.02, 0);
  state_.clamps.resize(1);
  state_.clamps[0].pose.position_m = place_m - Vec3(0, 0.02, 0);
  EXPECT_TRUE(isSteel(colourAt(draw(), place_m)));
  state_.clamps[0].pose.orientation = Quat(Eigen::AngleAxisd(M_PI, Vec3::UnitZ()));
  EXPECT_FALSE(isSteel(colourAt(draw(), place_m))) << "turned down";
  state_.clamps.clear();
  EXPECT_THROW(draw(), RunError);
}

TEST_F(OffscreenRenderer, SameStateSameBytes) {
  addNodes({{0, 0.001, 0}, {0.01, -0.001, 0}});
  state_.contact.node_states = {NodeState::feasible, NodeState::infeasible};
  scene_.ground_height_m = -0.03;
  const auto one = makeOffscreenRenderer(scene_, settings_, state_);
  const Image first = one->draw(state_, {"t = 0.1 s"});
  ASSERT_EQ(first.width_px, 320);
  ASSERT_EQ(first.height_px, 240);
  ASSERT_EQ(first.rgb.size(), 320u * 240u * 3u);
  // Another picture and another renderer of another size in between leave no trace.
  FrameSettings small = settings_;
  small.width_px = 33;
  small.height_px = 57;
  const auto two = makeOffscreenRenderer(scene_, small, state_);
  State moved = state_;
  moved.tools[0].pose.position_m.x() += 0.02;
  EXPECT_NE(one->draw(moved, {"t = 0.2 s"}).rgb, first.rgb);
  const Image second = two->draw(state_, {});
  EXPECT_EQ(one->draw(state_, {"t = 0.1 s"}).rgb, first.rgb);
  EXPECT_EQ(two->draw(state_, {}).rgb, second.rgb);
  EXPECT_EQ(draw({"t = 0.1 s"}).rgb, first.rgb);
}

TEST_F(OffscreenRenderer, ToolCoversItsProjection) {
  const Image image = draw();
  // The large face spans x = -10..30 mm, y = -2.5..12.5 mm at z = 51 mm.
  for (const double x_m : {-0.0085, 0.01, 0.0285}) {
    for (const double y_m : {-0.001, 0.005, 0.011}) {
      EXPECT_TRUE(isSteel(colourAt(image, {x_m, y_m, 0.051}))) << x_m << " " << y_m;
    }
  }
  for (const Vec3& beside_m :
       {Vec3(-0.0125, 0.005, 0.051), Vec3(0.01, -0.005, 0.051), Vec3(0.01, 0.015, 0.051)}) {
    EXPECT_TRUE(isFlesh(colourAt(image, beside_m)));
  }
  EXPECT_TRUE(isFlesh(colourAt(image, {-0.02, -0.01, 0.015})));
  EXPECT_EQ(pixel(image, 2, 2), palette::background);
  EXPECT_EQ(colourAt(image, {0, 0.036, 0}), palette::background);
}

TEST_F(OffscreenRenderer, ToolBehindTissueIsATintAndInsideItACut) {
  state_.tools[0].pose.position_m.z() = -0.05;
  const Image behind = draw();
  state_.tools[0].pose.position_m = {0, 0.2, 0};  // out of view
  const Image without = draw();
  const Colour tinted = colourAt(behind, {0.007, 0.006, -0.05});
  const Colour plain = colourAt(without, {0.007, 0.006, -0.05});
  EXPECT_TRUE(isFlesh(plain));
  EXPECT_FALSE(isSteel(tinted));
  EXPECT_GT(difference(tinted, plain), 8);
  EXPECT_GT(countNear(behind, palette::hidden_line, 40), 8) << "the dashed outline";
  EXPECT_EQ(countNear(without, palette::hidden_line, 40), 0);
  EXPECT_EQ(countNear(behind, palette::cut, 24), 0) << "behind is not inside";
  // Broadside on, half in: y = 0 plane, from x = 15 to 55 mm.
  state_.tools[0].pose = Pose{{0.035, 0, 0.01}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX()))};
  EXPECT_GT(countNear(draw(), palette::cut, 24), 5);
}

TEST_F(OffscreenRenderer, ToolHiddenByTissueIsNowhereOpaque) {
  // Lengthwise through the far side of the sphere, from z = -50 to -10 mm: even its cut is on the far side.
  state_.tools[0].pose = Pose{{0.008, 0, -0.03}, Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitY()))};
  const Image image = draw();
  const PicturePoint middle = project({0.008, 0, -0.03});
  for (int y = static_cast<int>(middle.y_px) - 25; y < middle.y_px + 25; ++y) {
    for (int x = static_cast<int>(middle.x_px) - 25; x < middle.x_px + 25; ++x) {
      EXPECT_FALSE(isSteel(pixel(image, x, y))) << x << " " << y;
    }
  }
  state_.tools[0].pose.position_m = {0, 0.2, 0};
  EXPECT_GT(difference(colourAt(image, {0.008, 0, -0.03}), colourAt(draw(), {0.008, 0, -0.03})), 8);
}

TEST_F(OffscreenRenderer, NodesHaveTheColourOfTheirState) {
  const std::vector<Vec3> positions_m = {
      {-0.015, 0.001, 0}, {-0.005, 0.001, 0}, {0.005, 0.001, 0}, {0.015, 0.001, 0}};
  addNodes(positions_m);
  state_.contact.node_states = {NodeState::free, NodeState::feasible, NodeState::infeasible,
                                NodeState::capped};
  settings_.width_px = 640;
  settings_.height_px = 480;
  const Image image = draw();
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    const Vec3 placed_m = state_.tools[0].pose.toScene(positions_m[i]);
    EXPECT_LE(difference(colourAt(image, placed_m), palette::ofNode(state_.contact.node_states[i])), 24) << i;
  }
  state_.contact.node_states.clear();  // a pipeline without nodes shows none, and no legend
  const Image none = draw();
  for (const NodeState state : {NodeState::feasible, NodeState::infeasible, NodeState::capped}) {
    EXPECT_GT(countNear(image, palette::ofNode(state), 8), 20);
    EXPECT_EQ(countNear(none, palette::ofNode(state), 8), 0);
  }
}

TEST_F(OffscreenRenderer, HiddenNodesShowUnlessFree) {
  settings_.width_px = 640;
  settings_.height_px = 480;
  addNodes({{0, 0.001, 0}});
  state_.tools[0].pose.position_m.z() = -0.05;
  const Vec3 node_m = state_.tools[0].pose.toScene({0, 0.001, 0});
  state_.contact.node_states = {NodeState::free};
  const Image free = draw();
  state_.contact.node_states = {NodeState::feasible};
  const Image feasible = draw();
  const PicturePoint at = project(node_m);
  const auto nodeInk = [&](const Image& image) {
    int count = 0;
    for (int dy = -4; dy <= 4; ++dy) {
      for (int dx = -4; dx <= 4; ++dx) {
        const Colour c = pixel(image, static_cast<int>(at.x_px) + dx, static_cast<int>(at.y_px) + dy);
        count += c.g > c.r + 30 ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_EQ(nodeInk(free), 0);
  EXPECT_GT(nodeInk(feasible), 3);
}

TEST_F(OffscreenRenderer, TextIsWrittenInTheCorner) {
  const Image blank = draw();
  const Image written = draw({"fukuhara", "t = 0.25 s"});
  int changed_in_corner = 0;
  int changed_elsewhere = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (pixel(blank, x, y) != pixel(written, x, y)) {
        ++(x < 80 && y < 40 ? changed_in_corner : changed_elsewhere);
      }
    }
  }
  EXPECT_GT(changed_in_corner, 100);
  EXPECT_EQ(changed_elsewhere, 0);
}

TEST_F(OffscreenRenderer, NonFiniteVerticesAreLeftOut) {
  scene_.ground_height_m = -0.03;
  const Image whole = draw({"t"});
  state_.positions_m[0].x() = nan;
  state_.positions_m[1].y() = std::numeric_limits<double>::infinity();
  state_.positions_m[2].z() = 1e300;
  const Image torn = draw({"t"});
  EXPECT_NE(torn.rgb, whole.rgb);
  EXPECT_TRUE(isFlesh(colourAt(torn, {-0.02, -0.008, 0.015})));
  for (Vec3& position_m : state_.positions_m) {
    position_m.setConstant(nan);
  }
  state_.tools[0].pose.position_m.setConstant(nan);
  settings_.camera.reset();
  addNodes({{0, 0, 0}});
  state_.contact.node_states = {NodeState::capped};
  const Image nothing = draw({"text stays"});
  EXPECT_GT(countNear(nothing, palette::ink, 60), 20);
}

TEST_F(OffscreenRenderer, TissueTurnedInsideOutLooksDifferent) {
  const Image proper = draw();
  for (Face& face : scene_.bodies[0].rest.faces) {
    std::swap(face[1], face[2]);
  }
  const Image inverted = draw();
  const Vec3 spot_m = {-0.02, -0.008, 0.015};
  EXPECT_LT(colourAt(inverted, spot_m).r + 40, colourAt(proper, spot_m).r);
}

// Each picture's largest pressure has the full colour, half of it half the way there, and pulls have none.
TEST_F(OffscreenRenderer, PressedTissueTakesColour) {
  const std::size_t vertices = scene_.bodies[0].rest.vertices_m.size();
  const Vec3 spot_m = {-0.02, -0.008, 0.015};
  const auto coloured = [&](double below_Pa, double above_Pa) {
    std::vector<double>& pressures_Pa = state_.volume.emplace().pressures_Pa;
    for (const Vec3& vertex_m : scene_.bodies[0].rest.vertices_m)
      pressures_Pa.push_back(vertex_m.y() < 0.01 ? below_Pa : above_Pa);
    EXPECT_EQ(pressures_Pa.size(), vertices);
    return colourAt(draw(), spot_m);
  };
  const Colour plain = colourAt(draw(), spot_m);
  EXPECT_EQ(coloured(0, 0), plain);
  EXPECT_EQ(coloured(-10, 100), plain);
  const Colour full = coloured(100, 0), half = coloured(100, 200);
  EXPECT_EQ(coloured(7, 0), full);
  EXPECT_LT(full.r + 60, plain.r);
  EXPECT_NEAR(half.r, 0.5 * (full.r + plain.r), 3);
  EXPECT_NEAR(half.g, 0.5 * (full.g + plain.g), 3);
}

TEST_F(OffscreenRenderer, DrawsSeveralBodiesAndToolsOnTheGround) {
  SceneBody second = scene_.bodies[0];
  second.first_vertex = static_cast<int>(second.rest.vertices_m.size());
  second.first_face = static_cast<int>(second.rest.faces.size());
  for (Vec3& vertex_m : second.rest.vertices_m) {
    vertex_m.x() += 0.08;
    state_.positions_m.push_back(vertex_m);
  }
  scene_.bodies.push_back(second);
  scene_.tools.push_back(scene_.tools[0]);
  state_.tools.push_back(state_.tools[0]);
  state_.tools[1].pose.position_m = {0.08, -0.005, 0.05};
  scene_.ground_height_m = -0.03;
  settings_.camera = CameraSettings{{0.04, 0.05, 0.4}, {0.04, 0, 0}, {0, 1, 0}, 35};
  const Image image = draw();
  EXPECT_TRUE(isSteel(colourAt(image, {0.01, 0.005, 0.051})));
  EXPECT_TRUE(isSteel(colourAt(image, {0.08, -0.005, 0.051})));
  EXPECT_TRUE(isFlesh(colourAt(image, {0.08, 0.02, 0.02})));
  EXPECT_NE(colourAt(image, {0.04, -0.03, 0.031}), palette::background);
}

TEST_F(OffscreenRenderer, DrawsEverySizeFromTheSmallest) {
  settings_.camera.reset();
  scene_.ground_height_m = -0.03;
  addNodes({{0, 0.001, 0}});
  state_.contact.node_states = {NodeState::feasible};
  for (const auto& [width_px, height_px] :
       {std::pair{16, 16}, {17, 333}, {641, 19}, {1921, 1089}, {4096, 64}}) {
    settings_.width_px = width_px;
    settings_.height_px = height_px;
    const Image image = draw({"a line far too long for the smallest of these pictures"});
    EXPECT_EQ(image.rgb.size(), 3u * width_px * height_px);
    EXPECT_LT(countNear(image, palette::background, 0), width_px * height_px);
  }
}

TEST_F(OffscreenRenderer, RefusesAStateOfAnotherScene) {
  const auto renderer = makeOffscreenRenderer(scene_, settings_, state_);
  state_.positions_m.pop_back();
  EXPECT_THROW(renderer->draw(state_, {}), RunError);
}

TEST_F(OffscreenRenderer, LeavesFloatingPointAsItWas) {
  draw();
  // Mesa computes with denormals off; the simulation in the same process must not.
  volatile double tiny = std::numeric_limits<double>::min();
  volatile double half = tiny / 2;
  EXPECT_GT(half, 0);
  EXPECT_EQ(half * 2, std::numeric_limits<double>::min());
}

TEST(OsMesaLibrary, MissingLibraryOrFunctionIsARunErrorInOneLine) {
  for (const std::string library : {"libNoSuchThingHere.so.8", "libm.so.6"}) {
    try {
      OsMesa mesa(16, 16, library);
      FAIL() << "no error for " << library;
    } catch (const RunError& error) {
      EXPECT_NE(std::string(error.what()).find(library), std::string::npos);
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(OsMesaLibrary, RefusesSizesBeyondItsLimit) {
  EXPECT_THROW(OsMesa(1 << 20, 1), RunError);
}

TEST(OsMesaLibrary, LeavesTheEnvironmentAsItWas) {
  const char* before = std::getenv("LP_NUM_THREADS");
  const std::string kept = before == nullptr ? "" : before;
  OsMesa mesa(16, 16);
  const char* after = std::getenv("LP_NUM_THREADS");
  EXPECT_EQ(after == nullptr, before == nullptr);
  EXPECT_EQ(std::string(after == nullptr ? "" : after), kept);
}

bool mapped(const std::string& name) {
  std::ifstream maps("/proc/self/maps");
  std::string line;
  while (std::getline(maps, line)) {
    if (line.find(name) != std::string::npos) {
      return true;
    }
  }
  return false;
}

/// Exit codes: 0 mapped by construction and not before, 1 mapped before, 2 not mapped after.
[[noreturn]] void constructAndLook() {
  if (mapped("OSMesa") || mapped("libLLVM")) {
    std::_Exit(1);
  }
  OsMesa mesa(16, 16);
  std::_Exit(mapped("OSMesa") ? 0 : 2);
}

TEST(OsMesaLibrary, IsNotMappedBeforeARendererIsMade) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";  // a fresh process, whatever ran in this one
  EXPECT_EXIT(constructAndLook(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace fissure::offscreen_renderer_test
