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

/// Reads the snapshots of one run in a result file, with all that is needed to draw them. There may be none.
/// All functions throw InputError about the file when it is damaged.
class SnapshotReader {
 public:
  SnapshotReader(const std::filesystem::path& file, const std::string& pipeline);

  /// Times of the snapshots, ascending.
  const std::vector<double>& times_s() const { return times_s_; }
  /// The stored surfaces, node positions and handles; without normals of nodes and ground, and only with
  /// clamps that have a handle. Empty where there are no snapshots.
  const Scene& scene() const { return scene_; }

  /// Positions, poses and node states of one snapshot; all else of the State is left at its default.
  State at(std::size_t snapshot) const;
  /// The measured depths at a snapshot, for the text in its picture.
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
  std::vector<std::size_t> clamps_;  ///< for scene_.clamps: indices among all clamps of the run
  std::size_t all_clamps_ = 0;
};

}  // namespace fissure
