#include "stepping/elastic_model.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "base/error.h"
#include "elastic/stiff_elements.h"
#include "stepping/substep_plan.h"

namespace fissure {

namespace {

MaterialModel modelOf(ElasticMaterialKind kind) {
  switch (kind) {
    case ElasticMaterialKind::neo_hookean:
      return MaterialModel::neo_hookean;
    case ElasticMaterialKind::linear_corotated:
      return MaterialModel::linear_corotated;
    case ElasticMaterialKind::saint_venant_kirchhoff:
      return MaterialModel::saint_venant_kirchhoff;
  }
  throw std::invalid_argument("no such material of elastic bodies");
}

ElasticMaterial materialOf(const ElasticSettings& settings) {
  return {.model = modelOf(settings.material),
          .youngs_modulus_Pa = settings.youngs_modulus_Pa,
          .poissons_ratio = settings.poissons_ratio,
          .density_kg_m3 = settings.density_kg_m3,
          .viscosity_Pa_s = settings.viscosity_Pa_s,
          .mass_damping_1_s = settings.mass_damping_1_s};
}

/// The material of the body, followed by those of its regions.
ElementMaterials materialsOf(const ElasticSettings& elastic, const SceneVolume& volume) {
  ElementMaterials materials = {{materialOf(elastic)}, volume.regions};
  for (const ElasticRegion& region : elastic.regions)
    materials.materials.push_back(materialOf(elastic.materialOf(region)));
  return materials;
}

/// The body at rest and without weight. Throws std::invalid_argument where steps of `step_s` need too many
/// substeps.
ElasticTissue makeTissueFor(const BodySettings& settings, const SceneBody& body, double step_s) {
  ElasticTissue tissue = makeTissue(settings, body, Vec3::Zero());
  const double critical_step_s = tissue.criticalStep_s();
  const double most_s = ElasticTissue::kMostSubsteps * ElasticTissue::kStepSafety * critical_step_s;
  if (step_s < most_s) return tissue;
  std::ostringstream text;
  text << "a step of " << step_s << " s needs more than " << ElasticTissue::kMostSubsteps
       << " substeps: the fastest vibration of the mesh allows " << critical_step_s
       << " s, expected a softer, less viscous or coarser body, or a shorter step";
  throw std::invalid_argument(text.str());
}

}  // namespace

ElasticTissue makeTissue(const BodySettings& settings, const SceneBody& body, const Vec3& gravity_m_s2) {
  const SceneVolume& volume = body.volume.value();
  return {volume.mesh, materialsOf(settings.elastic, volume), volume.fixed_vertices,
          static_cast<int>(body.rest.vertices_m.size()), gravity_m_s2};
}

void checkSubsteps(const BodySettings& settings, const SceneBody& body, double step_s) {
  try {
    makeTissueFor(settings, body, step_s);
  } catch (const std::invalid_argument& error) {
    throw InputError("bodies." + settings.name + ".elastic: " + error.what());
  }
}

SubstepPlan planSubsteps(const BodySettings& settings, const SceneBody& body, double step_s) {
  try {
    ElasticTissue tissue = makeTissueFor(settings, body, step_s);
    SubstepPlan plan = {.tetrahedra = body.volume->mesh.tetrahedra.size(),
                        .critical_step_s = tissue.criticalStep_s(),
                        .substeps = tissue.substepsFor(step_s),
                        .regions = {}};
    const ElementMaterials materials = materialsOf(settings.elastic, *body.volume);
    const std::vector<int> stiff = stiffestElements(body.volume->mesh, materials);
    ElasticTissue without(body.volume->mesh, softened(materials, body.volume->mesh, stiff),
                          body.volume->fixed_vertices, 0, Vec3::Zero());
    plan.stiffest = stiff.size();
    for (const int v : body.volume->mesh.tetrahedra[static_cast<std::size_t>(stiff.front())])
      plan.stiffest_m += body.volume->mesh.vertices_m[static_cast<std::size_t>(v)] / 4;
    plan.substeps_without_stiffest = without.substepsFor(step_s);
    const std::vector<int>& regions = body.volume->regions;
    for (const ElasticRegion& region : settings.elastic.regions) {
      const auto number = static_cast<int>(plan.regions.size()) + 1;
      plan.regions.push_back({static_cast<std::size_t>(std::count(regions.begin(), regions.end(), number)),
                              tissue.criticalStepOf_s(materialOf(settings.elastic.materialOf(region)))});
    }
    return plan;
  } catch (const std::invalid_argument& error) {
    throw InputError("bodies." + settings.name + ".elastic: " + error.what());
  }
}

}  // namespace fissure
