// fissure export: what ParaView shows is what the result holds.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::export_test {
namespace {

namespace fs = std::filesystem;

const std::string snapshots = "record: {snapshots_every_s: 0.01}\n";
const std::string script_folder = FISSURE_SOURCE_DIR "/tests/programs/";

void expectRefused(const Outcome& outcome, const std::string& fragment) {
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_NE(outcome.err.find(fragment), std::string::npos) << outcome.err << "expected: " << fragment;
  EXPECT_EQ(outcome.out, "");
}

void makeResult(const Folder& folder, const std::string& scenario) {
  folder.write("s.yaml", scenario);
  const Outcome run = runFissure(folder, {"run", "s.yaml", "-o", "a.h5", "--force"});
  ASSERT_EQ(run.code, 0) << run.out << run.err;
}

// Moved elsewhere, and without the result beside it: an export is whole by itself.
TEST(Export, ParaViewShowsWhatTheResultHolds) {
  const Folder folder;
  if (runTool(folder, {"pvpython", "--version"}).code != 0) GTEST_SKIP() << "no ParaView here";
  makeResult(folder, fullScenario());
  ASSERT_EQ(runFissure(folder, {"export", "a.h5"}).code, 0);
  fs::create_directory(folder / "moved");
  fs::rename(folder / "a.paraview", folder / "moved/shown");
  for (const std::string run : {"default", "fukuhara"}) {
    const Outcome read =
        runTool(folder, {"env", "QT_QPA_PLATFORM=offscreen", "pvpython",
                         script_folder + "read_with_paraview.py", "a.h5", run, "moved/shown"});
    EXPECT_EQ(read.code, 0) << run << read.out << read.err;
    EXPECT_NE(read.out.find("7 times agree"), std::string::npos) << read.out;
  }
}

TEST(Export, VtkhdfFilesFollowTheSpecification) {
  const std::string python = pythonWith("h5py, numpy");
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py here";
  const Folder folder;
  makeResult(folder, fullScenario());
  ASSERT_EQ(runFissure(folder, {"export", "a.h5", "-o", "out/shown"}).code, 0);
  for (const std::string run : {"default", "fukuhara"}) {
    const Outcome check =
        runTool(folder, {python, script_folder + "check_vtkhdf.py", "a.h5", run, "out/shown"});
    EXPECT_EQ(check.code, 0) << run << check.out << check.err;
  }
  EXPECT_FALSE(fs::exists(folder / "out/shown/default.nodes.vtkhdf")) << "Bullet's contact has no nodes";
}

TEST(Export, ChoosesRunsAndSaysWhichThereAre) {
  const Folder folder;
  makeResult(folder, pressScenario("[{pipeline: default}, {pipeline: fukuhara}]", "0.03", snapshots));
  expectRefused(runFissure(folder, {"export", "a.h5", "--pipeline", "fukuhra"}),
                "a.h5: has no run \"fukuhra\", expected one of default, fukuhara");
  EXPECT_FALSE(fs::exists(folder / "a.paraview"));
  EXPECT_EQ(runFissure(folder, {"export", "a.h5", "--pipeline", "fukuhara", "-o", "shown"}).code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "shown"), {}), 4);
  for (const char* file :
       {"fukuhara.xdmf", "fukuhara.tissue.vtkhdf", "fukuhara.tools.vtkhdf", "fukuhara.nodes.vtkhdf"})
    EXPECT_TRUE(fs::exists(folder / "shown" / file)) << file;
}

TEST(Export, WithoutSnapshotsSaysHowToRecordThem) {
  const Folder folder;
  makeResult(folder, pressScenario());
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"export", "a.h5"}, {"export", "a.h5", "--pipeline", "fukuhara"}})
    expectRefused(runFissure(folder, words), "record: {snapshots_every_s: 0.01}");
  EXPECT_FALSE(fs::exists(folder / "a.paraview"));
}

TEST(Export, ReplacesOnlyWhenForced) {
  const Folder folder;
  makeResult(folder, pressScenario("[{pipeline: fukuhara}]", "0.03", snapshots));
  ASSERT_EQ(runFissure(folder, {"export", "a.h5"}).code, 0);
  const std::string before = folder.read("a.paraview/fukuhara.xdmf");
  fs::remove(folder / "a.paraview/fukuhara.tissue.vtkhdf");
  expectRefused(runFissure(folder, {"export", "a.h5"}), "exists already");
  EXPECT_FALSE(fs::exists(folder / "a.paraview/fukuhara.tissue.vtkhdf")) << "nothing is half replaced";
  EXPECT_EQ(runFissure(folder, {"export", "a.h5", "--force"}).code, 0);
  EXPECT_EQ(folder.read("a.paraview/fukuhara.xdmf"), before);
  makeResult(folder, pressScenario("[{name: fukuhara, pipeline: default}]", "0.03", snapshots));
  EXPECT_EQ(runFissure(folder, {"export", "a.h5", "--force"}).code, 0);
  EXPECT_FALSE(fs::exists(folder / "a.paraview/fukuhara.nodes.vtkhdf")) << "of an earlier run that had nodes";
}

