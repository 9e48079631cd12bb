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

/// One pipeline's run as the front knows it.
struct PartResult {
  PipelineSettings pipeline;
  std::optional<std::filesystem::path>
      part;  ///< no value: nothing usable was written; only the status is stored
  RunStatus status;
};

/// Attributes of /provenance, in order: name and value.
using Provenance = std::vector<std::pair<std::string, std::string>>;

/// Joins the parts of one scenario into the result file `path`, with all views, scales and `complete` = 1.
/// Written beside `path` under a temporary name, synced, then renamed, and the directory synced: under `path`
/// stands either the whole file or what stood there before. Throws RunError (a full disk too); the temporary
/// file is removed then. A run whose part is damaged has the status `failed`; whether HDF5 crashes on it is
/// not known here.
void assembleResult(const std::filesystem::path& path, const LoadedScenario& loaded,
                    const Provenance& provenance, const std::vector<PartResult>& parts);

/// The same for one part whose run nobody finished; the file says so with `salvaged` = 1. Throws InputError
/// when the part cannot be copied.
void assembleSalvaged(const std::filesystem::path& path, const LoadedScenario& loaded,
                      const Provenance& provenance, const PartResult& part);

/// Removes what a process that died within one of these had written of `path`.
void removeHalfWritten(const std::filesystem::path& path, int process);

/// What the table at the end of `run` and `info` read.
struct PipelineResult {
  std::string name;
  std::string pipeline;
  std::string description;
  std::string precision;
  RunStatus status;
  Summary summary;  ///< scalars, with those of timing/ named "timing/..."
};
struct DatasetInfo {
  std::string path;
  std::string type;  ///< "f64", "i64", "u8", "text"
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

/// Reads a result file (or a part). Throws InputError when it is missing, no HDF5 file, not a fissure result,
/// damaged (a run with an unknown status too), or of a newer
/// format_version.
ResultInfo readResultInfo(const std::filesystem::path& path);

/// Versions of the HDF5 library in use at run time, for provenance.
std::string hdf5Version();

}  // namespace fissure
