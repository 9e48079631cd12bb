#include "sample_run.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "store/part_file.h"

namespace fissure {

namespace {

constexpr int kWidth = 5;
constexpr int kHeight = 4;

TriangleMesh tetrahedron(double x_m) {
  return {{{x_m, 0, 0}, {x_m + 1, 0, 0}, {x_m, 1, 0}, {x_m, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

SceneTool blade(const std::string& name, int first_node) {
  SceneTool tool;
  tool.name = name;
  tool.surface = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  tool.nodes.positions_m = {{0, 0, 0.5}, {0, 0, -0.5}};
  tool.nodes.normals = {{0, 0, 1}, {0, 0, -1}};
  tool.nodes.partners = {1, -1};
  tool.nodes.thicknesses_m = {1.0, std::numeric_limits<double>::infinity()};
  tool.first_node = first_node;
  return tool;
}

RecordLayout sampleLayout() {
  RecordLayout layout;
  layout.add({"time", "s", "simulated time", ValueType::real, {}});
  layout.addAxis({"law", {"hc", "linear"}});
  layout.addAxis({"xyz", {"x", "y", "z"}});
  layout.addAxis({"tool", {"left", "right"}});
  layout.add({"penetration_depth", "m", "deepest penetration", ValueType::real, {}});
  layout.add({"contact_count", "1", "contacts", ValueType::count, {}});
  layout.add({"force", "N", "force on the tools", ValueType::real, {"law", "xyz"}});
  layout.add({"force_elastic", "N", "its elastic term", ValueType::real, {"law"}});
  layout.add({"tool_position", "m", "tool positions", ValueType::real, {"tool", "xyz"}});
  layout.add({"saturated", "1", "beyond the device's limit", ValueType::flag, {"tool"}});
  layout.add({"timing/step_time_us", "us", "wall time of a step", ValueType::real, {}});
  return layout;
}

}  // namespace

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "fissure_store_XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

SampleRun makeSampleRun(std::size_t rows, bool with_pictures) {
  SampleRun run;
  run.scenario.name = "sample";
  run.scenario.force = {{.name = "hc", .model = ForceModel::hunt_crossley},
                        {.name = "linear",
                         .model = ForceModel::linear_elastic,
                         .deformation = DeformationKind::corotated,
                         .per_area = true}};
  run.scenario.description = "A made-up run";
  run.scenario.time.step_s = 0.5;
  PipelineSettings fukuhara;
  fukuhara.name = "paper_method";
  fukuhara.pipeline = PipelineKind::fukuhara;
  PipelineSettings bullet;
  bullet.name = "default";
  bullet.pipeline = PipelineKind::default_sdf;
  run.scenario.pipelines = {fukuhara, bullet};
  run.scene.bodies = {{"liver", tetrahedron(0), 0, 0}, {"kidney", tetrahedron(5), 4, 4}};
  run.scene.tools = {blade("left", 0), blade("right", 2)};
  run.layout = sampleLayout();
  run.rows = rows;
  if (with_pictures) {
    run.scenario.record.snapshots_every_s = 1.0;
    run.scenario.record.frames = FrameSettings{2.0, kWidth, kHeight, std::nullopt};
    run.snapshots = std::min<std::size_t>((rows + 1) / 2, 100);
    run.frames = std::min<std::size_t>((rows + 3) / 4, 4);
  }
  return run;
}

RecordRow sampleRow(const RecordLayout& layout, std::size_t row) {
  const double r = static_cast<double>(row);
  RecordRow values(layout.columns());
  const auto at = [&](const char* name) { return &values[layout.find(name)->first_column]; };
  *at("time") = r / 2;
  *at("penetration_depth") = row == 1 ? std::numeric_limits<double>::quiet_NaN() : r / 1000;
  *at("contact_count") = 3 * r;
  *at("timing/step_time_us") = 7 * r;
  for (int pair = 0; pair < 2; ++pair) {
    for (int axis = 0; axis < 3; ++axis) {
      at("force")[3 * pair + axis] = 100 * pair + r + axis / 10.0;
      at("tool_position")[3 * pair + axis] = r + 10 * pair + 100 * axis;
    }
    at("force_elastic")[pair] = 10 * pair + r;
    at("saturated")[pair] = static_cast<double>((row + static_cast<std::size_t>(pair)) % 2);
  }
  return values;
}

State sampleState(std::size_t snapshot) {
  State state;
  state.time_s = static_cast<double>(snapshot);
  for (int vertex = 0; vertex < 8; ++vertex) {
    const double value = state.time_s + vertex / 10.0;
    state.positions_m.emplace_back(value, value + 0.01, value + 0.02);
    state.contact.vertex_contact.push_back(static_cast<std::uint8_t>(vertex % 2));
  }
  state.contact.node_states = {NodeState::free, NodeState::feasible, NodeState::infeasible,
                               NodeState::capped};
  return state;
}

State sampleInputs(std::size_t row) {
  State state;
  const double r = static_cast<double>(row);
  state.time_s = r / 2;
  for (std::size_t i = 0; i < row % 3; ++i) {
    state.colliding_triangles.push_back(static_cast<int>(row + i));
    const double of_triangle = static_cast<double>(i);
    for (int law = 0; law < 2; ++law) {
      const double value = r + of_triangle / 10 + law / 100.0;
      state.law_inputs.push_back({value, -value, 1 + of_triangle, Vec3(r, of_triangle, -1)});
    }
  }
  return state;
}

Image sampleImage(std::size_t frame) {
  Image image{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        image.rgb.push_back(
            static_cast<std::uint8_t>(50 * static_cast<int>(frame) + 10 * y + 3 * x + channel));
      }
    }
  }
  return image;
}

std::unique_ptr<RecordSink> openSamplePart(const std::filesystem::path& path, const SampleRun& run,
                                           const std::string& pipeline) {
  for (const PipelineSettings& entry : run.scenario.pipelines) {
    if (entry.name != pipeline) continue;
    return createPartFile(path, {.scenario = run.scenario,
                                 .pipeline = entry,
                                 .scene = run.scene,
                                 .layout = run.layout,
                                 .expected_steps = static_cast<std::int64_t>(run.rows) - 1,
                                 .scenario_resolved = "name: sample\n"});
  }
  throw std::logic_error("no such pipeline");
}

void appendSamples(RecordSink& sink, const SampleRun& run) {
  for (std::size_t row = 0; row < run.rows; ++row) {
    if (run.scenario.record.force_inputs) sink.forceInputs(sampleInputs(row));
    sink.append(sampleRow(run.layout, row));
  }
  for (std::size_t snapshot = 0; snapshot < run.snapshots; ++snapshot) sink.snapshot(sampleState(snapshot));
  for (std::size_t frame = 0; frame < run.frames; ++frame) {
    sink.frame(2.0 * static_cast<double>(frame), sampleImage(frame));
  }
}

void writeSamplePart(const std::filesystem::path& path, const SampleRun& run, const std::string& pipeline) {
  const auto part = openSamplePart(path, run, pipeline);
  appendSamples(*part, run);
  part->finish({RunEnd::ok, ""}, {{"max_penetration_depth_m", 0.25},
                                  {"steps", 12LL},
                                  {"final_state_hash", std::string("abc")},
                                  {"timing/step_time_p99_us", 9.5}});
}

LoadedScenario loadedSample(const SampleRun& run) {
  LoadedScenario loaded;
  loaded.scenario = run.scenario;
  loaded.source = "# größer\nname: sample\n";
  loaded.resolved = "name: sample\n";
  return loaded;
}

ChildResult runInChild(const std::function<int()>& work) {
  const ScratchFolder folder;
  const std::filesystem::path log = folder / "stderr";
  const pid_t child = ::fork();
  if (child == 0) {
    const int descriptor = ::open(log.c_str(), O_WRONLY | O_CREAT, 0600);
    ::dup2(descriptor, STDERR_FILENO);
    int code = 3;
    try {
      code = work();
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s", error.what());
    }
    // An ordinary exit: what a library prints while it is taken down is part of the test.
    std::exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  std::ifstream file(log);
  std::ostringstream text;
  text << file.rdbuf();
  return {WIFEXITED(status), WIFEXITED(status) ? WEXITSTATUS(status) : WTERMSIG(status), text.str()};
}

}  // namespace fissure
