// What happens when the programs that make or read volumes are killed, asked to stop or starved of disk.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::mesh_fault_test {
namespace {

namespace fs = std::filesystem;

/// An elastic ball from a surface file, filled by TetGen.
const std::string filled =
    "format: 1\nname: filled\ndescription: A plate above a filled surface.\n"
    "time: {step_s: 0.001, duration_s: 0.002}\nbodies:\n"
    "  - name: organ\n    shape: {type: file, file: organ.stl, unit: mm}\n    model: elastic\n"
    "    elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4}\n"
    "tools:\n  - name: plate\n    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
    "    motion: {type: script, start_m: [0, 0.5, 0]}\npipelines: [{pipeline: swept}]\n";

const std::string read_volume =
    "format: 1\nname: volume\ndescription: A plate above a volume from a file.\n"
    "time: {step_s: 0.001, duration_s: 0.002}\nbodies:\n"
    "  - name: organ\n    shape: {type: tetrahedra, file: organ.msh, unit: m}\n    model: elastic\n"
    "    elastic: {youngs_modulus_Pa: 10000, poissons_ratio: 0.4}\n"
    "tools:\n  - name: plate\n    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
    "    motion: {type: script, start_m: [0, 0.5, 0]}\npipelines: [{pipeline: swept}]\n";

/// A folder with the scenarios, an empty folder `tmp` for temporary files, and `bin` for programs.
class MeshFaults : public testing::Test {
 protected:
  MeshFaults() {
    fs::create_directory(folder_ / "tmp");
    fs::create_directory(folder_ / "bin");
    fs::copy_file(fs::path(FISSURE_SOURCE_DIR) / "configs/meshes/sofa_env/gallbladder_collision.stl",
                  folder_ / "organ.stl");
    folder_.write("filled.yaml", filled);
    folder_.write("volume.yaml", read_volume);
  }

  /// A program in place of TetGen, which says its process in the file "pid" and then does `what`.
  void replaceTetgen(const std::string& what) const {
    folder_.write("bin/tetgen", "#!/bin/sh\necho $$ > pid.part; mv pid.part pid\n" + what + "\n");
    fs::permissions(folder_ / "bin/tetgen", fs::perms::owner_all);
  }

  std::vector<std::string> words(const std::vector<std::string>& verb) const {
    std::vector<std::string> all = {"env", "TMPDIR=" + (folder_ / "tmp").string(),
                                    "PATH=" + (folder_ / "bin").string() + ":/usr/bin:/bin",
                                    fissureProgram()};
    all.insert(all.end(), verb.begin(), verb.end());
    return all;
  }

