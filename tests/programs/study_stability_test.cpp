// Studies of stability, from outside: which maps run, and what is refused.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::study_stability_test {
namespace {

/// Two maps of one row each: over meshes of 8 and 512 triangles, on which the default law's force is 4 and 10
/// N, the one within the limit and the other not, and over the weight of the tissue.
const std::string study_text =
    "format: 1\n"
    "name: maps\n"
    "base: press.yaml\n"
    "press: {steps: 50}\n"
    "criteria: {force_N: 6, depth_m: 1, depth_of_thickness: 1e6, proved: false}\n"
    "maps:\n"
    "  - {name: mesh, axes: [{path: bodies.sphere.shape.subdivisions, linear: {from: 0, to: 3, count: 2}}]}\n"
    "  - {name: weight, axes: [{path: bodies.sphere.mass_kg, values: [0.1, 1]}]}\n";

class Stability : public testing::Test {
 protected:
  Stability() {
    folder_.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03"));
    folder_.write("study.yaml", study_text);
  }

  Outcome study(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"study", "stability", "study.yaml"};
    words.insert(words.end(), more.begin(), more.end());
    return runFissure(folder_, words);
  }

  nlohmann::json panels() const {
    return nlohmann::json::parse(folder_.read("out/maps/study.json"))["panels"];
  }

  Folder folder_;
};

TEST_F(Stability, AMapByItselfIsPartOfTheWholeStudyLater) {
  const Outcome one = study({"--map", "weight"});
  ASSERT_EQ(one.code, 0) << one.err;
  ASSERT_EQ(panels().size(), 1u);
  const nlohmann::json weight = panels()[0];
  EXPECT_EQ(weight["map"], "weight");
  const Outcome all = study({});
  ASSERT_EQ(all.code, 0) << all.err;
  ASSERT_EQ(panels().size(), 2u);
  EXPECT_EQ(panels()[1], weight);  // its times of the clock too: nothing of it has run again
}

TEST_F(Stability, AMapThatIsNotThereIsNamed) {
  const Outcome none = study({"--map", "wieght"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("study.yaml: has no map \"wieght\", did you mean \"weight\"?"), std::string::npos)
      << none.err;
}

// There is no mesh of one and a half subdivisions.
TEST_F(Stability, WholeNumbersAreHalvedToWholeNumbers) {
  folder_.write("press.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03",
                                            "force: [{name: hc, model: hunt_crossley}]\n"));
  const Outcome outcome = study({"--map", "mesh"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::vector<std::string> values;
  const nlohmann::json all = panels();
  for (const auto& cell : all[0]["cells"]) values.push_back(cell["values"][0]);
  EXPECT_GT(values.size(), 2u) << "nothing was halved";
  for (const std::string& value : values) EXPECT_EQ(value.find('.'), std::string::npos) << value;
}

}  // namespace
}  // namespace fissure::programs::study_stability_test
