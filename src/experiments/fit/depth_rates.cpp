#include "fit/depth_rates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace fissure {

namespace {

constexpr std::size_t kWindow = 5;

/// Points of equal time as one.
struct MergedPoints {
  std::vector<double> time_s, depth_m;
  std::vector<std::size_t> of_point;  ///< where each point went

  MergedPoints(const std::vector<double>& times_s, const std::vector<double>& depths_m) {
    std::vector<std::size_t> counts;
    for (std::size_t i = 0; i < times_s.size(); ++i) {
      if (time_s.empty() || times_s[i] > time_s.back()) {
        time_s.push_back(times_s[i]);
        depth_m.push_back(0);
        counts.push_back(0);
      }
      depth_m.back() += depths_m[i];
      ++counts.back();
      of_point.push_back(time_s.size() - 1);
    }
    for (std::size_t i = 0; i < counts.size(); ++i) depth_m[i] /= static_cast<double>(counts[i]);
  }

  std::vector<double> ofPoints(const std::vector<double>& values) const {
    std::vector<double> all;
    all.reserve(of_point.size());
    for (const std::size_t i : of_point) all.push_back(values[i]);
    return all;
  }
};

/// Factors of the depths before, at and after a time in the rate there. Two times at least.
std::array<double, 3> factorsAt(const std::vector<double>& time_s, std::size_t i) {
  if (i == 0) return {0, -1 / (time_s[1] - time_s[0]), 1 / (time_s[1] - time_s[0])};
  const double left_s = time_s[i] - time_s[i - 1];
  if (i + 1 == time_s.size()) return {-1 / left_s, 1 / left_s, 0};
  const double right_s = time_s[i + 1] - time_s[i], both_s = left_s + right_s;
  return {-right_s / (left_s * both_s), right_s / (left_s * both_s) - left_s / (right_s * both_s),
          left_s / (right_s * both_s)};
}

/// The fourth divided difference, over the root of the squares of its factors.
double pseudoResidual(std::span<const double> time_s, std::span<const double> depth_m) {
  const double span_s = time_s.back() - time_s.front();
  double difference = 0, squares = 0;
  for (std::size_t j = 0; j < kWindow; ++j) {
    double factor = 1;
    for (std::size_t m = 0; m < kWindow; ++m)
      if (m != j) factor *= span_s / (time_s[j] - time_s[m]);
    difference += factor * depth_m[j];
    squares += factor * factor;
  }
  return difference / std::sqrt(squares);
}

}  // namespace

std::vector<double> ratesOf(const std::vector<double>& time_s, const std::vector<double>& depth_m) {
  const MergedPoints merged(time_s, depth_m);
  const std::vector<double>&times = merged.time_s, &depths = merged.depth_m;
  std::vector<double> rates(times.size(), 0);
  for (std::size_t i = 0; i < times.size() && times.size() > 1; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, times.size() - 1);
    const double left_s = times[i] - times[before], right_s = times[after] - times[i];
    const double left = left_s > 0 ? (depths[i] - depths[before]) / left_s : 0;
    const double right = right_s > 0 ? (depths[after] - depths[i]) / right_s : 0;
    rates[i] = (left * right_s + right * left_s) / (left_s + right_s);
    if (i == before) rates[i] = right;
    if (i == after) rates[i] = left;
  }
  return merged.ofPoints(rates);
}

std::vector<double> rateNoiseOf(const std::vector<double>& time_s, const std::vector<double>& depth_m) {
  const MergedPoints merged(time_s, depth_m);
  const std::size_t count = merged.time_s.size();
  std::vector<double> noise(count, 0);
  for (std::size_t i = 0; i < count && count >= kWindow; ++i) {
    const std::size_t first = std::min(i - std::min(i, kWindow / 2), count - kWindow);
    const double depth_noise_m = pseudoResidual(std::span(merged.time_s).subspan(first, kWindow),
                                                std::span(merged.depth_m).subspan(first, kWindow));
    const std::array<double, 3> factors = factorsAt(merged.time_s, i);
    noise[i] = std::abs(depth_noise_m) * std::hypot(factors[0], factors[1], factors[2]);
  }
  return merged.ofPoints(noise);
}

}  // namespace fissure
