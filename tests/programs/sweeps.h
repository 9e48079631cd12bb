#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "store/result_file.h"
#include "store/run_reader.h"

namespace fissure::programs {

inline const std::string laws =
    "force: [{name: hc, model: hunt_crossley, k: 200, lambda: 50, n: 1.3}, {name: linear, model: "
    "linear_elastic, "
    "k: 200}]\n";

/// Two speeds, and eight sets of laws over each.
inline const std::string speed_and_laws =
    "axes:\n"
    "  - {path: tools.spatula.motion.segments.0.speed_m_s, values: [0.5, 0.4]}\n"
    "  - {path: force.hc.k, values: [100, 300]}\n"
    "  - {path: force.hc.lambda, values: [0, 80]}\n"
    "  - {path: force.hc.n, values: [1.3, 2]}\n";

/// Curves at times between the steps too, and longer than the run.
inline const std::string curves =
    "curves: {quantities: [force, penetration_depth, indentation], every_s: 0.0025, until_s: 0.04}\n";

/// A sweep over press.yaml beside it.
inline std::string sweepOf(const std::string& text) {
  return "format: 1\nname: sweep\nbase: press.yaml\n" + text;
}

inline std::map<std::string, double> summaryOf(const std::filesystem::path& file) {
  std::map<std::string, double> numbers;
  const ResultInfo info = readResultInfo(file);
  for (const SummaryValue& value : info.pipelines.at(0).summary) {
    if (const auto* number = std::get_if<double>(&value.value)) numbers[value.name] = *number;
    if (const auto* count = std::get_if<long long>(&value.value))
      numbers[value.name] = static_cast<double>(*count);
  }
  return numbers;
}

inline std::map<std::string, std::string> textsOf(const std::filesystem::path& file) {
  std::map<std::string, std::string> texts;
  const ResultInfo info = readResultInfo(file);
  for (const SummaryValue& value : info.pipelines.at(0).summary)
    if (const auto* text = std::get_if<std::string>(&value.value)) texts[value.name] = *text;
  return texts;
}

/// The magnitude of the force of every law at these times, linear between two steps, NaN after the end; law
/// by law.
inline std::vector<double> forceCurve(const std::filesystem::path& file, const std::string& pipeline,
                                      const std::vector<double>& times_s) {
  const RunReader run(file, pipeline);
  const StoredQuantity& force = *run.find("force");
  const std::vector<double> values = run.all(force);
  const std::vector<double> time_s = run.all(*run.find("time"));
  const std::size_t laws_count = force.columns() / 3;
  std::vector<double> curve;
  for (std::size_t law = 0; law < laws_count; ++law) {
    for (const double t : times_s) {
      const auto magnitude = [&](std::size_t row) {
        const double* v = values.data() + row * force.columns() + 3 * law;
        return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      };
      std::size_t row = 0;
      while (row + 1 < time_s.size() && time_s[row + 1] <= t + 1e-12) ++row;
      if (t > time_s.back() + 1e-12) {
        curve.push_back(std::nan(""));
      } else if (std::abs(time_s[row] - t) < 1e-12) {
        curve.push_back(magnitude(row));
      } else {
        const double share = (t - time_s[row]) / (time_s[row + 1] - time_s[row]);
        curve.push_back((1 - share) * magnitude(row) + share * magnitude(row + 1));
      }
    }
  }
  return curve;
}

}  // namespace fissure::programs
