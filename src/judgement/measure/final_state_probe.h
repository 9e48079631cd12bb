#pragma once

#include "base/probe.h"

namespace fissure {

/// The scalars `steps` (State::step of the last state) and `final_state_hash`, which is equal for two runs
/// whose tissue ended with bitwise the same positions and velocities, and practically only for these.
class FinalStateProbe : public Probe {
 public:
  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  bool sampled_ = false;
  std::int64_t step_ = 0;
  std::vector<Vec3> positions_m_;
  std::vector<Vec3> velocities_m_s_;
};

/// FNV-1a hash, 64 bits (Fowler, Noll and Vo), as 16 hexadecimal digits, over x, y, z of all positions, then
/// of all velocities, each double as 8 bytes in little-endian order. -0 counts as 0, and all NaN are equal.
std::string stateHash(const std::vector<Vec3>& positions_m, const std::vector<Vec3>& velocities_m_s);

}  // namespace fissure
