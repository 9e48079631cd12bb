#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "base/record.h"
#include "base/record_sink.h"
#include "base/scene.h"
#include "scenario/scenario.h"

namespace fissure {

/// The arguments of createPartFile().
struct PartHeader {
  const Scenario& scenario;
  const PipelineSettings& pipeline;  ///< the entry whose run is written
  const Scene& scene;
  /// Determines chunk sizes and tells how much an incomplete part lacks; 0: unknown.
  /// Must have a series "time" of one real value per row.
  const RecordLayout& layout;
  std::int64_t expected_steps = 0;
  std::string scenario_resolved = {};  ///< stored, so that the part alone can be salvaged
  /// Wall-clock time after which a block is written even if it is not full, seconds.
  double flush_every_s = 10.0;
};

/// Creates the part file of one run, replacing an older one: an HDF5 file with only the group
/// /pipelines/<name>, written block by block in SWMR mode, so that a killed worker leaves all complete blocks
/// readable. Datasets for snapshots and frames exist only if the scenario asks for them. The status attribute
/// is `incomplete` until finish(). The first failed write is thrown as RunError by the call in which it is
/// noticed and by every later one, including finish(). Throws RunError when the file cannot be created,
/// std::logic_error for a layout without time or with a name twice; append, snapshot and frame throw
/// std::logic_error on data that do not fit.
std::unique_ptr<RecordSink> createPartFile(const std::filesystem::path& path, const PartHeader& header);

}  // namespace fissure
