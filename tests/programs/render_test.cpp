// fissure render: what is drawn after the fact is what the run drew; everything else is one line.
#include <gtest/gtest.h>

#include <csignal>
#include <random>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::render_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;
using Words = std::vector<std::string>;

/// A clamp with a handle, a blade, two bodies and the ground; frames and snapshots at the same times.
const std::string clamp_scenario =
    "format: 1\n"
    "name: two\n"
    "time: {step_s: 0.001, settle_s: 0.003, duration_s: 0.03}\n"
    "ground: {height_m: 0}\n"
    "bodies:\n"
    "  - {name: a, shape: {type: sphere, radius_m: 0.02, subdivisions: 1}, position_m: [0, 0.02, 0], "
    "mass_kg: 0.1}\n"
    "  - {name: b, shape: {type: sphere, radius_m: 0.01, subdivisions: 1}, position_m: [0.05, 0.01, 0], "
    "mass_kg: 0.1}\n"
    "tools:\n"
    "  - name: clamp\n"
    "    shape: {type: box, size_m: [0.004, 0.03, 0.01]}\n"
    "    clamp:\n"
    "      opening: parallel\n"
    "      jaw_position_m: [0.002, 0, 0]\n"
    "      handle:\n"
    "        - {shape: {type: box, size_m: [0.05, 0.008, 0.01]}, position_m: [0, 0.03, 0]}\n"
    "    nodes: {resolution: [6, 4]}\n"
    "    motion:\n"
    "      type: script\n"
    "      start_m: [0, 0.025, 0]\n"
    "      start_opening_m: 0.042\n"
    "      segments: [{open_to_m: 0.036, duration_s: 0.03}]\n"
    "  - name: blade\n"
    "    shape: {type: box, size_m: [0.02, 0.002, 0.01]}\n"
    "    nodes: {resolution: [4, 4]}\n"
    "    motion:\n"
    "      type: script\n"
    "      start_m: [0.05, 0.023, 0]\n"
    "      segments: [{move_to_m: [0.05, 0.017, 0], speed_m_s: 0.3}]\n"
    "pipelines: [{pipeline: fukuhara}, {name: bullet, pipeline: default}]\n"
    "record: {snapshots_every_s: 0.01, frames: {every_s: 0.01, size_px: [160, 120]}}\n";

const std::string press_scenario = pressScenario("[{pipeline: fukuhara}, {pipeline: raycast}]", "0.02",
                                                 "record: {snapshots_every_s: 0.01}\n");

void run(const Folder& folder, const std::string& scenario, const std::string& result) {
  folder.write("s.yaml", scenario);
  const Outcome outcome = runFissure(folder, {"run", "s.yaml", "-o", result});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
}

Outcome render(const Folder& folder, Words words) {
  words.insert(words.begin(), "render");
  return runFissure(folder, std::move(words));
}

void expectOneLine(const Outcome& outcome, int code, const std::string& fragment) {
  EXPECT_EQ(outcome.code, code) << fragment;
  EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
  EXPECT_NE(outcome.err.find(fragment), std::string::npos) << outcome.err << "expected: " << fragment;
}

