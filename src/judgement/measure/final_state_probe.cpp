#include "measure/final_state_probe.h"

#include <bit>
#include <cmath>
#include <limits>

#include "base/hash.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

void appendDouble(double value, std::string& bytes) {
  if (value == 0) value = 0;  // the one comparison that -0 passes too
  if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>((bits >> shift) & 0xff);
}

}  // namespace

std::string stateHash(const std::vector<Vec3>& positions_m, const std::vector<Vec3>& velocities_m_s) {
  std::string bytes;
  for (const std::vector<Vec3>* vectors : {&positions_m, &velocities_m_s}) {
    for (const Vec3& vector : *vectors) {
      for (int i = 0; i < 3; ++i) appendDouble(vector[i], bytes);
    }
  }
  return fnv1a64(bytes);
}

void FinalStateProbe::declare(RecordLayout&) {}

void FinalStateProbe::sample(const State& state, RecordRow&) {
  sampled_ = true;
  step_ = state.step;
  positions_m_ = state.positions_m;
  velocities_m_s_ = state.velocities_m_s;
}

void FinalStateProbe::summarize(Summary& summary) const {
  summary.push_back(countOrMissing("steps", sampled_, step_));
  if (sampled_) {
    summary.push_back({"final_state_hash", stateHash(positions_m_, velocities_m_s_)});
  } else {
    summary.push_back({"final_state_hash", kMissing});
  }
}

}  // namespace fissure
