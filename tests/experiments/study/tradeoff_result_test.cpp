// What is chosen of settings that were judged, and what is written of them: synthetic settings of known cost
// and error.
#include "study/tradeoff_result.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "study/tradeoff_answer.h"
#include "study/tradeoff_output.h"
#include "study/tradeoff_text.h"

namespace fissure::tradeoff_result_test {

namespace {

const double kUnknown = std::nan("");

TradeoffStudy study() {
  TradeoffStudy of;
  of.name = "some";
  of.directory = "a study";
  of.base = "it's.yaml";
  AxisGroup& group = of.axes.emplace_back();
  group.axes.push_back({.path = "time.step_s"});
  of.errors = {{.quantity = ErrorQuantity::depth, .size = {1e-4, false}},
               {.quantity = ErrorQuantity::reaction, .size = {0.05, true}}};
  return of;
}

JudgedSetting setting(const std::string& step_s, double cost_us, double depth_m, double reaction_N) {
  JudgedSetting of;
  of.values = {step_s};
  of.pipeline = "swept";
  of.status.end = RunEnd::ok;
  of.cost.us_per_ms = spreadOf({0.9 * cost_us, cost_us, 1.1 * cost_us});
  of.cost.p99_us_per_ms = spreadOf({10 * cost_us});
  of.differences.resize(2);
  of.errors = {depth_m, reaction_N};
  of.score =
      std::isnan(depth_m) || std::isnan(reaction_N) ? kUnknown : std::max(depth_m / 1e-4, reaction_N / 0.1);
  return of;
}

/// Errors of order 1 in depth and 2 in the reaction, whose reference has a peak of 2 N and an error of 1 mN.
TradeoffResult result() {
  TradeoffResult of;
  of.paths = {"time.step_s"};
  for (const std::size_t error : {std::size_t{0}, std::size_t{1}}) {
    JudgedReference& reference = of.references.emplace_back();
    reference.pipeline = "swept";
    reference.error = error;
    reference.refinement.error = error == 0 ? 0 : 1e-3;
    reference.peak = error == 0 ? 0 : 2;
    reference.tolerance = error == 0 ? 1e-4 : 0.1;
  }
  for (const double step_s : {0.001, 0.002, 0.004, 0.008})
    of.settings.push_back(
        setting(std::to_string(step_s), 0.8 / step_s, 0.05 * step_s, 1e4 * step_s * step_s));
  of.settings.push_back(setting("0.016", 1, kUnknown, 0));
  return of;
}

}  // namespace

TEST(TradeoffResult, OrdersAreThoseOfTheErrors) {
  const std::vector<AxisOrder> orders = ordersOf(study(), result());
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_NEAR(orders[0].order.median, 1, 1e-9);
  EXPECT_NEAR(orders[1].order.median, 2, 1e-9);
}

TEST(TradeoffResult, BudgetAndErrorsChooseAndNaNNeverWins) {
  const TradeoffResult of = result();
  const TradeoffAnswer rich = answerOf({"budget", 500, {}}, study(), of, CostMeasure::mean);
  EXPECT_EQ(rich.choice.best, 1u) << "2 ms at 400 us, at most 420 in three of four runs";
  EXPECT_EQ(answerOf({"budget", 500, {}}, study(), of, CostMeasure::p99).choice.nearest, 3u);
  const TradeoffAnswer poor = answerOf({"budget", 2, {}}, study(), of, CostMeasure::mean);
  EXPECT_FALSE(poor.choice.best);
  EXPECT_EQ(poor.choice.nearest, 3u);
  EXPECT_NE(answerText(poor, study(), of, CostMeasure::mean).find("52.5 times beyond"), std::string::npos);
  const TradeoffWish wish{"errors", std::nullopt, parseErrorLimits("depth=0.15mm,reaction=5%")};
  EXPECT_EQ(answerOf(wish, study(), of, CostMeasure::mean).choice.best, 1u);
  EXPECT_TRUE(fulfils(of.settings[1], wish, study(), of, CostMeasure::mean));
  EXPECT_FALSE(fulfils(of.settings[2], wish, study(), of, CostMeasure::mean));
  EXPECT_FALSE(fulfils(of.settings[4], wish, study(), of, CostMeasure::mean));
  EXPECT_FALSE(fulfils(of.settings[4], {"budget", 1e9, {}}, study(), of, CostMeasure::mean));
}

TEST(TradeoffResult, TheReferencesOwnErrorIsAddedToErrorsBeforeALimit) {
  const TradeoffResult of = result();  // 2 ms: 40 mN, and the reference is known to 1 mN
  EXPECT_GT(excessOf(of.settings[1], study(), of, parseErrorLimits("reaction=40.5mN")), 1);
  EXPECT_LT(excessOf(of.settings[1], study(), of, parseErrorLimits("reaction=41.5mN")), 1);
}

TEST(TradeoffResult, ARefusedQuantityIsSaidAndChoosesNothing) {
  TradeoffResult of = result();
  of.references[1].refinement = {"does not converge", -2, kUnknown};
  for (JudgedSetting& one : of.settings) one.errors[1] = kUnknown;
  const TradeoffAnswer answer =
      answerOf({"errors", std::nullopt, parseErrorLimits("reaction=5%")}, study(), of, CostMeasure::mean);
  EXPECT_FALSE(answer.choice.best || answer.choice.nearest);
  EXPECT_NE(answerText(answer, study(), of, CostMeasure::mean).find("reaction has no reference: does not"),
            std::string::npos);
  EXPECT_NE(referenceLines(study(), of)[1].find("REFUSED, does not converge"), std::string::npos);
}

TEST(TradeoffResult, TheFrontIsMarked) {
  TradeoffResult of = result();
  of.settings.push_back(setting("0.003", 500, 1, 1));
  markFront(of.settings, CostMeasure::mean);
  for (std::size_t i = 0; i < of.settings.size(); ++i) EXPECT_EQ(of.settings[i].front, i < 4) << i;
}

TEST(TradeoffResult, FilesHaveWhatIsKnownAndNothingElse) {
  TradeoffResult of = result();
  markFront(of.settings, CostMeasure::mean);
  const std::string csv = tradeoffCsv(study(), of);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
  EXPECT_EQ(csv.find("nan"), std::string::npos);
  EXPECT_TRUE(csv.starts_with("step_s,pipeline,status,front,weighed_error,us_per_ms,"));
  const auto json = nlohmann::json::parse(tradeoffJson(study(), of, {}, CostMeasure::mean));
  EXPECT_EQ(json["settings"].size(), 5u);
  EXPECT_TRUE(json["settings"][4]["errors"]["depth"]["counts"].is_null());
  EXPECT_EQ(json["settings"][0]["front"], true);
  EXPECT_EQ(json["format"], "fissure-tradeoff");
  EXPECT_EQ(
      json["settings"][1]["command"],
      "fissure run 'a study/it'\\''s.yaml' --pipeline 'swept' --no-frames --set 'time.step_s=0.002000'");
  EXPECT_DOUBLE_EQ(json["references"][1]["own_error"], 1e-3);
  EXPECT_EQ(settingRows(study(), of).size(), 6u);
  EXPECT_EQ(settingRows(study(), of)[5].back(), "depth not measured");
}

}  // namespace fissure::tradeoff_result_test
