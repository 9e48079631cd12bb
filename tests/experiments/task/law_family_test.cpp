#include "task/law_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "base/error.h"

namespace fissure::law_family_test {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-12;

ForceSettings huntCrossley(double k, double lambda, double n, bool per_area = false) {
  return {.name = "hc",
          .model = ForceModel::hunt_crossley,
          .coefficients = {.k = k, .lambda = lambda, .n = n},
          .per_area = per_area};
}
ForceSettings kelvinVoigt(double k, double c, bool per_area = false) {
  return {.name = "kv",
          .model = ForceModel::kelvin_voigt,
          .coefficients = {.k = k, .c = c},
          .per_area = per_area};
}
ForceSettings linearElastic(double k) {
  return {.name = "le", .model = ForceModel::linear_elastic, .coefficients = {.k = k}};
}

/// A law over all triangles one by one, as contact/triangle_forces does it. `..rounding_N`: what the last
/// bits of its terms may add up to.
struct PlainValue {
  LawValue value;
  double elastic_rounding_N = 0, viscous_rounding_N = 0;
  double rounding_N() const { return elastic_rounding_N + viscous_rounding_N; }
};

PlainValue plainly(const ForceSettings& law, const std::vector<LawInput>& inputs) {
  const ForceLaw made(law.model, law.coefficients);
  PlainValue plain;
  Vec3 sum_N = Vec3::Zero();
  for (const LawInput& input : inputs) {
    const LawForce force = made.at(input.deformation_m, input.rate_m_s);
    const double area = law.per_area ? input.area_m2 : 1;
    plain.value.elastic_N += area * force.elastic_N;
    plain.value.viscous_N += area * force.viscous_N;
    plain.value.adhesion_clamped += force.adhesion_clamped ? 1 : 0;
    sum_N += area * (force.elastic_N + force.viscous_N) * input.direction;
    plain.elastic_rounding_N += kRounding * area * std::abs(force.elastic_N);
    plain.viscous_rounding_N += kRounding * area * std::abs(force.viscous_N);
  }
  plain.value.force_N = sum_N.norm();
  return plain;
}

/// Equal within `rounding`, or both not finite.
bool agree(double found, double expected, double rounding) {
  if (!std::isfinite(found) || !std::isfinite(expected))
    return !std::isfinite(found) && !std::isfinite(expected);
  return std::abs(found - expected) <= rounding;
}

/// Of a scenario with one law.
void expectPlainValues(const std::vector<ForceSettings>& laws, const std::vector<LawInput>& inputs) {
  LawFamily family(laws, {huntCrossley(200, 50, 1.3)});
  family.evaluate(inputs);
  ASSERT_EQ(family.valuesByPlace().size(), laws.size());
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const LawValue found = family.value(i);
    const PlainValue plain = plainly(laws[i], inputs);
    const LawValue& value = plain.value;
    std::string law(entryOf(laws[i].model).name);
    for (const LawCoefficient& of : entryOf(laws[i].model).coefficients)
      law.append(" ").append(of.name).append(" ").append(std::to_string(laws[i].coefficients.*of.member));
    EXPECT_TRUE(agree(found.force_N, value.force_N, plain.rounding_N()))
        << law << ": " << found.force_N << " instead of " << value.force_N;
    EXPECT_TRUE(agree(found.elastic_N, value.elastic_N, plain.elastic_rounding_N))
        << law << ": " << found.elastic_N << " instead of " << value.elastic_N;
    EXPECT_TRUE(agree(found.viscous_N, value.viscous_N, plain.viscous_rounding_N))
        << law << ": " << found.viscous_N << " instead of " << value.viscous_N;
    EXPECT_EQ(found.adhesion_clamped, value.adhesion_clamped) << law;
  }
}

