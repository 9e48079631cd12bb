#include <gtest/gtest.h>

#include <cmath>

#include "curve_text.h"

namespace fissure::measured_curve_test {

namespace {

using Numbers = std::vector<double>;

void expectTheCurve(const std::vector<MeasuredCurve>& curves) {
  ASSERT_EQ(curves.size(), 1u);
  ASSERT_EQ(curves[0].depth_m.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(curves[0].depth_m[i], 0.001 * static_cast<double>(i + 1), 1e-15);
    EXPECT_NEAR(curves[0].force_N[i], 0.1 * static_cast<double>(i + 1), 1e-15);
  }
  EXPECT_TRUE(curves[0].warnings.empty());
}

TEST(MeasuredCurve, ColumnsAreFoundByNameAndUnit) {
  expectTheCurve(curvesOf("depth_mm,force_N\n1,0.1\n2,0.2\n3,0.3\n"));
  expectTheCurve(curvesOf("Force [mN];Depth (m)\n100;0.001\n200;0.002\n300;0.003\n"));
  expectTheCurve(curvesOf("\"force mN\"\tdepth_mm\n100\t1\n200\t2\n300\t3\n"));
}

TEST(MeasuredCurve, ColumnsAreChosenByNameOrNumberWithUnitsOrFactors) {
  const std::string text = "a,b,depth_mm\n0.1,-1,7\n0.2,-2,7\n0.3,-3,7\n";
  expectTheCurve(curvesOf(text, "depth=b:-0.001,force=a:N"));
  expectTheCurve(curvesOf(text, "depth=2:-1e-3,force=1:N"));
  expectTheCurve(
      curvesOf("2,1,x\n1,0.1,\n2,0.2,\n3,0.3,\n", "depth=2:mm,force=1:N"));  // names before numbers
}

TEST(MeasuredCurve, ToleratesWhatRealFilesHaveAndCountsWhatItLeavesOut) {
  const auto curves = curvesOf(
      "# a probe\ndepth_mm,force_N,\n-1,0.01,\n1,0.1,\n,0.5\n1.5,nan\n# a break\n2,0.2,\n\n3,0.3,\n");
  expectTheCurve(curves);
  EXPECT_EQ(curves[0].rows_without_numbers, 2u);
  EXPECT_EQ(curves[0].rows_before_contact, 1u);
}

TEST(MeasuredCurve, AColumnNamesTheCurve) {
  const auto curves = curvesOf("probe,depth_mm,force_N\nb,1,1\na,1,2\nb,2,3\n");
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].name, "probe:b");
  EXPECT_EQ(curves[0].force_N, (Numbers{1, 3}));
  EXPECT_EQ(curves[1].name, "probe:a");
}

TEST(MeasuredCurve, WeightsAreGivenOrOneOverSigmaSquared) {
  EXPECT_EQ(curvesOf("depth_mm,force_N,weight\n1,1,2\n2,2,0\n3,3,\n4,4,1\n")[0].weights, (Numbers{2, 1}));
  const auto curves = curvesOf("depth_mm,force_N,sigma_mN\n1,1,500\n");
  EXPECT_NEAR(curves[0].weights[0], 4, 1e-12);
}

TEST(MeasuredCurve, RatesAreTakenOverTheRowsBeforeContactToo) {
  const auto curves =
      curvesOf("time_ms,depth_mm,force_N\n0,-1,0\n10,1,1\n20,-1,0\n30,-1,0\n40,1,1\n50,3,2\n");
  ASSERT_EQ(curves[0].rate_m_s.size(), 3u);
  EXPECT_NEAR(curves[0].rate_m_s[0], 0, 1e-12);
  EXPECT_NEAR(curves[0].rate_m_s[1], 0.2, 1e-12);
  ASSERT_EQ(curves[0].rate_noise_m_s.size(), 3u);
  EXPECT_GT(curves[0].rate_noise_m_s[1], 0.01);
}

TEST(MeasuredCurve, CurvesAreJoinedWithTheirRatesButNotTheirTimes) {
  const auto curves = curvesOf("probe,time_s,depth_mm,force_N\na,0,1,1\na,1,2,2\nb,0,1,3\nb,2,2,4\n");
  const MeasuredCurve all = joined(curves);
  EXPECT_EQ(all.force_N, (Numbers{1, 2, 3, 4}));
  EXPECT_TRUE(all.time_s.empty());
  ASSERT_EQ(all.rate_m_s.size(), 4u);
  EXPECT_NEAR(all.rate_m_s[3], 0.0005, 1e-15);
  EXPECT_EQ(all.rate_noise_m_s.size(), 4u);
  const auto slow = curvesOf("depth_mm,force_N\n1,1\n");
  EXPECT_TRUE(joined({curves[0], slow[0]}).rate_m_s.empty());
  EXPECT_TRUE(joined({curves[0], slow[0]}).rate_noise_m_s.empty());
  const auto deepless = curvesOf("time_s,force_N\n1,1\n");
  EXPECT_THROW(joined({curves[0], deepless[0]}), InputError);
  // Which have no times is said.
  MeasuredCurve timeless = slow[0];
  timeless.file = "a/slow.csv";
  timeless.name = "slow";
  EXPECT_EQ(joined({curves[0], timeless}).warnings,
            std::vector<std::string>{"no times in a/slow.csv: the rates of the others are not used"});
  EXPECT_TRUE(joined({timeless, timeless}).warnings.empty());
}

