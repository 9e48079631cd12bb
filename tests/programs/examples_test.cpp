// scripts/examples and scripts/montage.py, as a user runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "program.h"
#include "scenarios.h"
#include "store/read_series.h"

namespace fissure::programs::examples_test {
namespace {

bool isPicture(const Folder& folder, const std::string& name) {
  return folder.read(name).starts_with("\x89PNG\r\n") && folder.read(name).size() > 5000;
}

std::string sixDigits(double value) {
  std::array<char, 32> text = {};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

TEST(Examples, LoadPlotCompareAndMontageReadAResult) {
  const std::string python = pythonWith("xarray, h5py, matplotlib");
  if (python.empty()) GTEST_SKIP() << "no python3 with xarray, h5py and matplotlib here";
  const Folder folder;
  folder.write("s.yaml", fullScenario());
  ASSERT_EQ(runFissure(folder, {"run", "s.yaml", "-o", "a.h5"}).code, 0);
  const auto script = [&](std::vector<std::string> words) {
    words[0].insert(0, FISSURE_SOURCE_DIR "/scripts/");
    words.insert(words.begin(), {"env", "MPLBACKEND=Agg", python});
    const Outcome outcome = runTool(folder, words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  };
  const SeriesData depth = readSeries(folder / "a.h5", "/pipelines/default/penetration_depth");
  const std::string deepest = sixDigits(*std::max_element(depth.values.begin(), depth.values.end()));
  const std::string loaded = script({"examples/load.py", "a.h5"});
  for (const std::string& part :
       {"max_penetration_depth_m = " + deepest, std::string("jaw_angle(time 31 x clamp 1) [degree]")})
    EXPECT_NE(loaded.find(part), std::string::npos) << part << "\n" << loaded;
  script({"examples/plot.py", "a.h5", "fukuhara", "clamp_force", "jaw_angle", "-o", "plot.png"});
  EXPECT_TRUE(isPicture(folder, "plot.png"));
  // fukuhara holds: the runs are apart by the depth of the other one.
  const std::string compared =
      script({"examples/compare.py", "a.h5", "default", "fukuhara", "-o", "compare.png"});
  EXPECT_NE(compared.find("penetration_depth: up to " + deepest + " m apart"), std::string::npos) << compared;
  EXPECT_TRUE(isPicture(folder, "compare.png"));
  script({"montage.py", "a.h5", "-o", "montage.png"});
  EXPECT_TRUE(isPicture(folder, "montage.png"));
}

}  // namespace
}  // namespace fissure::programs::examples_test
