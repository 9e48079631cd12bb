// Files of a size that no scenario has: refused in one line, or read in a time that grows as they do.
#include "allocations.h"
#include "scenario/compose.h"
#include "scenario/yaml_document.h"
#include "scenario_text.h"

namespace fissure::size_test {

namespace {

/// "a0: 1" to "a<count-1>: 1", one a line.
std::string manyKeys(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "a" + std::to_string(i) + ": 1\n";
  return text;
}

TEST(Sizes, KeysOfAMap) {
  const Origin first = inFile("a.yaml", 1);
  EXPECT_EQ(parseYaml(manyKeys(10000), first).children.size(), 10000u);
  EXPECT_EQ(inputError([&] { parseYaml(manyKeys(10001), first); }),
            "a.yaml:10001: more than 10000 keys in one map, expected fewer");
  EXPECT_EQ(inputError([&] { parseYaml(manyKeys(9000) + "a123: 2\n", first); }),
            "a.yaml:9001: duplicate key \"a123\", first written in line 124, expected it once");
}

/// A list of `count` maps, each with a name too long to be copied without an allocation.
YamlNode namedItems(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += "- {name: a_name_of_more_than_sixteen_bytes_" + std::to_string(i) + ", mass_kg: 1}\n";
  return parseYaml(text, inFile("a.yaml", 1));
}

/// Allocations of merging a list of `count` named items over one of the same names. Each comparison of two
/// names makes some.
long long workOfMerging(int count) {
  YamlNode base = namedItems(count), top = namedItems(count);
  const long long before = bench::allocations();
  const YamlNode merged = merge(std::move(base), std::move(top));
  EXPECT_EQ(merged.children.size(), static_cast<std::size_t>(count));
  return bench::allocations() - before;
}

TEST(Sizes, MergingNamedItemsGrowsAsTheirNumber) {
  const double small = static_cast<double>(workOfMerging(200)),
               large = static_cast<double>(workOfMerging(2000));
  EXPECT_GT(large, 8 * small);
  EXPECT_LT(large, 12 * small);
}

class SizeFiles : public ScenarioFiles {
 protected:
  std::string errorOf(const std::string& text, const std::vector<Override>& overrides = {}) const {
    const std::filesystem::path file = write("a.yaml", text);
    const std::string message = inputError([&] { loadScenario(file, overrides); });
    const std::string where = file.string() + ":";
    return message.rfind(where, 0) == 0 ? message.substr(where.size()) : message;
  }
};

TEST_F(SizeFiles, OfAFile) {
  const std::string long_text =
      std::string(smallest_text) + "description: " + std::string(std::size_t{4} << 20, 'x');
  EXPECT_EQ(errorOf(long_text), " is larger than 4 MiB, expected a text file of at most 4 MiB");
  write("base.yaml", long_text);
  EXPECT_NE(errorOf("base: base.yaml\n").find("is larger than 4 MiB"), std::string::npos);
}

TEST_F(SizeFiles, OfAList) {
  const auto bodies = [](int count) {
    std::string text =
        "format: 1\nname: many\ntime: {duration_s: 1}\npipelines: [{pipeline: default}]\nbodies:\n";
    for (int i = 0; i < count; ++i)
      text += "  - {name: b" + std::to_string(i) + ", shape: {type: box, size_m: [1, 1, 1]}}\n";
    return text;
  };
  EXPECT_EQ(errorOf(bodies(1000)), "nothing");
  EXPECT_EQ(errorOf(bodies(1001)), "5: bodies has 1001 items, expected at most 1000");
}

TEST_F(SizeFiles, OfAnOverridesPath) {
  const auto path = [](int names, const std::string& name) {
    std::string text = name;
    for (int i = 1; i < names; ++i) text += "." + name;
    return text;
  };
  EXPECT_EQ(errorOf(smallest_text, {{path(64, "a"), "1"}}).rfind("--set a.a.a", 0), 0u);
  EXPECT_NE(errorOf(smallest_text, {{path(64, "a"), "1"}}).find("unknown key \"a\""), std::string::npos);
  EXPECT_EQ(errorOf(smallest_text, {{path(65, "a"), "1"}}),
            "--set a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a....: a path of 65 names in 129 bytes, expected at "
            "most 64 "
            "names in 1000");
  EXPECT_NE(
      errorOf(smallest_text, {{path(2, std::string(600, 'a')), "1"}}).find("a path of 2 names in 1201 bytes"),
      std::string::npos);
}

}  // namespace
}  // namespace fissure::size_test
