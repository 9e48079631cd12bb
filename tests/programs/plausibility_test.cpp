// What `validate`, `plan` and `run` warn of: what can be simulated, but is hardly meant.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "program.h"
#include "scenarios.h"

namespace fissure::programs::plausibility_test {
namespace {

namespace fs = std::filesystem;

struct Odd {
  const char* name;
  const char* from;
  const char* to;
  const char* warning;  ///< all of it after "s.yaml: warning: "
};

void PrintTo(const Odd& odd, std::ostream* stream) {
  *stream << odd.name;
}

class OddScenario : public testing::TestWithParam<Odd> {};

TEST_P(OddScenario, IsWarnedOf) {
  const Folder folder;
  const Odd& odd = GetParam();
  folder.write("s.yaml", with(pressScenario(), odd.from, odd.to));
  const Outcome outcome = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string line = "s.yaml: warning: " + std::string(odd.warning) + "\n";
  EXPECT_NE(outcome.out.find(line), std::string::npos) << outcome.out << "expected: " << line;
  EXPECT_NE(runFissure(folder, {"plan", "s.yaml"}).out.find("  warning: " + std::string(odd.warning)),
            std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, OddScenario,
    testing::Values(
        Odd{"a_tool_in_millimetres", "size_m: [0.04, 0.002, 0.015]", "size_m: [20, 2, 15]",
            "tools.spatula.shape: a tool of 20 m, expected 0.0001 m to 1 m (lengths are in metres)"},
        Odd{"a_tiny_tool", "size_m: [0.04, 0.002, 0.015]", "size_m: [4e-5, 2e-6, 1e-5]",
            "tools.spatula.shape: a tool of 4e-05 m, expected 0.0001 m to 1 m (lengths are in metres)"},
        Odd{"a_huge_body", "radius_m: 0.03", "radius_m: 30",
            "bodies.sphere.shape: a body of 60 m, expected 0.0001 m to 1 m (lengths are in metres)"},
        Odd{"a_wide_margin", "    mass_kg: 0.1", "    mass_kg: 0.1\n    margin_m: 0.25",
            "bodies.sphere.margin_m: the margin, 0.25 m, is larger than the body is thick, 0.06 m, expected "
            "a "
            "small part of that"},
        Odd{"a_margin_larger_than_the_tool", "    mass_kg: 0.1", "    mass_kg: 0.1\n    margin_m: 0.05",
            "bodies.sphere.margin_m: the margin, 0.05 m, is larger than tool spatula, 0.04 m, expected a "
            "small "
            "part of that"},
        Odd{"no_mass", "    mass_kg: 0.1\n", "",
            "bodies.sphere.mass_kg: is not given and is 0.1 kg whatever the body's size, expected the mass "
            "of "
            "the body"},
        Odd{"no_coefficients", "pipelines:", "force: [{name: hc, model: hunt_crossley, n: 1.3}]\npipelines:",
            "force.hc: coefficients are not given and are those of no tissue (k 200, lambda 50), expected "
            "them, "
            "or a tissue"},
        Odd{"a_start_in_tissue", "start_m: [0, 0.062, 0]", "start_m: [0, 0.055, 0]",
            "tools.spatula.motion: the tool starts inside tissue, up to 5.169 mm deep before anything moves, "
            "expected a start outside"},
        Odd{"a_path_in_millimetres", "move_to_m: [0, 0.052, 0], speed_m_s: 0.5",
            "move_to_m: [0, 52, 0], speed_m_s: 5000",
            "tools.spatula.motion: the tool travels over 51.94 m, expected at most 1 m (lengths are in "
            "metres)"},
        Odd{"a_bare_box", "shape: {type: sphere, radius_m: 0.03, subdivisions: 1}",
            "shape: {type: box, size_m: [0.06, 0.06, 0.06]}",
            "bodies.sphere.shape: a body of 12 triangles has nothing between its corners that tools could "
            "press "
            "in, expected finer ones (`cells`)"},
        Odd{"an_expectation_of_nothing",
            "pipelines:", "expect: [{quantity: max_penetration_dept_m, max: 1}]\npipelines:",
            "expect.0.quantity: run fukuhara will have no value \"max_penetration_dept_m\" and fail, did you "
            "mean \"max_penetration_depth_m\"?"},
        Odd{"an_expectation_without_certificate",
            "pipelines:", "expect: [{quantity: uncertified_steps, max: 0}]\npipelines:",
            "expect.0.quantity: run fukuhara will have no value \"uncertified_steps\" and fail, expected one "
            "of "
            "its summary"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(Plausibility, AnElasticBodyWithoutItsModulus) {
  const Folder folder;
  const std::string elastic = with(
      with(pressScenario("[{pipeline: swept}]"), "    mass_kg: 0.1\n", "    model: elastic\n"),
      "    material: {linear_stiffness: 0.5}\n"
      "    solver: {pose_matching: 0.02, damping: 0.01, dynamic_friction: 0.5, position_iterations: 10}\n",
      "");
  folder.write("s.yaml", elastic);
  EXPECT_EQ(
      runFissure(folder, {"validate", "s.yaml"}).out,
      "s.yaml: ok\ns.yaml: warning: bodies.sphere.elastic.youngs_modulus_Pa: is not given and is 10000 Pa, "
      "expected the modulus of the tissue, or a preset\n");
  folder.write("s.yaml", with(elastic, "model: elastic\n", "model: elastic\n    elastic: {preset: liver}\n"));
  EXPECT_EQ(runFissure(folder, {"validate", "s.yaml"}).out, "s.yaml: ok\n");
}

TEST(Plausibility, RunWarnsBeforeItStarts) {
  const Folder folder;
  folder.write("s.yaml", with(pressScenario(), "    mass_kg: 0.1\n", ""));
  const Outcome outcome = runFissure(folder, {"run", "s.yaml"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.err.starts_with("s.yaml: warning: bodies.sphere.mass_kg: ")) << outcome.err;
  folder.write("s.yaml", pressScenario());
  EXPECT_EQ(runFissure(folder, {"run", "s.yaml", "--force"}).err, "");
}

// What a summary really has is never called missing.
TEST(Plausibility, EveryValueOfASummaryCanBeExpected) {
  const Folder folder;
  std::string text = fullScenario(
      "[{pipeline: default}, {pipeline: cluster}, {pipeline: raycast}, {pipeline: fukuhara}, {pipeline: "
      "swept}]");
  folder.write("s.yaml", text);
  const Outcome run = runFissure(folder, {"run", "s.yaml", "-o", "s.h5", "--no-frames", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  std::string expectations = "expect:\n";
  std::string name;
  std::size_t count = 0;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) {
    const auto between = [&](const std::string& before) {
      const std::size_t at = line.find(before);
      return at == std::string::npos
                 ? std::string()
                 : line.substr(at + before.size(), line.find('"', at + before.size()) - at - before.size());
    };
    if (line.starts_with("          \"name\": \"")) name = between("\"name\": \"");
    if (!line.starts_with("            \"") || name.empty()) continue;
    const std::string quantity = between("            \"");
    if (quantity.starts_with("timing/") || quantity.starts_with("provenance/")) continue;
    expectations += "  - {pipeline: " + name + ", quantity: " + quantity + ", max: 1}\n";
    ++count;
  }
  EXPECT_GT(count, 150u);
  folder.write("s.yaml", text + expectations);
  const Outcome validated = runFissure(folder, {"validate", "s.yaml"});
  EXPECT_EQ(validated.code, 0) << validated.err;
  EXPECT_EQ(validated.out.find("expect."), std::string::npos) << validated.out;
}

TEST(Plausibility, ValidateRefusesSamplesThatNoRunCouldTake) {
  const Folder folder;
  folder.write("s.yaml",
               pressScenario("[{pipeline: fukuhara}]", "0.03", "measure: {sample_spacing_m: 1e-7}\n"));
  for (const char* verb : {"validate", "plan", "run"}) {
    const Outcome outcome = runFissure(folder, {verb, "s.yaml"});
    EXPECT_EQ(outcome.code, 2) << verb;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
    EXPECT_NE(outcome.err.find("s.yaml: measure.sample_spacing_m: too fine for tool 'spatula'"),
              std::string::npos)
        << outcome.err;
  }
}

// In configs/ every warning is right: scenes that are odd on purpose say so in their comments.
TEST(Plausibility, ScenariosOfTheHouseAreWarnedOfWhatTheyShow) {
  const Folder folder;
  std::vector<std::string> words = {"validate"};
  const fs::path configs = fs::path(FISSURE_SOURCE_DIR) / "configs";
  for (const char* of : {"", "fixtures", "templates", "sweeps/scenes"})
    for (const auto& entry : fs::directory_iterator(configs / of)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".yaml" && !(of == std::string("templates") && name == "sweep.yaml"))
        words.push_back(entry.path().string());
    }
  EXPECT_GT(words.size(), 50u);
  const Outcome outcome = runFissure(folder, words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::vector<std::string> warned;
  for (std::string line; std::getline(lines, line);)
    if (line.find(": warning: ") != std::string::npos && line.find(".nodes") == std::string::npos)
      warned.push_back(line.substr(configs.string().size() + 1));
  EXPECT_EQ(warned,
            std::vector<std::string>{
                "fixtures/starts_inside.yaml: warning: tools.blade.motion: the tool starts inside tissue, "
                "up to 3.959 mm deep before anything moves, expected a start outside"});
}

// An exponent below 1 is said only where the law pushes the tool.
TEST(Plausibility, AnExponentBelowOneAndACoupledTool) {
  const Folder folder;
  const std::string laws = "force: [{name: hc, model: hunt_crossley, k: 20, lambda: 1, n: 0.5}]\n";
  const std::string coupled =
      with(pressScenario("[{pipeline: fukuhara}]", "0.03", laws), "    motion:\n",
           "    coupling: {mass_kg: 0.05, stiffness_N_m: 500, damping_N_s_m: 5, force: hc}\n"
           "    motion:\n");
  folder.write("free.yaml", pressScenario("[{pipeline: fukuhara}]", "0.03", laws));
  folder.write("coupled.yaml", coupled);
  folder.write("linear.yaml", with(coupled, ", n: 0.5", ", n: 1"));
  const std::string warning =
      "warning: force.hc.n: is 0.5: where contact begins the law's stiffness, k n x^(n-1), has no bound, and "
      "a tool "
      "that feels it one step late chatters at any step, expected at least 1 for a law that pushes a coupled "
      "tool\n";
  EXPECT_NE(runFissure(folder, {"validate", "coupled.yaml"}).out.find(warning), std::string::npos);
  for (const char* file : {"free.yaml", "linear.yaml"})
    EXPECT_EQ(runFissure(folder, {"validate", file}).out.find("force.hc.n"), std::string::npos) << file;
}

}  // namespace
}  // namespace fissure::programs::plausibility_test
