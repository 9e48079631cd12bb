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

/// What a part file must know before its first row.
struct PartHeader {
  const Scenario& scenario;
  const PipelineSettings& pipeline;  ///< the entry this part is the run of
  const Scene& scene;
  const RecordLayout& layout;          ///< with a series "time" of one real value a row
  std::size_t expected_rows = 0;       ///< for chunk sizes, and to say how much a torn part lacks; 0: unknown
  std::string scenario_resolved = {};  ///< kept in the part, so that it can be salvaged alone
  double flush_every_s =
      10.0;  ///< wall clock: a block is written before it is full when the last one is this old
};

/// Opens the part file of one run, replacing an older one: an HDF5 file with the group /pipelines/<name>
/// alone, written block by block in SWMR mode, so that a killed worker leaves everything up to its last block
/// readable. Rows, snapshots and frames go to datasets that exist only when the scenario asks for them. The
/// status attribute is `incomplete` until finish(). The first failed write is remembered and thrown as
/// RunError by the call that met it and by every later one, finish() included. Throws RunError when the file
/// cannot be made, std::logic_error on a layout without time or with a name twice; append, snapshot and frame
/// throw std::logic_error on data that do not fit.
std::unique_ptr<RecordSink> createPartFile(const std::filesystem::path& path, const PartHeader& header);

}  // namespace fissure