/// Deformations of micrometres to centimetres, rates to 10 m/s of both signs, any directions.
std::vector<LawInput> randomInputs(int triangles, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> size(-6, -2), side(-1, 1);
  std::vector<LawInput> inputs;
  for (int i = 0; i < triangles; ++i) {
    const double rate_m_s = std::pow(10, size(random) + 3) * (side(random) < 0 ? -1 : 1);
    inputs.push_back({std::pow(10, size(random)), rate_m_s, 1e-5 * (1.5 + side(random)),
                      Vec3(side(random), side(random), side(random)) / 2});
  }
  return inputs;
}

/// Of every law of the table: its defaults, and each coefficient 0, small and large in turn.
std::vector<ForceSettings> everyLaw() {
  std::vector<ForceSettings> laws;
  for (std::size_t i = 0; i < forceLaws().size(); ++i) {
    const ForceSettings law{.name = "law", .model = static_cast<ForceModel>(i)};
    for (const bool per_area : {false, true}) {
      laws.push_back(law);
      laws.back().per_area = per_area;
      for (const LawCoefficient& of : forceLaws()[i].coefficients) {
        for (const double factor : {0.0, 1e-3, 3.0}) {
          if (factor == 0 && of.role == CoefficientRole::shape) continue;
          laws.push_back(law);
          laws.back().per_area = per_area;
          laws.back().coefficients.*of.member *= factor;
        }
      }
    }
  }
  return laws;
}

std::vector<ForceSettings> manyLaws() {
  std::vector<ForceSettings> laws = everyLaw();
  for (const double n : {1.0, 1.3, 2.5})
    for (const double k : {0.0, 1e-3, 200.0, 1e7})
      for (const double lambda : {0.0, 0.5, 50.0, 1e6}) {
        laws.push_back(huntCrossley(k, lambda, n, lambda == 0.5));
        laws.push_back(kelvinVoigt(k, lambda, k == 200));
        laws.push_back(linearElastic(k + lambda));
      }
  return laws;
}

TEST(LawFamily, EqualsEachLawTriangleByTriangle) {
  for (const int triangles : {1, 2, 60, 500}) expectPlainValues(manyLaws(), randomInputs(triangles, 7));
  LawFamily family({huntCrossley(200, 50, 1.3)}, {huntCrossley(1, 1, 1)});
  family.evaluate(randomInputs(60, 7));
  EXPECT_GT(family.value(0).adhesion_clamped, 2) << "no triangle pulls, no test";
  EXPECT_LT(family.value(0).adhesion_clamped, 50);
}

TEST(LawFamily, ALawThatOverflowsDoesSoAloneAndAsPlainly) {
  const ForceSettings wild{
      .name = "exp", .model = ForceModel::exponential, .coefficients = {.k = 1, .a = 1e6}};
  const std::vector<LawInput> inputs = randomInputs(60, 7);
  expectPlainValues({wild, huntCrossley(200, 50, 1.3)}, inputs);
  LawFamily family({wild}, {huntCrossley(1, 1, 1)});
  family.evaluate(inputs);
  EXPECT_FALSE(std::isfinite(family.value(0).elastic_N));
}

TEST(LawFamily, AStepWithoutTrianglesGivesZeros) {
  LawFamily family(manyLaws(), {huntCrossley(200, 50, 1.3)});
  family.evaluate(randomInputs(60, 1));
  family.evaluate({});
  for (std::size_t place = 0; place < family.valuesByPlace().size(); ++place) {
    const LawValue value = family.valuesByPlace().at(place);
    EXPECT_EQ(value.force_N, 0);
    EXPECT_EQ(value.elastic_N, 0);
    EXPECT_EQ(value.adhesion_clamped, 0);
  }
}

