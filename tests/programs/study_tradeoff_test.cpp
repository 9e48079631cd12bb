// Studies of accuracy and cost, from outside: what is found, written and refused, and what a killed one
// keeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::study_tradeoff_test {
namespace {

/// Two pipelines at two steps, against `swept` at three smaller ones, on a shell.
const std::string study_text =
    "format: 1\n"
    "name: press_study\n"
    "base: press.yaml\n"
    "axes:\n"
    "  - {path: time.step_s, values: [0.001, 0.002]}\n"
    "reference:\n"
    "  pipeline: swept\n"
    "  ladder: {path: time.step_s, values: [0.001, 0.0005, 0.00025]}\n"
    "errors:\n"
    "  - {quantity: depth, tolerance: 0.1mm}\n"
    "  - {quantity: reaction, tolerance: 5%}\n"
    "repeats: 2\n";

class Tradeoff : public testing::Test {
 protected:
  Tradeoff() {
    folder_.write("press.yaml", pressScenario("[{pipeline: default}, {pipeline: swept}]", "0.03"));
    folder_.write("study.yaml", study_text);
  }

  Outcome study(const std::vector<std::string>& more, const std::string& file = "study.yaml") const {
    std::vector<std::string> words{"study", "tradeoff", file};
    words.insert(words.end(), more.begin(), more.end());
    return runFissure(folder_, words);
  }

  nlohmann::json found(const std::string& name = "out/press_study") const {
    return nlohmann::json::parse(folder_.read(name + "/tradeoff.json"));
  }

  /// The errors alone: times differ from run to run.
  nlohmann::json errors(const std::string& name) const {
    nlohmann::json all;
    const nlohmann::json json = found(name);
    for (const auto& setting : json["settings"]) all.push_back(setting["errors"]);
    all.push_back(json["references"]);
    return all;
  }

