#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "sample_run.h"
#include "store/force_inputs.h"
#include "store/read_series.h"
#include "store/reference_file.h"
#include "store/result_file.h"

namespace fissure::result_test {

namespace {

const Provenance kProvenance = {{"version", "0.1.0"}, {"command_line", "fissure run sample.yaml"}};

std::vector<PartResult> writeParts(const ScratchFolder& folder, const SampleRun& run) {
  std::vector<PartResult> parts;
  for (const PipelineSettings& pipeline : run.scenario.pipelines) {
    const auto path = folder / (pipeline.name + ".part");
    writeSamplePart(path, run, pipeline.name);
    parts.push_back({pipeline, path, {RunEnd::ok, ""}});
  }
  return parts;
}

void expectReadableWithPython(std::size_t rows) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(rows, true);
  run.scenario.record.force_inputs = true;
  const auto path = folder / "sample.h5";
  assembleResult(path, loadedSample(run), kProvenance, writeParts(folder, run));
  const std::string command =
      "/usr/bin/python3 -B " FISSURE_SOURCE_DIR "/tests/results/store/read_with_xarray.py " + path.string() +
      " " + std::to_string(run.rows) + " " + std::to_string(run.snapshots) + " " + std::to_string(run.frames);
  EXPECT_EQ(std::system(command.c_str()), 0);
}

// Needs Debian's python3-xarray, h5netcdf, netcdf4, h5py, netcdf-bin and hdf5-tools, as the setup script
// installs them.
TEST(Result, ReadsInXarrayWithAnyEngine) {
  expectReadableWithPython(13);
}

// More than one chunk of rows: 5001 rows make two chunks of 2501.
TEST(Result, ReadsInXarrayAcrossChunks) {
  expectReadableWithPython(5001);
}

TEST(Result, ReadsInXarrayWithoutAnyRow) {
  expectReadableWithPython(0);
}

// Each text once, in the order of the pipelines; no part's own summary repeats it.
TEST(Result, ProvenanceSaysWhatTheWorkersWere) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(3, true);
  std::vector<PartResult> parts;
  for (const PipelineSettings& pipeline : run.scenario.pipelines) {
    const auto path = folder / (pipeline.name + ".part");
    const auto part = openSamplePart(path, run, pipeline.name);
    part->finish({RunEnd::ok, ""}, {{"provenance/gl_version", std::string("one")},
                                    {"provenance/engine_version", "engine of " + pipeline.name}});
    parts.push_back({pipeline, path, {RunEnd::ok, ""}});
  }
  assembleResult(folder / "sample.h5", loadedSample(run), kProvenance, parts);
  const ResultInfo info = readResultInfo(folder / "sample.h5");
  Provenance expected = kProvenance;
  expected.emplace_back("gl_version", "one");
  expected.emplace_back("engine_version",
                        "engine of " + parts[0].pipeline.name + "; engine of " + parts[1].pipeline.name);
  EXPECT_EQ(info.provenance, expected);
  EXPECT_TRUE(info.pipelines[0].summary.empty());
}

TEST(Result, InfoTellsWhatWasWritten) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(6, true);
  std::vector<PartResult> parts = writeParts(folder, run);
  parts[1].status = {RunEnd::timeout, "after 3600 s"};
  const auto path = folder / "sample.h5";
  assembleResult(path, loadedSample(run), kProvenance, parts);

  const ResultInfo info = readResultInfo(path);
  EXPECT_TRUE(info.complete);
  EXPECT_EQ(info.title, "sample");
  EXPECT_EQ(info.format, "fissure-result");
  EXPECT_EQ(info.format_version, 1);
  EXPECT_EQ(info.provenance, kProvenance);
  EXPECT_EQ(info.scenario_resolved, "name: sample\n");
  ASSERT_EQ(info.pipelines.size(), 2U);
  EXPECT_EQ(info.pipelines[0].name, "paper_method");
  EXPECT_EQ(info.pipelines[0].pipeline, "fukuhara");
  EXPECT_NE(info.pipelines[0].description.find("node ray casting"), std::string::npos);
  EXPECT_EQ(nameOf(info.pipelines[1].status.end), "timeout");
  EXPECT_EQ(info.pipelines[1].status.detail, "after 3600 s");
  const Summary& summary = info.pipelines[0].summary;
  ASSERT_EQ(summary.size(), 4U);
  EXPECT_EQ(summary[0].name, "max_penetration_depth_m");
  EXPECT_EQ(std::get<double>(summary[0].value), 0.25);
  EXPECT_EQ(std::get<long long>(summary[1].value), 12);
  EXPECT_EQ(std::get<std::string>(summary[2].value), "abc");
  EXPECT_EQ(summary[3].name, "timing/step_time_p99_us");
  const auto found = [&](const std::string& name) {
    for (const DatasetInfo& dataset : info.datasets) {
      if (dataset.path == "/pipelines/paper_method/" + name) return dataset;
    }
    return DatasetInfo{};
  };
  EXPECT_EQ(found("force").shape, (std::vector<unsigned long long>{2, 6, 3}));
  EXPECT_EQ(found("force").units, "N");
  EXPECT_EQ(found("force").type, "f64");
  EXPECT_EQ(found("contact_count").type, "i64");
  EXPECT_EQ(found("saturated").type, "u8");
  EXPECT_EQ(found("law").type, "text");
  EXPECT_EQ(found("frame_images/000000").type, "") << "views hold no data of their own";
}

