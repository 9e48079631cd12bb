// Pages of studies: where cells, boundaries, errors and fronts are, and what is refused.
#include "report/study_page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "report/page.h"
#include "report/stability_data.h"
#include "report/tradeoff_data.h"
#include "sample_study.h"

namespace fissure::study_page_test {

namespace {

namespace fs = std::filesystem;
using Data = PageJson (*)(const PageJson&);

/// Why a study is refused when the value at a place is another one.
std::string refusal(Data data, PageJson study, const char* place, const PageJson& value) {
  study[PageJson::json_pointer(place)] = value;
  try {
    data(study);
  } catch (const InputError& error) {
    return error.text();
  }
  return "nothing";
}

TEST(StabilityPage, CellsHavePlacesAndClassesCounts) {
  const PageJson data = stabilityData(sampleStability());
  EXPECT_EQ(data["classes"][0]["cells"], 1);
  EXPECT_EQ(data["classes"][1]["cells"], 3);
  EXPECT_EQ(data["classes"][2]["cells"], 5);
  const PageJson& steps = data["panels"][0];
  EXPECT_EQ(steps["rows"], PageJson({"1", "2", "10"})) << "by number, from below";
  EXPECT_EQ(steps["axes"][1]["name"], "step_s");
  const PageJson& last = steps["cells"][7];
  EXPECT_EQ(last["row"], 2);
  EXPECT_EQ(last["x"], 3e-3);
  EXPECT_TRUE(last["class"].is_null()) << "not run yet";
  EXPECT_EQ(steps["cells"][1]["frequency_Hz"], 215.5);
  EXPECT_EQ(steps["cells"][1]["class"], 1);
  EXPECT_EQ(steps["cells"][1]["result"], "steps/swept/runs/a b.h5");
}

TEST(StabilityPage, ListedValuesStandInTheOrderOfTheirList) {
  const PageJson panel = stabilityData(sampleStability())["panels"][1];
  EXPECT_EQ(panel["rows"], PageJson({""}));
  EXPECT_EQ(panel["cells"][0]["x"], 1);
  EXPECT_EQ(panel["cells"][1]["x"], 0);
  EXPECT_EQ(panel["cells"][0]["row"], 0);
}

TEST(StabilityPage, ABoundaryIsAtTheGeometricMean) {
  const PageJson boundary = stabilityData(sampleStability())["panels"][0]["boundaries"][0];
  EXPECT_NEAR(boundary["x"].get<double>(), std::sqrt(1e-3 * 1e-2), 1e-8);
  EXPECT_EQ(boundary["row"], 2);
  EXPECT_EQ(boundary["class_below"], 2);
  PageJson linear = sampleStability();
  linear["panels"][0]["axes"][1]["scale"] = "linear";
  linear["panels"][0]["boundaries"][0]["below"] = -1;
  linear["panels"][0]["boundaries"][0]["above"] = 2;
  EXPECT_EQ(stabilityData(linear)["panels"][0]["boundaries"][0]["x"], 0.5);
}

TEST(StabilityPage, WhatStudiesDoNotWriteIsRefused) {
  const auto refused = [](const char* place, const PageJson& value) {
    return refusal(stabilityData, sampleStability(), place, value);
  };
  EXPECT_EQ(refused("/format", "fissure-bench"),
            "format is \"fissure-bench\", expected \"fissure-stability\"");
  EXPECT_EQ(refused("/format_version", 2), "of a newer fissure, expected format_version 1");
  EXPECT_EQ(refused("/panels", nullptr), "\"panels\" is null, expected a list");
  EXPECT_EQ(refused("/panels/1/cells/0/class", "broken"),
            "panels.1: cells.0: class \"broken\" is none of the study's classes");
  EXPECT_EQ(refused("/panels/0/cells/3/command", 7), "panels.0: cells.3: \"command\" is 7, expected a text");
  EXPECT_EQ(refused("/panels/0/cells/3/values", {"1"}), "panels.0: cells.3: has 1 values, expected 2");
  EXPECT_EQ(refused("/panels/0/cells/3/values", {"1", "-2"}),
            "panels.0: cells.3: -2 has no place on axis time.step_s, which is logarithmic");
  EXPECT_EQ(refused("/panels/1/cells/0/values", {"both"}),
            "panels.1: cells.0: both is no value of axis response");
  EXPECT_EQ(refused("/panels/0/axes/0/scale", "round"),
            "panels.0: axes.0: scale is \"round\", expected values, linear or logarithmic");
  EXPECT_EQ(refused("/panels/0/axes", PageJson::array()), "panels.0: has 0 axes, expected one or two");
  EXPECT_EQ(refused("/panels/0/boundaries/0/others", {"7"}),
            "panels.0: boundaries.0: 7 is no value of the first axis");
  EXPECT_EQ(refused("/panels/0/boundaries/0/below", 1),
            "panels.0: boundaries.0: between 1 and 0.01, which is no part of a logarithmic axis");
  EXPECT_EQ(refused("/panels/0/cells/3/wall_s", nullptr), "nothing");
}

TEST(TradeoffPage, ErrorsHaveTheirReferencesAndQuantitiesTheirFront) {
  const PageJson data = tradeoffData(sampleTradeoff());
  EXPECT_EQ(data["names"][0], "step_s");
  ASSERT_EQ(data["quantities"].size(), 2u);
  const PageJson& depth = data["quantities"][0];
  EXPECT_EQ(depth["front"], PageJson({2, 1, 0})) << "from the cheapest on; 3 is dearer and worse than 1";
  EXPECT_TRUE(data["quantities"][1]["front"].empty()) << "the reaction has no errors";
  const PageJson& reaction = data["settings"][0]["errors"][1];
  EXPECT_TRUE(reaction["counts"].is_null());
  EXPECT_EQ(reaction["rms"], 0.2) << "the difference is known";
  EXPECT_EQ(reaction["reference"], 1) << "the only one is everybody's";
  EXPECT_EQ(data["settings"][4]["status"], "crashed");
  EXPECT_EQ(data["answers"][0]["again"]["cost"]["us_per_ms"]["median"], 205);
  EXPECT_TRUE(data["answers"][1]["holds"].is_null());
}

TEST(TradeoffPage, AReferenceOfItsOwnGoesBeforeOthers) {
  PageJson study = sampleTradeoff();
  study["references"].push_back(study["references"][0]);
  study["references"][2]["pipeline"] = "fukuhara";
  const PageJson data = tradeoffData(study);
  EXPECT_EQ(data["settings"][0]["errors"][0]["reference"], 0);
  EXPECT_EQ(data["settings"][2]["errors"][0]["reference"], 2);
  EXPECT_EQ(data["quantities"][0]["references"], PageJson({0, 2}));
}

TEST(TradeoffPage, TheFrontIsWhatNoCheaperSettingBeats) {
  EXPECT_TRUE(frontOf({}).empty());
  EXPECT_EQ(frontOf({{3, 1}, {1, 3}, {2, 2}, {2.5, 2.5}}), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(frontOf({{1, 1}, {2, 0.995}}), (std::vector<std::size_t>{0})) << "the same within 1 %";
  EXPECT_EQ(frontOf({{1, 1}, {1, 0.5}}), (std::vector<std::size_t>{1}));
  EXPECT_EQ(frontOf({{1, 0}, {2, 0}}), (std::vector<std::size_t>{0}));
}

TEST(TradeoffPage, WhatStudiesDoNotWriteIsRefused) {
  const auto refused = [](const char* place, const PageJson& value) {
    return refusal(tradeoffData, sampleTradeoff(), place, value);
  };
  EXPECT_EQ(refused("/format", "fissure-stability"),
            "format is \"fissure-stability\", expected \"fissure-tradeoff\"");
  EXPECT_EQ(refused("/cost", "memory"), "cost is \"memory\", expected us_per_ms or p99_us_per_ms");
  EXPECT_EQ(refused("/references/0/measure", "mean"),
            "references.0: measure is \"mean\", expected rms, worst or peak");
  EXPECT_EQ(refused("/settings/1/errors/depth/counts", "small"),
            "settings.1: \"counts\" is \"small\", expected a number or null");
  EXPECT_EQ(refused("/settings/1/values", PageJson::object()),
            "settings.1: missing \"time.step_s\", expected a text");
  EXPECT_EQ(refused("/answers/0/setting", 5),
            "answers.0: \"setting\" is 5, expected the index of one of 5 settings");
  EXPECT_EQ(refused("/orders/0/order", 2), "orders.0: \"order\" is 2, expected a map");
}

class StudyFolder : public testing::Test {
 protected:
  StudyFolder() : folder_(fs::path(testing::TempDir()) / ("fissure_study_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~StudyFolder() override { fs::remove_all(folder_); }

  void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string refused() const {
    try {
      studyPage(folder_, "./", "fissure");
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  }

  fs::path folder_;
};

TEST_F(StudyFolder, BothKindsAreOnOnePage) {
  EXPECT_TRUE(studyFilesIn(folder_).empty());
  write("study.json", sampleStability().dump());
  EXPECT_TRUE(studyPage(folder_, "./", "fissure")["tradeoff"].is_null());
  write("tradeoff.json", sampleTradeoff().dump());
  EXPECT_EQ(studyFilesIn(folder_).size(), 2u);
  const PageJson page = studyPage(folder_, "../s/", "fissure");
  EXPECT_EQ(page["title"], "limits, costs");
  EXPECT_EQ(page["folder"], "../s/");
  const std::string text = pageText(page);
  for (const char* words : {"stabilitySection();", "tradeoffSection();", "choosable(", "\\u003c/script>"})
    EXPECT_NE(text.find(words), std::string::npos) << words;
  EXPECT_EQ(text.find("{{"), std::string::npos);
}

TEST_F(StudyFolder, ADamagedOrForeignFileIsNamed) {
  const std::string whole = sampleStability().dump();
  const std::string file = (folder_ / "study.json").string();
  for (const std::size_t part : {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
    write("study.json", whole.substr(0, part));
    EXPECT_EQ(refused(), file + ": no whole JSON, expected what fissure study stability writes") << part;
  }
  write("study.json", "[1, 2]");
  EXPECT_EQ(refused(), file + ": missing \"format\", expected \"fissure-stability\"");
  fs::remove(folder_ / "study.json");
  fs::create_directory(folder_ / "study.json");
  EXPECT_NE(refused().find("study.json: "), std::string::npos);
}

}  // namespace
}  // namespace fissure::study_page_test
