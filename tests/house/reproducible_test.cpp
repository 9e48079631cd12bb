// What a simulation computes and what judges it has the same bits on every processor: read from the sources,
// no elementary function of the C library, nor one of Eigen's that calls it, stands in simulation/ and
// judgement/.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace fissure::reproducible_house_test {

namespace {

namespace fs = std::filesystem;

/// Line and text of each call; comments and texts between quotes are passed over.
std::vector<std::string> callsIn(const std::string& code) {
  static const std::regex passed_over(R"re(//[^\n]*|"(\\.|[^"\\\n])*")re");
  static const std::regex call(
      // Functions of <cmath>, with std:: or without, but for those of reproducible::. No member functions of
      // ours have such names.
      R"((^|[^\w:]|std::|[^e]::)(pow|exp|exp2|expm1|log|log2|log10|log1p|sin|cos|tan|sincos|asin|acos|atan|atan2|)"
      R"(sinh|cosh|tanh|asinh|acosh|atanh|cbrt|hypot|erf|erfc|tgamma|lgamma)[fl]?\s*\()"
      // Functions of Eigen's that call those, and conversions of its AngleAxis.
      R"(|\.(slerp|angularDistance|eulerAngles)\s*\(|AngleAxis[df]\s*\()"
      R"(|AngleAxis[df] \w+[({]|std::(complex|polar|normal_distribution|lognormal_distribution)\b)");
  std::string bare;
  std::size_t at = 0;
  for (std::sregex_iterator i(code.begin(), code.end(), passed_over), end; i != end; ++i) {
    bare += code.substr(at, static_cast<std::size_t>(i->position()) - at);
    at = static_cast<std::size_t>(i->position() + i->length());
  }
  bare += code.substr(at);
  std::vector<std::string> calls;
  for (std::sregex_iterator i(bare.begin(), bare.end(), call), end; i != end; ++i) calls.push_back(i->str());
  return calls;
}

TEST(Reproducible, CallsOfTheCLibraryAreSeen) {
  for (const char* code :
       {"y = std::pow(x, 2);", "return 2*exp(x);", "sinf (x)", "(::atan2(y, x))", "std::hypot(a, b)",
        "q.slerp(t, r)", "Eigen::AngleAxisd turn(q);", "const Quat turn(Eigen::AngleAxisd(a, v));",
        "v.array().exp()", "std::transform(a, b, c, Eigen::numext::log(d))"})
    EXPECT_EQ(callsIn(code).size(), 1u) << code;
  for (const char* code :
       {"y = reproducible::pow(x, 2);", "slerp(p, t, q)", "std::sqrt(x)", "std::fmod(x, y)", "catalog(x)",
        "// std::pow(x, 2)\n", "text = \"k (exp(a x) - 1)\";", "Eigen::AngleAxisd turn = axisAndAngle(q);"})
    EXPECT_EQ(callsIn(code).size(), 0u) << code;
}

TEST(Reproducible, SimulationAndJudgementCallNone) {
  std::size_t files = 0;
  for (const char* wing : {"simulation", "judgement"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FISSURE_SOURCE_DIR) / "src" / wing)) {
      if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
      std::ifstream stream(entry.path());
      const std::string code{std::istreambuf_iterator<char>(stream), {}};
      EXPECT_EQ(callsIn(code), std::vector<std::string>()) << entry.path() << ": take base/reproducible.h's";
      ++files;
    }
  }
  EXPECT_GT(files, 200u) << "the sources were not found";
}

}  // namespace
}  // namespace fissure::reproducible_house_test
