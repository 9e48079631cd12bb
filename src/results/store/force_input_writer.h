#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/state.h"
#include "hdf5/group_builder.h"

namespace fissure {

/// What the force laws saw of each colliding triangle, as a contiguous ragged array of CF 1.10
/// (section 9.3.3) in a subgroup of its own, `force_inputs`: row_size(time) observations a step, one a
/// triangle, and over them triangle(obs), deformation(obs,law), deformation_rate(obs,law), area(obs),
/// direction(obs,xyz). Its `time` may run ahead of the record's, and is no commit mark.
class ForceInputWriter {
 public:
  /// `laws`: their names; `chunk_rows`: steps in a chunk.
  ForceInputWriter(GroupBuilder& group, const std::vector<std::string>& laws, std::size_t chunk_rows);

  /// Buffers one step; true when there is enough to be written. Throws std::logic_error when the state's
  /// inputs are not one a colliding triangle and law.
  bool append(const State& state);

  /// Writes what is buffered.
  void writeData();

 private:
  std::size_t laws_;
  std::int64_t written_ = 0;  ///< observations
  std::vector<double> times_s_, deformations_m_, rates_m_s_, areas_m2_, directions_;
  std::vector<std::int64_t> row_sizes_, observations_, triangles_;
  GroupBuilder group_;
  GrowingDataset time_data_, row_size_data_, observation_data_, triangle_data_, deformation_data_, rate_data_,
      area_data_, direction_data_;
};

/// Observations that the first `rows` steps of a run's group `force_inputs` say they have.
hsize_t observationCount(hid_t force_inputs, hsize_t rows);

}  // namespace fissure
