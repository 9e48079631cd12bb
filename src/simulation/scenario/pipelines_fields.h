#pragma once

#include <string>

#include "scenario/catalog.h"
#include "scenario/pipelines.h"

namespace fissure {

// The keys of an entry of `pipelines:` (scenario/fields.h says how keys are described).

template <class Io>
void describe(Io& io, DeformableSolver& s) {
  io.field("substeps", s.substeps);
  io.field("implicit", s.implicit);
  io.field("line_search", s.line_search);
  io.field("projection", s.projection);
  io.field("newton_iterations", s.newton_iterations);
  io.field("newton_tolerance", s.newton_tolerance);
  io.field("krylov_iterations", s.krylov_iterations);
  io.field("krylov_tolerance", s.krylov_tolerance);
  io.field("contact_iterations", s.contact_iterations);
  io.field("contact_tolerance", s.contact_tolerance);
  io.field("split_impulse", s.split_impulse);
  io.field("error_reduction", s.error_reduction);
  io.field("max_error_reduction_m_s", s.max_error_reduction_m_s);
  io.field("constraint_mixing", s.constraint_mixing);
}

template <class Io>
void describe(Io& io, PipelineSettings& p) {
  io.nameOr("name", p.name, "pipeline");
  io.requiredChoice("pipeline", p.pipeline, catalog().pipelines);
  io.choice("precision", p.precision, catalog().precisions);
  using enum ContactDetection;
  const bool rays = p.usesNodes();
  const std::string with_bullet = pipelinesWith({sdf, clusters, volume}),
                    with_volume = pipelinesWith({volume}), with_sdf = pipelinesWith({sdf}),
                    with_voxels = with_sdf + ", or " + with_volume + " with contacts nodes",
                    with_rays = pipelinesWith({nodes}), with_ours = pipelinesWith({nodes, surface}),
                    with_surface = pipelinesWith({surface});
  const char *sdf_only = with_sdf.c_str(), *rays_only = with_rays.c_str(), *ours_only = with_ours.c_str(),
             *swept_only = with_surface.c_str();
  io.choiceIf(p.usesSdf() || p.usesClusters() || p.usesVolume(), with_bullet.c_str(), "settings", p.settings,
              catalog().settings);
  io.choiceIf(p.usesVolume(), with_volume.c_str(), "contacts", p.contacts, catalog().deformable_contacts);
  io.fieldIf(p.hasVoxels(), with_voxels.c_str(), "sdf_voxel_m", p.sdf_voxel_m);
  io.fieldIf(p.usesSdf(), sdf_only, "kinematic_hardness", p.kinematic_hardness);
  io.fieldIf(p.usesVolume(), with_volume.c_str(), "deformable", p.deformable);
  io.fieldIf(rays, rays_only, "ray_length_m", p.ray_length_m);
  io.fieldIf(rays, rays_only, "vertex_contacts", p.vertex_contacts);
  io.choiceIf(rays, rays_only, "response", p.response, catalog().responses);
  io.choiceIf(rays, rays_only, "ground_contact", p.ground_contact, catalog().ground_contacts);
  io.fieldIf(rays || p.usesSurface(), ours_only, "sweeps", p.sweeps);
  io.fieldIf(rays || p.usesSurface(), ours_only, "max_displacement_m", p.max_displacement_m);
  io.fieldIf(p.usesSurface(), swept_only, "rounds", p.rounds);
  io.field("time_limit_s", p.time_limit_s);
}

}  // namespace fissure
