#include "scenario/tissues.h"

#include <cmath>
#include <cstdio>

#include "scenario_text.h"

namespace fissure::tissues_test {

namespace {

Scenario with(const std::string& law) {
  return parseScenario(std::string(smallest_text) + "force: [" + law + "]\n", "s.yaml").scenario;
}

// What `list` says is what a scenario gets: the description of each tissue starts with its numbers.
TEST(Tissues, AreThoseOfTheCatalogWithTheirNumbers) {
  const auto& entries = catalog().tissues;
  ASSERT_EQ(tissues().size(), entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Tissue& tissue = tissues()[i];
    EXPECT_EQ(tissue.name, entries[i].name);
    double k = 0, n = 0, offset_N = 0;
    ASSERT_EQ(std::sscanf(std::string(entries[i].description).c_str(), "k %lf, n %lf, F0 %lf N to ", &k, &n,
                          &offset_N),
              3);
    EXPECT_EQ(tissue.k, k);
    EXPECT_EQ(tissue.n, n);
  }
}

// F = k d^n + F0 at 2 mm against the medians that were measured there, within their quartiles (newtons).
TEST(Tissues, GiveTheForceThatWasMeasuredOnAProbe) {
  struct Measured {
    std::string_view name;
    double offset_N, low_N, high_N;
  };
  for (const Measured& measured :
       {Measured{"pig_liver_1", 0.029, 0.186, 0.309}, Measured{"pig_liver_2", 0.060, 0.194, 0.356},
        Measured{"pig_liver_3", 0.072, 0.326, 0.532}, Measured{"meat_4", 0.039, 0.179, 0.286},
        Measured{"phantom_silicone", 0.119, 0.953, 1.124}}) {
    ForceSettings law{.model = ForceModel::hunt_crossley, .tissue = std::string(measured.name)};
    applyTissue(law);
    const double force_N = law.coefficients.k * std::pow(0.002, law.coefficients.n) + measured.offset_N;
    EXPECT_GE(force_N, measured.low_N) << measured.name;
    EXPECT_LE(force_N, measured.high_N) << measured.name;
  }
}

TEST(Tissues, FillWhatTheFileLeavesOutAndNothingElse) {
  const ForceSettings filled = with("{model: hunt_crossley, tissue: pig_liver_1}").force[0];
  EXPECT_EQ(filled.coefficients.k, 6.08e5);
  EXPECT_EQ(filled.coefficients.n, 2.4);
  EXPECT_EQ(filled.coefficients.lambda, 0.5 * 6.08e5);
  const ForceSettings own = with("{n: 1.5, model: hunt_crossley, lambda: 7, tissue: pig_liver_1}").force[0];
  EXPECT_EQ(own.coefficients.k, 6.08e5);
  EXPECT_EQ(own.coefficients.n, 1.5);
  EXPECT_EQ(own.coefficients.lambda, 7);
  EXPECT_EQ(with("{model: hunt_crossley}").force[0].coefficients.k, 200) << "the law's own default";
}

TEST(Tissues, AreMarkedWhereTheSizeOfTheForceIsThatOfAWholeProbe) {
  EXPECT_TRUE(isOfWholeProbe(with("{model: hunt_crossley, tissue: pig_liver_1}").force[0]));
  EXPECT_TRUE(isOfWholeProbe(with("{model: hunt_crossley, tissue: pig_liver_1, n: 1.5}").force[0]));
  EXPECT_FALSE(isOfWholeProbe(with("{model: hunt_crossley, tissue: pig_liver_1, k: 3}").force[0]));
  EXPECT_FALSE(isOfWholeProbe(with("{model: hunt_crossley, k: 6.08e5}").force[0]));
}

// The resolved scenario has the numbers and the name, and reads back to the same, its own numbers included.
TEST(Tissues, AreStoredWithTheNumbersThatWereUsed) {
  const std::string text =
      std::string(smallest_text) + "force: [{model: hunt_crossley, tissue: meat_1, k: 3}]\n";
  const LoadedScenario loaded = parseScenario(text, "s.yaml");
  for (const char* line : {"tissue: meat_1", "k: 3\n", "n: 2.15\n", "lambda: 56500\n"})
    EXPECT_NE(loaded.resolved.find(line), std::string::npos) << line << loaded.resolved;
  EXPECT_EQ(parseScenario(loaded.resolved, "r.yaml").scenario, loaded.scenario);
}

TEST(Tissues, AreForHuntCrossleyWithoutPerAreaAlone) {
  for (const char* law : {"{model: linear_elastic, tissue: meat_1}", "{model: kelvin_voigt, tissue: meat_1}",
                          "{model: hunt_crossley, tissue: meat_1, per_area: true, k: 1, lambda: 1}"})
    EXPECT_NE(inputError([&] { with(law); }).find("tissue"), std::string::npos) << law;
  EXPECT_NE(inputError([&] { with("{model: hunt_crossley, tissue: pig_liver}"); }).find("pig_liver_1"),
            std::string::npos);
  Scenario made = smallest();
  made.force = {{.name = "hc", .model = ForceModel::linear_elastic, .tissue = "meat_1"}};
  ASSERT_EQ(validate(made).size(), 1u);
  made.force = {{.name = "hc", .model = ForceModel::hunt_crossley, .tissue = "meat_9"}};
  ASSERT_EQ(validate(made).size(), 1u);
  EXPECT_EQ(validate(made)[0].path, "force.hc.tissue");
}

}  // namespace
}  // namespace fissure::tissues_test
