#include "contact/swept_contact.h"
#include "engine/after_solve_pipeline.h"
#include "engine/simulation.h"

namespace fissure {

namespace {

SweptContactSettings sweptSettings(const PipelineContext& context) {
  SweptContactSettings settings{.rounds = context.settings.rounds,
                                .sweeps = context.settings.sweeps,
                                .max_displacement_m = context.settings.max_displacement_m,
                                .margins_m = {},
                                .time_scales = {},
                                .body_frictions = {},
                                .tool_frictions = {},
                                .ground = halfSpaceOf(context),
                                .single_precision = enginePrecision() == Precision::f32};
  fillBodies(context.scenario, settings);
  return settings;
}

/// Swept contact (METHOD section 9), with the ground as one more obstacle.
class SweptPipeline : public AfterSolvePipeline<SweptContact> {
 public:
  explicit SweptPipeline(const PipelineContext& context)
      : AfterSolvePipeline(context, sweptSettings(context)) {}

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
            {"report", times.report_s},
            {"transfer", transfer_s_}};
  }
};

}  // namespace

std::unique_ptr<Pipeline> makeSweptPipeline(const PipelineContext& context) {
  return std::make_unique<SweptPipeline>(context);
}

}  // namespace fissure
