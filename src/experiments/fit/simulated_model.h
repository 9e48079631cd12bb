#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "fit/law_model.h"
#include "fit/match_by.h"
#include "scenario/forces.h"
#include "store/force_inputs.h"
#include "store/result_file.h"

namespace fissure {

/// What the force laws of one simulation saw, and where its first tool was.
struct SimulatedRun {
  ForceInputs inputs;
  std::vector<ForceSettings> laws;  ///< of its scenario
  /// Way of the first tool since the first step in which it met tissue, straight; 0 before. One a step.
  std::vector<double> way_m;
};

/// The name of the only run of a result. Throws InputError where it has several.
std::string onlyRun(const ResultInfo& info, const std::filesystem::path& file);

/// Reads a run of a result, the only one for an empty name. Throws InputError when there is no such run, or
/// it was not recorded with `record: {force_inputs: true}`.
SimulatedRun readSimulatedRun(const std::filesystem::path& file, const std::string& run);

/// A law summed over the triangles of a simulation, at the points of a measured curve.
struct SimulatedFit {
  std::unique_ptr<LawModel> model;
  MeasuredCurve curve;    ///< its points that the simulation reaches; a warning counts the others
  std::string rate_note;  ///< where depths are matched: measured and simulated rates differ; empty: no
};

/// Forces between two steps are interpolated linearly. The triangles are seen as the scenario's first law of
/// this model sees them (its deformation, rate and per_area), or as its first law where there is none. Rates
/// are the simulation's: where depths are matched the model has none unless the curve has some
/// (rateScale_m_s() is 0 then), and a note says where their typical values differ by more than a factor of
/// two. Throws InputError, without a file, when the curve has no times or depths, or the simulation reaches
/// none.
SimulatedFit makeSimulatedFit(ForceModel law, const SimulatedRun& run, const MeasuredCurve& curve,
                              MatchBy by);

}  // namespace fissure