Names below(const Folder& folder, const std::string& name) {
  Names names;
  for (const auto& entry : fs::directory_iterator(folder / name))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// The pictures of the folder `pictures` against the frames in the result, pixel by pixel.
const std::string compare_frames =
    "import h5py, numpy, sys\n"
    "from PIL import Image\n"
    "count = 0\n"
    "for name, run in h5py.File('r.h5')['pipelines'].items():\n"
    "    assert (run['frame_time'][:] == run['snapshot_time'][:]).all()\n"
    "    for time, frame in zip(run['frame_time'][:], run['frames'][:]):\n"
    "        picture = numpy.asarray(Image.open(f'pictures/{name}_{time:.3f}s.png'))\n"
    "        assert picture.shape == frame.shape and (picture == frame).all(), (name, time)\n"
    "        count += 1\n"
    "print(count)\n";

TEST(Render, AfterTheFactEqualsTheFramesOfTheRun) {
  const Folder folder;
  run(folder, clamp_scenario, "r.h5");
  ASSERT_EQ(render(folder, {"r.h5", "-o", "pictures", "--separate"}).out, "pictures: 8 in pictures\n");
  const Outcome compared = runTool(folder, {"/usr/bin/python3", "-c", compare_frames});
  EXPECT_EQ(compared.out, "8\n") << compared.err;
  // One run alone, again: the same files.
  ASSERT_EQ(render(folder, {"r.h5:bullet", "-o", "again"}).code, 0);
  EXPECT_EQ(below(folder, "again"),
            (Names{"bullet_0.000s.png", "bullet_0.010s.png", "bullet_0.020s.png", "bullet_0.030s.png"}));
  for (const std::string& name : below(folder, "again"))
    EXPECT_EQ(folder.read("again/" + name), folder.read("pictures/" + name)) << name;
}

// What frames show needs no frames in the run, and no file beside the result.
TEST(Render, NeedsOnlySnapshots) {
  const Folder folder;
  run(folder, clamp_scenario, "r.h5");
  run(folder, with(clamp_scenario, ", frames: {every_s: 0.01, size_px: [160, 120]}", ""), "bare.h5");
  fs::remove(folder / "s.yaml");
  ASSERT_EQ(render(folder, {"r.h5", "-o", "a", "--at", "0.02"}).code, 0);
  ASSERT_EQ(render(folder, {"bare.h5", "-o", "b", "--at", "0.02", "--size", "160x120"}).code, 0);
  EXPECT_EQ(below(folder, "a"), Names{"two_0.020s.png"});
  EXPECT_EQ(folder.read("a/two_0.020s.png"), folder.read("b/two_0.020s.png"));
  EXPECT_GT(folder.read("a/two_0.020s.png").size(), 1000u);
  ASSERT_EQ(render(folder, {"r.h5", "-o", "c", "--at", "0.02", "--look-at", "0.05", "0.01", "0"}).code, 0);
  EXPECT_NE(folder.read("a/two_0.020s.png"), folder.read("c/two_0.020s.png"));
}

TEST(Render, VideosAreTheSameTwice) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  for (const std::string kind : {"mp4", "webm", "gif"}) {
    const Words words = {"r.h5", "--size", "64x48", "--slow-motion", "10", "--video"};
    Words first = words, second = words;
    first.push_back("a." + kind);
    second.push_back("new/b." + kind);
    EXPECT_EQ(render(folder, first).out, "video: a." + kind + ", 6 frames, 0.24 s\n");
    EXPECT_EQ(render(folder, second).code, 0);
    EXPECT_GT(folder.read("a." + kind).size(), 500u);
    EXPECT_EQ(folder.read("a." + kind), folder.read("new/b." + kind)) << kind;
  }
  EXPECT_EQ(folder.names(), (Names{"a.gif", "a.mp4", "a.webm", "new", "r.h5", "s.yaml"}));
}

TEST(Render, WithoutFfmpegThePicturesAreThere) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  const Words nowhere = {"env", "PATH=/nonexistent", fissureProgram(), "render", "r.h5", "--video", "a.mp4"};
  expectOneLine(runTool(folder, nowhere), 2, "a.mp4: needs ffmpeg, which is not installed");
  EXPECT_EQ(folder.names(), (Names{"r.h5", "s.yaml"}));
  Words pictures = nowhere;
  pictures.insert(pictures.end(), {"-o", "pictures", "--size", "64x48"});
  const Outcome outcome = runTool(folder, pictures);
  expectOneLine(outcome, 2, "a.mp4: needs ffmpeg");
  EXPECT_EQ(outcome.out, "pictures: 3 in pictures\n");
  EXPECT_EQ(below(folder, "pictures").size(), 3u);
}

