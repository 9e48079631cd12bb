#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/frame_text.h"
#include "base/scene.h"
#include "base/state.h"
#include "store/run_reader.h"

namespace fissure {

/// The snapshots of one run of a result file, with all that a picture of them needs. A run that never came to
/// one, or whose scenario asks for none, has none. Everything here throws InputError about the file when it
/// is damaged.
class SnapshotReader {
 public:
  SnapshotReader(const std::filesystem::path& file, const std::string& pipeline);

  /// Ascending.
  const std::vector<double>& times_s() const { return times_s_; }
  /// Surfaces, places of nodes and handles, as they were stored: no normals of nodes, no ground, and only
  /// clamps that have a handle. Empty where there are no snapshots.
  const Scene& scene() const { return scene_; }

  /// Positions, poses and node states of one snapshot; nothing of what else a step leaves behind.
  State at(std::size_t snapshot) const;
  /// What a picture of it says of depths.
  FrameMeasures depths(std::size_t snapshot) const;

 private:
  const StoredQuantity& need(const std::string& name, std::vector<std::size_t> shape) const;
  std::vector<double> row(const std::string& name, std::size_t row, std::vector<std::size_t> shape) const;
  std::size_t stepOf(std::size_t snapshot) const;
  TriangleMesh readSurface(const std::string& group) const;
  void readBodies();
  void readTools();
  void readHandles();

  std::filesystem::path path_;
  RunReader run_;
  std::vector<double> times_s_;
  std::vector<double> step_times_s_;
  Scene scene_;
  std::vector<std::size_t> clamps_;  ///< of scene_.clamps: their places among all clamps of the run
  std::size_t all_clamps_ = 0;
};

}  // namespace fissure
