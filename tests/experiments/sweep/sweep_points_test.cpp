#include "sweep/sweep_points.h"

#include <cmath>
#include <set>

#include "sweep_text.h"

namespace fissure::sweep_points_test {

namespace {

std::vector<std::string> rows(const SweepPoints& points) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::string line;
    for (std::size_t a = 0; a < points.paths().size(); ++a) line += (a > 0 ? " " : "") + points.value(i, a);
    lines.push_back(line);
  }
  return lines;
}

double number(const SweepPoints& points, std::size_t point, std::size_t axis) {
  return std::stod(points.value(point, axis));
}

TEST(SweepPoints, AGridIsEveryCombinationTheLastAxisFastest) {
  const SweepPoints points(
      sweepOf("axes:\n"
              "  - {path: a, values: [x, y]}\n"
              "  - zip:\n"
              "      - {path: b, linear: {from: 0, to: 1, count: 3}}\n"
              "      - {path: c, logarithmic: {from: 1, to: 100, count: 3}}\n"));
  EXPECT_EQ(points.paths(), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(rows(points),
            (std::vector<std::string>{"x 0 1", "x 0.5 10", "x 1 100", "y 0 1", "y 0.5 10", "y 1 100"}));
}

TEST(SweepPoints, ExcludedOnesAreLeftOut) {
  const SweepPoints points(
      sweepOf("axes:\n"
              "  - {path: a, values: [1, 2, 3]}\n"
              "  - {path: b, values: [x, y]}\n"
              "exclude:\n"
              "  - [{path: a, min: 2}, {path: b, values: [y]}]\n"
              "  - [{path: a, max: 1}]\n"));
  EXPECT_EQ(rows(points), (std::vector<std::string>{"2 x", "3 x"}));
}

TEST(SweepPoints, TheirNumberIsKnownBeforeTheyAreMade) {
  std::string axes = "axes:\n";
  for (int i = 0; i < 30; ++i)
    axes += "  - {path: p" + std::to_string(i) + ", linear: {from: 0, to: 1, count: 1000}}\n";
  EXPECT_DOUBLE_EQ(SweepPoints::designed(sweepOf(axes)), 1e90);
}

const std::string kTwoRanges =
    "axes:\n"
    "  - {path: a, linear: {from: -1, to: 3, count: 2}}\n"
    "  - {path: b, logarithmic: {from: 0.01, to: 100, count: 2}}\n";

class Sampled : public testing::TestWithParam<const char*> {
 protected:
  static SweepPoints points(int count, int seed) {
    return SweepPoints(sweepOf(kTwoRanges + "design: " + GetParam() + "\ncount: " + std::to_string(count) +
                               "\nseed: " + std::to_string(seed) + "\n"));
  }
};

TEST_P(Sampled, LiesInTheRangesAndDependsOnTheSeedAlone) {
  const SweepPoints one = points(200, 1), again = points(200, 1), other = points(200, 2);
  EXPECT_EQ(rows(one), rows(again));
  EXPECT_NE(rows(one), rows(other));
  ASSERT_EQ(one.size(), 200u);
  double mean_a = 0, mean_b = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_TRUE(number(one, i, 0) >= -1 && number(one, i, 0) < 3);
    EXPECT_TRUE(number(one, i, 1) >= 0.01 && number(one, i, 1) < 100);
    mean_a += number(one, i, 0) / 200;
    mean_b += std::log10(number(one, i, 1)) / 200;
  }
  EXPECT_NEAR(mean_a, 1, 0.3);
  EXPECT_NEAR(mean_b, 0, 0.3) << "even in the logarithm";
}

INSTANTIATE_TEST_SUITE_P(Designs, Sampled, testing::Values("random", "latin_hypercube", "sobol"),
                         [](const auto& design) { return std::string(design.param); });

// Each of n points has a stratum of its own on every axis.
TEST(SweepPoints, ALatinHypercubeHitsEveryStratumOnce) {
  const SweepPoints points(sweepOf(kTwoRanges + "design: latin_hypercube\ncount: 50\nseed: 3\n"));
  std::set<int> a, b;
  for (std::size_t i = 0; i < 50; ++i) {
    a.insert(static_cast<int>((number(points, i, 0) + 1) / 4 * 50));
    b.insert(static_cast<int>((std::log10(number(points, i, 1)) + 2) / 4 * 50));
  }
  EXPECT_EQ(a.size(), 50u);
  EXPECT_EQ(b.size(), 50u);
}

// Of 2^8 points each of the 16 x 16 cells holds one: a random design leaves a third of them empty.
TEST(SweepPoints, ASobolSequenceFillsThePlane) {
  const auto cells = [](const char* design) {
    const SweepPoints points(sweepOf(kTwoRanges + "design: " + design + "\ncount: 256\nseed: 4\n"));
    std::set<std::pair<int, int>> hit;
    for (std::size_t i = 0; i < 256; ++i)
      hit.insert({static_cast<int>((number(points, i, 0) + 1) * 4),
                  static_cast<int>((std::log10(number(points, i, 1)) + 2) * 4)});
    return hit.size();
  };
  EXPECT_EQ(cells("sobol"), 256u);
  EXPECT_LT(cells("random"), 190u);
}

TEST(SweepPoints, ListsAreSampledByTheirItemsAndZippedAxesTogether) {
  const SweepPoints points(
      sweepOf("axes:\n"
              "  - zip:\n"
              "      - {path: a, values: [1, 2, 3]}\n"
              "      - {path: b, values: [x, y, z]}\n"
              "design: random\ncount: 60\nseed: 5\n"));
  std::set<std::string> seen;
  for (const std::string& row : rows(points)) seen.insert(row);
  EXPECT_EQ(seen, (std::set<std::string>{"1 x", "2 y", "3 z"}));
}

}  // namespace
}  // namespace fissure::sweep_points_test