TEST(Render, FfmpegThatFailsIsQuoted) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  folder.write("ffmpeg", "#!/bin/sh\necho more >&2\necho 'the encoder is on strike' >&2\nexit 1\n");
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  const std::string path = "PATH=" + folder.path().string() + ":/bin";
  const Outcome outcome = runTool(folder, {"env", path, fissureProgram(), "render", "r.h5", "--video",
                                           "a.mp4", "-o", "pictures", "--size", "64x48"});
  expectOneLine(outcome, 3, "a.mp4: ffmpeg: the encoder is on strike\n");
  EXPECT_EQ(folder.names(), (Names{"ffmpeg", "pictures", "r.h5", "s.yaml"}));
  EXPECT_EQ(below(folder, "pictures").size(), 3u);
}

TEST(Render, RefusesBadInput) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  run(folder, pressScenario("[{pipeline: fukuhara}]", "0.005"), "bare.h5");
  folder.write("text.h5", "no result\n");
  folder.write("cut.h5", folder.read("r.h5").substr(0, 30000));
  fs::create_directory(folder / "taken");
  folder.write("taken/press_0.010s.png", "mine");
  folder.write("old.mp4", "mine");
  const std::vector<std::pair<Words, std::string>> cases = {
      {{"none.h5", "-o", "d"}, "none.h5: no such file"},
      {{"text.h5", "-o", "d"}, "text.h5: not an HDF5 file, expected a fissure result"},
      {{"cut.h5", "-o", "d"}, "cut.h5: a damaged or truncated HDF5 file"},
      {{".", "-o", "d"}, ".: is a folder"},
      {{"bare.h5", "-o", "d"},
       "bare.h5: run fukuhara holds no snapshots to draw, expected a scenario with record: {snap"},
      {{"r.h5"}, "expected -o DIR for pictures, --video FILE, or both"},
      {{"r.h5:fukuhra", "-o", "d"}, "r.h5: has no run \"fukuhra\", did you mean \"fukuhara\"?"},
      {{"r.h5", "--pipeline", "raycst", "-o", "d"}, "did you mean \"raycast\"?"},
      {{"r.h5", "-o", "d", "--from", "0.5"}, "no snapshot in this range, expected times from 0 to 0.02 s"},
      {{"r.h5", "-o", "d", "--at", "0.01,1"}, "no snapshot near 1 s"},
      {{"r.h5", "-o", "d", "--at", "0.01", "--from", "0"}, "excludes"},
      {{"r.h5", "-o", "d", "--every", "0"}, "--every"},
      {{"r.h5", "-o", "d", "--every", "nan"}, "--every"},
      {{"r.h5", "-o", "d", "--size", "0x0"}, "size_px is 0, expected a number from 16 to 4096"},
      {{"r.h5", "-o", "d", "--size", "64x5000"}, "size_px is 5000"},
      {{"r.h5", "-o", "d", "--size", "64"},
       "--size: \"64\", expected width and height in pixels, as in 640x480"},
      {{"r.h5", "-o", "d", "--up", "0,0,0"}, "camera.up is zero or along the view"},
      {{"r.h5", "-o", "d", "--field-of-view", "0"}, "--field-of-view"},
      {{"r.h5", "-o", "d", "--columns", "0"}, "--columns"},
      {{"r.h5", "-o", "taken"}, "taken/press_0.010s.png: exists already, expected a new name or --force"},
      {{"r.h5", "-o", "r.h5"}, "r.h5: cannot make this folder"},
      {{"r.h5", "--video", "old.mp4"}, "old.mp4: exists already"},
      {{"r.h5", "--video", "/dev/full"}, "expected a name that ends in .mp4, .webm or .gif"},
      {{"r.h5", "--video", "a.avi"}, "expected a name that ends in .mp4, .webm or .gif"},
      {{"r.h5", "--video", "a.gif", "--fps", "60"}, "at most 50 in a gif"},
      {{"r.h5", "--video", "a.mp4", "--slow-motion", "1000000"}, "expected at most 100000"},
      {{"r.h5", "--video", "a.mp4", "--separate"}, "excludes"}};
  const Names before = folder.names();
  for (const auto& [words, fragment] : cases) {
    const Outcome outcome = render(folder, words);
    expectOneLine(outcome, 2, fragment);
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(folder.names(), before);
  EXPECT_EQ(folder.read("taken/press_0.010s.png"), "mine");
  EXPECT_EQ(render(folder, {"r.h5", "-o", "taken", "--force", "--size", "64x48"}).code, 0);
  EXPECT_NE(folder.read("taken/press_0.010s.png"), "mine");
}