// Rates at which k x^n + lambda x^n x' is zero but for rounding, and the doubles next to them: whether a
// triangle pulls is then a matter of the last bit, and must be the same one.
TEST(LawFamily, CountsTheSameTrianglesAsPullingRightAtTheEdge) {
  std::vector<ForceSettings> laws;
  std::vector<LawInput> inputs;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> size(0, 1);
  for (int i = 0; i < 40; ++i) {
    const double k = 300 * size(random), lambda = 90 * size(random);
    for (const double n : {1.0, 1.3}) laws.push_back(huntCrossley(k, lambda, n));
    laws.push_back(kelvinVoigt(k, lambda));
    for (int j = 0; j < 10; ++j) {
      const double x_m = 0.01 * size(random);
      for (double rate_m_s : {-k / lambda, -k / lambda * x_m}) {
        rate_m_s = std::nextafter(std::nextafter(rate_m_s, -kInfinity), -kInfinity);
        for (int ulp = -2; ulp <= 2; ++ulp, rate_m_s = std::nextafter(rate_m_s, kInfinity))
          inputs.push_back({x_m, rate_m_s, 1e-5, Vec3(0.6, 0, -0.8)});
      }
    }
  }
  expectPlainValues(laws, inputs);
}

TEST(LawFamily, RestStandstillAndZeroCoefficientsAreTheLawsOwn) {
  std::vector<LawInput> inputs;
  for (const double x_m : {0.0, -0.0, -0.001, 1e-300, 1e-100, 1e-17, 0.002, 1e90})
    for (const double rate_m_s : {0.0, -0.0, 1e-320, -1e-320, -1e-170, -1e-17, -4.0, 0.3, 1e100})
      for (const double area_m2 : {0.0, 1e-5}) inputs.push_back({x_m, rate_m_s, area_m2, Vec3(0, 1, 0)});
  std::vector<ForceSettings> laws = manyLaws();
  for (const double k : {1e-310, 1e-120, 1e120})
    for (const double lambda : {0.0, 1e-310, 1e-120, 1e120}) {
      laws.push_back(huntCrossley(k, lambda, 1.3));
      laws.push_back(kelvinVoigt(k, lambda, true));
    }
  for (const LawInput& input : inputs) expectPlainValues(laws, {input});
  expectPlainValues(laws, inputs);
}

TEST(LawFamily, WhatIsNoNumberStaysSo) {
  const LawInput usual{0.002, -0.1, 1e-5, Vec3(0, 1, 0)};
  for (const double wrong : {kNaN, kInfinity, -kInfinity}) {
    LawInput deformation = usual, rate = usual, area = usual, direction = usual, resting = usual;
    deformation.deformation_m = rate.rate_m_s = area.area_m2 = direction.direction.x() = wrong;
    resting = {0, 0, wrong, Vec3(wrong, 0, 0)};
    for (const LawInput& input : {deformation, rate, area, direction, resting})
      expectPlainValues(manyLaws(), {usual, input, usual});
  }
  LawFamily family({huntCrossley(200, 50, 1.3)}, {huntCrossley(200, 50, 1.3)});
  family.evaluate({usual, {kNaN, 0, 1e-5, Vec3(0, 1, 0)}});
  EXPECT_TRUE(std::isnan(family.value(0).force_N));
  family.evaluate({usual});
  EXPECT_TRUE(std::isfinite(family.value(0).force_N)) << "the step after is good again";
}