  pid_t waitForTetgen() const {
    for (int i = 0; i < 2000 && !fs::exists(folder_ / "pid"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::string text = folder_.read("pid");
    return text.empty() ? 0 : std::stoi(text);
  }

  std::ptrdiff_t temporaryFiles() const { return std::distance(fs::directory_iterator(folder_ / "tmp"), {}); }

  const Folder folder_;
};

TEST_F(MeshFaults, AKilledFrontTakesTetgenAlongAndTheNextOneClearsUp) {
  replaceTetgen("exec sleep 600");
  Program front(folder_, words({"validate", "filled.yaml"}));
  const pid_t tetgen = waitForTetgen();
  ASSERT_GT(tetgen, 0);
  front.send(SIGKILL);
  EXPECT_EQ(front.wait().signal, SIGKILL);
  EXPECT_TRUE(endsSoon(tetgen));
  fs::remove(folder_ / "bin/tetgen");
  const Outcome next = runTool(folder_, words({"validate", "filled.yaml"}));
  EXPECT_EQ(next.code, 0) << next.err;
  EXPECT_EQ(temporaryFiles(), 0);
}

TEST_F(MeshFaults, ARequestToStopEndsTetgenAndLeavesNothing) {
  replaceTetgen("exec sleep 600");
  for (const std::string verb : {"validate", "run"}) {
    fs::remove(folder_ / "pid");
    Program front(folder_, words({verb, "filled.yaml"}));
    const pid_t tetgen = waitForTetgen();
    ASSERT_GT(tetgen, 0);
    front.send(SIGINT);
    const Outcome outcome = front.wait();
    // Where nothing else is to be put away, the request ends the program as if nobody had held it back.
    EXPECT_TRUE(outcome.code == 130 || outcome.signal == SIGINT) << verb << outcome.code << outcome.err;
    EXPECT_TRUE(endsSoon(tetgen)) << verb;
    EXPECT_EQ(temporaryFiles(), 0) << verb;
    EXPECT_FALSE(fs::exists(folder_ / "out/filled.h5"));
  }
}

// The worker fills the surface again; what it leaves lies with the parts of its run.
TEST_F(MeshFaults, AStoppedRunLeavesNothingOfItsWorkersTetgen) {
  replaceTetgen(
      "if [ -e second ]; then touch waits; exec sleep 600; fi; touch second; exec /usr/bin/tetgen \"$@\"");
  Program front(folder_, words({"run", "filled.yaml", "-o", "out/result.h5"}));
  for (int i = 0; i < 2000 && !fs::exists(folder_ / "waits"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  ASSERT_TRUE(fs::exists(folder_ / "waits"));
  const pid_t tetgen = waitForTetgen();
  front.send(SIGINT);
  EXPECT_EQ(front.wait().code, 130);
  EXPECT_TRUE(endsSoon(tetgen));
  EXPECT_EQ(temporaryFiles(), 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "out"), {}), 0);
}

TEST_F(MeshFaults, TetgenKilledByAnotherIsNoFaultOfTheSurface) {
  replaceTetgen("kill -9 $$");
  const Outcome outcome = runTool(folder_, words({"validate", "filled.yaml"}));
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "bodies.organ.shape: tetgen: killed by signal 9\n");
  EXPECT_EQ(temporaryFiles(), 0);
}

/// Exit code 3, one line that says where and why, and nothing left.
void expectNoSpace(const Outcome& outcome, const char* reason) {
  EXPECT_EQ(outcome.code, 3) << outcome.out;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("bodies.organ.shape: ")) << outcome.err;
  EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
}

// The surface is 25 kB of text, what TetGen makes of it more than 30.
TEST_F(MeshFaults, AFileSizeLimitIsOneLine) {
  for (const unsigned long most_bytes : {2000ul, 30000ul}) {
    Program front(folder_, words({"validate", "filled.yaml"}), {.file_bytes = most_bytes});
    expectNoSpace(front.wait(), most_bytes < 10000 ? "File too large" : "no whole mesh");
    EXPECT_EQ(temporaryFiles(), 0);
  }
}

TEST_F(MeshFaults, AFullDiskIsOneLine) {
  for (const char* size : {"size=12k", "size=60k"}) {
    if (::mount("tmpfs", (folder_ / "tmp").c_str(), "tmpfs", 0, size) != 0)
      GTEST_SKIP() << "mounting a small file system needs more rights than this test has";
    const Outcome outcome = runTool(folder_, words({"validate", "filled.yaml"}));
    expectNoSpace(outcome, size == std::string("size=12k") ? "No space left on device" : "no whole mesh");
    EXPECT_EQ(temporaryFiles(), 0);
    ::umount((folder_ / "tmp").c_str());
  }
}

TEST_F(MeshFaults, AKilledOrStoppedFrontTakesTheReaderAlong) {
  if (pythonWith("meshio").empty()) GTEST_SKIP() << "no meshio";
  // Some seconds' worth of text.
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n400000\n";
  for (int n = 1; n <= 400000; ++n) text += std::to_string(n) + " 0 " + std::to_string(n) + " 0\n";
  folder_.write("organ.msh", text + "$EndNodes\n$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n");
  for (const int signal : {SIGKILL, SIGINT}) {
    Program front(folder_, words({"validate", "volume.yaml"}));
    const pid_t reader = front.waitForChild("python3");
    ASSERT_GT(reader, 0);
    front.send(signal);
    const Outcome outcome = front.wait();
    EXPECT_TRUE(outcome.signal == signal || outcome.code == 130) << outcome.code << outcome.err;
    EXPECT_TRUE(endsSoon(reader));
    EXPECT_EQ(temporaryFiles(), 0);
  }
}

}  // namespace
}  // namespace fissure::programs::mesh_fault_test
