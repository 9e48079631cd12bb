#include "scenario_text.h"

namespace fissure::couplings_test {

namespace {

/// What is wrong with a tool of this coupling, or "nothing".
std::string complaint(const std::string& coupling, const std::string& more = "") {
  return inputError([&] {
    parseScenario(std::string(smallest_text) + "force: [{name: felt, model: linear_elastic}]\n" +
                      "tools:\n"
                      "  - name: blade\n"
                      "    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n" +
                      "    coupling: {" + coupling + "}\n" + more +
                      "    motion: {type: script, start_m: [0, 1, 0], segments: [{hold_s: 1}]}\n",
                  "s.yaml");
  });
}

void expectComplaint(const std::string& coupling, const std::string& message) {
  EXPECT_NE(complaint(coupling).find(message), std::string::npos) << complaint(coupling);
}

TEST(Couplings, NeedPositiveNumbersAndALaw) {
  EXPECT_EQ(complaint("mass_kg: 0.1, stiffness_N_m: 1, damping_N_s_m: 0, force: felt"), "nothing");
  expectComplaint("mass_kg: 0, stiffness_N_m: 1, damping_N_s_m: 0, force: felt",
                  "tools.blade.coupling.mass_kg is 0, expected a number above 0");
  expectComplaint("mass_kg: 1, stiffness_N_m: -2, damping_N_s_m: 0, force: felt",
                  "tools.blade.coupling.stiffness_N_m is -2, expected a number above 0");
  expectComplaint("mass_kg: 1, stiffness_N_m: 1, damping_N_s_m: -1, force: felt",
                  "tools.blade.coupling.damping_N_s_m is -1, expected a number of at least 0");
  expectComplaint("mass_kg: 1, stiffness_N_m: 1, damping_N_s_m: 1, force: nix",
                  "s.yaml:13: tools.blade.coupling.force is \"nix\", expected the name of an entry of force, "
                  "or reaction");
}

struct ReactionScenario {
  std::string pipelines = "{pipeline: swept}";
  std::string law = "felt";
  std::string time_scale = "1";
};

/// What is wrong with a tool that contacts push, or "nothing".
std::string reactionComplaint(const ReactionScenario& of) {
  return inputError([&] {
    parseScenario(
        "format: 1\nname: pushed\n"
        "bodies:\n  - name: ball\n    shape: {type: sphere, radius_m: 0.03}\n    solver: {time_scale: " +
            of.time_scale + "}\npipelines: [" + of.pipelines + "]\nforce: [{name: " + of.law +
            ", model: linear_elastic}]\n"
            "tools:\n  - name: blade\n    shape: {type: box, size_m: [0.04, 0.002, 0.015]}\n"
            "    coupling: {mass_kg: 1, stiffness_N_m: 1, damping_N_s_m: 1, force: reaction}\n"
            "    motion: {type: script, start_m: [0, 1, 0], segments: [{hold_s: 1}]}\n",
        "s.yaml");
  });
}

void expectReactionComplaint(const ReactionScenario& of, const std::string& message) {
  EXPECT_NE(reactionComplaint(of).find("tools.blade.coupling.force is reaction, but " + message),
            std::string::npos)
      << reactionComplaint(of);
}

TEST(Couplings, ByReactionNeedContactsThatPushTools) {
  expectReactionComplaint(
      {.pipelines = "{pipeline: default}"},
      "the contacts of run default push no tool, expected pipeline swept, or pipelines raycast and "
      "fukuhara with response momentum");
  expectReactionComplaint({.pipelines = "{pipeline: swept}, {pipeline: raycast}"},
                          "the contacts of run raycast push");
  expectReactionComplaint({.pipelines = "{pipeline: prescribed}"},
                          "the contacts of run prescribed push no tool");
  EXPECT_EQ(reactionComplaint({.pipelines = "{pipeline: raycast, response: momentum}, {pipeline: fukuhara}, "
                                            "{pipeline: swept}"}),
            "nothing");
}

TEST(Couplings, ByReactionAllowNoLawOfThatName) {
  expectReactionComplaint({.law = "reaction"},
                          "an entry of force has that name, expected another name for it");
}

TEST(Couplings, ByReactionNeedOneTimeForToolAndTissue) {
  expectReactionComplaint({.time_scale = "0.5"},
                          "bodies.ball.solver.time_scale is 0.5, expected 1: tool and tissue share one time");
}

TEST(Couplings, HaveNoDefaults) {
  expectComplaint("stiffness_N_m: 1, damping_N_s_m: 0, force: felt", "missing key \"mass_kg\"");
  expectComplaint("mass_kg: 1, damping_N_s_m: 0, force: felt", "missing key \"stiffness_N_m\"");
  expectComplaint("mass_kg: 1, stiffness_N_m: 1, force: felt", "missing key \"damping_N_s_m\"");
  expectComplaint("mass_kg: 1, stiffness_N_m: 1, damping_N_s_m: 0", "missing key \"force\"");
}

TEST(Couplings, AreNotForClamps) {
  EXPECT_NE(complaint("mass_kg: 1, stiffness_N_m: 1, damping_N_s_m: 1, force: felt",
                      "    clamp: {opening: parallel, jaw_position_m: [0.03, 0, 0]}\n")
                .find("is given for a clamp, expected a tool that does not open"),
            std::string::npos);
}

}  // namespace
}  // namespace fissure::couplings_test
