// What a page says of results whose every value is known, and of results that went wrong.
#include "report/page_data.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "report/page.h"
#include "scenario/load.h"
#include "store/part_file.h"
#include "store/sample_run.h"

namespace fissure::page_data_test {

namespace {

namespace fs = std::filesystem;

/// Both pipelines of the sample run, "paper_method" and "default".
fs::path writeSample(const ScratchFolder& folder, const SampleRun& run,
                     const std::optional<RunStatus>& second = std::nullopt) {
  std::vector<PartResult> parts;
  for (const PipelineSettings& entry : run.scenario.pipelines) {
    if (second && !parts.empty()) {
      parts.push_back({entry, std::nullopt, *second});
      continue;
    }
    const fs::path part = folder / (entry.name + ".part");
    writeSamplePart(part, run, entry.name);
    parts.push_back({entry, part, {RunEnd::ok, ""}});
  }
  assembleResult(folder / "sample.h5", loadedSample(run), {{"version", "1.2.3"}}, parts);
  return folder / "sample.h5";
}

const PageJson* findPlot(const PageJson& page, const std::string& id) {
  for (const PageJson& plot : page["plots"])
    if (plot["id"] == id) return &plot;
  return nullptr;
}

bool hasWarning(const PageJson& page, const std::string& words, bool serious) {
  for (const PageJson& warning : page["warnings"])
    if (warning["text"].get<std::string>().find(words) != std::string::npos && warning["serious"] == serious)
      return true;
  return false;
}

/// Rows of a series, from their steps.
std::vector<std::size_t> rowsOf(const PageJson& series) {
  std::vector<std::size_t> rows;
  std::size_t row = 0;
  for (const PageJson& more : series["rows"]) rows.push_back(row += more.get<std::size_t>());
  return rows;
}

// penetration_depth = row mm, missing in row 1; contact_count = 3 row; force = 100 law + row + axis/10.
TEST(PageData, SeriesAreTheResults) {
  const ScratchFolder folder;
  const PageJson page = resultPage(writeSample(folder, makeSampleRun(50, false)), "fissure test", "");
  EXPECT_EQ(page["title"], "sample");
  ASSERT_EQ(page["runs"].size(), 2u);
  EXPECT_EQ(page["runs"][0]["name"], "paper_method");
  EXPECT_EQ(page["runs"][1]["times"]["step_s"], 0.5);
  const PageJson* depth = findPlot(page, "penetration_depth");
  ASSERT_TRUE(depth);
  EXPECT_EQ((*depth)["unit"], "mm");
  const PageJson& series = (*depth)["variants"][0]["series"];
  ASSERT_EQ(series.size(), 2u);
  const std::vector<std::size_t> rows = rowsOf(series[1]);
  ASSERT_EQ(rows.size(), 50u);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] == 1)
      EXPECT_TRUE(series[1]["values"][i].is_null());
    else
      EXPECT_DOUBLE_EQ(series[1]["values"][i].get<double>(), static_cast<double>(rows[i]));
  }
  const PageJson* force = findPlot(page, "force");
  ASSERT_TRUE(force);
  EXPECT_EQ((*force)["select"], "law");
  ASSERT_EQ((*force)["variants"].size(), 2u);
  EXPECT_EQ((*force)["variants"][1]["label"], "linear");
  const double last = (*force)["variants"][1]["series"][0]["values"].back();
  EXPECT_NEAR(last, std::sqrt(149.0 * 149.0 + 149.1 * 149.1 + 149.2 * 149.2), 1e-3);
  EXPECT_TRUE(hasWarning(page, "the penetration depth of 1 step is no number", true));
  EXPECT_TRUE(hasWarning(page, "its scenario cannot be read", false)) << "its text is no scenario";
  EXPECT_EQ(page["provenance"][0], PageJson({"version", "1.2.3"}));
}

TEST(PageData, OnlyWhatIsPresentIsShown) {
  const ScratchFolder folder;
  const PageJson page = resultPage(writeSample(folder, makeSampleRun(50, false)), "fissure test", "");
  EXPECT_TRUE(page["frames"].is_null());
  std::set<std::string> ids;
  for (const PageJson& plot : page["plots"]) ids.insert(plot["id"]);
  EXPECT_EQ(ids, (std::set<std::string>{"penetration_depth", "force", "force_elastic", "contact_count"}));
}