TEST(Render, DoesNotWriteOverWhatItReads) {
  const Folder folder;
  run(folder, press_scenario, "r.mp4");
  expectOneLine(render(folder, {"r.mp4", "--video", "r.mp4", "--force"}), 2,
                "r.mp4: is the result itself, expected another name");
}

TEST(Render, RefusesWhatOthersWrote) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  for (const auto& [change, fragment] : std::vector<std::pair<std::string, std::string>>{
           {"f.attrs['format_version'] = 99",
            "format_version 99, expected at most 1: written by a newer fissure"},
           {"f.attrs['complete'] = 0", "not complete, expected a finished result"},
           {"f['pipelines/raycast/node_state'][1, 3] = 9", "damaged: node_state holds no states of nodes"},
           {"f['pipelines/raycast/faces'][1, 1] = 1000", "damaged: faces name no vertices of their body"},
           {"f['pipelines/raycast/snapshot_time'][1] = 0.0105", "damaged: a snapshot is of no recorded step"},
           {"del f['pipelines/raycast/tool_quaternion']", "damaged: there is no tool_quaternion"},
           {"del f['pipelines/raycast/tools/spatula/faces']", "damaged: there is no tools/spatula/faces"}}) {
    fs::copy_file(folder / "r.h5", folder / "x.h5", fs::copy_options::overwrite_existing);
    const Outcome changed =
        runTool(folder, {"/usr/bin/python3", "-c", "import h5py\nf = h5py.File('x.h5', 'r+')\n" + change});
    ASSERT_EQ(changed.code, 0) << changed.err;
    expectOneLine(render(folder, {"x.h5", "-o", "d"}), 2, "x.h5: " + fragment);
  }
  EXPECT_FALSE(fs::exists(folder / "d"));
}

// A run that ended early says so side by side, and alone has no later pictures.
TEST(Render, ARunThatEndedEarlyHidesNoOther) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  const Outcome changed =
      runTool(folder, {"/usr/bin/python3", "-c",
                       "import h5py\n"
                       "run = h5py.File('r.h5', 'r+')['pipelines/raycast']\n"
                       "run.attrs['status'] = 'non_finite'\n"
                       "for name in ['snapshot_time', 'positions', 'vertex_contact', 'node_state']:\n"
                       "    run[name].resize(2, axis=0)\n"});
  ASSERT_EQ(changed.code, 0) << changed.err;
  ASSERT_EQ(render(folder, {"r.h5", "-o", "d", "--separate", "--from", "0.005", "--size", "64x48"}).code, 0);
  EXPECT_EQ(below(folder, "d"), (Names{"fukuhara_0.010s.png", "fukuhara_0.020s.png", "raycast_0.010s.png"}));
  EXPECT_EQ(render(folder, {"r.h5", "-o", "e", "--size", "64x48"}).out, "pictures: 3 in e\n");
  expectOneLine(render(folder, {"r.h5:raycast", "-o", "f", "--from", "0.015"}), 2, "times from 0 to 0.01 s");
}

