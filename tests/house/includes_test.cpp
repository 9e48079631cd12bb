// Rooms point one way, and each third-party library lives in one of them: read from the include lines
// themselves.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {}},
    {"scenario", {"base"}},
    {"motion", {"base", "scenario"}},
    {"mesh", {"base", "scenario"}},
    {"contact", {"base"}},
    {"engine", {"base", "scenario", "motion", "mesh", "contact"}},
    {"run", {"base", "scenario", "motion", "mesh", "contact", "engine"}},
    {"measure", {"base", "scenario", "mesh"}},
    {"render", {"base", "scenario", "mesh"}},
    {"store", {"base", "scenario"}},
    {"process", {"base", "scenario"}},
    {"study", {"base", "scenario", "contact", "measure", "store", "process"}},
    {"compare", {"base", "scenario", "store"}},
    {"picture", {"base", "scenario", "render", "store", "process"}},
    {"report", {"base", "scenario", "measure", "store", "compare"}},
    {"main",
     {"base", "scenario", "motion", "mesh", "contact", "engine", "run", "measure", "render", "store",
      "process", "compare", "picture", "report", "study"}},
};

struct Confined {
  std::regex include;
  std::vector<std::string> where;  ///< prefixes of the only paths below src/ that may have it
};

struct Include {
  std::string file;  ///< below src/
  std::string target;
};

std::vector<Include> includesOf(const fs::path& source_tree) {
  static const std::regex line_pattern("^\\s*#include\\s*[<\"]([^>\"]+)[>\"].*");
  std::vector<Include> includes;
  for (const auto& entry : fs::recursive_directory_iterator(source_tree)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream stream(entry.path());
    std::string line;
    std::smatch match;
    while (std::getline(stream, line)) {
      if (std::regex_match(line, match, line_pattern)) {
        includes.push_back({fs::relative(entry.path(), source_tree).string(), match[1]});
      }
    }
  }
  return includes;
}

std::string roomOf(const std::string& path) {
  return path.substr(0, path.find('/'));
}

const fs::path kSource = fs::path(FISSURE_SOURCE_DIR) / "src";

TEST(House, EveryRoomIsInTheTable) {
  for (const auto& entry : fs::directory_iterator(kSource)) {
    EXPECT_TRUE(kMayInclude.contains(entry.path().filename().string())) << entry.path();
  }
}

TEST(House, RoomsIncludeEachOtherOneWayOnly) {
  int between_rooms = 0;
  for (const Include& include : includesOf(kSource)) {
    const std::string from = roomOf(include.file), to = roomOf(include.target);
    if (!kMayInclude.contains(to) || from == to) continue;
    ++between_rooms;
    EXPECT_TRUE(kMayInclude.at(from).contains(to)) << include.file << " includes " << include.target;
  }
  EXPECT_GT(between_rooms, 100) << "the include lines were not understood";
}

TEST(House, EachLibraryLivesInOneRoom) {
  const std::vector<Confined> confined = {
      {std::regex("(Bullet|LinearMath|bt[A-Z]).*"), {"engine/"}},
      {std::regex("(hdf5|H5).*"), {"store/"}},
      {std::regex("yaml-cpp/.*"), {"scenario/yaml_document.cpp"}},
      {std::regex("GL/.*"), {"render/"}},
      {std::regex("assimp/.*"), {"mesh/file_mesh.cpp"}},
      {std::regex("png.h"), {"picture/picture_file.cpp"}},
      {std::regex("boost/random/.*"), {"study/sweep_points.cpp"}},
      {std::regex("boost/math/.*"), {"study/fit_intervals.cpp"}},
      {std::regex("unsupported/Eigen/.*"), {"study/least_squares.cpp"}},
      {std::regex("CLI/.*"), {"main/"}},
      {std::regex("nlohmann/.*"), {"main/", "report/", "study/"}},
      {std::regex("webp/.*"), {"report/webp.cpp"}},
  };
  std::set<const Confined*> seen;
  for (const Include& include : includesOf(kSource)) {
    for (const Confined& library : confined) {
      if (!std::regex_match(include.target, library.include)) continue;
      const auto holds = [&](const std::string& where) { return include.file.starts_with(where); };
      EXPECT_TRUE(std::any_of(library.where.begin(), library.where.end(), holds))
          << include.file << " includes " << include.target;
      seen.insert(&library);
    }
  }
  EXPECT_EQ(seen.size(), confined.size()) << "a library was not found where it should be";
}

TEST(House, TheFrontKnowsNoEngine) {
  for (const Include& include : includesOf(kSource)) {
    if (roomOf(include.file) != "main" || include.file == "main/engine.cpp") continue;
    const std::string room = roomOf(include.target);
    EXPECT_TRUE(room != "engine" && include.target != "run/run.h")
        << include.file << " includes " << include.target;
  }
}

}  // namespace
