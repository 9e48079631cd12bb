#include "report/sweep_page.h"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "report/packed.h"
#include "report/page.h"
#include "report/sweep_curves.h"
#include "report/sweep_failures.h"
#include "store/sample_run.h"
#include "table/sample_sweep.h"
#include "table/sweep_table_writer.h"

namespace fissure::sweep_page_test {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

std::string decoded(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, held = 0;
  for (const char c : base64.substr(0, base64.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xffu);
  }
  return bytes;
}

std::vector<unsigned> codesOf(const PageJson& packed) {
  const std::string bytes = decoded(packed.at("u16"));
  std::vector<unsigned> codes;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    codes.push_back(static_cast<unsigned char>(bytes[i]) | static_cast<unsigned char>(bytes[i + 1]) << 8);
  return codes;
}

std::vector<float> numbersOf(const PageJson& packed) {
  const std::string bytes = decoded(packed.at("f32"));
  std::vector<float> numbers;
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4) {
    std::uint32_t bits = 0;
    for (std::size_t k = 4; k-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[i + k]);
    numbers.push_back(std::bit_cast<float>(bits));
  }
  return numbers;
}

TEST(Packed, NumbersAndCodesReadBack) {
  const std::vector<float> read = numbersOf(packedNumbers({0.5, -3, missing}));
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[0], 0.5F);
  EXPECT_EQ(read[1], -3.0F);
  EXPECT_TRUE(std::isnan(read[2]));
  EXPECT_EQ(packedNumbers({2, 2}).dump(), R"({"same":2.0})");
  EXPECT_EQ(packedNumbers({missing, missing}).dump(), R"({"same":null})");
  EXPECT_EQ(codesOf(packedCodes({0, 1, 65535, 258})), (std::vector<unsigned>{0, 1, 65535, 258}));
  const PageJson texts = packedTexts({"c", "b", "a", "b"}, {2, 3});
  EXPECT_EQ(texts.at("values").dump(), R"(["b","a"])");
  EXPECT_EQ(codesOf(texts.at("codes")), (std::vector<unsigned>{1, 0}));
  const PageJson levels = packedLevels({3, 1, 3}, 2);
  EXPECT_EQ(levels.at("values").dump(), "[1.0,3.0]");
  EXPECT_EQ(codesOf(levels.at("codes")), (std::vector<unsigned>{1, 0, 1}));
  EXPECT_TRUE(packedLevels({1, 2, 3}, 2).is_null());
}

TEST(SweepFailures, NumbersInReasonsAreStripped) {
  EXPECT_EQ(withoutNumbers("at step 512, t = 0.512 s"), "at step #, t = # s");
  EXPECT_EQ(withoutNumbers("x = -1.5e-07 m"), "x = # m");
  EXPECT_EQ(withoutNumbers("law hc2 of tool_3: +4"), "law hc2 of tool_3: #");
  EXPECT_EQ(withoutNumbers("killed by signal 11."), "killed by signal #.");
  EXPECT_EQ(withoutNumbers(""), "");
}

/// A sweep over k = 0 .. 9 with two pipelines; `stiff` fails from k = 8 on, and one run is missing.
void writeFailing(const std::filesystem::path& path) {
  SweepTableLayout layout;
  layout.title = "failing";
  layout.design = "grid";
  layout.axes = {{"k", "force.hc.k", true}, {"rate", "force.hc.rate", false}};
  layout.metrics = {{"max_penetration_depth_m"}};
  layout.runs = 20;
  SweepTableWriter writer(path, layout);
  for (int run = 0; run < 20; ++run) {
    const int k = run / 2;
    const bool stiff = run % 2 == 1;
    SweepRun row{k,  0,  stiff ? "stiff" : "soft",           RunEnd::ok,
                 "", "", {std::to_string(k), "differences"}, {0.001 * k},
                 {}};
    if (stiff && k >= 8) row.end = RunEnd::non_finite, row.detail = "at step " + std::to_string(run);
    if (run == 4) row.end = RunEnd::missing, row.metrics = {missing};
    writer.append(row);
  }
  writer.finish(false);
}

TEST(SweepFailures, SameReasonsAreOneWithTheirPlaceInTheAxes) {
  const ScratchFolder folder;
  writeFailing(folder / "sweep.h5");
  const SweepEnds ends = sweepEnds(SweepTable(folder / "sweep.h5"));
  const PageJson failures = failuresJson(ends);
  ASSERT_EQ(failures.size(), 1U);
  const PageJson& failure = failures.front();
  EXPECT_EQ(failure.at("status"), "non_finite");
  EXPECT_EQ(failure.at("reason"), "at step #");
  EXPECT_EQ(failure.at("count"), 2);
  EXPECT_EQ(failure.at("examples").dump(), "[17,19]");
  EXPECT_EQ(failure.at("pipelines").dump(), R"([["stiff",2]])");
  EXPECT_EQ(failure.at("where").dump(), R"([{"axis":"k","from":8.0,"to":9.0,"share":0.2}])");
  EXPECT_EQ(ends.reasons[17], 0U);
  EXPECT_EQ(ends.reasons[4], 1U) << "a run that nobody has run has not failed";
}

