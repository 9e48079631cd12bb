// Every force law of the table as a key of a scenario.
#include <gtest/gtest.h>

#include <string>

#include "scenario/load.h"
#include "scenario_text.h"

namespace fissure::force_laws_test {

namespace {

Scenario with(const std::string& law) {
  return parseScenario(std::string(smallest_text) + "force: [" + law + "]\n", "a.yaml").scenario;
}

std::string refusalOf(const std::string& law) {
  const std::string error = inputError([&] { with(law); });
  return error == "nothing" ? "" : error;
}

TEST(ForceLaws, AreReadWrittenAndReadAgain) {
  for (const ForceLawEntry& law : forceLaws()) {
    SCOPED_TRACE(law.name);
    const std::string name(law.name);
    const ForceSettings plain = with("{model: " + name + "}").force[0];
    EXPECT_EQ(plain.name, name);
    EXPECT_EQ(plain.coefficients, law.defaults());
    std::string text = "{model: " + name, area = "{per_area: true, model: " + name;
    double value = 3;
    LawCoefficients expected;
    for (const LawCoefficient& of : law.coefficients) {
      text.append(", ").append(of.name).append(": ").append(std::to_string(++value));
      expected.*of.member = value;
      if (of.role != CoefficientRole::shape) {
        EXPECT_NE(refusalOf(area + "}"), "") << "without " << of.name;
        area.append(", ").append(of.name).append(": 2");
      }
      EXPECT_NE(refusalOf("{model: " + name + ", " + std::string(of.name) + ": -1}"), "") << of.name;
    }
    const Scenario read = with(text + "}");
    EXPECT_EQ(read.force[0].coefficients, expected);
    EXPECT_EQ(parseStoredScenario(toYaml(read), "result.h5").scenario.force, read.force);
    EXPECT_EQ(refusalOf(area + "}"), "");
  }
}

TEST(ForceLaws, RefuseCoefficientsOfOthers) {
  for (const ForceLawEntry& law : forceLaws()) {
    for (const CoefficientName& of : allCoefficients()) {
      const std::string refusal =
          refusalOf("{model: " + std::string(law.name) + ", " + std::string(of.name) + ": 2}");
      EXPECT_EQ(refusal.empty(), law.find(of.name) != nullptr) << law.name << " " << of.name << refusal;
      if (!refusal.empty()) {
        EXPECT_NE(refusal.find(modelsWith(of.name)), std::string::npos) << refusal;
      }
    }
  }
}

TEST(ForceLaws, NamesOutsideTheTablesAreRefused) {
  EXPECT_NE(refusalOf("{model: hertz}").find("hunt_crossley"), std::string::npos);
  EXPECT_NE(refusalOf("{model: hunt_crossley, rate: speed}").find("velocities"), std::string::npos);
  EXPECT_NE(refusalOf("{model: hunt_crossley, deformation: rigid}").find("corotated"), std::string::npos);
}

}  // namespace
}  // namespace fissure::force_laws_test
