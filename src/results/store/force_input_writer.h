#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/state.h"
#include "hdf5/group_builder.h"

namespace fissure {

/// Writes the arguments of the force laws for each colliding triangle into the subgroup `force_inputs`, as a
/// contiguous ragged array of CF 1.10 (section 9.3.3): row_size(time) observations per step, one per
/// triangle, with triangle(obs), deformation(obs,law), deformation_rate(obs,law), area(obs) and
/// direction(obs,xyz). Its `time` may be ahead of the record's and does not mark committed rows.
class ForceInputWriter {
 public:
  /// `laws`: names of the laws; `chunk_rows`: steps per chunk.
  ForceInputWriter(GroupBuilder& group, const std::vector<std::string>& laws, std::size_t chunk_rows);

  /// Buffers one step; returns true when the buffer should be written. Throws std::logic_error unless the
  /// state has one input per colliding triangle and law.
  bool append(const State& state);

  /// Writes the buffer.
  void writeData();

 private:
  std::size_t laws_;
  std::int64_t written_ = 0;  ///< number of observations written
  std::vector<double> times_s_, deformations_m_, rates_m_s_, areas_m2_, directions_;
  std::vector<std::int64_t> row_sizes_, observations_, triangles_;
  GroupBuilder group_;
  GrowingDataset time_data_, row_size_data_, observation_data_, triangle_data_, deformation_data_, rate_data_,
      area_data_, direction_data_;
};

/// Number of observations in the first `rows` steps of a run's group `force_inputs`, from its row sizes.
hsize_t observationCount(hid_t force_inputs, hsize_t rows);

}  // namespace fissure
