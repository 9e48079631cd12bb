// Wings and rooms point one way, each third-party library lives in one place, and files stay short: read from
// the source files themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A folder of rooms. A wing may use those that stand before it in the list.
struct Wing {
  std::string name;
  /// A room, and the other rooms of its own wing that it may use.
  std::map<std::string, std::set<std::string>> rooms;
};

const std::vector<Wing> kWings = {
    {"ground",
     {{"base", {}}, {"files", {"base"}}, {"text", {"base", "files"}}, {"process", {"base", "files"}}}},
    {"simulation",
     {{"law", {}},
      {"scenario", {"law"}},
      {"motion", {"scenario"}},
      {"mesh", {"scenario"}},
      {"volume", {"scenario", "mesh"}},
      {"contact", {"law"}},
      {"elastic", {}},
      {"scene", {"scenario", "motion", "mesh", "volume", "contact"}},
      {"stepping", {"law", "scenario", "contact", "elastic"}},
      {"engine", {"law", "scenario", "motion", "mesh", "contact", "stepping"}},
      {"explicit", {"scenario", "elastic", "stepping"}},
      {"run", {"scenario", "motion", "scene", "stepping", "engine", "explicit"}}}},
    {"results",
     {{"hdf5", {}}, {"store", {"hdf5"}}, {"table", {"hdf5", "store"}}, {"paraview", {"hdf5", "store"}}}},
    {"judgement", {{"surface", {}}, {"measure", {"surface"}}, {"compare", {}}}},
    {"views", {{"render", {}}, {"picture", {"render"}}, {"report", {}}}},
    {"experiments",
     {{"check", {}},
      {"pilot", {}},
      {"task", {}},
      {"fit", {"task"}},
      {"batch", {"check", "pilot"}},
      {"sweep", {"check", "task", "fit", "batch"}},
      {"study", {"check", "task", "batch", "sweep"}},
      {"keys", {"sweep", "study"}},
      {"calibrate", {"check", "fit", "batch", "sweep"}},
      {"slurm", {"batch", "sweep"}}}},
    {"main", {{"main", {}}}},
};

/// Rooms that use less of the wings below than they could.
const std::map<std::string, std::set<std::string>> kNarrow = {
    {"law", {"base", "text"}},
    {"scenario", {"base", "text", "files"}},
    {"motion", {"base", "text"}},
    {"mesh", {"base", "files"}},
    {"volume", {"base", "files", "process"}},
    {"scene", {"base"}},
    {"contact", {"base"}},
    {"elastic", {"base"}},
    {"stepping", {"base"}},
    {"engine", {"base"}},
    {"explicit", {"base"}},
    {"run", {"base"}},
    {"hdf5", {"base", "files"}},
    {"store", {"base", "files", "law", "scenario"}},
    {"table", {"base", "text", "files"}},
    {"paraview", {"base", "files"}},
    {"surface", {"base"}},
    {"measure", {"base", "scenario", "mesh"}},  // the judge shares no code with the judged
    {"compare", {"base", "text", "scenario", "store"}},
    {"render", {"base", "scenario"}},
    {"picture", {"base", "text", "files", "process", "scenario", "store"}},
    {"report", {"base", "text", "files", "scenario", "store", "table", "measure", "compare"}},
    // What a worker does of a sweep knows neither fits nor Slurm nor how results are stored.
    {"pilot", {"base", "text", "files", "scenario", "motion", "scene"}},
    {"task", {"base", "text", "law", "scenario", "measure"}},
    {"fit", {"base", "text", "law", "scenario", "store"}},
};

/// A library's headers, by how their names begin, and the only files that may include them.
struct Confined {
  std::vector<std::string> headers;
  std::vector<std::string> where;  ///< beginnings of paths below src/
};

