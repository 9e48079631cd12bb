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

/// The arguments of the force laws in one simulation, and the displacement of its first tool.
struct SimulatedRun {
  ForceInputs inputs;
  std::vector<ForceSettings> laws;  ///< laws of its scenario
  /// [step] straight distance of the first tool from its position at first contact; 0 before.
  std::vector<double> way_m;
};

/// The name of the only run of a result. Throws InputError where it has several.
std::string onlyRun(const ResultInfo& info, const std::filesystem::path& file);

/// Reads a run of a result; an empty name stands for the only run. Throws InputError when there is no such
/// run, or it was not recorded with `record: {force_inputs: true}`.
SimulatedRun readSimulatedRun(const std::filesystem::path& file, const std::string& run);

/// The way of a tool since it first met tissue, per row, from its positions. `contact_s` is the time of that
/// step, which has no row of its own where rows are of one step in several (`record: {every}`): the position
/// then is interpolated. NaN: it is that of the first row with contact.
std::vector<double> waySinceContact(const std::vector<Vec3>& tool_m, const ForceInputs& inputs,
                                    double contact_s);

/// A law summed over the triangles of a simulation, as a model of a measured curve.
struct SimulatedFit {
  std::unique_ptr<LawModel> model;
  MeasuredCurve curve;  ///< the points that the simulation reaches; a warning has the number of others
  /// For matching by depth: note that measured and simulated rates differ; else empty.
  std::string rate_note;
};

/// Makes such a model. Forces between two steps are interpolated linearly. Deformation, rate and per_area are
/// those of the scenario's first law with this model, or of its first law where there is none. Rates are
/// those of the simulation. For matching by depth there are none unless the curve has rates (rateScale_m_s()
/// is then 0), and a note tells where their typical values differ by more than a factor of two. Throws
/// InputError, without a file, when the curve has no times or depths, or the simulation reaches none of them.
SimulatedFit makeSimulatedFit(ForceModel law, const SimulatedRun& run, const MeasuredCurve& curve,
                              MatchBy by);

}  // namespace fissure
