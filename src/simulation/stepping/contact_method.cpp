#include "stepping/contact_method.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "contact/node_contact.h"
#include "contact/swept_contact.h"
#include "stepping/sticking_method.h"

namespace fissure {

namespace {

/// What settings of a method say of bodies and tools.
template <class Settings>
void fillBodies(const Scenario& scenario, Settings& settings) {
  settings.margins_m = marginsOf(scenario);
  for (const BodySettings& body : scenario.bodies) {
    settings.time_scales.push_back(body.timeScale());
    settings.body_frictions.push_back(body.friction());
  }
  const std::vector<ToolSettings>& tools = scenario.tools;
  if (std::any_of(tools.begin(), tools.end(), [](const ToolSettings& tool) { return tool.friction > 0; })) {
    for (const ToolSettings& tool : tools) settings.tool_frictions.push_back(tool.friction);
  }
}

/// The ground of a method that stands on its own; else none.
std::optional<HalfSpace> halfSpaceOf(const ContactMethodContext& context) {
  const std::optional<GroundSettings>& ground = context.scenario.ground;
  if (!ground || !context.settings.ownGround()) return std::nullopt;
  return HalfSpace{.point_m = Vec3(0, ground->height_m, 0), .friction = ground->friction};
}

NodeContactSettings nodeSettings(const ContactMethodContext& context) {
  NodeContactSettings settings{.association = context.settings.traits().association,
                               .vertex_contacts = context.settings.vertexContacts(),
                               .response = context.settings.contactResponse(),
                               .sweeps = context.settings.sweeps,
                               .ray_length_m = context.settings.ray_length_m,
                               .max_displacement_m = context.settings.max_displacement_m,
                               .margins_m = {},
                               .time_scales = {},
                               .body_frictions = {},
                               .tool_frictions = {},
                               .ground = halfSpaceOf(context)};
  fillBodies(context.scenario, settings);
  return settings;
}

/// The paper's method.
class NodeMethod : public ContactMethod {
 public:
  explicit NodeMethod(const ContactMethodContext& context) : contact_(context.scene, nodeSettings(context)) {}

  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch) override {
    contact_.step(step, inverse_masses, outcome, patch);
  }

  bool pushesTools() const override { return !contact_.motion_m().empty(); }
  std::span<const Vec3> motion_m() const override { return contact_.motion_m(); }

  Summary counters() const override {
    return {{"rays", contact_.rays()},
            {"ray_triangle_tests", contact_.rayTests()},
            {"displacement_sweeps", contact_.displacementCounts().sweeps},
            {"displacement_pushes", contact_.displacementCounts().pushes}};
  }

  std::vector<StageTime> stageTimes() const override {
    const ContactTimes& times = contact_.times();
    return {{"rays", times.rays_s},
            {"association", times.association_s},
            {"vertex_contacts", times.vertex_contacts_s},
            {"displacement", times.displacement_s},
            {"report", times.report_s}};
  }

 private:
  NodeContact contact_;
};

SweptContactSettings sweptSettings(const ContactMethodContext& context) {
  SweptContactSettings settings{.rounds = context.settings.rounds,
                                .sweeps = context.settings.sweeps,
                                .max_displacement_m = context.settings.max_displacement_m,
                                .margins_m = {},
                                .time_scales = {},
                                .body_frictions = {},
                                .tool_frictions = {},
                                .ground = halfSpaceOf(context),
                                .single_precision = context.precision == Precision::f32};
  fillBodies(context.scenario, settings);
  return settings;
}

/// Swept contact (contact/METHOD.md 8), with the ground as one more obstacle.
class SweptMethod : public ContactMethod {
 public:
  explicit SweptMethod(const ContactMethodContext& context)
      : contact_(context.scene, sweptSettings(context)) {}

  void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
            ContactPatch& patch) override {
    contact_.step(step, inverse_masses, outcome, patch);
  }

  bool pushesTools() const override { return true; }
  std::span<const Vec3> motion_m() const override { return contact_.motion_m(); }

  Summary counters() const override {
    return {{"displacement_sweeps", contact_.displacementCounts().sweeps},
            {"displacement_pushes", contact_.displacementCounts().pushes},
            {"rounds", contact_.rounds()},
            {"truncated_steps", contact_.truncationCounts().steps},
            {"truncated_vertices", contact_.truncationCounts().vertices},
            {"no_room_steps", contact_.truncationCounts().no_room_steps},
            {"freeing_steps", contact_.freeingSteps()}};
  }

  std::vector<StageTime> stageTimes() const override {
    const SweptTimes& times = contact_.times();
    return {{"search", times.search_s},
            {"displacement", times.displacement_s},
            {"truncation", times.truncation_s},
            {"report", times.report_s}};
  }

 private:
  SweptContact contact_;
};

}  // namespace

std::vector<double> marginsOf(const Scenario& scenario) {
  std::vector<double> margins_m;
  for (const BodySettings& body : scenario.bodies) margins_m.push_back(body.margin_m);
  return margins_m;
}

std::unique_ptr<ContactMethod> makeContactMethod(const ContactMethodContext& context) {
  switch (context.settings.traits().detection) {
    case ContactDetection::nodes:
      return std::make_unique<NodeMethod>(context);
    case ContactDetection::surface:
      return std::make_unique<SweptMethod>(context);
    case ContactDetection::sticking:
      return makeStickingMethod(context);
    default:
      throw std::invalid_argument("pipeline " + std::string(context.settings.traits().name) +
                                  " has no contact method of its own");
  }
}

}  // namespace fissure
