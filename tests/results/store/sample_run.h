#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "base/record.h"
#include "base/record_sink.h"
#include "base/scene.h"
#include "scenario/load.h"
#include "scenario/scenario.h"

namespace fissure {

/// A folder of its own that goes away with the object.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A made-up run whose every value follows from its row: two tetrahedra (4 vertices, 4 faces each), two tools
/// of one triangle with two nodes each, two laws, two tools, step 0.5 s. read_with_xarray.py knows the same
/// formulas:
///   time = row/2   penetration_depth = row/1000, missing (NaN) in row 1   contact_count = 3 row
///   force[law][row][axis] = 100 law + row + axis/10   force_elastic[law][row] = 10 law + row
///   tool_position[row][tool][axis] = row + 10 tool + 100 axis   saturated[row][tool] = (row + tool) % 2
///   timing/step_time_us = 7 row   positions[snapshot][vertex][axis] = snapshot + vertex/10 + axis/100
///   vertex_contact[snapshot][vertex] = vertex % 2   node_state[snapshot][node] = node
///   frames[frame][y][x][channel] = 50 frame + 10 y + 3 x + channel (5 x 4 pixels)
/// Where its scenario is changed to ask for force_inputs, row % 3 triangles collide, and of the i-th
///   triangle = row + i   deformation[law] = row + i/10 + law/100   deformation_rate = -deformation
///   area = 1 + i   direction = (row, i, -1)
struct SampleRun {
  Scenario scenario;
  Scene scene;
  RecordLayout layout;
  std::size_t rows = 0;
  std::size_t snapshots = 0;
  std::size_t frames = 0;
};

/// With snapshots and frames when asked for; two pipelines, `fukuhara` and `default`.
SampleRun makeSampleRun(std::size_t rows, bool with_pictures);

RecordRow sampleRow(const RecordLayout& layout, std::size_t row);
State sampleState(std::size_t snapshot);
/// With what the force laws saw, alone.
State sampleInputs(std::size_t row);
Image sampleImage(std::size_t frame);

/// A part of the sample run, unfinished: all rows, snapshots and frames appended.
std::unique_ptr<RecordSink> openSamplePart(const std::filesystem::path& path, const SampleRun& run,
                                           const std::string& pipeline);
void appendSamples(RecordSink& sink, const SampleRun& run);
/// The same, finished with a summary.
void writeSamplePart(const std::filesystem::path& path, const SampleRun& run, const std::string& pipeline);

LoadedScenario loadedSample(const SampleRun& run);

/// How a child process that ran `work` ended; what it printed on stderr is in `errors`.
struct ChildResult {
  bool exited = false;
  int code = -1;  ///< exit code, or the signal
  std::string errors;
};
/// Runs `work` in a child process and exits it with the code it returns. An exception gives 3 and its text on
/// stderr.
ChildResult runInChild(const std::function<int()>& work);

}  // namespace fissure
