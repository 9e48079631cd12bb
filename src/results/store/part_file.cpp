#include "store/part_file.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/error.h"
#include "base/steps.h"
#include "files/disk_error.h"
#include "hdf5/output_file.h"
#include "store/force_input_writer.h"
#include "store/format.h"
#include "store/series_writer.h"
#include "store/snapshot_writer.h"

namespace fissure {

namespace {

using Clock = std::chrono::steady_clock;

std::size_t expectedRows(const PartHeader& header) {
  if (header.expected_steps == 0) return 0;
  const int every = stepsPerRow(header.scenario.record, header.scenario.measure);
  return static_cast<std::size_t>(everyNth(header.expected_steps, every));
}

std::size_t expectedSnapshots(const PartHeader& header) {
  if (header.expected_steps == 0) return 0;
  const double last_s = static_cast<double>(header.expected_steps) * header.scenario.time.step_s;
  return 1 + static_cast<std::size_t>(std::ceil(last_s / *header.scenario.record.snapshots_every_s));
}

// Where a summary value belongs: "timing/x" is attribute x of the group timing.
std::pair<std::string, std::string> groupAndAttribute(const std::string& name) {
  for (const std::string group : {"timing", "provenance"}) {
    if (name.starts_with(group + "/")) return {group, name.substr(group.size() + 1)};
  }
  return {"summary", name};
}

class PartFile : public RecordSink {
 public:
  PartFile(const std::filesystem::path& path, const PartHeader& header);
  ~PartFile() override;

  void forceInputs(const State& state) override;
  void append(const RecordRow& row) override;
  void snapshot(const State& state) override;
  void frame(double time_s, const Image& image) override;
  void finish(const RunStatus& status, const Summary& summary) override;

 private:
  template <typename Work>
  void guarded(Work work);
  void makeDatasets(const PartHeader& header);
  void writeBlock();
  void closeDatasets();
  void writeSummary(const RunStatus& status, const Summary& summary) const;
  void verify(const RunStatus& status) const;

