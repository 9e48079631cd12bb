#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "scenario/load.h"

namespace fissure {

/// The smallest scenario there is: one sphere, no tool, one run of a second.
inline const char* const smallest_text =
    "format: 1\n"
    "name: smallest\n"
    "time: {duration_s: 1}\n"
    "bodies:\n"
    "  - name: ball\n"
    "    shape: {type: sphere, radius_m: 0.03}\n"
    "pipelines:\n"
    "  - {pipeline: default}\n";

inline Scenario smallest() {
  return parseScenario(smallest_text, "smallest.yaml").scenario;
}

/// The message of the InputError that `call` throws; "nothing" when it throws none.
template <class Call>
std::string inputError(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

/// A folder of its own for each test, removed afterwards.
class ScenarioFiles : public testing::Test {
 protected:
  ScenarioFiles() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("fissure_scenario_" + std::string(info->test_suite_name()) + "_" + info->name() + "_" +
               std::to_string(testing::UnitTest::GetInstance()->random_seed()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~ScenarioFiles() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const std::filesystem::path file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  /// The error of loading a file of this folder, without the folder's name.
  std::string loadError(const std::string& name, const std::vector<Override>& overrides = {}) const {
    std::string message = inputError([&] { loadScenario(folder_ / name, overrides); });
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
      message.erase(at, prefix.size());
    }
    return message;
  }

  std::filesystem::path folder_;
};

}  // namespace fissure
