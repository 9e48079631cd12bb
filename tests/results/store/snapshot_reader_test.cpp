// What snapshots leave in a result is what a picture needs, to the last bit.
#include "store/snapshot_reader.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "drawable_run.h"
#include "sample_run.h"
#include "store/read_series.h"

namespace fissure::snapshot_reader_test {

namespace {

void expectSameSurface(const TriangleMesh& a, const TriangleMesh& b) {
  EXPECT_EQ(a.vertices_m, b.vertices_m);
  EXPECT_EQ(a.faces, b.faces);
}

void expectSamePose(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.position_m, b.position_m);
  EXPECT_EQ(a.orientation.coeffs(), b.orientation.coeffs());
}

TEST(SnapshotReader, GivesBackSceneAndStates) {
  const ScratchFolder folder;
  writeDrawableResult(folder / "r.h5", {{"a"}});
  const SnapshotReader reader(folder / "r.h5", "a");
  const Scene scene = drawableScene();
  ASSERT_EQ(reader.times_s(), (std::vector<double>{0, 0.1, 0.2}));
  ASSERT_EQ(reader.scene().bodies.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) {
    const SceneBody& body = reader.scene().bodies[b];
    EXPECT_EQ(body.rest.faces, scene.bodies[b].rest.faces);
    EXPECT_EQ(body.rest.vertices_m.size(), 8u);
    EXPECT_EQ(body.first_vertex, scene.bodies[b].first_vertex);
  }
  ASSERT_EQ(reader.scene().tools.size(), 3u);
  for (std::size_t t = 0; t < 3; ++t) {
    expectSameSurface(reader.scene().tools[t].surface, scene.tools[t].surface);
    EXPECT_EQ(reader.scene().tools[t].nodes.positions_m, scene.tools[t].nodes.positions_m);
    EXPECT_EQ(reader.scene().tools[t].first_node, scene.tools[t].first_node);
  }
  ASSERT_EQ(reader.scene().clamps.size(), 1u);
  expectSameSurface(reader.scene().clamps[0].handle, scene.clamps[0].handle);
  for (std::size_t k = 0; k < 3; ++k) {
    const State read = reader.at(k), state = drawableState(k);
    EXPECT_EQ(read.time_s, state.time_s);
    EXPECT_EQ(read.positions_m, state.positions_m);
    EXPECT_EQ(read.contact.node_states, state.contact.node_states);
    for (std::size_t t = 0; t < 3; ++t) expectSamePose(read.tools.at(t).pose, state.tools[t].pose);
    expectSamePose(read.clamps.at(0).pose, state.clamps[0].pose);
    EXPECT_EQ(reader.depths(k).depth_m, drawableDepth_m(k));
  }
}

TEST(SnapshotReader, ARunWithoutSnapshotsIsEmpty) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(5, false);
  writeSamplePart(folder / "a.part", run, "default");
  assembleResult(folder / "r.h5", loadedSample(run), {},
                 {{run.scenario.pipelines[1], folder / "a.part", {RunEnd::ok, ""}},
                  {run.scenario.pipelines[0], std::nullopt, {RunEnd::crashed, ""}}});
  for (const char* name : {"default", "paper_method"}) {
    const SnapshotReader reader(folder / "r.h5", name);
    EXPECT_TRUE(reader.times_s().empty());
    EXPECT_TRUE(reader.scene().bodies.empty());
  }
}

// The sample run has positions of its tools, but no orientations.
TEST(SnapshotReader, WhatIsMissingIsNamed) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(5, true);
  writeSamplePart(folder / "a.part", run, "default");
  assembleResult(folder / "r.h5", loadedSample(run), {},
                 {{run.scenario.pipelines[1], folder / "a.part", {RunEnd::ok, ""}}});
  const SnapshotReader reader(folder / "r.h5", "default");
  try {
    reader.at(0);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), (folder / "r.h5").string() + ": damaged: there is no tool_quaternion");
  }
}

TEST(SnapshotWriter, StoresHandlesAndTheirPlacesOnlyWhereThereAreSome) {
  const ScratchFolder folder;
  writeDrawableResult(folder / "r.h5", {{"a"}});
  EXPECT_EQ(readSeries(folder / "r.h5", "/pipelines/a/visuals/clamp_handle/faces").shape,
            (std::vector<std::size_t>{12, 3}));
  EXPECT_EQ(readSeries(folder / "r.h5", "/pipelines/a/clamp_quaternion").shape,
            (std::vector<std::size_t>{3, 1, 4}));
  const SampleRun run = makeSampleRun(5, true);
  writeSamplePart(folder / "b.part", run, "default");
  for (const char* name : {"visuals/clamp_handle/faces", "clamp_position"})
    EXPECT_THROW(readSeries(folder / "b.part", std::string("/pipelines/default/") + name), InputError)
        << name;
}

}  // namespace
}  // namespace fissure::snapshot_reader_test
