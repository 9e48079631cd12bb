#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/record.h"
#include "base/scene.h"
#include "base/stage_times.h"
#include "base/state.h"
#include "contact/contact_patch.h"
#include "contact/step_view.h"
#include "scenario/scenario.h"

namespace fissure {

/// A contact method on plain arrays: it corrects the positions of tissue after any engine has moved it. One
/// object belongs to one run.
class ContactMethod {
 public:
  virtual ~ContactMethod() = default;

  /// One step, after the engine's own solve: moves the step's positions_m and tool_bodies in place.
  /// inverse_masses: [vertex] 1/kg, 0: fixed. Fills `patch` and all of `outcome` except vertex_contact, which
  /// is in the patch.
  virtual void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
                    ContactPatch& patch) = 0;
  /// Whether contacts can push tools with a mass (StepView::tool_bodies).
  virtual bool pushesTools() const { return false; }
  /// [vertex] part of its displacement in the last step that changes its velocity; empty: none does.
  virtual std::span<const Vec3> motion_m() const = 0;
  /// Counts over the run, for the summary.
  virtual Summary counters() const = 0;
  /// Wall time of its stages so far.
  virtual std::vector<StageTime> stageTimes() const = 0;
};

/// [body] distance at which contacts hold it in front of a tool, metres.
std::vector<double> marginsOf(const Scenario& scenario);

/// Arguments of makeContactMethod(), which are used only during that call.
struct ContactMethodContext {
  const Scenario& scenario;  ///< with rigid tools, one per tool of the scene
  const PipelineSettings& settings;
  const Scene& scene;
  Precision precision = Precision::f64;  ///< precision of the engine's positions
};

/// Makes the contact method of a pipeline: NodeContact, SweptContact or the sticking method. Throws
/// std::invalid_argument where the pipeline's contacts are Bullet's own.
std::unique_ptr<ContactMethod> makeContactMethod(const ContactMethodContext& context);

}  // namespace fissure
