#pragma once

#include <optional>
#include <vector>

#include "base/image.h"
#include "base/scene.h"
#include "base/state.h"
#include "hdf5/group_builder.h"

namespace fissure {

/// Writes the datasets of a scene's bodies into `group`: faces(face,corner), whose indices run over all
/// bodies, and the offsets first_vertex(body) and first_face(body).
void addBodies(GroupBuilder& group, const Scene& scene);

/// Writes volumes/<body> for each elastic body as placed at time zero, in the scene frame:
/// vertices(vertex,xyz), of which the first are those of the body's surface in its order;
/// tetrahedra(tetrahedron,corner), whose first three corners run counter-clockwise seen from the fourth;
/// fixed_vertices(fixed_vertex) and region(tetrahedron) where there are any.
void addVolumes(GroupBuilder& group, const Scene& scene);

/// Writes tools/<tool> with the surface and the nodes of each tool, in the tool's frame, and first_node(tool)
/// into `group` itself when the scene has nodes. A node without partner has node_partner -1 and a missing
/// (NaN) thickness.
void addTools(GroupBuilder& group, const Scene& scene);

/// Writes visuals/<clamp>_handle with the surface of each clamp's handle, in the clamp's frame; it is only
/// drawn and has no contacts.
void addHandles(GroupBuilder& group, const Scene& scene);

/// Writes the snapshots of a run: positions(snapshot_time,vertex,xyz), vertex_contact, node_state where the
/// scene has nodes, contact_pressure where a body is elastic, and clamp_position(snapshot_time,clamp,xyz) and
/// clamp_quaternion where clamps have handles. The buffer holds about a megabyte of positions.
class SnapshotWriter {
 public:
  /// Creates the datasets. `expected`: number of snapshots, which limits the chunk size (0: unknown).
  SnapshotWriter(GroupBuilder& group, const Scene& scene, std::size_t expected);

  /// Buffers a snapshot; returns true when the chunk is full and must be written. Throws std::logic_error
  /// when the arrays of the state do not fit the scene; contacts and node states may be empty, which means no
  /// contact.
  bool append(const State& state);

  /// Writes the buffer without the times.
  void writeData();
  /// Writes the times. A snapshot is committed when its time is written, so the caller must flush the file
  /// between writeData() and writeTimes().
  void writeTimes();

 private:
  void addClamps(GroupBuilder& group, const Scene& scene);

  std::size_t vertices_;
  std::size_t nodes_;
  std::size_t placed_clamps_;  ///< number of clamps; 0 where none has a handle
  bool has_pressures_;
  std::size_t chunk_;
  std::size_t in_chunk_ = 0;  ///< number of snapshots in the current chunk, written or buffered
  std::vector<double> positions_;
  std::vector<std::uint8_t> contacts_;
  std::vector<std::uint8_t> node_states_;
  std::vector<double> pressures_Pa_;
  std::vector<double> clamp_positions_;
  std::vector<double> clamp_quaternions_;
  std::vector<double> times_;
  hsize_t unwritten_ = 0;  ///< number of snapshots whose data are buffered
  std::optional<GrowingDataset> time_data_;
  std::optional<GrowingDataset> position_data_;
  std::optional<GrowingDataset> contact_data_;
  std::optional<GrowingDataset> pressure_data_;
  std::optional<GrowingDataset> node_data_;
  std::optional<GrowingDataset> clamp_position_data_;
  std::optional<GrowingDataset> clamp_quaternion_data_;
};

/// Writes the pictures of a run: frames(frame_time,image_y,image_x,channel).
class FrameWriter {
 public:
  FrameWriter(GroupBuilder& group, int width_px, int height_px);

  /// Writes a picture at once. Throws std::logic_error for a picture of another size.
  void append(double time_s, const Image& image);
  /// Writes the times of the frames so far; the caller must flush the file before.
  void writeTimes();

 private:
  int width_px_;
  int height_px_;
  std::vector<double> times_;
  std::optional<GrowingDataset> time_data_;
  std::optional<GrowingDataset> picture_data_;
};

}  // namespace fissure
