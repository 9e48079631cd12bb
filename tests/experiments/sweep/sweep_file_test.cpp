#include "sweep/sweep_file.h"

#include "sweep_text.h"

namespace fissure::sweep_file_test {

namespace {

TEST(SweepFile, EveryFieldReachesItsPlace) {
  const SweepSettings sweep = sweepOf(
      "description: What and why\n"
      "pipelines: [fukuhara, default_tuned]\n"
      "axes:\n"
      "  - {path: force.hc.k, logarithmic: {from: 1, to: 1000, count: 4}}\n"
      "  - zip:\n"
      "      - {path: a.b, values: [1, \"two\", [8, 8], {x: 1.50}]}\n"
      "      - {path: c, linear: {from: -1, to: 2, count: 4}}\n"
      "exclude:\n"
      "  - [{path: c, min: 0.5, max: 1}, {path: a.b, values: [1]}]\n"
      "design: sobol\n"
      "count: 64\n"
      "seed: 7\n");
  EXPECT_EQ(sweep.name, "sweep");
  EXPECT_EQ(sweep.description, "What and why");
  EXPECT_EQ(sweep.base, "base.yaml");
  EXPECT_EQ(sweep.pipelines, (std::vector<std::string>{"fukuhara", "default_tuned"}));
  ASSERT_EQ(sweep.axes.size(), 2u);
  ASSERT_EQ(sweep.axes[1].axes.size(), 2u);
  EXPECT_EQ(sweep.axes[0].axes[0].logarithmic->to, 1000);
  EXPECT_EQ(sweep.axes[1].axes[0].values, (std::vector<std::string>{"1", "two", "[8, 8]", "{x: 1.50}"}));
  EXPECT_EQ(sweep.axes[1].axes[1].linear->from, -1);
  EXPECT_EQ(sweep.exclude.at(0).at(0).max, 1);
  EXPECT_EQ(sweep.exclude.at(0).at(1).values, std::vector<std::string>{"1"});
  EXPECT_EQ(sweep.design, SweepDesign::sobol);
  EXPECT_EQ(sweep.count, 64);
  EXPECT_EQ(sweep.seed, 7);
}

TEST(SweepFile, WhatIsWrongIsSaidWithItsLine) {
  const std::string good = "axes:\n  - {path: x, values: [1]}\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {good, "nothing"},
      {"", "1: missing key \"axes\", expected it"},
      {"axes: []\n", "4: axes is empty, expected at least one"},
      {good + "  - {path: x, values: [2]}\n", "6: a second axis on x, expected one axis a path"},
      {"axes:\n  - {path: x}\n", "5: axis x has none of values, linear and logarithmic, expected one"},
      {"axes:\n  - {path: x, values: [1], linear: {from: 0, to: 1, count: 2}}\n",
       "5: axis x has several of values, linear and logarithmic, expected one"},
      {"axes:\n  - {path: x, values: []}\n", "5: axes.0.values is empty, expected at least one"},
      {"axes:\n  - {path: x, linear: {from: 1, to: 1, count: 3}}\n",
       "5: axis x linear: from and to are 1, expected a range"},
      {"axes:\n  - {path: x, linear: {from: 1, to: 2, count: 1}}\n",
       "5: axes.0.linear.count is 1, expected a number of at least 2"},
      {"axes:\n  - {path: x, logarithmic: {from: 0, to: 2, count: 3}}\n",
       "5: axis x logarithmic: from and to are 0 and 2, expected numbers above 0"},
      {"axes:\n  - zip:\n      - {path: x, values: [1, 2]}\n      - {path: y, values: [1]}\n",
       "5: y has 1 values and x 2, expected as many of zipped axes"},
      {"axes:\n  - zip: []\n", "5: axes.0.zip is empty, expected at least one"},
      {good + "exclude:\n  - [{path: y, max: 1}]\n", "7: exclude: y is no axis, expected the path of one"},
      {good + "exclude:\n  - [{path: x}]\n",
       "7: exclude: x without a condition, expected min, max or values"},
      {good + "exclude:\n  - [{path: x, values: [7]}]\n",
       "7: exclude: 7 is no value of axis x, expected one of them"},
      {good + "repeats: 0\n", "6: repeats is 0, expected a number of at least 1"},
      {good + "keep: everything\n", "6: keep is \"everything\", expected one of metrics, results"},
      {good + "limits: {time_s: 0}\n", "6: limits.time_s is 0, expected a number above 0"},
      {good + "limits: {memory_mb: -1}\n", "6: limits.memory_mb is -1, expected a number above 0"},
      {good + "curves: {quantities: [force], every_s: 0}\n",
       "6: curves.every_s is 0, expected a number above 0"},
      {good + "curves: {quantities: [force], every_s: 1, until_s: 0.5}\n",
       "6: curves.until_s is 0.5, expected at least every_s"},
      {good + "curves: {quantities: [force], every_s: 1e-6, until_s: 5}\n",
       "6: curves.until_s is 5, expected fewer than a million times"},
      {good + "fit: {curve: a.csv}\n",
       "6: fit compares the curve force, expected it among curves.quantities"},
      {good + "curves: {quantities: [force], every_s: 1}\nfit: {curve: a.csv}\n",
       "7: fit compares the curve indentation, expected it among curves.quantities"},
      {good + "curves: {quantities: [force], every_s: 1}\nfit: {curve: a.csv, match: time}\n", "nothing"},
      {good + "design: random\n", "1: missing key \"count\", expected it"},
      {good + "design: random\ncount: 0\nseed: 1\n", "7: count is 0, expected a number of at least 1"},
      {good + "design: sobel\n", "6: design is \"sobel\", did you mean \"sobol\"?"},
      {good + "count: 3\n",
       "6: key \"count\" has no meaning here, expected it only for design random, latin_"},
  };
  for (const auto& [text, complaint] : cases)
    EXPECT_EQ(complaintAbout(text).substr(0, complaint.size()), complaint) << text;
}

}  // namespace
}  // namespace fissure::sweep_file_test
