#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "law/force_law.h"

namespace fissure::law_table_test {

namespace {

double sizeOf(const ForceLawEntry& law, const LawCoefficients& coefficients, CoefficientRole role) {
  const LawCoefficient* coefficient = law.find(role);
  return coefficient ? coefficients.*coefficient->member : 0;
}

TEST(LawTable, EachLawSaysEverythingAboutItself) {
  std::set<std::string_view> names;
  for (const ForceLawEntry& law : forceLaws()) {
    SCOPED_TRACE(law.name);
    EXPECT_TRUE(names.insert(law.name).second) << "the name twice";
    EXPECT_TRUE(law.description.starts_with("F = ")) << law.description;
    EXPECT_TRUE(law.fit_formula.starts_with("F = F0 + ")) << law.fit_formula;
    EXPECT_EQ(&entryOf(*modelNamed(law.name)), &law) << "enum and table have different orders";
    ASSERT_NE(law.find(CoefficientRole::elastic), nullptr);
    EXPECT_EQ(law.find(CoefficientRole::elastic)->member, &LawCoefficients::k) << "fits search k";
    EXPECT_EQ(law.find(CoefficientRole::shape) != nullptr, law.shape_search.largest > 0);
    for (const LawCoefficient& of : law.coefficients) {
      EXPECT_GT(law.defaults().*of.member, 0) << of.name;
      EXPECT_NE(of.unit, "") << of.name;
      EXPECT_EQ(of.units.empty(), of.unit == "1") << of.name;
      EXPECT_EQ(of.units.empty(), of.units_per_area.empty()) << of.name;
      EXPECT_EQ(law.find(of.name), &of) << "the name twice";
      for (const CoefficientName& other : allCoefficients())
        if (other.name == of.name) {
          EXPECT_EQ(other.member, of.member) << of.name << " means two things";
        }
    }
  }
  EXPECT_EQ(modelNamed("hertz"), std::nullopt);
}

// F = k x elastic term + damping x damping term, in two writings.
TEST(LawTable, TermsAndForceAgree) {
  for (std::size_t i = 0; i < forceLaws().size(); ++i) {
    const ForceLawEntry& law = forceLaws()[i];
    SCOPED_TRACE(law.name);
    const LawCoefficients of = law.defaults();
    const ForceLaw made(static_cast<ForceModel>(i), of);
    for (const double x_m : {1e-6, 1e-3, 0.02}) {
      for (const double rate_m_s : {-1e-3, 0.0, 0.4}) {
        const LawTerms terms = law.terms(of, x_m, rate_m_s);
        const LawForce force = made.at(x_m, rate_m_s);
        if (force.adhesion_clamped) continue;
        const double elastic_N = of.k * terms.elastic;
        const double viscous_N = sizeOf(law, of, CoefficientRole::damping) * terms.damping;
        EXPECT_NEAR(force.elastic_N, elastic_N, 1e-14 * elastic_N) << x_m;
        EXPECT_NEAR(force.viscous_N, viscous_N, 1e-14 * std::abs(viscous_N)) << x_m;
        EXPECT_NEAR(terms.damping_over_elastic * terms.elastic, terms.damping,
                    1e-14 * std::abs(terms.damping));
      }
    }
    EXPECT_EQ(made.at(0, 0).elastic_N, 0);
    EXPECT_EQ(made.at(-1e-3, 1).elastic_N + made.at(-1e-3, 1).viscous_N, 0);
    if (!law.find(CoefficientRole::damping)) continue;
    EXPECT_TRUE(made.at(1e-3, -1e6).adhesion_clamped);
    EXPECT_EQ(made.at(1e-3, -1e6).elastic_N + made.at(1e-3, -1e6).viscous_N, 0);
    // A damper of its own acts from the first touch on.
    EXPECT_EQ(made.at(0, 0.1).viscous_N != 0, !law.damping_grows_with_elastic);
  }
}

// Far beyond any tissue exp() overflows: the force is then no number, which a run names with its step.
TEST(LawTable, AnExponentialThatOverflowsIsSeen) {
  EXPECT_TRUE(std::isinf(ForceLaw(ForceModel::exponential, {.k = 1, .a = 1e6}).at(0.01, 0).elastic_N));
  EXPECT_EQ(ForceLaw(ForceModel::exponential, {.k = 0, .a = 1e6}).at(0.01, 0).elastic_N, 0);
  EXPECT_EQ(ForceLaw(ForceModel::exponential, {.k = 0, .c = 2, .a = 1e6}).at(0.01, 0.5).viscous_N, 1);
}

TEST(LawTable, MessagesNameTheLawsOfACoefficient) {
  EXPECT_EQ(modelsWith("lambda"), "model hunt_crossley");
  EXPECT_NE(modelsWith(CoefficientRole::damping).find("hunt_crossley"), std::string::npos);
  EXPECT_EQ(modelsWith(CoefficientRole::damping).find("linear_elastic"), std::string::npos);
}

}  // namespace
}  // namespace fissure::law_table_test