// HDF5 1.10 alone crashes on some, or never ends.
TEST(Render, DamagedResultsAreDrawnOrOneLine) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  const std::string whole = folder.read("r.h5");
  std::mt19937 random(5);
  int refused = 0;
  for (int i = 0; i < 12; ++i) {
    std::string damaged = whole;
    damaged.replace(random() % (damaged.size() - 64), 64, 64, i % 2 == 0 ? '\xff' : '\0');
    folder.write("x.h5", damaged);
    const Outcome outcome = render(folder, {"x.h5", "-o", "d", "--size", "32x24", "--force"});
    EXPECT_TRUE(outcome.code == 0 || (outcome.code == 2 && isOneLine(outcome.err)))
        << i << ": exit " << outcome.code << ", signal " << outcome.signal << ", " << outcome.err;
    refused += outcome.code != 0;
  }
  EXPECT_GT(refused, 3) << "the damage did not bite";
}

TEST(Render, FullDisksLeaveNoPartOfAFile) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  for (const std::string kind : {"mp4", "webm", "gif"}) {
    const Words words = {fissureProgram(), "render", "r.h5", "--video", "a." + kind, "--slow-motion", "30"};
    const Outcome outcome = Program(folder, words, {.file_bytes = 3000, .error_is_terminal = false}).wait();
    expectOneLine(outcome, 3, "a." + kind + ": ffmpeg: ");
  }
  const Words words = {fissureProgram(), "render", "r.h5", "-o", "d"};
  const Outcome outcome = Program(folder, words, {.file_bytes = 3000, .error_is_terminal = false}).wait();
  expectOneLine(outcome, 3, "d/press_0.000s.png: cannot write: File too large");
  EXPECT_TRUE(fs::is_empty(folder / "d"));
  fs::remove(folder / "d");
  EXPECT_EQ(folder.names(), (Names{"r.h5", "s.yaml"}));
}

TEST(Render, StoppedItLeavesNoVideo) {
  const Folder folder;
  run(folder, press_scenario, "r.h5");
  folder.write("ffmpeg", "#!/bin/sh\ntouch started\nexec sleep 1000\n");  // reads nothing
  fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
  const std::string path = "PATH=" + folder.path().string() + ":/bin";
  Program program(folder, {"env", path, fissureProgram(), "render", "r.h5", "--video", "a.mp4"});
  while (!fs::exists(folder / "started") && !endsSoon(program.process(), 0.005)) {
  }
  program.send(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(folder.names(), (Names{"ffmpeg", "r.h5", "s.yaml", "started"}));
}

/// Libraries that the loader has found for `fissure WORDS...`, those loaded later too.
std::string librariesOf(const Folder& folder, Words words) {
  words.insert(words.begin(), {"env", "LD_DEBUG=files", fissureProgram()});
  return runTool(folder, words).err;
}

TEST(Render, OnlyItLoadsTheRenderer) {
  const Folder folder;
  run(folder, clamp_scenario, "r.h5");
  for (const Words& words : std::vector<Words>{{"info", "r.h5"},
                                               {"compare", "r.h5", "r.h5"},
                                               {"plan", "s.yaml"},
                                               {"validate", "s.yaml"},
                                               {"list"},
                                               {"salvage", "r.h5"},
                                               {"render", "r.h5", "-o", "d", "--from", "1"},
                                               {"run", "s.yaml", "-o", "new.h5", "--no-frames"}}) {
    const std::string loaded = librariesOf(folder, words);
    EXPECT_NE(loaded.find("libyaml-cpp"), std::string::npos) << words[0];
#ifndef __SANITIZE_ADDRESS__  // with them HDF5 is a shared library
    EXPECT_EQ(loaded.find("libcurl"), std::string::npos) << words[0] << ": what HDF5 has for clouds";
#endif
    EXPECT_EQ(loaded.find("OSMesa"), std::string::npos) << words[0];
  }
  EXPECT_NE(librariesOf(folder, {"render", "r.h5", "-o", "d", "--at", "0"}).find("OSMesa"), std::string::npos)
      << "the comparison above would find it";
}

}  // namespace
}  // namespace fissure::programs::render_test
