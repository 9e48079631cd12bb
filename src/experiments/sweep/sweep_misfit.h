#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/curve_rank.h"
#include "sweep/sweep_file.h"

namespace fissure {

/// Computes the misfit of the runs of a sweep to the measured curve that its file names.
class SweepMisfit {
 public:
  /// Reads `file`, which must have one curve. `laws`: names of the scenario's force laws. Throws InputError
  /// about the file, also when it lacks the columns that the fit needs.
  SweepMisfit(const SweepFit& fit, const std::vector<std::string>& laws, const std::filesystem::path& file);

  /// The misfit of one run from its curves over `time_s`: `force_N`, one law after the other, and `way_m`,
  /// the indentation, which is empty for matching by time. rms_N is NaN where the run does not reach all
  /// measured points.
  Misfit of(const std::vector<double>& time_s, std::span<const double> force_N,
            std::span<const double> way_m) const;

  /// The measured force at these times, linear between its points and NaN outside of them; empty for matching
  /// by depth.
  std::vector<double> at(const std::vector<double>& time_s) const;

 private:
  MatchBy match_;
  std::optional<double> fixed_offset_N_;
  std::size_t law_ = 0;
  MeasuredCurve curve_;
};

}  // namespace fissure
