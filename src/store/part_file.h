#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

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
  const RecordLayout& layout;
  std::size_t expected_rows = 0;     ///< for chunk sizes only
};

/// Opens the part file of one run: an HDF5 file with the group /pipelines/<name> alone, written block by block in SWMR
/// mode, so that a killed worker leaves everything up to its last block readable. Rows, snapshots and frames go to
/// datasets that exist only when the scenario asks for them. The status attribute is "incomplete" until finish().
/// The first failed write is remembered and thrown as RunError, at the latest by finish().
std::unique_ptr<RecordSink> createPartFile(const std::filesystem::path& path, const PartHeader& header);

}  // namespace fissure
