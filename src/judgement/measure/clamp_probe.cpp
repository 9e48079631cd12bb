#include <algorithm>
#include <optional>

#include "measure/probe_makers.h"
#include "measure/statistics.h"

namespace fissure {

namespace {

/// What a hand at a clamp would feel: series clamp_force(law, clamp, xyz) and clamp_reaction(clamp, xyz), the
/// resultants of both jaws (paper, Fig. 5), and how far the clamps are open, jaw_opening(clamp) in metres or
/// jaw_angle(clamp) in degrees, each only where a clamp of that kind is, NaN for others. Scalars, each with
/// the clamp's name before it: max_resultant_<law>_N, left_max_force_<law>_N and right_max_force_<law>_N, the
/// largest magnitudes; final_reaction_N, that of the resultant reaction at the end, where the engine says it.
class ClampProbe : public Probe {
 public:
  ClampProbe(const Scenario& scenario, const Scene& scene);

  void declare(RecordLayout& layout) override;
  void sample(const State& state, RecordRow& row) override;
  void summarize(Summary& summary) const override;

 private:
  struct Largest {
    RunningMax resultant_N, left_N, right_N;
  };
  void sampleForces(const State& state, RecordRow& row);

  std::vector<SceneClamp> clamps_;
  std::vector<std::string> laws_;
  std::size_t tools_;
  std::vector<Largest> largest_;                          ///< law x number of clamps + clamp
  std::vector<std::optional<double>> final_reactions_N_;  ///< no value: the engine does not say
  std::size_t force_column_ = 0;
  std::size_t reaction_column_ = 0;
  std::optional<std::size_t> opening_column_, angle_column_;  ///< where a clamp of that kind is
};

}  // namespace

ClampProbe::ClampProbe(const Scenario& scenario, const Scene& scene)
    : clamps_(scene.clamps),
      tools_(scene.tools.size()),
      largest_(scenario.force.size() * scene.clamps.size()),
      final_reactions_N_(scene.clamps.size()) {
  for (const ForceSettings& law : scenario.force) laws_.push_back(law.name);
}

void ClampProbe::declare(RecordLayout& layout) {
  RecordAxis clamp_axis{"clamp", {}};
  for (const SceneClamp& clamp : clamps_) clamp_axis.labels.push_back(clamp.name);
  layout.addAxis(clamp_axis);
  layout.addAxis(xyzAxis());
  if (!laws_.empty()) {
    layout.addAxis({"law", laws_});
    force_column_ = layout.add({.name = "clamp_force",
                                .units = "N",
                                .long_name = "force on both jaws of each clamp, scene frame",
                                .axes = {"law", "clamp", "xyz"}});
  }
  reaction_column_ = layout.add({.name = "clamp_reaction",
                                 .units = "N",
                                 .long_name = "constraint reaction on both jaws of each clamp, scene frame",
                                 .axes = {"clamp", "xyz"}});
  const auto any = [&](bool hinged) {
    return std::any_of(clamps_.begin(), clamps_.end(),
                       [&](const SceneClamp& clamp) { return clamp.hinged == hinged; });
  };
  if (any(false))
    opening_column_ = layout.add({.name = "jaw_opening",
                                  .units = "m",
                                  .long_name = "way by which each clamp's parallel jaws are open",
                                  .axes = {"clamp"}});
  if (any(true))
    angle_column_ = layout.add({.name = "jaw_angle",
                                .units = "degree",
                                .long_name = "angle by which each clamp's hinged jaws are open",
                                .axes = {"clamp"}});
}

void ClampProbe::sample(const State& state, RecordRow& row) {
  const bool known = !state.contact.tool_reactions_N.empty();
  for (std::size_t c = 0; c < clamps_.size(); ++c) {
    const SceneClamp& clamp = clamps_[c];
    if (opening_column_) row[*opening_column_ + c] = clamp.hinged ? kMissing : state.clamps[c].opening;
    if (angle_column_) row[*angle_column_ + c] = clamp.hinged ? state.clamps[c].opening : kMissing;
    const Vec3 reaction_N = known ? Vec3(state.contact.tool_reactions_N[clamp.left_tool] +
                                         state.contact.tool_reactions_N[clamp.right_tool])
                                  : Vec3(Vec3::Constant(kMissing));
    writeVector(reaction_N, reaction_column_ + 3 * c, row);
    final_reactions_N_[c] = known ? std::optional(reaction_N.norm()) : std::nullopt;
  }
  sampleForces(state, row);
}

void ClampProbe::sampleForces(const State& state, RecordRow& row) {
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    for (std::size_t c = 0; c < clamps_.size(); ++c) {
      const std::size_t at = law * clamps_.size() + c;
      const Vec3& left_N = state.tool_forces_N[law * tools_ + clamps_[c].left_tool];
      const Vec3& right_N = state.tool_forces_N[law * tools_ + clamps_[c].right_tool];
      writeVector(left_N + right_N, force_column_ + 3 * at, row);
      largest_[at].resultant_N.add((left_N + right_N).norm());
      largest_[at].left_N.add(left_N.norm());
      largest_[at].right_N.add(right_N.norm());
    }
  }
}

void ClampProbe::summarize(Summary& summary) const {
  for (std::size_t c = 0; c < clamps_.size(); ++c) {
    const std::string name = clamps_[c].name + "_";
    for (std::size_t law = 0; law < laws_.size(); ++law) {
      const Largest& largest = largest_[law * clamps_.size() + c];
      const auto add = [&](const char* what, const RunningMax& max_N) {
        summary.push_back({name + what + "_" + laws_[law] + "_N", max_N.value(), true});
      };
      add("max_resultant", largest.resultant_N);
      add("left_max_force", largest.left_N);
      add("right_max_force", largest.right_N);
    }
    if (final_reactions_N_[c]) summary.push_back({name + "final_reaction_N", *final_reactions_N_[c]});
  }
}

std::unique_ptr<Probe> makeClampProbe(const Scenario& scenario, const Scene& scene) {
  return std::make_unique<ClampProbe>(scenario, scene);
}

}  // namespace fissure
