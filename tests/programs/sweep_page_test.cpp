// `fissure info` and `fissure report` of a sweep's table, from outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "table/sample_sweep.h"

namespace fissure::programs::sweep_page_test {
namespace {

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(SweepInfo, SaysWhatWasSwept) {
  const Folder folder;
  writeSampleSweep(folder / "sweep.h5", sampleSweep(20, 4), false);
  const Outcome text = runFissure(folder, {"info", "sweep.h5"});
  EXPECT_EQ(text.code, 0) << text.err;
  for (const char* words :
       {"fissure-sweep, version 1, not complete", "20 runs, design grid", "default   non_finite     1",
        "k      force.hc.k              5", "max_penetration_depth_m (m)", "force (N), 4 instants, each law"})
    EXPECT_TRUE(has(text.out, words)) << words << "\n" << text.out;
  const Outcome machine = runFissure(folder, {"info", "sweep.h5", "--json"});
  const auto json = nlohmann::json::parse(machine.out);
  EXPECT_EQ(json.at("runs"), 20);
  EXPECT_EQ(json.at("complete"), false);
  EXPECT_EQ(json.at("pipelines").at("full").at("ok"), 8);
  EXPECT_EQ(json.at("axes")[0].at("path"), "force.hc.k");
}

TEST(SweepReport, OfATableAndOfItsFolder) {
  const Folder folder;
  std::filesystem::create_directories(folder / "law");
  writeSampleSweep(folder / "law/sweep.h5", sampleSweep(20, 4));
  EXPECT_EQ(runFissure(folder, {"report", "law"}).out, "page: law/sweep.html\n");
  const std::string page = folder.read("law/sweep.html");
  EXPECT_TRUE(has(page, "\"kind\":\"sweep\"") && has(page, "\"total\":20"));
  EXPECT_EQ(runFissure(folder, {"report", "law/sweep.h5", "-o", "page.html"}).code, 0);
  EXPECT_EQ(folder.read("page.html"), page);
  const Outcome video = runFissure(folder, {"report", "law", "-o", "v.html", "--video", "v.mp4"});
  EXPECT_EQ(video.code, 2);
  EXPECT_TRUE(has(video.err, "--video: is of one result, expected no sweep")) << video.err;
}

TEST(SweepReport, IsARowInTheTableOfAFolder) {
  const Folder folder;
  std::filesystem::create_directories(folder / "out/law");
  writeSampleSweep(folder / "out/law/sweep.h5", sampleSweep(20, 4));
  EXPECT_EQ(runFissure(folder, {"report", "out"}).code, 0);
  EXPECT_TRUE(has(folder.read("out/index.html"), "\"note\":\"a sweep of 20 runs\""));
  EXPECT_TRUE(has(folder.read("out/law/sweep.html"), "\"kind\":\"sweep\""));
}

TEST(SweepReport, OfADamagedTableIsOneLine) {
  const Folder folder;
  writeSampleSweep(folder / "sweep.h5", sampleSweep(2000, 4));
  std::filesystem::resize_file(folder / "sweep.h5", std::filesystem::file_size(folder / "sweep.h5") / 2);
  for (const char* verb : {"info", "report"}) {
    const Outcome outcome = runFissure(folder, {verb, "sweep.h5"});
    EXPECT_EQ(outcome.code, 2) << verb;
    EXPECT_TRUE(isOneLine(outcome.err) && has(outcome.err, "sweep.h5: a damaged or truncated HDF5 file"))
        << outcome.err;
  }
}

}  // namespace
}  // namespace fissure::programs::sweep_page_test