const std::vector<Confined> kConfined = {
    {{"Bullet", "LinearMath", "bt"}, {"simulation/engine/"}},
    {{"hdf5", "H5"}, {"results/hdf5/", "results/store/", "results/table/", "results/paraview/"}},
    {{"yaml-cpp/"}, {"simulation/scenario/yaml_document.cpp"}},
    {{"sleef.h"}, {"ground/base/reproducible.cpp"}},
    {{"GL/"}, {"views/render/"}},
    {{"assimp/"}, {"simulation/mesh/file_mesh.cpp"}},
    {{"png.h"}, {"views/picture/picture_file.cpp"}},
    {{"boost/random/"}, {"experiments/sweep/sweep_points.cpp"}},
    {{"boost/math/"}, {"experiments/fit/fit_intervals.cpp"}},
    {{"unsupported/Eigen/"}, {"experiments/fit/least_squares.cpp"}},
    {{"CLI/"}, {"main/command.cpp"}},
    // Sources alone: headers take nlohmann/json_fwd.hpp.
    {{"nlohmann/json.hpp"},
     {"experiments/keys/key_schema.cpp",
      "experiments/study/stability_output.cpp",
      "experiments/study/tradeoff_output.cpp",
      "experiments/sweep/sweep_manifest.cpp",
      "experiments/sweep/sweep_why.cpp",
      "experiments/task/task_order.cpp",
      "experiments/task/task_record.cpp",
      "main/comparison_json.cpp",
      "main/fit_modulus.cpp",
      "main/fit_output.cpp",
      "main/fit_ranking.cpp",
      "main/result_json.cpp",
      "main/study_stability.cpp",
      "main/sweep_info.cpp",
      "main/verb_compare.cpp",
      "main/verb_fit.cpp",
      "main/verb_info.cpp",
      "main/verb_report.cpp",
      "main/verb_run.cpp",
      "main/verb_sweep.cpp",
      "views/report/bench_history.cpp",
      "views/report/frames.cpp",
      "views/report/history_page.cpp",
      "views/report/json_map.cpp",
      "views/report/key_numbers.cpp",
      "views/report/packed.cpp",
      "views/report/page.cpp",
      "views/report/page_data.cpp",
      "views/report/plots.cpp",
      "views/report/report_run.cpp",
      "views/report/stability_data.cpp",
      "views/report/step_times.cpp",
      "views/report/study_page.cpp",
      "views/report/sweep_curves.cpp",
      "views/report/sweep_failures.cpp",
      "views/report/sweep_page.cpp",
      "views/report/tradeoff_data.cpp",
      "views/report/warnings.cpp"}},
    {{"webp/"}, {"views/report/webp.cpp"}},
};

struct Include {
  std::string file;  ///< below src/
  std::string target;
};

const fs::path kSource = fs::path(FISSURE_SOURCE_DIR) / "src";

bool beginsWithOne(const std::string& text, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return text.starts_with(beginning); });
}

/// What stands between quotes or angle brackets of an include line; empty for other lines.
std::string includedBy(const std::string& line) {
  const std::size_t hash = line.find_first_not_of(" \t");
  if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) return {};
  const std::size_t begin = line.find_first_of("<\"", hash);
  const std::size_t end = begin == std::string::npos ? begin : line.find_first_of(">\"", begin + 1);
  return end == std::string::npos ? std::string() : line.substr(begin + 1, end - begin - 1);
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kSource))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  return files;
}

std::vector<Include> includes() {
  std::vector<Include> found;
  for (const fs::path& file : sources()) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
      if (const std::string target = includedBy(line); !target.empty())
        found.push_back({fs::relative(file, kSource).generic_string(), target});
  }
  return found;
}

/// "simulation/contact/ray.h" and "main/verbs.h" lie in contact and main.
std::string roomOfFile(const std::string& file) {
  const std::size_t first = file.find('/'), second = file.find('/', first + 1);
  return file.substr(0, first) == "main" ? "main" : file.substr(first + 1, second - first - 1);
}

