#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/record.h"
#include "base/run_status.h"
#include "scenario/load.h"

namespace fissure {

/// The part file and the status of one run, for the assembly of a result.
struct PartResult {
  PipelineSettings pipeline;
  /// Path of the part; no value: nothing usable was written, and only the status is stored.
  std::optional<std::filesystem::path> part;
  RunStatus status;
};

/// Attributes of /provenance, in order: name and value.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// Joins the parts of one scenario into the result file `path`, with all views, scales and `complete` = 1. It
/// is written under a temporary name beside `path`, flushed to disk and renamed: `path` is replaced by the
/// complete file or not at all. Throws RunError when writing fails (a full disk); the temporary file is then
/// removed. A run whose part is damaged gets the status `failed`. HDF5 may crash on a damaged part: try to
/// read it in a child process first.
void assembleResult(const std::filesystem::path& path, const LoadedScenario& loaded,
                    const Provenance& provenance, const std::vector<PartResult>& parts);

/// The same for one part of a run that was never finished; the file has the attribute `salvaged` = 1. Throws
/// InputError when the part cannot be copied.
void assembleSalvaged(const std::filesystem::path& path, const LoadedScenario& loaded,
                      const Provenance& provenance, const PartResult& part);

/// Removes the temporary files of `path` that a process which died in one of these functions has left.
void removeHalfWritten(const std::filesystem::path& path, int process);

/// The attributes and summary of one run in a result.
struct PipelineResult {
  std::string name;
  std::string pipeline;
  std::string description;
  std::string precision;
  RunStatus status;
  /// All scalars; those of timing/ are named "timing/...".
  Summary summary;
};
struct DatasetInfo {
  std::string path;
  /// "f64", "i64", "u8", "text".
  std::string type;
  std::vector<unsigned long long> shape;
  std::string units;
};
struct ResultInfo {
  std::string title;
  std::string format;
  int format_version = 0;
  bool complete = false;
  bool salvaged = false;   ///< made by assembleSalvaged()
  bool reference = false;  ///< made by writeReference()
  Provenance provenance;
  std::string scenario_resolved;
  std::vector<PipelineResult> pipelines;
  std::vector<DatasetInfo> datasets;
};

/// Reads the attributes, summaries and list of datasets of a result file or a part. Throws InputError when it
/// is missing, no HDF5 file, not a fissure result, damaged (including a run with an unknown status), or of a
/// newer format_version.
ResultInfo readResultInfo(const std::filesystem::path& path);

/// Version of the HDF5 library at run time, for provenance.
std::string hdf5Version();

}  // namespace fissure