TEST(Result, HoldsOnlyWhatTheScenarioAskedFor) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(4, false);
  run.scene.tools[0].nodes = {};
  run.scene.tools[1].nodes = {};
  run.scene.tools[1].first_node = 0;
  const auto path = folder / "sample.h5";
  assembleResult(path, loadedSample(run), kProvenance, writeParts(folder, run));
  for (const DatasetInfo& dataset : readResultInfo(path).datasets) {
    for (const char* unasked :
         {"snapshot", "positions", "vertex", "node", "frame", "tools", "faces", "body", "force_inputs"}) {
      EXPECT_EQ(dataset.path.find(unasked), std::string::npos) << dataset.path;
    }
  }
}

// What another finite-element program needs to be given the same problem. References leave it out.
TEST(Result, HoldsTheTetrahedraOfElasticBodiesBesideTheirSurfaces) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(4, false);
  run.scenario.record.snapshots_every_s = 1.0;
  SceneBody& kidney = run.scene.bodies[1];
  TetrahedralMesh mesh{kidney.rest.vertices_m, {{0, 1, 2, 4}, {0, 3, 1, 4}, {1, 3, 2, 4}, {2, 3, 0, 4}}};
  mesh.vertices_m.emplace_back(5.2, 0.3, 0.1);
  kidney.volume = SceneVolume{mesh, {1, 4}, {0, 2, 0, 1}};
  const auto path = folder / "sample.h5", reference = folder / "reference.h5";
  assembleResult(path, loadedSample(run), kProvenance, writeParts(folder, run));
  const std::string group = "/pipelines/default/volumes/kidney/";
  const SeriesData vertices = readSeries(path, group + "vertices");
  ASSERT_EQ(vertices.shape, (std::vector<std::size_t>{5, 3}));
  for (std::size_t v = 0; v < 5; ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_EQ(vertices.values[3 * v + axis], mesh.vertices_m[v][static_cast<int>(axis)]);
  const SeriesData tetrahedra = readSeries(path, group + "tetrahedra");
  ASSERT_EQ(tetrahedra.shape, (std::vector<std::size_t>{4, 4}));
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(tetrahedra.values[i], mesh.tetrahedra[i / 4][i % 4]) << i;
  EXPECT_EQ(readSeries(path, group + "fixed_vertices").values, (std::vector<double>{1, 4}));
  EXPECT_EQ(readSeries(path, group + "region").values, (std::vector<double>{0, 2, 0, 1}));
  EXPECT_THROW(readSeries(path, "/pipelines/default/volumes/liver/vertices"), InputError) << "a shell";
  writeReference(reference, path);
  for (const DatasetInfo& dataset : readResultInfo(reference).datasets)
    EXPECT_EQ(dataset.path.find("volumes"), std::string::npos) << dataset.path;
}

