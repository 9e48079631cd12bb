#include "scenario/checker.h"

namespace fissure {

void checkPipeline(Checker check, const PipelineSettings& pipeline) {
  if (pipeline.sdf_voxel_m) check.positive("sdf_voxel_m", *pipeline.sdf_voxel_m);
  if (pipeline.kinematic_hardness) check.between("kinematic_hardness", *pipeline.kinematic_hardness, 0, 1);
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
