#include "study/stability_signal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace fissure {

namespace {

constexpr std::size_t fewest_samples = 12;
constexpr double least_of_peak = 0.01;
constexpr double least_energy_of_peak = 1e-6;
constexpr double nothing_of_peak = 1e-9;

bool allFinite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

double rms(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Without its straight line of least squares.
std::vector<double> detrended(std::span<const double> signal) {
  const auto count = static_cast<double>(signal.size());
  const double middle = (count - 1) / 2;
  double mean = 0, slope = 0;
  for (const double value : signal) mean += value / count;
  for (std::size_t i = 0; i < signal.size(); ++i)
    slope += (static_cast<double>(i) - middle) * (signal[i] - mean) / (count * (count * count - 1) / 12);
  std::vector<double> rest(signal.begin(), signal.end());
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= mean + slope * (static_cast<double>(i) - middle);
  return rest;
}

/// Changes of sign, of values beyond +-least.
struct Crossings {
  int count = 0;
  std::size_t first = 0, last = 0;  ///< samples at which the new sign is first seen
};

Crossings crossingsOf(std::span<const double> values, double least) {
  Crossings found;
  int side = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const int now = values[i] > least ? 1 : values[i] < -least ? -1 : 0;
    if (now == 0) continue;
    if (side != 0 && now != side) {
      if (found.count++ == 0) found.first = i;
      found.last = i;
    }
    side = now;
  }
  return found;
}

}  // namespace

std::optional<Chatter> chatterOf(std::span<const double> signal, double step_s, double peak,
                                 double least_share, int least_crossings) {
  if (signal.size() < fewest_samples || !allFinite(signal)) return std::nullopt;
  double mean = 0;
  for (const double value : signal) mean += std::abs(value) / static_cast<double>(signal.size());
  const std::vector<double> rest = detrended(signal);
  const double size = rms(rest);
  if (!(size > least_share * mean) || !(size > least_of_peak * peak)) return std::nullopt;
  const std::size_t third = rest.size() / 3;
  const std::span<const double> all(rest);
  if (rms(all.last(third)) < 0.5 * rms(all.first(third))) return std::nullopt;
  const Crossings found = crossingsOf(all, 0.25 * size);
  if (found.count < least_crossings) return std::nullopt;
  const double half_waves = found.count - 1;
  return Chatter{size / mean, half_waves / (2 * step_s * static_cast<double>(found.last - found.first))};
}

std::optional<double> bounceRate_Hz(std::span<const double> signal, double step_s, double peak,
                                    int least_rises) {
  if (signal.size() < fewest_samples || !allFinite(signal)) return std::nullopt;
  const double nothing = nothing_of_peak * peak;
  int rises = 0;
  std::size_t first = 0, last = 0;
  for (std::size_t i = 1; i < signal.size(); ++i) {
    if (std::abs(signal[i - 1]) > nothing || std::abs(signal[i]) <= nothing) continue;
    if (rises++ == 0) first = i;
    last = i;
  }
  if (rises < std::max(2, least_rises) || last < signal.size() - signal.size() / 3) return std::nullopt;
  return (rises - 1) / (step_s * static_cast<double>(last - first));
}

std::optional<double> growthOf(std::span<const double> energy_J, double peak_J) {
  if (energy_J.size() < fewest_samples || !allFinite(energy_J)) return std::nullopt;
  const std::size_t third = energy_J.size() / 3;
  const auto most = [&](std::size_t first) {
    const auto part = energy_J.subspan(first, third);
    return *std::max_element(part.begin(), part.end());
  };
  const double first = most(0), middle = most(third), last = most(energy_J.size() - third);
  if (!(peak_J > 0) || !(last > least_energy_of_peak * peak_J) || middle < first || last < middle)
    return std::nullopt;
  return first > 0 ? last / first : std::numeric_limits<double>::infinity();
}

}  // namespace fissure
