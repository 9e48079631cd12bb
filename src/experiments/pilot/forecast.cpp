#include "pilot/forecast.h"

#include <sstream>

#include "base/error.h"
#include "text/scalars.h"

namespace fissure {

std::string forecastText(const Forecast& forecast) {
  std::string text = std::to_string(forecast.pilot_steps) + " " + std::to_string(forecast.run_steps);
  for (const double seconds : {forecast.run_s, forecast.low_s, forecast.high_s})
    text.append(" ").append(formatReal(seconds));
  return text + "\n";
}

Forecast parseForecast(const std::string& text) {
  Forecast forecast;
  std::istringstream in(text);
  in >> forecast.pilot_steps >> forecast.run_steps >> forecast.run_s >> forecast.low_s >> forecast.high_s;
  if (!in) throw RunError("the pilot left no times");
  return forecast;
}

}  // namespace fissure
