#include "contact/node_contact.h"
#include "engine/after_solve_pipeline.h"

namespace fissure {

namespace {

NodeContactSettings contactSettings(const PipelineContext& context) {
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
class NodePipeline : public AfterSolvePipeline<NodeContact> {
 public:
  explicit NodePipeline(const PipelineContext& context)
      : AfterSolvePipeline(context, contactSettings(context)) {}

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
            {"report", times.report_s},
            {"transfer", transfer_s_}};
  }
};

}  // namespace

std::unique_ptr<Pipeline> makeNodePipeline(const PipelineContext& context) {
  return std::make_unique<NodePipeline>(context);
}

}  // namespace fissure
