#pragma once

#include <optional>
#include <vector>

#include "base/image.h"
#include "base/scene.h"
#include "base/state.h"
#include "hdf5/group_builder.h"

namespace fissure {

/// Bodies, faces and offsets of a scene: faces(face,corner) counts through all bodies, first_vertex(body),
/// first_face(body). Datasets `vertex`, `faces` and so on in `group`.
void addBodies(GroupBuilder& group, const Scene& scene);

/// volumes/<body> of each elastic body, as placed at time zero, in the scene's frame: vertices(vertex,xyz),
/// whose first are those of the body's surface in its order; tetrahedra(tetrahedron,corner) of them, seen
/// from the last corner the others run counter-clockwise; fixed_vertices(fixed_vertex) and
/// region(tetrahedron) where there are any.
void addVolumes(GroupBuilder& group, const Scene& scene);

/// tools/<tool>: the surface and the nodes of each tool, in the tool's frame; first_node(tool) in `group`
/// itself when the scene has nodes. A node without partner has node_partner -1 and a missing (NaN) thickness.
void addTools(GroupBuilder& group, const Scene& scene);

/// visuals/<clamp>_handle: the surface of each clamp's handle, in the clamp's frame; it is drawn, and met by
/// nothing.
void addHandles(GroupBuilder& group, const Scene& scene);

/// Snapshots of a run: positions(snapshot_time,vertex,xyz), vertex_contact, node_state when the scene has
/// nodes, contact_pressure where a body is elastic, and where it has handles their places:
/// clamp_position(snapshot_time,clamp,xyz), clamp_quaternion. Buffered by about a megabyte of positions.
class SnapshotWriter {
 public:
  /// Makes the datasets; `expected` snapshots bound the chunk (0: unknown).
  SnapshotWriter(GroupBuilder& group, const Scene& scene, std::size_t expected);

  /// Buffers one; true when the chunk is full and must be written. State arrays fit the scene; contacts and
  /// node states may be empty: all free. Throws std::logic_error otherwise.
  bool append(const State& state);

  /// Writes what is buffered but its times.
  void writeData();
  /// Then the times: what a snapshot needs to count as written, so the caller flushes in between.
  void writeTimes();

 private:
  void addClamps(GroupBuilder& group, const Scene& scene);

  std::size_t vertices_;
  std::size_t nodes_;
  std::size_t placed_clamps_;  ///< 0: there is no handle
  bool has_pressures_;
  std::size_t chunk_;
  std::size_t in_chunk_ = 0;  ///< snapshots of the current chunk, written or buffered
  std::vector<double> positions_;
  std::vector<std::uint8_t> contacts_;
  std::vector<std::uint8_t> node_states_;
  std::vector<double> pressures_Pa_;
  std::vector<double> clamp_positions_;
  std::vector<double> clamp_quaternions_;
  std::vector<double> times_;
  hsize_t unwritten_ = 0;  ///< snapshots whose data are buffered
  std::optional<GrowingDataset> time_data_;
  std::optional<GrowingDataset> position_data_;
  std::optional<GrowingDataset> contact_data_;
  std::optional<GrowingDataset> pressure_data_;
  std::optional<GrowingDataset> node_data_;
  std::optional<GrowingDataset> clamp_position_data_;
  std::optional<GrowingDataset> clamp_quaternion_data_;
};

/// Pictures of a run: frames(frame_time,image_y,image_x,channel).
class FrameWriter {
 public:
  FrameWriter(GroupBuilder& group, int width_px, int height_px);

  /// Writes one at once. Throws std::logic_error on a picture of another size.
  void append(double time_s, const Image& image);
  /// Writes the times of the frames so far; the caller flushes before.
  void writeTimes();

 private:
  int width_px_;
  int height_px_;
  std::vector<double> times_;
  std::optional<GrowingDataset> time_data_;
  std::optional<GrowingDataset> picture_data_;
};

}  // namespace fissure
