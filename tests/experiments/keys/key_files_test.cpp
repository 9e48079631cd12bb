#include "keys/key_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "base/error.h"
#include "keys/key_text.h"
#include "law/force_law.h"

namespace fissure::key_files_test {

namespace {

std::vector<std::string> pathsOf(const std::vector<KeyPlace>& keys) {
  std::vector<std::string> paths;
  for (const KeyPlace& key : keys) paths.push_back(key.path);
  return paths;
}

using Paths = std::vector<std::string>;

std::string refusalOf(const std::string& wanted) {
  try {
    findKeys(wanted);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Keys, FilesHaveTheNamesThatTheirTreesSay) {
  std::vector<std::string> names;
  for (const KeyNode& file : keyFiles()) names.push_back(file.name);
  EXPECT_EQ(keyFileNames(), names);
}

// Whoever adds a key says these three, or a number's name says its unit.
TEST(Keys, EachHasADocLineAUnitAndADefault) {
  for (const KeyPlace& key : allKeys()) {
    if (key.node->kind == KeyNode::Kind::alternative) continue;
    EXPECT_TRUE(key.node->doc.size() > 10 && key.node->doc.ends_with(".")) << key.path;
    EXPECT_NE(key.node->unit, "") << key.path << ": say unit(...) or noUnit()";
    EXPECT_NE(key.node->default_text, "") << key.path << ": say required() or otherwise(...)";
  }
  EXPECT_GT(allKeys().size(), 250u);
}

TEST(Keys, NoPathIsThereTwice) {
  std::set<std::string> seen;
  for (const KeyPlace& key : allKeys()) EXPECT_TRUE(seen.insert(key.path).second) << key.path;
}

TEST(Keys, AreFoundByPathByTheirEndAndByName) {
  EXPECT_EQ(pathsOf(findKeys("bodies.elastic.youngs_modulus_Pa")), Paths{"bodies.elastic.youngs_modulus_Pa"});
  EXPECT_EQ(pathsOf(findKeys("elastic.friction")), Paths{"bodies.elastic.friction"});
  EXPECT_EQ(pathsOf(findKeys("time_limit_s")), Paths{"pipelines.time_limit_s"});
  EXPECT_EQ(pathsOf(findKeys("friction")),
            (Paths{"ground.friction", "bodies.elastic.friction", "tools.friction"}));
  EXPECT_EQ(pathsOf(findKeys("sweep.axes.path")), Paths{"sweep.axes.path"});
  EXPECT_EQ(pathsOf(findKeys("sweep.axes.zip.values")), Paths{"sweep.axes.zip.values"});
  EXPECT_EQ(pathsOf(findKeys("tolerances.tolerances.relative")), Paths{"tolerances.tolerances.relative"});
}

// As messages and --set write them.
TEST(Keys, AreFoundByAPathInAFile) {
  EXPECT_EQ(pathsOf(findKeys("tools.spatula.shape.size_m")),
            (Paths{"tools.shape.box.size_m", "tools.shape.lobes.size_m"}));
  EXPECT_EQ(pathsOf(findKeys("tools.shape.radius_m")),
            (Paths{"tools.shape.sphere.radius_m", "tools.shape.capsule.radius_m"}));
  EXPECT_EQ(pathsOf(findKeys("tools.0.motion.segments.1.speed_m_s")),
            Paths{"tools.motion.script.segments.speed_m_s"});
  EXPECT_EQ(pathsOf(findKeys("tools.spatula.nodes.resolution.0")), Paths{"tools.nodes.resolution"});
}

TEST(Keys, AreFoundByAWordOfWhatIsSaidOfThem) {
  const Paths of_poisson = pathsOf(findKeys("Poisson"));
  EXPECT_NE(std::find(of_poisson.begin(), of_poisson.end(), "bodies.elastic.poissons_ratio"),
            of_poisson.end());
  EXPECT_EQ(pathsOf(findKeys("poisson")), of_poisson);
  EXPECT_EQ(pathsOf(findKeys("youngs_modulus")), pathsOf(findKeys("youngs_modulus_Pa")))
      << "a part of a name";
  EXPECT_EQ(refusalOf("oisson"), "\"oisson\" is no key, expected one that fissure explain names")
      << "no word begins so";
}

TEST(Keys, TheNearestIsNamed) {
  EXPECT_EQ(refusalOf("yongs_modulus"), "\"yongs_modulus\" is no key, did you mean \"youngs_modulus_Pa\"?");
  EXPECT_EQ(
      refusalOf("bodies.elastc.youngs_modulus_Pa"),
      "\"bodies.elastc.youngs_modulus_Pa\" is no key, did you mean \"bodies.elastic.youngs_modulus_Pa\"?");
  EXPECT_EQ(refusalOf("xyzzy_of_nothing"),
            "\"xyzzy_of_nothing\" is no key, expected one that fissure explain names");
  EXPECT_NE(refusalOf(""), "nothing");
}

TEST(Keys, ATextSaysAllThatIsKnown) {
  EXPECT_EQ(textOf(findKeys("bodies.elastic.youngs_modulus_Pa")),
            "bodies.elastic.youngs_modulus_Pa\n"
            "  Young's modulus at small strain.\n"
            "  value     a number above 0, in Pa\n"
            "  default   10000, unless `preset` says another\n"
            "  only for  model elastic\n");
  EXPECT_EQ(textOf(findKeys("bodies.bending_distance")),
            "bodies.bending_distance\n"
            "  Vertices that are this many links apart are joined by bending links; 0 makes\n"
            "  none.\n"
            "  value     0 (no bending links) or 2 to 5\n"
            "  default   2\n"
            "  only for  model shell\n");
  const std::string resolution = textOf(findKeys("tools.nodes.resolution"));
  EXPECT_NE(resolution.find("  value     a list of 2, each a whole number from 1 to 512\n"),
            std::string::npos);
  EXPECT_NE(resolution.find("  default   [8, 8]\n  only for  placement grid\n"), std::string::npos);
  const std::string material = textOf(findKeys("bodies.elastic.material"));
  EXPECT_NE(material.find("\n    neo_hookean "), std::string::npos) << material;
  EXPECT_NE(material.find("  stable neo-Hookean"), std::string::npos) << material;
}

// What a table knows is not written a second time.
TEST(Keys, DefaultsOfTablesAreTheirs) {
  const auto defaultOf = [](const std::string& key) { return findKeys(key).front().node->default_text; };
  EXPECT_EQ(
      defaultOf("force.k"),
      "200 (hunt_crossley, kelvin_voigt, linear_elastic), 0.2 (exponential), unless `tissue` says another; "
      "required with per_area");
  EXPECT_EQ(defaultOf("pipelines.response"), "raycast none, fukuhara momentum");
  EXPECT_EQ(defaultOf("pipelines.deformable.contact_iterations"),
            "stock 150 (neo_hookean) or 100 (linear_corotated), tuned 50");
  for (const CoefficientName& of : allCoefficients())
    EXPECT_EQ(findKeys("force." + std::string(of.name)).front().node->when, modelsWith(of.name));
}

TEST(Keys, TheFileInConfigsIsCurrent) {
  std::ifstream file(FISSURE_SOURCE_DIR "/configs/KEYS.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(text == keysAsMarkdown()) << "build/release/fissure explain --markdown > configs/KEYS.md";
}

}  // namespace

}  // namespace fissure::key_files_test
