// Model only what a scene requires: what nobody asked for is not allocated.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "contact/grid_nodes.h"
#include "engine/simulation.h"
#include "mesh/primitives.h"
#include "scene/place.h"

namespace {
long long allocated_bytes = 0;
}

// Not inlined: GCC 12 would otherwise take malloc and free for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated_bytes += static_cast<long long>(size);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocated_bytes += static_cast<long long>(size);
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace fissure::allocation_test {

namespace {

/// A sphere of 2,048 triangles (1,026 vertices) and a spatula far above it.
class Allocated : public testing::Test {
 protected:
  Allocated() {
    BodySettings body;
    body.name = "sphere";
    body.shape = SphereShape{.radius_m = 0.03, .subdivisions = 4};
    scenario.bodies = {body};
    ToolSettings tool;
    tool.name = "spatula";
    tool.nodes.resolution = {32, 32};
    scenario.tools = {tool};
  }

  /// Bytes for building the simulation and for one step, by `operator new` (Bullet's own arrays do not
  /// count).
  long long bytes(PipelineKind pipeline) {
    const PipelineSettings entry{.name = "p", .pipeline = pipeline};
    Scene scene;
    scene.bodies.push_back({.name = "sphere", .rest = placeBody(scenario.bodies[0])});
    const Vec3 size_m = std::get<BoxShape>(scenario.tools[0].shape).size_m;
    scene.tools.push_back({.name = "spatula", .surface = makeBox(size_m), .box_size_m = size_m});
    if (entry.usesNodes()) scene.tools[0].nodes = makeGridNodes(size_m, scenario.tools[0].nodes.resolution);
    const Pose above{.position_m = Vec3(0, 1, 0), .orientation = Quat::Identity()};
    const long long before = allocated_bytes;
    auto simulation = makeSimulation(scenario, entry, scene, {above});
    simulation->step({above});
    return allocated_bytes - before;
  }

  Scenario scenario;
};

TEST_F(Allocated, WithoutLawsNoCentroidsAndNoContactNormals) {
  for (const PipelineKind pipeline : {PipelineKind::default_sdf, PipelineKind::fukuhara}) {
    scenario.force.clear();
    const long long without = bytes(pipeline);
    scenario.force = {{.name = "hc", .model = ForceModel::hunt_crossley}};
    const long long with = bytes(pipeline);
    const long long centroids = 2 * 2048 * static_cast<long long>(sizeof(Vec3));
    const long long normals = (2048 + 1026) * static_cast<long long>(sizeof(Vec3));
    EXPECT_GE(with - without, centroids + normals) << traitsOf(pipeline).name;
  }
}

TEST_F(Allocated, OnlyWhatTheLawsAskForOfDeformationAndAreas) {
  const auto bytesWith = [&](const std::vector<ForceSettings>& laws) {
    scenario.force = laws;
    return bytes(PipelineKind::fukuhara);
  };
  const ForceSettings paper{.name = "hc", .model = ForceModel::hunt_crossley};
  ForceSettings corotated = paper, per_area = paper, velocities = paper;
  corotated.deformation = DeformationKind::corotated;
  per_area.per_area = true;
  velocities.rate = RateSource::velocities;
  const long long plain = bytesWith({paper});
  const long long arms = 1026 * static_cast<long long>(sizeof(Vec3));
  const long long areas = 2048 * static_cast<long long>(sizeof(double));
  const long long centroids = 2048 * static_cast<long long>(sizeof(Vec3));
  EXPECT_GE(bytesWith({corotated}), plain + arms);
  EXPECT_GE(bytesWith({per_area}), plain + areas);
  EXPECT_LE(bytesWith({velocities}), plain - centroids) << "no centroids of the last step";
  const long long second_law = bytesWith({paper, paper}) - plain;
  EXPECT_LT(second_law, areas) << "a second law of one kind shares what the first needs";
}

TEST_F(Allocated, BulletsOwnContactBuildsNoNodesAndNoTreeOfFaces) {
  const long long nodes = 2 * 32 * 32 * static_cast<long long>(sizeof(Vec3));
  const long long tree = 2048 * static_cast<long long>(sizeof(Face));
  EXPECT_GE(bytes(PipelineKind::fukuhara) - bytes(PipelineKind::default_sdf), 2 * nodes + tree);
}

// What a step of a press needs is there once the press has been as deep before.
TEST_F(Allocated, NothingMoreOnceContactWasAsLarge) {
  scenario.force.clear();
  scenario.time.step_s = 0.001;
  scenario.ground = GroundSettings{.height_m = -0.03};
  for (const PipelineKind pipeline : {PipelineKind::fukuhara, PipelineKind::swept}) {
    const PipelineSettings entry{.name = "p", .pipeline = pipeline};
    Scene scene;
    scene.bodies.push_back({.name = "sphere", .rest = placeBody(scenario.bodies[0])});
    const Vec3 size_m(0.04, 0.002, 0.015);
    scene.tools.push_back({.name = "spatula", .surface = makeBox(size_m), .box_size_m = size_m});
    if (entry.usesNodes()) scene.tools[0].nodes = makeGridNodes(size_m, {32, 32});
    std::vector<Pose> pose{{.position_m = Vec3(0, 0.033, 0), .orientation = Quat::Identity()}};
    auto simulation = makeSimulation(scenario, entry, scene, pose);
    const auto press = [&](double way_m) {
      pose[0].position_m.y() -= way_m;
      simulation->step(pose);
    };
    int contacts = 0;
    for (int i = 0; i < 60; ++i) {
      press(0.0002);
      contacts += simulation->state().contact.contact_count;
    }
    ASSERT_GT(contacts, 0) << "no contact, no test: " << traitsOf(pipeline).name;
    for (int i = 0; i < 60; ++i) press(-0.0002);
    const long long before = allocated_bytes;
    for (int i = 0; i < 30; ++i) press(0.0002);
    EXPECT_EQ(allocated_bytes, before) << traitsOf(pipeline).name;
  }
}

}  // namespace
}  // namespace fissure::allocation_test
