#include "report/bench_history.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/history_page.h"
#include "report/page.h"

namespace fissure::bench_history_test {

namespace {

namespace fs = std::filesystem;
using Times = std::vector<std::vector<double>>;

/// Five repetitions of about this time, within 1 %.
std::vector<double> around(double time_us) {
  return {time_us, 0.995 * time_us, 1.005 * time_us, 0.99 * time_us, 1.01 * time_us};
}

Times commitsOf(const std::vector<double>& times_us) {
  Times times;
  for (const double time_us : times_us) times.push_back(around(time_us));
  return times;
}

std::vector<std::size_t> stepsOf(const Times& times_us) {
  std::vector<std::size_t> places;
  for (const BenchStep& step : findSteps(times_us)) places.push_back(step.at);
  return places;
}

using Places = std::vector<std::size_t>;

// Mann and Whitney 1947: U of two samples without an overlap is 0 or n m; z = (n m / 2 - 1/2) / sqrt(n m (n +
// m
// + 1) / 12).
TEST(BenchSteps, TheUTestIsThatOfTheNormalApproximation) {
  const std::vector<double> low = {1, 2, 3, 4, 5}, high = {6, 7, 8, 9, 10};
  const double z = 12 / std::sqrt(25 * 11.0 / 12);
  EXPECT_NEAR(uTest(low, high), std::erfc(z / std::sqrt(2.0)), 1e-12);
  EXPECT_EQ(uTest(low, high), uTest(high, low));
  EXPECT_NEAR(uTest({1, 2, 3, 4}, {1, 2, 3, 4}), 1, 1e-12);
}

TEST(BenchSteps, QuantilesLieBetweenNeighbours) {
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 1, 2, 3}, 0.5), 2.5);
  EXPECT_EQ(quantile({7}, 0.25), 7);
  EXPECT_EQ(quantile({0, 10}, 0.25), 2.5);
}

TEST(BenchSteps, TwoCommitsShowAStep) {
  const std::vector<BenchStep> steps = findSteps(commitsOf({100, 120}));
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].at, 1u);
  EXPECT_NEAR(steps[0].ratio, 1.2, 1e-12);
  EXPECT_LT(steps[0].p, step_p);
  EXPECT_EQ(stepsOf(commitsOf({120, 100})), (Places{1}));
}

TEST(BenchSteps, NothingIsMarkedBelowTheLimits) {
  EXPECT_TRUE(stepsOf({}).empty());
  EXPECT_TRUE(stepsOf(commitsOf({100})).empty());
  EXPECT_TRUE(stepsOf(commitsOf({100, 104})).empty());  // 4 %
  EXPECT_TRUE(stepsOf(commitsOf({2, 2.4})).empty());    // 0.4 us
  EXPECT_TRUE(stepsOf({{100}, {200}}).empty());         // one repetition says nothing
  EXPECT_TRUE(stepsOf({{100, 150, 90, 160, 100}, {110, 95, 170, 120, 130}}).empty());  // noise
}

TEST(BenchSteps, OneSlowDayIsNone) {
  EXPECT_TRUE(stepsOf(commitsOf({100, 100, 100, 130, 100, 100, 100})).empty());
  EXPECT_EQ(stepsOf(commitsOf({100, 100, 130, 130, 100, 100})), (Places{2, 4}));  // two are
}

TEST(BenchSteps, EveryStepOfALongHistoryIsMarkedOnceAtItsCommit) {
  std::vector<double> times_us(50, 100);
  for (std::size_t i = 20; i < 50; ++i) times_us[i] = 115;
  for (std::size_t i = 35; i < 50; ++i) times_us[i] = 80;
  EXPECT_EQ(stepsOf(commitsOf(times_us)), (Places{20, 35}));
}

