#include "measure/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fissure::verdict_test {

namespace {

Summary good() {
  return {{"max_penetration_depth_m", 0.0}, {"max_inversion_aware_depth_m", 0.0},
          {"passed_through_samples", 0LL},  {"max_inverted_triangles", 0LL},
          {"sample_coverage_m", 0.0},       {"contact_steps", 12LL},
          {"unsound_steps", 0LL},           {"max_ground_depth_m", 0.0},
          {"node_spacing_over_edge", 0.5}};
}

Summary with(const std::string& name, const std::variant<double, long long, std::string>& value) {
  Summary summary = good();
  for (SummaryValue& known : summary) {
    if (known.name != name) continue;
    known.value = value;
    return summary;
  }
  summary.push_back({name, value});
  return summary;
}

void expectVerdict(const Summary& summary, VerdictGrade grade, const std::string& text) {
  const Verdict verdict = verdictOf(summary);
  EXPECT_EQ(verdict.text, text);
  EXPECT_EQ(static_cast<int>(verdict.grade), static_cast<int>(grade)) << text;
}

TEST(Verdict, SaysHeldOnlyWhereNothingSpeaksAgainstIt) {
  expectVerdict(good(), VerdictGrade::held, "held");
  expectVerdict(with("max_inversion_aware_depth_m", 0.00012), VerdictGrade::held, "held to 0.12 mm");
  expectVerdict(with("max_inversion_aware_depth_m", 0.014), VerdictGrade::failed, "14.00 mm inside");
  expectVerdict(with("max_inversion_aware_depth_m", NAN), VerdictGrade::failed, "depth unknown");
  expectVerdict(with("passed_through_samples", 3LL), VerdictGrade::failed, "passed through");
  expectVerdict(with("max_inverted_triangles", 3LL), VerdictGrade::failed, "inverted");
  expectVerdict(with("unsound_steps", 1LL), VerdictGrade::failed, "unsound tissue");
  expectVerdict(with("contact_steps", 0LL), VerdictGrade::doubtful, "never touched tissue");
  expectVerdict(with("contacts_total", 0LL), VerdictGrade::doubtful, "beside tissue, no contact");
  expectVerdict(with("uncertified_steps", 0LL), VerdictGrade::held, "held, proved");
  Summary inverted = with("uncertified_steps", 0LL);  // proved of tissue that is none: no praise
  for (SummaryValue& value : inverted)
    if (value.name == "max_inverted_triangles") value.value = 3LL;
  expectVerdict(inverted, VerdictGrade::failed, "inverted");
  expectVerdict(with("untouched_tools", std::string("far")), VerdictGrade::doubtful,
                "held, far never touched tissue");
  expectVerdict(with("uncertified_steps", 7LL), VerdictGrade::doubtful, "held, 7 steps not proved");
  expectVerdict(with("uncertified_steps", NAN), VerdictGrade::held, "held");
  expectVerdict(with("max_ground_depth_m", 0.00565), VerdictGrade::doubtful, "held, 5.65 mm below ground");
}

TEST(Verdict, OfAnOlderResultTakesThePlainDepth) {
  expectVerdict({{"max_penetration_depth_m", 0.002}}, VerdictGrade::failed, "2.00 mm inside");
  expectVerdict({{"steps", 3LL}}, VerdictGrade::held, "-");
}

TEST(Remarks, AreMadeOfWhatTheNumbersDoNotSay) {
  EXPECT_TRUE(remarksOf(good()).empty());
  const auto only = [](const Summary& summary) {
    const std::vector<Remark> remarks = remarksOf(summary);
    EXPECT_EQ(remarks.size(), 1u);
    return remarks.empty() ? "" : remarks.front().text;
  };
  EXPECT_EQ(only(with("not_measured", std::string("the inside of sheet"))),
            "not measured: the inside of sheet");
  EXPECT_EQ(only(with("untouched_tools", std::string("left"))), "never touched tissue: left");
  EXPECT_EQ(only(with("sample_coverage_m", 0.00053)),
            "samples see depths to within 0.53 mm: that much more may hide between them "
            "(measure.sample_spacing_m)");
  EXPECT_NE(only(with("node_spacing_over_edge", 0.51)).find("0.51 of a mean tissue edge"), std::string::npos);
  EXPECT_NE(only(with("oblique_steps", 7LL)).find("in 7 steps a blade moves obliquely"), std::string::npos);
  Summary truncated = with("truncated_steps", 4LL);
  truncated.push_back({"truncated_vertices", 9LL});
  EXPECT_EQ(only(truncated),
            "in 4 steps tissue that contacts did not hold was stopped on its way (9 vertices)");
  EXPECT_EQ(only(with("no_room_steps", 2LL)),
            "after 2 steps there was no room for tissue, which may overlap a tool");
  EXPECT_TRUE(remarksOf(with("no_room_steps", 0LL)).empty());
  EXPECT_EQ(only(with("freeing_steps", 3LL)), "in 3 steps a tool that stood in tissue was on its way out");
  Summary unsound = with("unsound_tissue", std::string("vessel explodes"));
  unsound.push_back({"first_unsound_step", 12LL});
  EXPECT_EQ(only(unsound), "unsound tissue, first in step 12: vessel explodes");
  EXPECT_EQ(only(with("steps_per_measurement", 10LL)),
            "depth and proof of one step in 10 only (measure.every): what came in between was not seen");
  EXPECT_EQ(
      only(with("laws_of_whole_probes", std::string("liver (pig_liver_1)"))),
      "force of liver (pig_liver_1): fitted to a whole probe, here summed over triangles; its exponent is "
      "the tissue's, its newtons are not");
}

TEST(Remarks, CoverageIsNoneWhereTheDepthClaimedIsLarger) {
  Summary summary = with("sample_coverage_m", 0.00053);
  for (SummaryValue& value : summary)
    if (value.name == "max_inversion_aware_depth_m") value.value = 0.02;
  EXPECT_TRUE(remarksOf(summary).empty());
}

// Nothing hides between samples where overlap is excluded.
TEST(Remarks, CoverageIsNoneWhereEveryStepIsProved) {
  Summary summary = with("sample_coverage_m", 0.00053);
  summary.push_back({"uncertified_steps", 0LL});
  EXPECT_TRUE(remarksOf(summary).empty());
}

TEST(Remarks, NameTheFirstStepThatIsNotProved) {
  Summary summary = with("first_uncertified", std::string("edge 1-2 of sphere may meet edge 0-1 of spatula"));
  summary.push_back({"first_uncertified_step", 90LL});
  const std::vector<Remark> remarks = remarksOf(summary);
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_EQ(remarks[0].text,
            "overlap is not excluded, first in step 90: edge 1-2 of sphere may meet edge 0-1 of spatula");
}

TEST(ReactionNote, StandsWhereThereIsAReaction) {
  EXPECT_EQ(reactionNote(good()), "");
  EXPECT_EQ(reactionNote(with("max_reaction_N", NAN)), "");
  EXPECT_NE(reactionNote(with("max_reaction_N", 30.0)).find("1/dt^2"), std::string::npos);
}

TEST(EndText, OkIsNoJudgement) {
  EXPECT_EQ(endText(RunEnd::ok), "finished");
  EXPECT_EQ(endText(RunEnd::non_finite), "non_finite");
}

}  // namespace
}  // namespace fissure::verdict_test
