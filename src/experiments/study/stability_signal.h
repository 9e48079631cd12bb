#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace fissure {

/// A lasting oscillation.
struct Chatter {
  double share = 0;  ///< RMS beside a straight line, over the mean magnitude
  double frequency_Hz = 0;
};

/// The oscillation of an evenly sampled signal beside its straight line, whose RMS is above `least_share` of
/// its mean magnitude and 1 % of `peak`, which changes its sign (by more than a quarter of the RMS) at least
/// `least_crossings` times, and whose RMS in the last third is at least half of that in the first third. No
/// value where one of that fails, for fewer than 12 samples and for samples that are not finite.
std::optional<Chatter> chatterOf(std::span<const double> signal, double step_s, double peak,
                                 double least_share, int least_crossings);

/// The rate, 1/s, at which a magnitude that falls to nothing (a billionth of `peak`) rises from it again. No
/// value where it does so less than `least_rises` times, or not in the last third, for fewer than 12 samples
/// and for samples that are not finite.
std::optional<double> bounceRate_Hz(std::span<const double> signal, double step_s, double peak,
                                    int least_rises);

/// How many times the largest value in the last third of an energy is that in the first third. No value where
/// the largest value falls from third to third, where it stays below a millionth of `peak`, the largest value
/// of the time before (or this is 0), for fewer than 12 samples and for
/// samples that are not finite.
std::optional<double> growthOf(std::span<const double> energy_J, double peak_J);

}  // namespace fissure
