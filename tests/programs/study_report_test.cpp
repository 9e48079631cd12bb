// `fissure report` of a folder that `fissure study` has filled, from outside.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::study_report_test {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Both studies of one scenario, in one folder, for all tests.
class StudyReport : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<Folder>();
    made_->write("press.yaml", pressScenario("[{pipeline: default}, {pipeline: swept}]", "0.03"));
    made_->write("stability.yaml",
                 "format: 1\n"
                 "name: limits\n"
                 "base: press.yaml\n"
                 "press: {steps: 50}\n"
                 "refine_to: 0.5\n"
                 "maps:\n"
                 "  - name: step\n"
                 "    pipelines: [default]\n"
                 "    axes: [{path: time.step_s, values: [0.001, 0.002]}]\n");
    made_->write(
        "tradeoff.yaml",
        "format: 1\n"
        "name: costs\n"
        "base: press.yaml\n"
        "pipelines: [swept]\n"
        "axes: [{path: time.step_s, values: [0.001, 0.002]}]\n"
        "reference: {pipeline: swept, ladder: {path: time.step_s, values: [0.001, 0.0005, 0.00025]}}\n"
        "errors: [{quantity: depth, tolerance: 0.1mm}]\n"
        "repeats: 1\n");
    for (const char* kind : {"stability", "tradeoff"}) {
      const Outcome outcome = runFissure(*made_, {"study", kind, std::string(kind) + ".yaml", "-o", "both"});
      ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    }
  }
  static void TearDownTestSuite() { made_.reset(); }

  StudyReport() { fs::copy(*made_ / "both", folder_ / "both", fs::copy_options::recursive); }

  Outcome report(std::vector<std::string> words) const {
    words.insert(words.begin(), "report");
    return runFissure(folder_, words);
  }
  /// The data of a page, as its script reads them.
  nlohmann::json dataOf(const std::string& page) const {
    const std::string text = folder_.read(page), opening = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = text.find(opening) + opening.size();
    return nlohmann::json::parse(text.substr(begin, text.find("</script>", begin) - begin));
  }
  void expectRefused(const std::vector<std::string>& given, const std::string& words) const {
    const std::vector<std::string> before = folder_.names();
    const Outcome outcome = report(given);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(isOneLine(outcome.err) && has(outcome.err, words)) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder_.names(), before);
  }

  static std::unique_ptr<Folder> made_;
  Folder folder_;
};
std::unique_ptr<Folder> StudyReport::made_;

TEST_F(StudyReport, OnePageOfBothStudiesAndNoneOfTheirRuns) {
  const Outcome outcome = report({"both"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "page: both/index.html\n");
  std::vector<fs::path> pages, results;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / "both")) {
    if (entry.path().extension() == ".html") pages.push_back(entry.path());
    if (entry.path().extension() == ".h5") results.push_back(entry.path());
  }
  EXPECT_EQ(pages.size(), 1u);
  EXPECT_FALSE(results.empty()) << "which are the study's, and have no pages";
  const nlohmann::json data = dataOf("both/index.html");
  EXPECT_EQ(data["title"], "limits, costs");
  const nlohmann::json& cells = data["stability"]["panels"][0]["cells"];
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_TRUE(fs::is_regular_file(folder_ / "both" / cells[0]["result"].get<std::string>()));
  EXPECT_EQ(data["tradeoff"]["settings"].size(), 2u);
  expectRefused({"both"}, "index.html: exists already");
  EXPECT_EQ(report({"both", "--force"}).code, 0);
}

TEST_F(StudyReport, CommandsRunAndLinksLeadFromThePageToTheFolder) {
  ASSERT_EQ(report({"both", "-o", "pages/p.html"}).code, 0);
  const nlohmann::json data = dataOf("pages/p.html");
  EXPECT_EQ(data["folder"], "../both/");
  const std::string command = data["tradeoff"]["settings"][1]["command"];
  EXPECT_EQ(command, "fissure run './press.yaml' --pipeline 'swept' --no-frames --set 'time.step_s=0.002'");
  const std::string words = command.substr(std::string("fissure ").size());
  const Outcome run =
      runTool(*made_, {"sh", "-c", "\"$0\" " + words + " -o again.h5 --no-expect", fissureProgram()});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(StudyReport, ADamagedOrForeignStudyIsOneLine) {
  folder_.write("both/study.json", folder_.read("both/study.json").substr(0, 500));
  expectRefused({"both"}, "both/study.json: no whole JSON, expected what fissure study stability writes");
  folder_.write("both/study.json", "{\"format\": \"survey\"}");
  expectRefused({"both"}, "both/study.json: format is \"survey\", expected \"fissure-stability\"");
  fs::remove(folder_ / "both/study.json");
  folder_.write("both/tradeoff.json", "{\"study\": 7}");
  expectRefused({"both"}, "both/tradeoff.json: missing \"format\", expected \"fissure-tradeoff\"");
  expectRefused({"both", "-o", "both/tradeoff.json", "--force"}, "both/tradeoff.json: is one of its files");
  expectRefused({"both", "--video", "v.mp4"}, "--video: is of one result, expected no study");
  EXPECT_FALSE(fs::exists(folder_ / "both/index.html"));
}

}  // namespace
}  // namespace fissure::programs::study_report_test
