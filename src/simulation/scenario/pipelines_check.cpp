#include "scenario/checker.h"

namespace fissure {

namespace {

void checkSolver(Checker check, const DeformableSolver& solver) {
  const auto whole = [&](const char* key, const std::optional<int>& value, int most) {
    if (value) check.between(key, *value, 1, most);
  };
  const auto share = [&](const char* key, const std::optional<double>& value) {
    if (value) check.between(key, *value, 0, 1);
  };
  const auto tolerance = [&](const char* key, const std::optional<double>& value) {
    if (value) check.notNegative(key, *value);
  };
  whole("substeps", solver.substeps, 10000);
  whole("newton_iterations", solver.newton_iterations, 1000);
  tolerance("newton_tolerance", solver.newton_tolerance);
  whole("krylov_iterations", solver.krylov_iterations, 100000);
  tolerance("krylov_tolerance", solver.krylov_tolerance);
  whole("contact_iterations", solver.contact_iterations, 10000);
  tolerance("contact_tolerance", solver.contact_tolerance);
  share("error_reduction", solver.error_reduction);
  if (solver.max_error_reduction_m_s)
    check.positive("max_error_reduction_m_s", *solver.max_error_reduction_m_s);
  share("constraint_mixing", solver.constraint_mixing);
}

}  // namespace

void checkPipeline(Checker check, const PipelineSettings& pipeline) {
  if (pipeline.sdf_voxel_m) check.positive("sdf_voxel_m", *pipeline.sdf_voxel_m);
  if (pipeline.kinematic_hardness) check.between("kinematic_hardness", *pipeline.kinematic_hardness, 0, 1);
  checkSolver(check.in("deformable"), pipeline.deformable);
  if (pipeline.ray_length_m) check.positive("ray_length_m", *pipeline.ray_length_m);
  check.require(!pipeline.usesNodes() || !pipeline.ownGround() ||
                    pipeline.contactResponse() == ContactResponse::momentum,
                "ground_contact",
                "is half_space, expected bullet with response none, which carries no weight");
  check.between("sweeps", pipeline.sweeps, 1, 1000);
  check.between("rounds", pipeline.rounds, 0, 10);
  check.positive("max_displacement_m", pipeline.max_displacement_m);
  check.positive("time_limit_s", pipeline.time_limit_s);
}

}  // namespace fissure