/// A sweep over `runs` texts, of which those that `fail` says have failed.
PageJson placesOfTexts(const std::filesystem::path& path, int runs, const std::function<bool(int)>& fail) {
  SweepTableLayout layout;
  layout.design = "grid";
  layout.axes = {{"start_m", "tools.spatula.motion.start_m", false}};
  layout.runs = static_cast<std::size_t>(runs);
  SweepTableWriter writer(path, layout);
  for (int run = 0; run < runs; ++run)
    writer.append({run,
                   0,
                   "soft",
                   fail(run) ? RunEnd::timeout : RunEnd::ok,
                   "",
                   "",
                   {"[0, " + std::to_string(10 + run) + "]"},
                   {},
                   {}});
  writer.finish(true);
  return failuresJson(sweepEnds(SweepTable(path))).at(0).at("where");
}

TEST(SweepFailures, AxesOfTextsSayAtWhichValues) {
  const ScratchFolder folder;
  const auto places = [&](int runs, const std::function<bool(int)>& fail) {
    return placesOfTexts(folder / "sweep.h5", runs, fail);
  };
  EXPECT_EQ(places(10, [](int run) { return run == 3 || run == 7; }).dump(),
            R"([{"axis":"start_m","values":["[0, 13]","[0, 17]"],"more":0,"share":0.2}])");
  EXPECT_EQ(places(10, [](int run) { return run > 0; })[0].at("share"), 0.9);
  EXPECT_EQ(places(10, [](int) { return true; }).dump(), "[]");
  const PageJson many = places(40, [](int run) { return run < 20; });
  EXPECT_EQ(many[0].at("values").size(), 12U);
  EXPECT_EQ(many[0].at("more"), 8);
}

TEST(SweepPage, HasEveryRunAndHowItEnded) {
  const ScratchFolder folder;
  writeFailing(folder / "sweep.h5");
  const PageJson page = sweepPage(folder / "sweep.h5", "fissure test");
  EXPECT_EQ(page.at("kind"), "sweep");
  EXPECT_EQ(page.at("total"), 20);
  EXPECT_TRUE(page.at("whole_grid"));
  EXPECT_EQ(page.at("shown"), 20);
  EXPECT_TRUE(page.at("numbers").is_null());
  EXPECT_EQ(page.at("counts").dump(),
            R"([["soft","missing",1],["soft","ok",9],["stiff","non_finite",2],["stiff","ok",8]])");
  EXPECT_EQ(page.at("axes")[0].at("levels").at("values").size(), 10U);
  EXPECT_EQ(page.at("axes")[1].at("levels").at("values").dump(), R"(["differences"])");
  EXPECT_EQ(page.at("metrics")[0].at("unit"), "m");
  EXPECT_FLOAT_EQ(numbersOf(page.at("metrics")[0].at("data"))[19], 0.009F);
  EXPECT_TRUE(page.at("curves").is_null());
  const std::string text = pageText(page);
  EXPECT_NE(text.find("parallel coordinates"), std::string::npos);
  EXPECT_EQ(text.find("function timePlot"), std::string::npos) << "what only other pages need";
  EXPECT_EQ(text, pageText(sweepPage(folder / "sweep.h5", "fissure test")));
}

TEST(SweepPage, AxesHaveTheUnitsOfTheirNamesAndTextsNone) {
  const ScratchFolder folder;
  SweepTableLayout layout;
  layout.axes = {{"stiffness_N_m", "tools.spatula.coupling.stiffness_N_m", true},
                 {"start_m", "tools.spatula.motion.start_m", false}};
  layout.runs = 1;
  SweepTableWriter writer(folder / "sweep.h5", layout);
  writer.append({0, 0, "soft", RunEnd::ok, "", "", {"3000", "[0, 0.062, 0]"}, {}, {}});
  writer.finish(true);
  const PageJson axes = sweepPage(folder / "sweep.h5", "").at("axes");
  EXPECT_EQ(axes[0].at("unit"), "N m-1");
  EXPECT_EQ(axes[0].at("label"), "stiffness");
  EXPECT_EQ(axes[1].at("unit"), "1");
  EXPECT_EQ(axes[1].at("label"), "start_m") << "its values are in metres";
}