  Folder folder_;
};

TEST_F(Tradeoff, DepthIsJudgedAndAShellsReactionRefused) {
  const Outcome outcome = study({"--budget-us", "1e6", "--max-error", "depth=0.1mm"});
  ASSERT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const nlohmann::json json = found();
  ASSERT_EQ(json["settings"].size(), 4u);
  for (const auto& setting : json["settings"]) {
    EXPECT_EQ(setting["cost"]["us_per_ms"]["count"], 2);
    EXPECT_GT(setting["cost"]["us_per_ms"]["median"], 0);
    EXPECT_GT(setting["cost"]["memory_mib"]["median"], 1);
    const double depth_m = setting["errors"]["depth"]["counts"];
    if (setting["pipeline"] == "default") {
      EXPECT_GT(depth_m, 1e-3) << "the blade goes in";
    } else {
      EXPECT_LT(depth_m, 1e-5);
    }
    EXPECT_TRUE(setting["errors"]["reaction"]["counts"].is_null());
  }
  for (const auto& reference : json["references"])
    EXPECT_EQ(reference["refused"] == "", reference["quantity"] == "depth");
  EXPECT_NE(outcome.out.find("reaction: REFUSED, does not converge"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("its reaction never converges"), std::string::npos);

  // What is recommended holds, is of swept, and runs as it is.
  ASSERT_EQ(json["answers"].size(), 2u);
  for (const auto& answer : json["answers"]) {
    EXPECT_EQ(answer["holds"], true);
    EXPECT_EQ(json["settings"][answer["setting"].get<std::size_t>()]["pipeline"], "swept");
    const Outcome run = runFissure(
        folder_,
        {"run", "out/press_study/" + answer["scenario"].get<std::string>(), "-o", "again.h5", "--force"});
    EXPECT_EQ(run.code, 0) << run.err;
  }
}

TEST_F(Tradeoff, WhereNothingIsWithinTheWishTheNearestIsNamed) {
  const Outcome outcome = study({"--budget-us", "0.01"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("at most 0.01 us for a simulated millisecond: no setting; the nearest, "),
            std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("times beyond"), std::string::npos);
  const Outcome reaction = study({"--max-error", "reaction=5%"});
  EXPECT_EQ(reaction.code, 1);
  EXPECT_NE(reaction.out.find("0 of 8 simulations to do"), std::string::npos) << reaction.out;
  EXPECT_NE(reaction.out.find("no setting, reaction has no reference: does not converge"), std::string::npos)
      << reaction.out;
}

TEST_F(Tradeoff, AKilledOneGoesOnAndFindsTheSame) {
  ASSERT_EQ(study({"-o", "truth"}).code, 0);
  Program program(folder_, {fissureProgram(), "study", "tradeoff", "study.yaml", "-o", "killed"});
  // Of two rungs that have a result the first is recorded.
  const auto results = [&] {
    std::error_code none;
    const std::filesystem::directory_iterator files(folder_ / "killed/ladder/runs", none);
    return none ? 0 : std::distance(begin(files), end(files));
  };
  while (results() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  program.send(SIGKILL);
  program.wait();
  const Outcome outcome = study({"-o", "killed"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.find("ladder: 3 of 3"), std::string::npos) << "the first rung was finished";
  EXPECT_EQ(errors("killed"), errors("truth"));
}

TEST_F(Tradeoff, SharesTogetherAreTheWhole) {
  ASSERT_EQ(study({"-o", "truth"}).code, 0);
  for (const char* shard : {"1/2", "2/2"}) ASSERT_EQ(study({"-o", "parts", "--shard", shard}).code, 0);
  const Outcome outcome = study({"-o", "parts"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("ladder: 0 of 3"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("settings: 0 of 8"), std::string::npos) << outcome.out;
  EXPECT_EQ(errors("parts"), errors("truth"));
}

TEST_F(Tradeoff, BadInputIsOneLineAndLeavesNothing) {
  const auto refuse = [&](const std::string& from, const std::string& to, const std::string& expected,
                          const std::vector<std::string>& more = {}) {
    std::string text = study_text;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    folder_.write("bad.yaml", text);
    const Outcome outcome = study(more, "bad.yaml");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(expected), std::string::npos) << outcome.err;
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"bad.yaml", "press.yaml", "study.yaml"}));
  };
  refuse(study_text, "", "bad.yaml");
  refuse("base: press.yaml\n", "", "missing key \"base\"");
  refuse("path: time.step_s", "path: time.step_ms", "bad.yaml:5: axis time.step_ms");
  refuse("[0.001, 0.002]", "[0.001, -1]", "bad.yaml:5: axis time.step_s");
  refuse("pipeline: swept", "pipeline: swep", "swep");
  refuse("quantity: depth, tolerance: 0.1mm", "quantity: shape, tolerance: 0.1mm", "shape needs snapshots");
  refuse("quantity: depth, tolerance: 0.1mm", "quantity: force, tolerance: 2%", "force needs a law");
  refuse("", "", "--max-error: ", {"--max-error", "depth=1"});
  refuse("", "", "does not judge shape", {"--max-error", "shape=1mm"});
  refuse("", "", "--shard", {"--shard", "3/2"});
  refuse("", "", "--shard", {"--shard", "1/2", "--budget-us", "10"});
  refuse("", "", "press.yaml is a file, expected a folder or a new name", {"-o", "press.yaml/below"});
  EXPECT_EQ(study({}, "missing.yaml").code, 2);
  for (const char* verb : {"sweep", "run"})
    EXPECT_NE(runFissure(folder_, {verb, "study.yaml"}).err.find("type: fissure study tradeoff study.yaml"),
              std::string::npos);
}

TEST_F(Tradeoff, TheFolderOfAnotherStudyIsLeftAlone) {
  ASSERT_EQ(study({"-o", "mine"}).code, 0);
  std::string other = study_text;
  folder_.write("other.yaml", other.replace(other.find("press_study"), 11, "other"));
  const std::string before = folder_.read("mine/settings.yaml");
  EXPECT_EQ(study({"-o", "mine"}, "other.yaml").code, 2);
  EXPECT_EQ(folder_.read("mine/settings.yaml"), before);
}

TEST_F(Tradeoff, TheStudiesOfConfigsAreSound) {
  for (const char* name : {"tradeoff_quick", "tradeoff_shell_quick", "tradeoff_shell"}) {
    std::string file = FISSURE_SOURCE_DIR "/configs/studies/";
    file += name;
    file += ".yaml";
    const Outcome outcome = study({"--dry-run"}, file);
    EXPECT_EQ(outcome.code, 0) << name << ": " << outcome.err;
    EXPECT_NE(outcome.out.find("settings: "), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace fissure::programs::study_tradeoff_test
