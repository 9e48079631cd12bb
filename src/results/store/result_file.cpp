#include "store/result_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "base/error.h"
#include "files/temporary_file.h"
#include "hdf5/group_builder.h"
#include "hdf5/output_file.h"
#include "store/format.h"
#include "store/frame_images.h"
#include "store/part_reader.h"
#include "store/root_attributes.h"

namespace fissure {

namespace {

void writeProvenance(hid_t file, const LoadedScenario& loaded, const Provenance& provenance) {
  const h5::Id group = h5::createGroup(file, "provenance");
  for (const auto& [name, value] : provenance) h5::setAttribute(group, name, value);
  h5::writeText(group, "scenario_source", loaded.source);
  h5::writeText(group, "scenario_resolved", loaded.resolved);
}

/// What the workers say of themselves: each text once for each name, in the order of the parts.
class WorkerProvenance {
 public:
  void add(const PartReader& part) {
    for (const auto& [name, value] : part.provenance()) {
      std::vector<std::string>& known = valuesOf(name);
      if (std::find(known.begin(), known.end(), value) == known.end()) known.push_back(value);
    }
  }
  void write(hid_t group) const {
    for (const auto& [name, values] : names_) {
      std::string text;
      for (const std::string& value : values) text += (text.empty() ? "" : "; ") + value;
      h5::setAttribute(group, name, text);
    }
  }

 private:
  std::vector<std::string>& valuesOf(const std::string& name) {
    for (auto& [known, values] : names_) {
      if (known == name) return values;
    }
    return names_.emplace_back(name, std::vector<std::string>{}).second;
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> names_;
};

/// Leaves a half filled group behind when it throws.
void copyPart(const h5::OutputFile& file, hid_t pipelines, const std::vector<ForceSettings>& laws,
              const PartResult& result, WorkerProvenance& workers) {
  const PartReader part(*result.part, result.pipeline.name);
  const h5::Id group = h5::createGroup(pipelines, result.pipeline.name);
  describePipeline(group, result.pipeline, result.status);
  part.copyTo(group, file);
  attachScales(group);
  // Here and not in the part: H5Ocopy of HDF5 1.10.8 crashes on a dataset with more than eight attributes.
  if (h5::exists(group, "force")) describeForceLaws(h5::openDataset(group, "force"), laws);
  if (h5::exists(group, "frames")) addFrameImages(group, "/pipelines/" + result.pipeline.name);
  workers.add(part);
}

// A damaged part must not take the other pipelines' results with it.
void writePipeline(const h5::OutputFile& file, hid_t pipelines, const std::vector<ForceSettings>& laws,
                   const PartResult& result, WorkerProvenance& workers, bool salvaged) {
  RunStatus status = result.status;
  if (result.part && std::filesystem::exists(*result.part)) {
    try {
      return copyPart(file, pipelines, laws, result, workers);
    } catch (const RunError& error) {
      file.checkWritten();
      if (salvaged)
        throw InputError(inFile(*result.part), std::string("a damaged part file (") + error.what() + ")");
      if (status.end == RunEnd::ok) status.end = RunEnd::failed;
      status.detail +=
          (status.detail.empty() ? "" : "; ") + std::string("part file unreadable: ") + error.what();
    }
  }
  const std::string& name = result.pipeline.name;
  if (h5::exists(pipelines, name))
    h5::check(H5Ldelete(pipelines, name.c_str(), H5P_DEFAULT), "cannot drop", name);
  describePipeline(h5::createGroup(pipelines, name), result.pipeline, status);
}

void writeResult(const h5::OutputFile& file, const LoadedScenario& loaded, const Provenance& provenance,
                 const std::vector<PartResult>& parts, bool salvaged) {
  describeRoot(file, loaded.scenario.name, loaded.scenario.description, provenance, loaded.resolved,
               result_format);
  writeProvenance(file, loaded, provenance);
  {
    const h5::Id pipelines = h5::createGroup(file, "pipelines");
    WorkerProvenance workers;
    for (const PartResult& part : parts)
      writePipeline(file, pipelines, loaded.scenario.force, part, workers, salvaged);
    workers.write(h5::openGroup(file, "provenance"));
  }
  if (salvaged) h5::setAttribute(file, "salvaged", std::int32_t{1});
  h5::setAttribute(file, "complete", std::int32_t{1});
}

// The file itself has the last word before it gets its name.
void verify(const std::filesystem::path& path, std::size_t pipelines) {
  try {
    const ResultInfo info = readResultInfo(path);
    if (info.complete && info.pipelines.size() == pipelines) return;
  } catch (const InputError& error) {
    throw RunError(std::string("not all of it was written: ") + error.what());
  }
  throw RunError("not all of it was written");
}

void assemble(const std::filesystem::path& path, const LoadedScenario& loaded, const Provenance& provenance,
              const std::vector<PartResult>& parts, bool salvaged) {
  try {
    ReplacementFile replacement(path);
    try {
      writeResult(replacement.file(), loaded, provenance, parts, salvaged);
    } catch (const RunError&) {
      // What HDF5 stumbled on after a failed write is no news.
      replacement.file().checkWritten();
      throw;
    }
    replacement.close();
    verify(replacement.temporaryPath(), parts.size());
    replacement.commit();
  } catch (const RunError& error) {
    throw RunError(path.string() + ": " + error.what());
  }
}

}  // namespace

void assembleResult(const std::filesystem::path& path, const LoadedScenario& loaded,
                    const Provenance& provenance, const std::vector<PartResult>& parts) {
  assemble(path, loaded, provenance, parts, false);
}

void assembleSalvaged(const std::filesystem::path& path, const LoadedScenario& loaded,
                      const Provenance& provenance, const PartResult& part) {
  assemble(path, loaded, provenance, {part}, true);
}

void removeHalfWritten(const std::filesystem::path& path, int process) {
  std::error_code ignored;
  for (int n = 0; std::filesystem::remove(TemporaryFile::nameFor(path, process, n), ignored); ++n) {
  }
}

std::string hdf5Version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  h5::check(H5get_libversion(&major, &minor, &release), "cannot ask HDF5 for its version");
  return fmt::format("{}.{}.{}", major, minor, release);
}

}  // namespace fissure