// The sample's summary is of 12 steps, of which rows tell only some.
TEST(PageData, StepsWithoutRowsMayBeMore) {
  const ScratchFolder folder;
  const PageJson page = resultPage(writeSample(folder, makeSampleRun(5, false)), "fissure test", "");
  EXPECT_TRUE(hasWarning(page, "the penetration depth of at least 1 step is no number", true));
  for (const PageJson& times : page["step_times"]["runs"]) {
    EXPECT_EQ(times["steps_of_run"], 12);
    EXPECT_LT(times["steps"], 12);
  }
  EXPECT_FALSE(page["step_times"]["runs"].empty());
}

// The sample's worst depth is 250 mm: that its run has finished is nothing good.
TEST(PageData, ARunThatFinishedIsJudgedByItsMeasures) {
  const ScratchFolder folder;
  const fs::path file = writeSample(folder, makeSampleRun(5, false));
  const PageJson deep = {
      {"status", "finished"}, {"finished", true}, {"verdict", "250.00 mm inside"}, {"grade", "bad"}};
  EXPECT_EQ(resultPage(file, "p", "")["runs"][0]["end"], deep);
  const PageJson table = folderPage("f", "p", {{.name = "sample.h5", .info = readResultInfo(file)}});
  EXPECT_EQ(table["results"][0]["runs"][0]["end"], deep);
}

TEST(PageData, FramesAreWebpPictures) {
  const ScratchFolder folder;
  const PageJson page = resultPage(writeSample(folder, makeSampleRun(50, true)), "fissure test", "");
  ASSERT_EQ(page["frames"]["runs"].size(), 2u);
  EXPECT_EQ(page["frames"]["stored"], 8);
  EXPECT_EQ(page["frames"]["shown"], 8);
  EXPECT_EQ(page["frames"]["runs"][1]["times_s"], PageJson({0, 2, 4, 6}));
  for (const PageJson& image : page["frames"]["runs"][0]["images"])
    EXPECT_TRUE(image.get<std::string>().starts_with("data:image/webp;base64,UklGR")) << image;
}

TEST(PageData, ACrashedRunIsOnTopAndTheOtherIsShown) {
  const ScratchFolder folder;
  const RunStatus crashed = {RunEnd::crashed, "killed by signal 11 at step 3"};
  const PageJson page = resultPage(writeSample(folder, makeSampleRun(50, true), crashed), "fissure test", "");
  ASSERT_FALSE(page["warnings"].empty());
  EXPECT_EQ(page["warnings"][0]["text"], "the penetration depth of 1 step is no number");
  EXPECT_TRUE(hasWarning(page, "crashed: killed by signal 11 at step 3", true));
  EXPECT_TRUE(hasWarning(page, "it left no series", true));
  EXPECT_EQ(page["runs"][1]["end"]["status"], "crashed");
  EXPECT_EQ(page["runs"][1]["times"]["count"], 0);
  EXPECT_EQ((*findPlot(page, "penetration_depth"))["variants"][0]["series"].size(), 1u);
}

TEST(PageData, OneRowAndNone) {
  for (const std::size_t rows : {0u, 1u}) {
    const ScratchFolder folder;
    const PageJson page = resultPage(writeSample(folder, makeSampleRun(rows, false)), "fissure test", "");
    EXPECT_EQ(page["runs"][0]["times"]["count"], rows);
    EXPECT_EQ(hasWarning(page, "it left no series", true), rows == 0);
  }
}

TEST(PageData, TheSameResultGivesTheSamePage) {
  const ScratchFolder folder;
  const fs::path file = writeSample(folder, makeSampleRun(500, true));
  EXPECT_EQ(pageText(resultPage(file, "p", "")), pageText(resultPage(file, "p", "")));
}

TEST(PageData, APartIsNoResult) {
  const ScratchFolder folder;
  writeSamplePart(folder / "a.part", makeSampleRun(5, false), "default");
  EXPECT_THROW(resultPage(folder / "a.part", "p", ""), InputError);
}

