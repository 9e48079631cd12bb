#include "sweep/sweep_misfit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "base/error.h"

namespace fissure::sweep_misfit_test {

namespace {

class MisfitTest : public testing::Test {
 protected:
  MisfitTest()
      : file_(std::filesystem::path(testing::TempDir()) /
              ("fissure_misfit_" + std::to_string(::getpid()) + ".csv")) {}
  ~MisfitTest() override { std::filesystem::remove(file_); }
  void measured(const std::string& text) const { std::ofstream(file_) << text; }

  std::filesystem::path file_;
  std::vector<double> time_s_ = {0, 1, 2, 3};
};

TEST_F(MisfitTest, ComparesTheLawThatIsNamedOverDepth) {
  measured("depth_mm,force_N\n0.5,1\n1.5,3\n");
  // Two laws; the way of the tool in metres. The second law gives 2 N a millimetre: 1 and 3 at the points.
  const std::vector<double> force_N = {0, 9, 9, 9, 0, 2, 4, 6}, way_m = {0, 0.001, 0.002, 0.003};
  const SweepMisfit second({"", {}, MatchBy::depth, "b", false}, {"a", "b"}, file_);
  EXPECT_NEAR(second.of(time_s_, force_N, way_m).rms_N, 0, 1e-12);
  const SweepMisfit first({"", {}, MatchBy::depth, {}, false}, {"a", "b"}, file_);
  EXPECT_NEAR(first.of(time_s_, force_N, way_m).rms_N, std::sqrt((3.5 * 3.5 + 6 * 6) / 2), 1e-12);
  EXPECT_TRUE(second.at(time_s_).empty());
  // A run that does not go as deep cannot be compared.
  EXPECT_TRUE(std::isnan(second.of(time_s_, force_N, std::vector<double>{0, 0.0005, 0.001, 0.0012}).rms_N));
}

TEST_F(MisfitTest, OverTimeItGivesTheMeasuredForceToo) {
  measured("time_s,force_N\n0.5,2\n2,5\n");
  const SweepMisfit misfit({"", {}, MatchBy::time, {}, true}, {"a"}, file_);
  const Misfit found = misfit.of(time_s_, std::vector<double>{0, 2, 4, 6}, {});
  EXPECT_NEAR(found.rms_N, 0, 1e-12);  // 1 N lower throughout
  EXPECT_NEAR(found.F0_N, 1, 1e-12);
  const std::vector<double> at = misfit.at(time_s_);
  ASSERT_EQ(at.size(), 4u);
  EXPECT_TRUE(std::isnan(at[0]) && std::isnan(at[3]));
  EXPECT_NEAR(at[1], 3, 1e-12);
  EXPECT_EQ(at[2], 5);
}

TEST_F(MisfitTest, ACurveThatCannotBeMatchedIsRefused) {
  measured("depth_mm,force_N\n0.5,1\n1.5,3\n");
  EXPECT_THROW(SweepMisfit({"", {}, MatchBy::time, {}, true}, {"a"}, file_), InputError);
  EXPECT_THROW(SweepMisfit({"", "depth=nothing:mm", MatchBy::depth, {}, true}, {"a"}, file_), InputError);
}

TEST_F(MisfitTest, AFileOfSeveralCurvesIsRefused) {
  measured("probe,depth_mm,force_N\nx,0.5,1\ny,0.5,2\nx,1.5,3\n");
  try {
    SweepMisfit({"", {}, MatchBy::depth, {}, true}, {"a"}, file_);
    FAIL() << "nothing";
  } catch (const InputError& error) {
    const std::string stem = file_.stem().string();
    EXPECT_EQ(error.what(), file_.string() + ": has 2 curves (" + stem + ":x, " + stem +
                                ":y), expected one to hold the runs against");
  }
}

}  // namespace
}  // namespace fissure::sweep_misfit_test