std::string wingOf(const std::string& room) {
  for (const Wing& wing : kWings)
    if (wing.rooms.contains(room)) return wing.name;
  return {};
}

bool mayUse(const std::string& from, const std::string& to) {
  std::set<std::string> below;
  for (const Wing& wing : kWings) {
    if (const auto room = wing.rooms.find(from); room != wing.rooms.end()) {
      if (const auto narrow = kNarrow.find(from); narrow != kNarrow.end()) below = narrow->second;
      below.insert(room->second.begin(), room->second.end());
      return below.contains(to);
    }
    for (const auto& room : wing.rooms) below.insert(room.first);
  }
  return false;
}

TEST(House, EveryWingAndRoomIsInTheTable) {
  std::set<std::string> known, found;
  for (const Wing& wing : kWings)
    for (const auto& room : wing.rooms)
      known.insert(wing.name == "main" ? "main" : wing.name + "/" + room.first);
  for (const auto& wing : fs::directory_iterator(kSource)) {
    if (!wing.is_directory()) continue;
    if (wing.path().filename() == "main") found.insert("main");
    if (wing.path().filename() == "main") continue;
    for (const auto& room : fs::directory_iterator(wing))
      if (room.is_directory())
        found.insert(wing.path().filename().string() + "/" + room.path().filename().string());
  }
  EXPECT_EQ(found, known);
  EXPECT_LE(kWings.size(), 7u);
}

// Within a wing too: rooms are listed after those that they use, so that no circle can be.
TEST(House, RoomsIncludeEachOtherOneWayOnly) {
  int between_rooms = 0;
  for (const Include& include : includes()) {
    const std::string from = roomOfFile(include.file),
                      to = include.target.substr(0, include.target.find('/'));
    if (wingOf(to).empty() || from == to) continue;
    ++between_rooms;
    EXPECT_TRUE(mayUse(from, to)) << include.file << " includes " << include.target;
  }
  EXPECT_GT(between_rooms, 500) << "the include lines were not understood";
}

TEST(House, RoomsOfAWingFormNoCircle) {
  for (const Wing& wing : kWings) {
    std::set<std::string> placed;
    while (placed.size() < wing.rooms.size()) {
      const std::size_t before = placed.size();
      for (const auto& [room, uses] : wing.rooms)
        if (std::includes(placed.begin(), placed.end(), uses.begin(), uses.end())) placed.insert(room);
      ASSERT_GT(placed.size(), before) << "rooms of " << wing.name << " use each other in a circle";
    }
  }
}

TEST(House, EachLibraryLivesInOnePlace) {
  std::set<const Confined*> seen;
  for (const Include& include : includes()) {
    for (const Confined& library : kConfined) {
      if (!beginsWithOne(include.target, library.headers) || include.target.ends_with("_fwd.hpp")) continue;
      EXPECT_TRUE(beginsWithOne(include.file, library.where))
          << include.file << " includes " << include.target;
      seen.insert(&library);
    }
  }
  EXPECT_EQ(seen.size(), kConfined.size()) << "a library was not found where it should be";
}

TEST(House, TheFrontKnowsNoEngine) {
  for (const Include& include : includes()) {
    if (!include.file.starts_with("main/") || include.file == "main/engine.cpp") continue;
    EXPECT_TRUE(!include.target.starts_with("engine/") && include.target != "run/run.h")
        << include.file << " includes " << include.target;
  }
}

TEST(House, FilesStayShort) {
  std::size_t of_main = 0;
  for (const fs::path& file : sources()) {
    std::ifstream stream(file);
    const auto lines = static_cast<std::size_t>(
        std::count(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>(), '\n'));
    EXPECT_LE(lines, file.extension() == ".h" ? 150u : 400u) << file;
    if (file.parent_path().filename() == "main") of_main += lines;
  }
  EXPECT_GT(of_main, 1000u) << "main/ was not found";
  EXPECT_LE(of_main, 4900u);
}

}  // namespace