class HistoryTest : public testing::Test {
 protected:
  HistoryTest() : folder_(fs::path(testing::TempDir()) / ("fissure_bench_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~HistoryTest() override { fs::remove_all(folder_); }

  static nlohmann::json fileOf(int day, double time_us, double rays = 64, const std::string& cpu = "Cpu A") {
    const std::string two_digits = (day < 10 ? "0" : "") + std::to_string(day);
    return {{"format", "fissure-bench"},
            {"format_version", 1},
            {"commit", std::string(38, 'a') + two_digits},
            {"commit_date", "2026-01-" + two_digits + "T12:00:00Z"},
            {"modified", false},
            {"machine", {{"cpu", cpu}, {"cores", 2}}},
            {"build", {{"type", "Release"}, {"compiler", "c++ 12"}, {"flags", "-O3"}}},
            {"benchmarks",
             {{{"name", "step/press"}, {"time_us", around(time_us)}, {"counters", {{"rays", rays}}}}}}};
  }
  void write(const std::string& name, const nlohmann::json& json) const { write(name, json.dump()); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  void write(const std::string& name, const char* text) const { write(name, std::string(text)); }
  PageJson page() const { return historyPage("bench", "fissure", readBenchHistory(folder_)); }
  std::string refusal(const nlohmann::json& json) const {
    write("bad.json", json);
    try {
      readBenchFile(folder_ / "bad.json");
    } catch (const InputError& error) {
      EXPECT_TRUE(error.isAbout(folder_ / "bad.json"));
      return error.text();
    }
    return "nothing";
  }

  fs::path folder_;
};

TEST_F(HistoryTest, MachinesStandApartAndCommitsInTheOrderOfTheirDates) {
  write("z.json", fileOf(1, 100));
  write("a.json", fileOf(3, 130));
  write("m.json", fileOf(2, 100, 64, "Cpu B"));
  const PageJson shown = page();
  ASSERT_EQ(shown.at("commits").size(), 3u);
  EXPECT_EQ(shown.at("commits").at(0).at("date"), "2026-01-01T12:00:00Z");
  ASSERT_EQ(shown.at("machines").size(), 2u);
  const PageJson& curves = shown.at("benchmarks").at(0).at("curves");
  EXPECT_EQ(curves.at(0).at("commits"), PageJson({0, 2}));
  EXPECT_EQ(curves.at(0).at("median_us"), PageJson({100, 130}));
  EXPECT_EQ(curves.at(0).at("low_us").at(0), 99.5);
  EXPECT_EQ(curves.at(0).at("steps").at(0).at("commit"), 2);
  EXPECT_EQ(curves.at(0).at("steps").at(0).at("from"), 0);
  EXPECT_EQ(curves.at(1).at("commits"), PageJson({1}));
  EXPECT_TRUE(curves.at(1).at("steps").empty());
}

TEST_F(HistoryTest, CountersStandBesideTimes) {
  write("1.json", fileOf(1, 100));
  write("2.json", fileOf(2, 100, 70));
  write("3.json", fileOf(2, 100, 71, "Cpu B"));
  const PageJson shown = page();
  const PageJson& counter = shown.at("benchmarks").at(0).at("counters").at(0);
  EXPECT_EQ(counter.at("name"), "rays");
  EXPECT_EQ(counter.at("values"), PageJson({64.0, 70.0}));
  EXPECT_EQ(counter.at("differs"), true);
}

TEST_F(HistoryTest, MachinesOfOneNameAreNumbered) {
  write("1.json", fileOf(1, 100));
  nlohmann::json other = fileOf(1, 100);
  other["build"]["flags"] = "-O2";
  write("2.json", other);
  const PageJson shown = page();
  EXPECT_EQ(shown.at("machines").at(0).at("name"), "Cpu A (1)");
  EXPECT_EQ(shown.at("machines").at(1).at("name"), "Cpu A (2)");
}

TEST_F(HistoryTest, WhatCannotBeShownIsNamedAndTheRestIsShown) {
  write("1.json", fileOf(1, 100));
  write("2.json", fileOf(1, 110));  // of the same commit and machine
  write("empty.json", "");
  write("foreign.json", "{\"format\": \"other\"}");
  write("torn.json", fileOf(2, 100).dump().substr(0, 200));
  const BenchHistory history = readBenchHistory(folder_);
  EXPECT_EQ(history.files.size(), 1u);
  std::map<std::string, std::string> texts;
  for (const auto& problem : history.problems) texts[problem.file] = problem.text;
  EXPECT_EQ(texts.at("2.json"), "of the same commit and machine as 1.json, which is shown");
  EXPECT_EQ(texts.at("foreign.json"), "format is \"other\", expected \"fissure-bench\"");
  EXPECT_EQ(texts.at("torn.json"), "no whole JSON, expected a file of scripts/bench");
  EXPECT_EQ(texts.at("empty.json"), "no whole JSON, expected a file of scripts/bench");
  EXPECT_EQ(page().at("problems").size(), 4u);
}

TEST_F(HistoryTest, BadFilesAreRefusedWithWhatWasExpected) {
  const auto with = [](const char* place, const nlohmann::json& value) {
    nlohmann::json json = fileOf(1, 100);
    json[nlohmann::json::json_pointer(place)] = value;
    return json;
  };
  EXPECT_EQ(refusal(with("/format_version", 2)), "of a newer fissure, expected format_version 1");
  EXPECT_EQ(refusal(with("/commit_date", "yesterday")),
            "commit_date is \"yesterday\", expected UTC as 2026-01-31T12:00:00Z");
  EXPECT_EQ(refusal(with("/commit", 7)), "\"commit\" is 7, expected a commit's hash");
  EXPECT_EQ(refusal(with("/benchmarks", nlohmann::json::array())), "has no benchmarks, expected some");
  EXPECT_EQ(refusal(with("/benchmarks/0/time_us", nlohmann::json::array())),
            "step/press has no times, expected some");
  EXPECT_EQ(refusal(with("/benchmarks/0/time_us/1", nullptr)),
            "a time of step/press is null, expected a finite number");
  EXPECT_EQ(refusal(with("/benchmarks/0/time_us/1", -1)), "a time of step/press is -1, expected more than 0");
  EXPECT_EQ(refusal(with("/benchmarks/0/counters/rays", "many")),
            "a counter of step/press is \"many\", expected a finite number");
  nlohmann::json twice = fileOf(1, 100);
  twice["benchmarks"].push_back(twice["benchmarks"][0]);
  EXPECT_EQ(refusal(twice), "step/press is there twice, expected once");
  nlohmann::json missing = fileOf(1, 100);
  missing.erase("machine");
  EXPECT_EQ(refusal(missing), "missing \"machine\", expected a map");
  EXPECT_EQ(refusal(nlohmann::json::array()), "missing \"format\", expected \"fissure-bench\"");
  EXPECT_EQ(refusal(fileOf(1, 100)), "nothing");
}

TEST_F(HistoryTest, AFolderWithoutAnyIsRefused) {
  EXPECT_THROW(readBenchHistory(folder_), InputError);
  write("foreign.json", "[]");
  try {
    readBenchHistory(folder_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.text(),
              "holds neither results (*.h5) nor files of scripts/bench: foreign.json: missing \"format\", "
              "expected \"fissure-bench\"");
  }
}

TEST_F(HistoryTest, ThePageIsWhole) {
  for (const int commits : {1, 2, 50}) {
    for (int i = 1; i <= commits; ++i) {
      nlohmann::json file = fileOf(i % 28 + 1, 100 + i);
      file["commit"] = std::string(38, 'b') + std::to_string(100 + i);
      write(std::to_string(i) + ".json", file);
    }
    const std::string text = pageText(page());
    EXPECT_NE(text.find("historyHeading();"), std::string::npos);
    EXPECT_EQ(text.find("{{"), std::string::npos);
    EXPECT_EQ(page().at("commits").size(), static_cast<std::size_t>(commits));
    EXPECT_LT(text.size(), 300000u);
  }
}

}  // namespace
}  // namespace fissure::bench_history_test