// sample_sweep.h: in its pipeline "default" the depth at the first instant is the run's number, 0, 2, 4
// ... 40.
TEST(SweepPage, CurvesHaveQuantilesAndSingleRuns) {
  const ScratchFolder folder;
  writeSampleSweep(folder / "sweep.h5", sampleSweep(42, 200));
  const PageJson page = sweepPage(folder / "sweep.h5", "fissure test");
  EXPECT_FALSE(page.at("whole_grid")) << "21 of 5 x 5 points";
  const PageJson& curves = page.at("curves");
  EXPECT_EQ(curves.at("every"), 3);
  EXPECT_EQ(curves.at("times_s").size(), 67U);
  ASSERT_EQ(curves.at("tracks").size(), 3U);
  EXPECT_EQ(curves.at("tracks")[2].at("law"), "linear");
  const PageJson& depth = curves.at("tracks")[0];
  // Of the even runs 10, 24 and 38 are not good.
  EXPECT_DOUBLE_EQ(depth.at("bands")[0].at("median")[0].get<double>(), 19);
  EXPECT_NEAR(depth.at("bands")[0].at("low")[0].get<double>(), 3.4, 1e-5);
  EXPECT_NEAR(depth.at("bands")[0].at("high")[0].get<double>(), 34.6, 1e-5);
  const std::vector<unsigned> rows = codesOf(curves.at("rows")), values = codesOf(depth.at("values"));
  ASSERT_EQ(rows.size(), 42U);
  ASSERT_EQ(values.size(), 42U * 67U);
  const std::vector<float> low = numbersOf(depth.at("low")), high = numbersOf(depth.at("high"));
  const double second = low[5] + values[5 * 67 + 1] / 65534.0 * (high[5] - low[5]);
  EXPECT_NEAR(second, 5 + 3 / 128.0, 1e-4);
  EXPECT_EQ(values[5 * 67 + 66], 65535U) << "this run has ended";
}

TEST(SweepPage, BestFitsKeepTheirCurves) {
  const ScratchFolder folder;
  SweepTableLayout layout = sampleSweep(6000, 96);
  layout.metrics[1].name = "misfit_N";  // three times the run's number
  layout.curves.pop_back();
  SweepTableWriter writer(folder / "sweep.h5", layout);
  for (std::size_t run = 0; run < layout.runs; ++run) {
    SweepRun row = sampleSweepRun(layout, run);
    row.curves.resize(96);
    row.metrics[1] = 3 * (6000.0 - static_cast<double>(run));
    writer.append(row);
  }
  writer.finish(true);
  const std::vector<unsigned> rows = codesOf(sweepPage(folder / "sweep.h5", "").at("curves").at("rows"));
  EXPECT_LT(rows.size(), 6000U);
  const std::set<unsigned> held(rows.begin(), rows.end());
  for (unsigned run = 5980; run < 6000; ++run) EXPECT_TRUE(held.contains(run)) << run;
}

// As many quantities as a summary of many laws and tools has.
TEST(SweepPage, TenThousandRunsStayBelowFiveMegabytesAndMoreAreSampled) {
  const ScratchFolder folder;
  SweepTableLayout layout = sampleSweep(10400, 40);
  layout.metrics.clear();
  for (int i = 0; i < 60; ++i) layout.metrics.push_back({"value" + std::to_string(i) + "_N"});
  SweepTableWriter writer(folder / "sweep.h5", layout);
  for (std::size_t run = 0; run < layout.runs; ++run) {
    SweepRun row = sampleSweepRun(layout, run);
    row.metrics.clear();
    for (std::size_t i = 0; i < 60; ++i) row.metrics.push_back(static_cast<double>(scattered(run * 60 + i)));
    writer.append(row);
  }
  writer.finish(true);
  const PageJson page = sweepPage(folder / "sweep.h5", "");
  EXPECT_EQ(page.at("shown"), 10000);
  EXPECT_EQ(page.at("total"), 10400);
  const std::vector<float> numbers = numbersOf(page.at("numbers"));
  EXPECT_EQ(std::set<float>(numbers.begin(), numbers.end()).size(), 10000U);
  const std::size_t bytes = pageText(page).size();
  EXPECT_LT(bytes, 5000000U);
  EXPECT_GT(bytes, 3000000U) << "the numbers are not there";
}

TEST(SweepPage, OfNoRunsAndOfWhatIsNoSweep) {
  const ScratchFolder folder;
  writeSampleSweep(folder / "sweep.h5", sampleSweep(0, 3));
  EXPECT_EQ(sweepPage(folder / "sweep.h5", "").at("shown"), 0);
  EXPECT_THROW(sweepPage(folder / "none.h5", ""), InputError);
}

}  // namespace
}  // namespace fissure::sweep_page_test
