#include "explicit/elastic_model.h"

#include <sstream>
#include <stdexcept>

#include "base/error.h"
#include "explicit/substep_plan.h"

namespace fissure {

namespace {

ElasticMaterial materialOf(const ElasticSettings& settings) {
  return {.model = settings.material == ElasticMaterialKind::neo_hookean ? MaterialModel::neo_hookean
                                                                         : MaterialModel::linear_corotated,
          .youngs_modulus_Pa = settings.youngs_modulus_Pa,
          .poissons_ratio = settings.poissons_ratio,
          .density_kg_m3 = settings.density_kg_m3,
          .viscosity_Pa_s = settings.viscosity_Pa_s,
          .mass_damping_1_s = settings.mass_damping_1_s};
}

}  // namespace

ElasticTissue makeTissue(const BodySettings& settings, const SceneBody& body, const Vec3& gravity_m_s2) {
  const SceneVolume& volume = body.volume.value();
  return {volume.mesh, materialOf(settings.elastic), volume.fixed_vertices,
          static_cast<int>(body.rest.vertices_m.size()), gravity_m_s2};
}

SubstepPlan planSubsteps(const BodySettings& settings, const SceneBody& body, double step_s) {
  try {
    ElasticTissue tissue = makeTissue(settings, body, Vec3::Zero());
    const double critical_step_s = tissue.criticalStep_s();
    const double most_s = ElasticTissue::kMostSubsteps * ElasticTissue::kStepSafety * critical_step_s;
    if (!(step_s < most_s)) {
      std::ostringstream text;
      text << "a step of " << step_s << " s needs more than " << ElasticTissue::kMostSubsteps
           << " substeps: the fastest vibration of the mesh allows " << critical_step_s
           << " s, expected a softer, less viscous or coarser body, or a shorter step";
      throw std::invalid_argument(text.str());
    }
    return {.tetrahedra = body.volume->mesh.tetrahedra.size(),
            .critical_step_s = critical_step_s,
            .substeps = tissue.substepsFor(step_s)};
  } catch (const std::invalid_argument& error) {
    throw InputError("bodies." + settings.name + ".elastic: " + error.what());
  }
}

}  // namespace fissure