TEST(MeasuredCurve, WeightsOfDifferentKindsAreNotJoined) {
  MeasuredCurve a = curvesOf("depth_mm,force_N,sigma_N\n1,1,0.1\n")[0],
                b = curvesOf("depth_mm,force_N\n1,1\n")[0];
  a.file = "a.csv";
  a.name = "a";
  b.name = "b";
  b.file = "b.csv";
  const auto refusal = [](const std::vector<MeasuredCurve>& curves) -> std::string {
    try {
      joined(curves);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_EQ(refusal({a, b}),
            "weights of different kinds, a.csv by sigma and b.csv by nothing, expected one kind");
  EXPECT_EQ(refusal({a, a}), "nothing");
}

TEST(MeasuredCurve, MessagesNameTheFileAndTheCurveOfAColumn) {
  MeasuredCurve curve;
  curve.name = "probe:left";
  curve.file = "day 1/probe.csv";
  EXPECT_EQ(labelOf(curve), "day 1/probe.csv, curve left");
  curve.name = "probe";
  EXPECT_EQ(labelOf(curve), "day 1/probe.csv");
  curve.file.clear();
  EXPECT_EQ(labelOf(curve), "probe");
  EXPECT_TRUE(curvesOf("depth_mm,force_N\n1,1\n")[0].file.ends_with("/probe.csv"));
}

TEST(MeasuredCurve, PointsWithoutTimesAreInTheOrderOfTheirDepths) {
  const auto curves = curvesOf("depth_mm,force_N,weight\n3,3,1\n1,2,5\n2,2.5,4\n1,1,3\n");
  EXPECT_EQ(curves[0].force_N, (Numbers{1, 2, 2.5, 3}));
  EXPECT_EQ(curves[0].weights, (Numbers{3, 5, 4, 1}));
  EXPECT_EQ(joined({curves[0], curves[0]}).force_N, (Numbers{1, 1, 2, 2, 2.5, 2.5, 3, 3}));
  EXPECT_EQ(curvesOf("time_s,depth_mm,force_N\n0,2,2\n1,1,1\n")[0].force_N, (Numbers{2, 1}));
}

TEST(MeasuredCurve, WarnsOfUnitsThatMayBeWrong) {
  const auto warning = [](const std::string& text) {
    const auto curves = curvesOf(text);
    return curves[0].warnings.empty() ? "none" : curves[0].warnings[0];
  };
  EXPECT_EQ(warning("depth_m,force_N\n1,0.1\n2,0.2\n"),
            "the largest depth is 2 m, usual are 5e-05 to 0.2 m: is its unit right?");
  EXPECT_EQ(warning("depth_mm,force_N\n0.001,0.1\n0.002,0.2\n"),
            "the largest depth is 2e-06 m, usual are 5e-05 to 0.2 m: is its unit right?");
  EXPECT_EQ(warning("depth_mm,force_N\n1,100\n2,235\n"),
            "the largest force is 235 N, usual are 0.002 to 100 N: is its unit right?");
  EXPECT_EQ(warning("depth_mm,force_mN\n1,0.1\n2,0.235\n"),
            "the largest force is 0.000235 N, usual are 0.002 to 100 N: is its unit right?");
  EXPECT_EQ(warning("time_ms,depth_mm,force_N\n0,1,1\n0.1,2,1\n"),
            "the largest rate is 10 m/s, usual are 0 to 5 m/s: is its unit right?");
}

TEST(MeasuredCurve, SaysInOneLineWhatIsWrong) {
  EXPECT_EQ(curveError("depth_mm,force_N\n1,x\n"),
            "probe.csv:2: \"x\" in column \"force_N\", expected a number like -0.0125 or nothing");
  EXPECT_EQ(curveError("depth_mm,force_N\n1,inf\n"),
            "probe.csv:2: an infinite force, expected a number like 0.0125 or nothing");
  EXPECT_EQ(
      curveError("depth,force_N\n1,1\n"),
      "probe.csv:1: column \"depth\" has no unit of a depth, expected it in the name, or after a colon: "
      "depth=depth:m");
  EXPECT_EQ(curveError("d_mm,F_N\n1,1\n"),
            "probe.csv:1: no column of forces, expected --columns force=F:N to say which it is of d_mm, F_N");
  EXPECT_EQ(
      curveError("d_mm,force_N\n1,1\n"),
      "probe.csv:1: neither depths nor times, expected --columns depth=d:mm to say which it is of d_mm, "
      "force_N");
  EXPECT_EQ(
      curveError("depth_mm,force_N\n1,1\n", "depth=deep"),
      "probe.csv:1: no column \"deep\" in the header (it has depth_mm, force_N), expected one of these");
  EXPECT_EQ(curveError("depth_mm,force_N\n1,1\n", "depth=3:mm"),
            "probe.csv:1: no column 3, expected a number from 1 to 2");
  EXPECT_EQ(curveError("depth_mm,depth_m,force_N\n1,1,1\n"),
            "probe.csv:1: 2 columns may be the depth, expected --columns to choose one");
  EXPECT_EQ(curveError("depth_mm,force_N,sigma_N,weight\n1,1,1,1\n"),
            "probe.csv:1: both a sigma and a weight, expected one of them");
  EXPECT_EQ(curveError("depth_mm,force_N,sigma_N\n1,1,0\n"),
            "probe.csv:2: a sigma of 0 or less, expected > 0");
  EXPECT_EQ(curveError("depth_mm,force_N,weight\n1,1,-1\n"), "probe.csv:2: a weight below 0, expected >= 0");
  EXPECT_EQ(curveError("time_s,depth_mm,force_N\n1,1,1\n0,1,1\n"),
            "probe.csv:3: the time goes back, expected times in order");
  EXPECT_EQ(curveError("1,0.1\n2,0.2\n3,0.3\n", "depth=1:mm,force=2:N"),
            "probe.csv:1: a header of numbers alone, the first point would be lost, expected a line of names "
            "above it");
  EXPECT_EQ(curveError("depth_mm,force_N\n"), "probe.csv:1: only a header line, expected rows below it");
  EXPECT_EQ(
      curveError("depth_mm,force_N\n-1,1\n-2,2\n"),
      "probe.csv: no row of curve probe is a point of contact, expected numbers and depths >= 0 (is the "
      "depth's sign turned? a factor of -0.001 makes it metres)");
}

TEST(MeasuredCurve, QuartilesStandBesideTheirPoints) {
  const MeasuredCurve curve =
      curvesOf("depth_mm,force_N,lower_quartile_N,q3\n2,0.2,0.15,270\n1,0.1,,120\n-1,0,0,1\n",
               "upper_quartile=q3:mN")[0];
  ASSERT_EQ(curve.lower_quartile_N.size(), 2u);
  EXPECT_TRUE(std::isnan(curve.lower_quartile_N[0]));
  EXPECT_DOUBLE_EQ(curve.upper_quartile_N[0], 0.12);
  EXPECT_DOUBLE_EQ(curve.lower_quartile_N[1], 0.15);
  EXPECT_DOUBLE_EQ(curve.upper_quartile_N[1], 0.27);
  EXPECT_TRUE(curvesOf("depth_mm,force_N\n1,0.1\n")[0].lower_quartile_N.empty());
  EXPECT_EQ(curveError("depth_mm,force_N,lower_quartile_N\n1,0.1,0\n"),
            "probe.csv:1: one quartile alone, expected a lower_quartile and an upper_quartile");
  EXPECT_EQ(curveError("depth_mm,force_N,lower_quartile_N,upper_quartile_N\n1,0.1,0.2,0.1\n"),
            "probe.csv:2: a lower quartile above the upper one, expected it below");
}

TEST(MeasuredCurve, RefusesColumnsThatMakeNoSense) {
  const auto error = [](const std::string& columns) { return curveError("a,b\n1,1\n", columns); };
  EXPECT_EQ(error("deep=a"),
            "--columns deep=a: expected ROLE=COLUMN[:UNIT] with a role of depth, force, time, sigma, weight, "
            "curve, lower_quartile, upper_quartile");
  EXPECT_EQ(error("depth="),
            "--columns depth=: expected ROLE=COLUMN[:UNIT] with a role of depth, force, time, sigma, weight, "
            "curve, lower_quartile, upper_quartile");
  EXPECT_EQ(error("depth=a:N"),
            "--columns depth=a:N: \"N\" is no unit of a depth, expected m or mm or a factor");
  EXPECT_EQ(error("depth=a:0"),
            "--columns depth=a:0: \"0\" is no unit of a depth, expected m or mm or a factor");
  EXPECT_EQ(error("depth=a:inf"),
            "--columns depth=a:inf: \"inf\" is no unit of a depth, expected m or mm or a factor");
  EXPECT_EQ(error("curve=a:1"), "--columns curve=a:1: \"1\" is no unit of a curve, expected none");
  EXPECT_EQ(error("depth=a:m,depth=b:m"), "--columns: two columns for depth, expected one");
}

}  // namespace
}  // namespace fissure::measured_curve_test
