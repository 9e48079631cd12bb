// `fissure report` from outside: a page of whatever a file holds, or one clear line.
#include <gtest/gtest.h>

#include <fstream>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::report_test {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// One result for all tests: two runs of 10 steps.
class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<Folder>();
    made_->write("s.yaml", pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.01",
                                         "force: [{name: hc, model: hunt_crossley}]\n"));
    ASSERT_EQ(runFissure(*made_, {"run", "s.yaml", "-o", "press.h5"}).code, 0);
  }
  static void TearDownTestSuite() { made_.reset(); }

  void copy(const std::string& name) const {
    fs::create_directories((folder_ / name).parent_path());
    fs::copy_file(*made_ / "press.h5", folder_ / name);
  }
  Outcome report(std::vector<std::string> words) const {
    words.insert(words.begin(), "report");
    return runFissure(folder_, words);
  }
  /// Refused in one line that says `words`, and nothing is written.
  void expectRefused(const std::vector<std::string>& given, const std::string& words, int code = 2) const {
    const std::vector<std::string> before = folder_.names();
    const Outcome outcome = report(given);
    EXPECT_EQ(outcome.code, code) << given.front();
    EXPECT_TRUE(isOneLine(outcome.err) && has(outcome.err, words)) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder_.names(), before);
  }

  static std::unique_ptr<Folder> made_;
  Folder folder_;
};
std::unique_ptr<Folder> Report::made_;

TEST_F(Report, OnePageBesideTheResult) {
  copy("press.h5");
  const Outcome outcome = report({"press.h5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "page: press.html\n");
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"press.h5", "press.html"}));
  const std::string page = folder_.read("press.html");
  for (const char* words :
       {"<!DOCTYPE html>", "\"title\":\"press\"", "\"name\":\"fukuhara\"", "penetration_depth"})
    EXPECT_TRUE(has(page, words)) << words;
  expectRefused({"press.h5"}, "press.html: exists already, expected a new name or --force");
  EXPECT_EQ(report({"press.h5", "--force"}).code, 0);
  EXPECT_EQ(folder_.read("press.html"), page) << "the same result gives the same page";
}

TEST_F(Report, OutputMayBeElsewhere) {
  copy("press.h5");
  EXPECT_EQ(report({"press.h5", "-o", "pages/p.html"}).code, 0);
  EXPECT_TRUE(fs::exists(folder_ / "pages/p.html"));
  expectRefused({"press.h5", "-o", "press.h5", "--force"}, "is the result itself");
}

TEST_F(Report, AVideoBecomesPartOfThePage) {
  copy("press.h5");
  folder_.write("v.webm", "\x1a\x45\xdf\xa3 and more");
  folder_.write("v.avi", "RIFF");
  EXPECT_EQ(report({"press.h5", "-o", "p.html", "--video", "v.webm"}).code, 0);
  EXPECT_TRUE(has(folder_.read("p.html"), "data:video/webm;base64,GkXfoy"));
  expectRefused({"press.h5", "-o", "q.html", "--video", "v.avi"}, "v.avi: no video that browsers play");
  expectRefused({"press.h5", "-o", "q.html", "--video", "none.mp4"}, "none.mp4: no such file");
}

TEST_F(Report, WhatIsNoResultGivesOneLine) {
  folder_.write("text.h5", "no result\n");
  expectRefused({"none.h5"}, "none.h5: no such file");
  expectRefused({"text.h5"}, "text.h5: not an HDF5 file");
  const std::string python = pythonWith("h5py");
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py here";
  copy("new.h5");
  const Outcome edit = runTool(
      folder_, {python, "-c", "import h5py; h5py.File('new.h5', 'a').attrs.modify('format_version', 2)"});
  ASSERT_EQ(edit.code, 0) << edit.err;
  expectRefused({"new.h5"}, "format_version 2, expected at most 1: written by a newer fissure");
}

TEST_F(Report, TruncatedFilesGiveOneLine) {
  copy("press.h5");
  const std::uintmax_t whole = fs::file_size(folder_ / "press.h5");
  for (const std::uintmax_t part : {9, 7, 4, 1}) {
    fs::resize_file(folder_ / "press.h5", whole * part / 10);
    expectRefused({"press.h5"}, "press.h5: a damaged");
  }
}

TEST_F(Report, AFullDiskLeavesNothing) {
  copy("press.h5");
  const Outcome outcome =
      Program(folder_, {fissureProgram(), "report", "press.h5"}, {.file_bytes = 20000}).wait();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(isOneLine(outcome.err) && has(outcome.err, "press.html: cannot write: ")) << outcome.err;
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"press.h5"});
}

