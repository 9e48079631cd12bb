#pragma once

#include <cstdint>
#include <string>

namespace fissure {

/// The wall time that a run will take, forecast from its pilot: that of its worker, from start to end, on an
/// otherwise idle machine; seconds.
struct Forecast {
  std::int64_t pilot_steps = 0;  ///< steps of the pilot, without settling
  std::int64_t run_steps = 0;    ///< steps of the run, without settling
  double run_s = 0;              ///< mean of low and high
  /// The range of the forecast: it is lower by the amount that the pilot's greater speed may add to the cost
  /// of a step, and higher by the amount by which one half of the windows forecasts more than both.
  double low_s = 0, high_s = 0;
};

/// The forecast as a line, for the file that passes it from the worker to the program.
std::string forecastText(const Forecast& forecast);

/// Parses such a line. Throws RunError when `text` is no forecast.
Forecast parseForecast(const std::string& text);

}  // namespace fissure