TEST(Result, InputsOfForceLawsAreReadBackOrNamedAsMissing) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(5, false);
  const auto without = folder / "without.h5", with = folder / "with.h5";
  assembleResult(without, loadedSample(run), kProvenance, writeParts(folder, run));
  run.scenario.record.force_inputs = true;
  assembleResult(with, loadedSample(run), kProvenance, writeParts(folder, run));
  const ForceInputs inputs = readForceInputs(with, "paper_method");
  EXPECT_EQ(inputs.laws, (std::vector<std::string>{"hc", "linear"}));
  EXPECT_EQ(inputs.times_s, (std::vector<double>{0, 0.5, 1, 1.5, 2}));
  EXPECT_EQ(inputs.row_sizes, (std::vector<std::size_t>{0, 1, 2, 0, 1}));
  ASSERT_EQ(inputs.inputs.size(), 8U);
  EXPECT_EQ(inputs.inputs[5].deformation_m, 2 + 0.1 + 0.01) << "row 2, second triangle, second law";
  EXPECT_EQ(inputs.inputs[5].rate_m_s, -inputs.inputs[5].deformation_m);
  EXPECT_EQ(inputs.inputs[5].area_m2, 2);
  EXPECT_EQ(inputs.inputs[5].direction, Vec3(2, 1, -1));
  const auto complaint = [](const std::filesystem::path& file, const std::string& pipeline) -> std::string {
    try {
      readForceInputs(file, pipeline);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(complaint(without, "default"),
            without.string() +
                ": run default has no force_inputs/time, expected a run with record: "
                "{force_inputs: true}");
  EXPECT_NE(complaint(with, "other"), "nothing");
  EXPECT_NE(complaint(folder / "no.h5", "default"), "nothing");
  for (const char* sizes : {"[0, 1, 2, 0, 2]", "[0, 1, 2, 0, 0]", "[0, -1, 4, 0, 1]"}) {
    const std::string command = "/usr/bin/python3 -c \"import h5py; h5py.File('" + with.string() +
                                "', 'r+')['pipelines/default/force_inputs/row_size'][:] = " + sizes + "\"";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(
        complaint(with, "default"),
        with.string() + ": the force_inputs of run default are damaged: their lengths do not fit together");
  }
}

// Views slow readers down by the square of their number; the stack of frames itself is never cut.
TEST(Result, ThousandFramesHaveViews) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(4, true);
  run.frames = 1001;
  const auto path = folder / "sample.h5";
  assembleResult(path, loadedSample(run), kProvenance, writeParts(folder, run));
  EXPECT_EQ(readSeries(path, "/pipelines/default/frames").shape.at(0), 1001U);
  const SeriesData last = readSeries(path, "/pipelines/default/frame_images/000999");
  EXPECT_EQ(last.shape, (std::vector<std::size_t>{4, 5, 3}));
  EXPECT_EQ(last.values.at(59), (50 * 999 + 10 * 3 + 3 * 4 + 2) % 256);
  EXPECT_THROW(readSeries(path, "/pipelines/default/frame_images/001000"), InputError);
}

TEST(Result, MissingOrDamagedPartLeavesItsStatusAlone) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(4, false);
  std::vector<PartResult> parts = writeParts(folder, run);
  std::filesystem::resize_file(*parts[0].part, std::filesystem::file_size(*parts[0].part) / 2);
  parts[1].part.reset();
  parts[1].status = {RunEnd::crashed, "killed by signal 11"};
  const auto path = folder / "sample.h5";
  assembleResult(path, loadedSample(run), kProvenance, parts);
  const ResultInfo info = readResultInfo(path);
  EXPECT_EQ(nameOf(info.pipelines[0].status.end), "failed");
  EXPECT_NE(info.pipelines[0].status.detail.find("part file unreadable"), std::string::npos);
  EXPECT_EQ(nameOf(info.pipelines[1].status.end), "crashed");
  EXPECT_EQ(info.datasets.size(), 2U) << "the two texts of the scenario and nothing else";
}

TEST(Result, ReplacesWholeFilesAndLeavesNoOthers) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(4, false);
  const auto parts = writeParts(folder, run);
  std::filesystem::create_directory(folder / "out");
  const auto path = folder / "out" / "sample.h5";
  assembleResult(path, loadedSample(run), {{"version", "old"}}, parts);
  assembleResult(path, loadedSample(run), kProvenance, parts);
  EXPECT_EQ(readResultInfo(path).provenance, kProvenance);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"), {}), 1);
  EXPECT_THROW(assembleResult(folder / "nowhere" / "x.h5", loadedSample(run), kProvenance, parts), RunError);
}

TEST(ReadSeries, GivesValuesAndShape) {
  const ScratchFolder folder;
  const SampleRun run = makeSampleRun(3, false);
  const auto path = folder / "default.part";
  writeSamplePart(path, run, "default");
  const SeriesData force = readSeries(path, "/pipelines/default/force");
  EXPECT_EQ(force.shape, (std::vector<std::size_t>{2, 3, 3}));
  EXPECT_EQ(force.values[1 * 9 + 2 * 3 + 1], 100 + 2 + 0.1);
  const SeriesData depth = readSeries(path, "/pipelines/default/penetration_depth");
  EXPECT_TRUE(std::isnan(depth.values[1]));
  EXPECT_EQ(depth.values[2], 0.002);
  EXPECT_EQ(readSeries(path, "/pipelines/default/saturated").values, (std::vector<double>{0, 1, 1, 0, 0, 1}));
  EXPECT_THROW(readSeries(path, "/pipelines/default/law"), InputError);
  EXPECT_THROW(readSeries(path, "/pipelines/other/force"), InputError);
  EXPECT_THROW(readSeries(path, "/pipelines/default"), InputError);
  EXPECT_THROW(readSeries(folder / "none.h5", "/time"), InputError);
}

TEST(Result, NamesTheLibraryVersion) {
  EXPECT_EQ(hdf5Version().rfind("1.", 0), 0U);
}

}  // namespace
}  // namespace fissure::result_test