TEST_F(Report, AFolderIsATableWithLinks) {
  copy("in/b.h5");
  copy("in/a/deep one.h5");
  copy("in/.hidden.XXXXXX/0.h5");
  folder_.write("in/broken.h5", "no result");
  const Outcome outcome = report({"in", "-o", "out/table.html"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("no page: broken.h5: not an HDF5 file") &&
              outcome.out.ends_with("\npage: out/table.html\n"))
      << outcome.out;
  const std::string table = folder_.read("out/table.html");
  std::size_t at = 0;
  for (const char* words :
       {"\"name\":\"a/deep one.h5\",\"page\":\"a/deep%20one.html\"", "\"name\":\"b.h5\",\"page\":\"b.html\"",
        "\"name\":\"broken.h5\",\"page\":\"\""}) {
    at = table.find(words, at);
    EXPECT_NE(at, std::string::npos) << words;
  }
  EXPECT_FALSE(has(table, ".hidden.XXXXXX"));
  EXPECT_TRUE(has(folder_.read("out/a/deep one.html"), "\"kind\":\"result\""));
  EXPECT_FALSE(fs::exists(folder_ / "out/broken.html"));
  expectRefused({"in", "-o", "out/table.html"}, "exists already");
  EXPECT_EQ(report({"in", "-o", "out/table.html", "--force"}).code, 0);
  EXPECT_EQ(folder_.read("out/table.html"), table);
}

TEST_F(Report, LinksToNowhereAreRowsOfTheTable) {
  copy("in/b.h5");
  fs::create_symlink("loop.h5", folder_ / "in/loop.h5");
  fs::create_symlink("gone", folder_ / "in/lost.h5");
  const Outcome outcome = report({"in"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "no page: loop.h5: ") && has(outcome.out, "no page: lost.h5: "))
      << outcome.out;
  EXPECT_TRUE(fs::exists(folder_ / "in/b.html"));
  fs::create_symlink("round", folder_ / "round");
  expectRefused({"round"}, "round: ");
}

TEST_F(Report, FoldersThatCannotBeReported) {
  fs::create_directory(folder_ / "empty");
  expectRefused({"empty"}, "empty: holds no result, expected *.h5 files");
  copy("in/b.h5");
  expectRefused({"in", "-o", "in/b.html"}, "is the page of in/b.h5 too");
  expectRefused({"in", "-o", "in/b.h5", "--force"}, "is a result itself");
  expectRefused({"in", "--video", "v.mp4"}, "--video: is of one result");
}

std::string benchFile(const std::string& commit) {
  return "{\"format\": \"fissure-bench\", \"format_version\": 1, \"commit\": \"" + commit +
         "\", \"commit_date\": \"2026-01-31T12:00:00Z\", \"modified\": false, \"machine\": {\"cpu\": \"A\", "
         "\"cores\": 2}, \"build\": {\"type\": \"Release\", \"compiler\": \"c\", \"flags\": \"\"}, "
         "\"benchmarks\": [{\"name\": \"step/a\", \"time_us\": [1, 2], \"counters\": {\"rays\": 64}}]}";
}

TEST_F(Report, AFolderOfBenchmarkFilesIsAHistory) {
  fs::create_directory(folder_ / "bench");
  folder_.write("bench/1.json", benchFile("aa"));
  folder_.write("bench/2.json", benchFile("bb"));
  folder_.write("bench/torn.json", benchFile("cc").substr(0, 100));
  const Outcome outcome = report({"bench"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(
      outcome.out,
      "not shown: torn.json: no whole JSON, expected a file of scripts/bench\npage: bench/index.html\n");
  const std::string page = folder_.read("bench/index.html");
  for (const char* words : {"\"kind\":\"history\"", "\"title\":\"bench\"", "\"name\":\"step/a\""})
    EXPECT_TRUE(has(page, words)) << words;
  expectRefused({"bench"}, "bench/index.html: exists already");
  EXPECT_EQ(report({"bench", "--force"}).code, 0);
  expectRefused({"bench", "--force", "-o", "bench/1.json"}, "bench/1.json: is one of its files");
  expectRefused({"bench", "--video", "v.mp4"}, "--video: is of one result");
  copy("bench/press.h5");  // then its results are shown
  EXPECT_TRUE(has(report({"bench", "--force"}).out, "page: bench/index.html"));
  EXPECT_TRUE(has(folder_.read("bench/index.html"), "\"kind\":\"folder\""));
}

TEST_F(Report, AFolderOfOtherJsonIsRefused) {
  fs::create_directory(folder_ / "plans");
  folder_.write("plans/manifest.json", "{\"format\": \"fissure-sweep-plan\"}");
  expectRefused({"plans"},
                "plans: holds neither results (*.h5) nor files of scripts/bench: manifest.json: format is "
                "\"fissure-sweep-plan\", expected \"fissure-bench\"");
}

}  // namespace
}  // namespace fissure::programs::report_test