  std::filesystem::path path_;
  std::string group_;
  Clock::duration flush_every_;
  Clock::time_point last_block_ = Clock::now();
  hsize_t rows_ = 0;
  bool finished_ = false;
  std::optional<std::string> first_error_;
  h5::OutputFile file_;
  std::optional<SeriesWriter> series_;
  std::optional<ForceInputWriter> force_inputs_;
  std::optional<SnapshotWriter> snapshots_;
  std::optional<FrameWriter> frames_;
};

PartFile::PartFile(const std::filesystem::path& path, const PartHeader& header)
    : path_(path),
      group_("/pipelines/" + header.pipeline.name),
      flush_every_(
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(header.flush_every_s))) {
  guarded([&] {
    file_ = h5::OutputFile::create(path, H5F_ACC_TRUNC, h5::Space::paged);
    h5::setAttribute(file_, "title", header.scenario.name);
    h5::setAttribute(file_, "format", std::string(part_format));
    h5::setAttribute(file_, "format_version", format_version);
    h5::setAttribute(file_, "expected_steps", header.expected_steps);
    h5::setAttribute(file_, "steps_per_row",
                     std::int64_t{stepsPerRow(header.scenario.record, header.scenario.measure)});
    const h5::Id provenance = h5::createGroup(file_, "provenance");
    h5::writeText(provenance, "scenario_resolved", header.scenario_resolved);
    makeDatasets(header);
    h5::check(H5Fstart_swmr_write(file_), "cannot start writing");
  });
}

PartFile::~PartFile() {
  // Without finish() what came so far is kept, as far as the disk takes it.
  if (finished_ || first_error_ || !series_) return;
  try {
    writeBlock();
  } catch (const std::exception&) {
    closeDatasets();
  }
}

void PartFile::makeDatasets(const PartHeader& header) {
  const h5::Id pipelines = h5::createGroup(file_, "pipelines");
  GroupBuilder group(pipelines, header.pipeline.name);
  describePipeline(group.id(), header.pipeline, {RunEnd::incomplete, ""});
  series_.emplace(group, header.layout, rowsInChunk(expectedRows(header)));
  const RecordSettings& record = header.scenario.record;
  if (record.force_inputs) {
    std::vector<std::string> laws;
    for (const ForceSettings& law : header.scenario.force) laws.push_back(law.name);
    force_inputs_.emplace(group, laws, rowsInChunk(expectedRows(header)));
  }
  if (record.snapshots_every_s) {
    snapshots_.emplace(group, header.scene, expectedSnapshots(header));
    addBodies(group, header.scene);
    addVolumes(group, header.scene);
    addHandles(group, header.scene);
  }
  if (record.snapshots_every_s || header.scene.nodeCount() > 0) addTools(group, header.scene);
  if (record.frames) frames_.emplace(group, record.frames->width_px, record.frames->height_px);
}

// Runs what may fail on the disk, unless that has happened before: then the first error is thrown again.
// After it no more is written, and the file is let go.
template <typename Work>
void PartFile::guarded(Work work) {
  if (finished_) throw std::logic_error("a part file was written to after finish");
  if (first_error_) throw DiskError(*first_error_);
  try {
    work();
    file_.checkWritten();
  } catch (const RunError& error) {
    // What HDF5 stumbled on after a failed write is no news.
    first_error_ = path_.string() + ": " + file_.writeFailure().value_or(error.what());
    closeDatasets();
    file_.reset();
    throw DiskError(*first_error_);
  }
}

void PartFile::forceInputs(const State& state) {
  if (!force_inputs_ && !first_error_)
    throw std::logic_error("inputs of force laws that the scenario did not ask for");
  guarded([&] {
    if (force_inputs_->append(state)) force_inputs_->writeData();
  });
}

void PartFile::append(const RecordRow& row) {
  guarded([&] {
    const bool full = series_->append(row);
    ++rows_;
    if (full || Clock::now() - last_block_ >= flush_every_) writeBlock();
  });
}

void PartFile::snapshot(const State& state) {
  if (!snapshots_ && !first_error_) throw std::logic_error("a snapshot that the scenario did not ask for");
  guarded([&] {
    if (snapshots_->append(state)) snapshots_->writeData();
  });
}

void PartFile::frame(double time_s, const Image& image) {
  if (!frames_ && !first_error_) throw std::logic_error("a frame that the scenario did not ask for");
  guarded([&] { frames_->append(time_s, image); });
}

// Times reach the file after everything they stand for: a reader of a torn file trusts rows up to the last
// time.
void PartFile::writeBlock() {
  series_->writeData();
  if (force_inputs_) force_inputs_->writeData();
  if (snapshots_) snapshots_->writeData();
  file_.flush();
  series_->writeTime();
  if (snapshots_) snapshots_->writeTimes();
  if (frames_) frames_->writeTimes();
  file_.flush();
  last_block_ = Clock::now();
}

void PartFile::closeDatasets() {
  series_.reset();
  force_inputs_.reset();
  snapshots_.reset();
  frames_.reset();
}

void PartFile::finish(const RunStatus& status, const Summary& summary) {
  guarded([&] {
    writeBlock();
    closeDatasets();
    file_.close();
    writeSummary(status, summary);
    verify(status);
  });
  finished_ = true;
}

void PartFile::writeSummary(const RunStatus& status, const Summary& summary) const {
  h5::OutputFile file = h5::OutputFile::openToChange(path_);
  {
    const h5::Id group = h5::openGroup(file, group_);
    for (const auto& [name, value, of_law] : summary) {
      const auto [below, attribute] = groupAndAttribute(name);
      if (attribute.find('/') != std::string::npos) throw std::logic_error("unknown group: " + name);
      const hid_t parent = below == "provenance" ? hid_t{file} : hid_t{group};
      const h5::Id target =
          h5::exists(parent, below) ? h5::openGroup(parent, below) : h5::createGroup(parent, below);
      if (const auto* number = std::get_if<double>(&value)) h5::setAttribute(target, attribute, *number);
      if (const auto* text = std::get_if<std::string>(&value)) h5::setAttribute(target, attribute, *text);
      if (const auto* count = std::get_if<long long>(&value)) {
        h5::setAttribute(target, attribute, static_cast<std::int64_t>(*count));
      }
    }
    h5::setAttribute(group, "status", nameOf(status.end));
    h5::setAttribute(group, "status_detail", status.detail);
  }
  file.close();
}

// The file itself has the last word.
void PartFile::verify(const RunStatus& status) const {
  const h5::Id file = h5::openToRead(path_);
  const h5::Id group = h5::openGroup(file, group_);
  const h5::Id time = h5::openDataset(group, "time");
  if (h5::textAttribute(group, "status") != nameOf(status.end) || h5::shapeOf(time).front() != rows_) {
    throw RunError("not all of it was written");
  }
}

}  // namespace

std::unique_ptr<RecordSink> createPartFile(const std::filesystem::path& path, const PartHeader& header) {
  return std::make_unique<PartFile>(path, header);
}

}  // namespace fissure
