#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "fit/measured_curve.h"

namespace fissure {

/// The curves of a file of this text, called probe.csv.
inline std::vector<MeasuredCurve> curvesOf(const std::string& text, const std::string& columns = "") {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("fissure_curves_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  struct Removed {
    const std::filesystem::path& folder;
    ~Removed() { std::filesystem::remove_all(folder); }
  } removed{folder};
  std::ofstream(folder / "probe.csv", std::ios::binary) << text;
  return readCurves(folder / "probe.csv",
                    columns.empty() ? std::vector<CurveColumn>() : parseCurveColumns(columns));
}

/// What is wrong, without the folder, or "nothing".
inline std::string curveError(const std::string& text, const std::string& columns = "") {
  try {
    curvesOf(text, columns);
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    const std::size_t file = message.find("probe.csv");
    return file == std::string::npos ? message : message.substr(file);
  }
  return "nothing";
}

}  // namespace fissure