TEST(Export, WithoutForceNothingOfOthersIsTouched) {
  const Folder folder;
  makeResult(folder, pressScenario("[{pipeline: default}]", "0.03", snapshots));
  fs::create_directory(folder / "shown");
  folder.write("shown/default.nodes.vtkhdf", "mine");
  EXPECT_EQ(
      runFissure(folder, {"export", "-o", "shown", "--pipeline", "default", "--pipeline", "default", "a.h5"})
          .code,
      0);
  EXPECT_EQ(folder.read("shown/default.nodes.vtkhdf"), "mine");
  fs::create_directory(folder / "own");
  fs::rename(folder / "a.h5", folder / "own/default.tissue.vtkhdf");
  expectRefused(runFissure(folder, {"export", "own/default.tissue.vtkhdf", "-o", "own", "--force"}),
                "own/default.tissue.vtkhdf: is the result itself, expected another name");
}

TEST(Export, RefusesWhatIsNoResult) {
  const Folder folder;
  makeResult(folder, pressScenario("[{pipeline: fukuhara}]", "0.03", snapshots));
  folder.write("text.h5", "hello");
  folder.write("file", "no folder");
  fs::copy_file(folder / "a.h5", folder / "cut.h5");
  fs::resize_file(folder / "cut.h5", fs::file_size(folder / "cut.h5") / 2);
  for (const std::string bad : {"text.h5", "cut.h5", "none.h5"})
    expectRefused(runFissure(folder, {"export", bad}), bad);
  expectRefused(runFissure(folder, {"export", "a.h5", "-o", "file"}), "file/fukuhara.");
  ASSERT_EQ(runFissure(folder, {"compare", "a.h5", "few.h5", "--update"}).code, 0);
  expectRefused(runFissure(folder, {"export", "few.h5"}), "few.h5: a reference");
  if (const std::string python = pythonWith("h5py"); !python.empty()) {
    const Outcome edit =
        runTool(folder, {python, "-c", "import h5py; h5py.File('a.h5', 'r+').attrs['format_version'] = 2"});
    ASSERT_EQ(edit.code, 0) << edit.err;
    expectRefused(runFissure(folder, {"export", "a.h5"}), "written by a newer fissure");
  }
  EXPECT_FALSE(fs::exists(folder / "a.paraview"));
}

TEST(Export, DamagedValuesAreFoundBeforeAnythingIsWritten) {
  const std::string python = pythonWith("h5py");
  if (python.empty()) GTEST_SKIP() << "no python3 with h5py here";
  const Folder folder;
  makeResult(folder, pressScenario("[{pipeline: fukuhara}]", "0.03", snapshots));
  const Outcome edit = runTool(
      folder,
      {python, "-c", "import h5py; del h5py.File('a.h5', 'r+')['pipelines/fukuhara/tool_quaternion']"});
  ASSERT_EQ(edit.code, 0) << edit.err;
  expectRefused(runFissure(folder, {"export", "a.h5"}), "a.h5: a run has snapshots but no tool_quaternion");
  EXPECT_FALSE(fs::exists(folder / "a.paraview"));
}

TEST(Export, AFullDiskLeavesNothingHalfWritten) {
  const Folder folder;
  makeResult(folder, pressScenario("[{pipeline: fukuhara}]", "0.03", "record: {snapshots_every_s: 0.001}\n"));
  fs::create_directory(folder / "small");
  if (::mount("tmpfs", (folder / "small").c_str(), "tmpfs", 0, "size=60k") != 0)
    GTEST_SKIP() << "mounting a small file system needs more rights than this test has";
  const Outcome outcome = runFissure(folder, {"export", "a.h5", "-o", "small"});
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder / "small")) left.push_back(entry.path().filename());
  ::umount((folder / "small").c_str());
  EXPECT_EQ(outcome.code, 3) << outcome.out << outcome.err;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_NE(outcome.err.find("small/fukuhara."), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << outcome.err;
  EXPECT_EQ(left, std::vector<std::string>{});
}

}  // namespace
}  // namespace fissure::programs::export_test
