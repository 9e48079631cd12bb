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

/// A contact method on plain arrays: what a pipeline of ours does to tissue that an engine has moved,
/// whatever engine that is. One object belongs to one run.
class ContactMethod {
 public:
  virtual ~ContactMethod() = default;

  /// One step, after the engine's own solve: moves its positions_m and tool_bodies in place. inverse_masses:
  /// one per vertex in 1/kg, 0: fixed. Fills `patch` and all of `outcome` but vertex_contact, which the patch
  /// has.
  virtual void step(const StepView& step, std::span<const double> inverse_masses, ContactOutcome& outcome,
                    ContactPatch& patch) = 0;
  /// Whether contacts push tools that are bodies; where not, all are led.
  virtual bool pushesTools() const { return false; }
  /// The share of each vertex's displacement in the last step that changes its velocity; empty: none does.
  virtual std::span<const Vec3> motion_m() const = 0;
  /// Counts over the run, for the summary.
  virtual Summary counters() const = 0;
  virtual std::vector<StageTime> stageTimes() const = 0;
};

/// Of the bodies, in their order: how far in front of a tool contacts hold them.
std::vector<double> marginsOf(const Scenario& scenario);

/// What a contact method is made from; read while it is made.
struct ContactMethodContext {
  const Scenario& scenario;  ///< with one tool for each of the scene
  const PipelineSettings& settings;
  const Scene& scene;
  Precision precision = Precision::f64;  ///< of the engine's positions
};

/// The method of a pipeline: of nodes, of surfaces, or of vertices that stick to box tools. Throws
/// std::invalid_argument where the pipeline's contacts are Bullet's own.
std::unique_ptr<ContactMethod> makeContactMethod(const ContactMethodContext& context);

}  // namespace fissure
