#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "motion/motion.h"

namespace fissure {

/// A log in a folder of its own, removed with this object.
class TemporaryLog {
 public:
  explicit TemporaryLog(const std::string& text) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("fissure_" + std::string(test->name()) + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "log.csv", std::ios::binary) << text;
  }
  ~TemporaryLog() { std::filesystem::remove_all(folder_); }
  TemporaryLog(const TemporaryLog&) = delete;
  TemporaryLog& operator=(const TemporaryLog&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Plays `settings` from a log of this text, as a tool named "hand".
inline std::unique_ptr<Motion> play(const std::string& text, ReplayMotion settings) {
  const TemporaryLog log(text);
  settings.file = "log.csv";
  ToolSettings tool;
  tool.name = "hand";
  tool.motion = settings;
  return makeMotion(tool, log.folder());
}

/// Columns t, x, y, z in metres.
inline ReplayMotion timed() {
  ReplayMotion settings;
  settings.time_column = "t";
  return settings;
}

/// Columns x, y, z in metres at a rate.
inline ReplayMotion rated(double rate_hz) {
  ReplayMotion settings;
  settings.rate_hz = rate_hz;
  return settings;
}

/// The one line of the InputError that `act` throws, without the folder of the log.
template <typename Act>
std::string inputError(const Act& act) {
  try {
    act();
  } catch (const InputError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const std::size_t slash = line.rfind('/', line.find("log.csv"));
    return line.find("log.csv") == std::string::npos || slash == std::string::npos ? line
                                                                                   : line.substr(slash + 1);
  }
  return "no InputError";
}

inline std::string playError(const std::string& text, const ReplayMotion& settings) {
  return inputError([&] { play(text, settings); });
}

/// A count of a motion's summary; -1 where it has none of this name.
inline long long count(const Motion& motion, const std::string& name) {
  for (const SummaryValue& entry : motion.summary())
    if (entry.name == name) return std::get<long long>(entry.value);
  return -1;
}

}  // namespace fissure