// To the last bit, however many laws are evaluated at a time.
TEST(LawFamily, StepsTogetherAreStepsInTurn) {
  std::vector<ForceSettings> laws = manyLaws();
  for (int i = 0; i < 600; ++i) laws.push_back(huntCrossley(1 + i, 0.1 * i, 1.3));
  std::vector<std::vector<LawInput>> steps;
  for (const int triangles : {60, 0, 7, 200}) steps.push_back(randomInputs(triangles, 5 + triangles));
  LawFamily together(laws, {laws[0]}), in_turn(laws, {laws[0]});
  std::vector<std::vector<double>> forces_N(steps.size(), std::vector<double>(laws.size(), -1));
  std::vector<std::size_t> seen(laws.size());
  together.evaluate(steps, [&](std::size_t step, std::size_t first, std::size_t end) {
    for (std::size_t place = first; place < end; ++place) {
      EXPECT_EQ(seen[place]++, step) << "each place once in a step, and steps in their order";
      forces_N[step][place] = together.valuesByPlace().force_N[static_cast<Eigen::Index>(place)];
    }
  });
  for (std::size_t s = 0; s < steps.size(); ++s) {
    in_turn.evaluate(steps[s]);
    for (std::size_t law = 0; law < laws.size(); ++law)
      EXPECT_EQ(forces_N[s][together.place(law)], in_turn.value(law).force_N) << s << " " << law;
  }
  EXPECT_THROW(LawFamily({laws[0]}, {laws[0], laws[0]}).evaluate({{randomInputs(3, 1)}}, [](auto...) {}),
               std::logic_error);
}

// To the last bit: a sweep may be cut into families in any way.
TEST(LawFamily, OtherLawsAndTheirOrderDoNotMatter) {
  const std::vector<ForceSettings> laws = manyLaws();
  std::vector<std::size_t> order(laws.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937_64(5));
  std::vector<ForceSettings> shuffled;
  for (const std::size_t i : order) shuffled.push_back(laws[i]);
  LawFamily family(laws, {laws[0]}), other(shuffled, {laws[0]});
  family.evaluate(randomInputs(60, 11));
  other.evaluate(randomInputs(60, 11));
  for (std::size_t i = 0; i < order.size(); ++i) {
    LawFamily alone({laws[i]}, {laws[0]});
    alone.evaluate(randomInputs(60, 11));
    EXPECT_EQ(alone.value(0).force_N, family.value(i).force_N);
    EXPECT_EQ(alone.value(0).elastic_N, family.value(i).elastic_N);
    EXPECT_EQ(other.value(i).force_N, family.value(order[i]).force_N);
    EXPECT_EQ(other.value(i).viscous_N, family.value(order[i]).viscous_N);
    EXPECT_EQ(other.value(i).adhesion_clamped, family.value(order[i]).adhesion_clamped);
  }
}

// Two laws of the scenario, of other kinds: each member sees what the one of its own kinds does.
TEST(LawFamily, EachLawTakesTheInputsOfItsKinds) {
  ForceSettings corotated = huntCrossley(1, 1, 1);
  corotated.deformation = DeformationKind::corotated;
  corotated.rate = RateSource::velocities;
  const std::vector<ForceSettings> scenario_laws = {linearElastic(1), corotated, corotated};
  const std::vector<LawInput> first = randomInputs(30, 1), second = randomInputs(30, 2);
  std::vector<LawInput> inputs;
  for (std::size_t i = 0; i < first.size(); ++i) {
    inputs.push_back(first[i]);
    inputs.push_back(second[i]);
    inputs.push_back({kNaN, kNaN, kNaN, Vec3::Zero()});
  }
  std::vector<ForceSettings> laws = {huntCrossley(200, 50, 1.3), huntCrossley(200, 50, 1.3)};
  laws[1].deformation = DeformationKind::corotated;
  laws[1].rate = RateSource::velocities;
  LawFamily family(laws, scenario_laws);
  family.evaluate(inputs);
  const PlainValue of_first = plainly(laws[0], first), of_second = plainly(laws[1], second);
  EXPECT_NEAR(family.value(0).force_N, of_first.value.force_N, of_first.rounding_N());
  EXPECT_NEAR(family.value(1).force_N, of_second.value.force_N, of_second.rounding_N());

  laws[1].rate = RateSource::differences;
  try {
    LawFamily refused(laws, scenario_laws);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "force law hc: no law of the scenario has deformation corotated and rate "
                 "differences, whose inputs it needs");
  }
  inputs.pop_back();
  EXPECT_THROW(family.evaluate(inputs), std::logic_error);
}

}  // namespace
}  // namespace fissure::law_family_test