/// Everything that a page plots, for one run of `rows` steps that never repeats a value: the hardest to thin
/// out. Frames of noise, which no compression helps.
void writeNoisyPart(const fs::path& path, const Scenario& scenario, const Scene& scene, std::size_t entry,
                    std::size_t rows) {
  RecordLayout layout;
  layout.add({"time", "s", "", ValueType::real, {}});
  layout.addAxis({"law", {"hc", "linear", "tissue"}});
  layout.addAxis({"xyz", {"x", "y", "z"}});
  layout.addAxis({"tool", {"left", "right"}});
  layout.addAxis({"body", {"liver", "kidney"}});
  for (const char* name : {"penetration_depth", "stand_off", "kinetic_energy"})
    layout.add({name, "m", "", ValueType::real, {}});
  for (const char* name : {"contact_count", "infeasible_count", "candidate_count", "capped_count",
                           "colliding_triangles", "passed_through", "inverted_triangles"})
    layout.add({name, "1", "", ValueType::count, {}});
  for (const char* name : {"force_elastic", "force_viscous"})
    layout.add({name, "N", "", ValueType::real, {"law"}});
  layout.add({"force", "N", "", ValueType::real, {"law", "xyz"}});
  layout.add({"tool_force", "N", "", ValueType::real, {"law", "tool", "xyz"}});
  layout.add({"reaction_force", "N", "", ValueType::real, {"xyz"}});
  layout.add({"volume", "m3", "", ValueType::real, {"body"}});
  layout.add({"timing/step_time_us", "us", "", ValueType::real, {}});
  const auto part = createPartFile(path, {.scenario = scenario,
                                          .pipeline = scenario.pipelines[entry],
                                          .scene = scene,
                                          .layout = layout,
                                          .expected_steps = static_cast<std::int64_t>(rows) - 1});
  std::uint32_t noise = static_cast<std::uint32_t>(entry) + 1;
  const auto next = [&] { return noise = noise * 1664525u + 1013904223u; };  // Numerical Recipes
  RecordRow row(layout.columns());
  for (std::size_t r = 0; r < rows; ++r) {
    for (double& value : row) value = static_cast<double>(next() >> 12);
    row[0] = 0.001 * static_cast<double>(r);
    part->append(row);
  }
  Image image{scenario.record.frames->width_px, scenario.record.frames->height_px, {}};
  image.rgb.resize(static_cast<std::size_t>(3 * image.width_px * image.height_px));
  for (std::uint8_t& byte : image.rgb) byte = static_cast<std::uint8_t>(next() >> 24);
  for (int frame = 0; frame < 26; ++frame) part->frame(0.2 * frame, image);
  part->finish({RunEnd::ok, ""}, {});
}

// The numbers: four pipelines, 5,000 steps, below 2 MB. The time is only printed: machines differ.
TEST(PageData, FourNoisyRunsOf5000StepsStayBelow2MB) {
  const ScratchFolder folder;
  SampleRun run = makeSampleRun(1, true);
  run.scenario.record.snapshots_every_s.reset();
  run.scenario.record.frames = FrameSettings{0.2, 320, 240, std::nullopt};
  const PipelineSettings entry = run.scenario.pipelines.front();
  run.scenario.pipelines.assign(4, entry);
  std::vector<PartResult> parts;
  for (std::size_t i = 0; i < 4; ++i) {
    run.scenario.pipelines[i].name = "run_" + std::to_string(i);
    const fs::path part = folder / (std::to_string(i) + ".part");
    writeNoisyPart(part, run.scenario, run.scene, i, 5001);
    parts.push_back({run.scenario.pipelines[i], part, {RunEnd::ok, ""}});
  }
  assembleResult(folder / "a.h5", loadedSample(run), {}, parts);
  const auto start = std::chrono::steady_clock::now();
  const PageJson page = resultPage(folder / "a.h5", "p", "");
  const std::size_t bytes = pageText(page).size();
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_LT(bytes, 2000000u);
  EXPECT_GT(bytes, 500000u) << "far from the limit: it could show more";
  EXPECT_EQ(page["frames"]["stored"], 104);
  EXPECT_GE(page["frames"]["shown"], 8);
  EXPECT_LT(page["frames"]["shown"], 104) << "noise does not fit";
  std::printf("page of four runs of 5,000 noisy steps: %zu bytes in %.2f s\n", bytes, wall_s);
}

}  // namespace
}  // namespace fissure::page_data_test
