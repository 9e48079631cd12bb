#include "engine/deformable_body.h"

#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/reproducible.h"
#include "engine/convert.h"

namespace fissure {

namespace {

/// Coefficients of the stress, as Bullet's force of the material takes them.
struct Coefficients {
  double mu_Pa = 0;
  double lambda_Pa = 0;
};

Coefficients coefficientsOf(const ElasticSettings& settings) {
  const double ratio = settings.poissons_ratio;
  const double mu_Pa = settings.youngs_modulus_Pa / (2 * (1 + ratio));
  const double lambda_Pa = settings.youngs_modulus_Pa * ratio / ((1 + ratio) * (1 - 2 * ratio));
  if (settings.material == ElasticMaterialKind::linear_corotated) return {mu_Pa, lambda_Pa};
  return {mu_Pa * 4 / 3, lambda_Pa + mu_Pa * 5 / 6};
}

btScalar scalar(double value) {
  return static_cast<btScalar>(value);
}

std::vector<double> lumpedMasses(const TetrahedralMesh& mesh, double density_kg_m3) {
  std::vector<double> masses_kg(mesh.vertices_m.size());
  for (const Tetrahedron& corners : mesh.tetrahedra) {
    const Vec3& a = mesh.vertices_m[corners[0]];
    const Vec3 b = mesh.vertices_m[corners[1]] - a, c = mesh.vertices_m[corners[2]] - a,
               d = mesh.vertices_m[corners[3]] - a;
    const double corner_kg = density_kg_m3 * b.dot(c.cross(d)) / 24;
    for (const int corner : corners) masses_kg[corner] += corner_kg;
  }
  return masses_kg;
}

/// Free vertices in their order, then the fixed ones.
std::vector<int> nodesOf(std::size_t vertices, const std::vector<int>& fixed_vertices) {
  std::vector<char> fixed(vertices);
  for (const int vertex : fixed_vertices) fixed[vertex] = 1;
  std::vector<int> node_of_vertex(vertices);
  int next = 0;
  for (const char last : {0, 1})
    for (std::size_t v = 0; v < vertices; ++v)
      if (fixed[v] == last) node_of_vertex[v] = next++;
  return node_of_vertex;
}

void appendElements(btSoftBody& body, const SceneBody& scene_body, const std::vector<int>& node) {
  std::set<std::pair<int, int>> edges;
  const TetrahedralMesh& mesh = scene_body.volume->mesh;
  body.m_tetras.reserve(static_cast<int>(mesh.tetrahedra.size()));
  for (const Tetrahedron& t : mesh.tetrahedra) {
    body.appendTetra(node[t[0]], node[t[1]], node[t[2]], node[t[3]]);
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) {
        const auto edge = std::minmax(node[t[i]], node[t[j]]);
        if (edges.insert(edge).second) body.appendLink(edge.first, edge.second);
      }
  }
  for (const Face& face : scene_body.rest.faces) body.appendFace(node[face[0]], node[face[1]], node[face[2]]);
}

double energyDensity(const btSoftBody::TetraScratch& at, const Coefficients& law, ElasticMaterialKind kind) {
  if (kind == ElasticMaterialKind::linear_corotated) {
    const btMatrix3x3 stretch = at.m_corotation.transpose() * at.m_F;
    const btMatrix3x3 strain = (stretch + stretch.transpose()) * btScalar(0.5) - btMatrix3x3::getIdentity();
    const double trace = strain[0][0] + strain[1][1] + strain[2][2];
    const double square = strain[0].length2() + strain[1].length2() + strain[2].length2();
    return law.mu_Pa * square + 0.5 * law.lambda_Pa * trace * trace;
  }
  const double alpha = 1 + 0.75 * law.mu_Pa / law.lambda_Pa;
  const auto density = [&](double trace, double volume) {
    return 0.5 * law.mu_Pa * (trace - 3 - reproducible::log(trace + 1)) +
           0.5 * law.lambda_Pa * (volume - alpha) * (volume - alpha);
  };
  return density(at.m_trace, at.m_J) - density(3, 1);
}

}  // namespace

DeformableBody makeDeformableBody(btSoftBodyWorldInfo& world_info, const SceneBody& scene_body,
                                  const BodySettings& settings, const PipelineSettings& pipeline) {
  const SceneVolume& volume = scene_body.volume.value();
  const std::size_t vertices = volume.mesh.vertices_m.size();
  DeformableBody made;
  made.node_of_vertex = nodesOf(vertices, volume.fixed_vertices);
  std::vector<double> masses_kg = lumpedMasses(volume.mesh, settings.elastic.density_kg_m3);
  for (const int vertex : volume.fixed_vertices) masses_kg[vertex] = 0;
  std::vector<btVector3> positions(vertices);
  std::vector<btScalar> masses(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    positions[made.node_of_vertex[v]] = toBullet(volume.mesh.vertices_m[v]);
    masses[made.node_of_vertex[v]] = scalar(masses_kg[v]);
  }
  made.body =
      std::make_unique<btSoftBody>(&world_info, static_cast<int>(vertices), positions.data(), masses.data());
  btSoftBody& body = *made.body;
  appendElements(body, scene_body, made.node_of_vertex);
  body.initializeDmInverse();
  btSoftBody::TetraScratch at_rest;
  at_rest.m_F.setIdentity();
  at_rest.m_cofF.setIdentity();
  at_rest.m_corotation.setIdentity();
  at_rest.m_trace = 3;
  at_rest.m_J = 1;
  body.m_tetraScratches.resize(body.m_tetras.size(), at_rest);
  body.m_tetraScratchesTn.resize(body.m_tetras.size(), at_rest);
  body.getCollisionShape()->setMargin(scalar(settings.margin_m));
  using Flags = btSoftBody::fCollision;
  body.m_cfg.collisions =
      Flags::SDF_RD | (pipeline.contacts == DeformableContacts::nodes ? Flags::SDF_RDN : Flags::SDF_RDF);
  body.m_cfg.kDF = scalar(settings.elastic.friction);
  body.setActivationState(DISABLE_DEACTIVATION);
  body.updateDeformation();
  return made;
}

std::unique_ptr<btDeformableLagrangianForce> makeElasticity(const ElasticSettings& settings) {
  const Coefficients law = coefficientsOf(settings);
  if (settings.material == ElasticMaterialKind::linear_corotated) {
    return std::make_unique<btDeformableLinearElasticityForce>(scalar(law.mu_Pa), scalar(law.lambda_Pa),
                                                               scalar(settings.mass_damping_1_s),
                                                               scalar(settings.viscosity_Pa_s / law.mu_Pa));
  }
  auto force =
      std::make_unique<btDeformableNeoHookeanForce>(scalar(law.mu_Pa), scalar(law.lambda_Pa), btScalar(0));
  force->m_mu_damp = scalar(settings.viscosity_Pa_s);
  force->m_lambda_damp = 0;
  return force;
}

double storedEnergy_J(const btSoftBody& body, const ElasticSettings& settings) {
  const Coefficients law = coefficientsOf(settings);
  double energy_J = 0;
  for (int i = 0; i < body.m_tetras.size(); ++i)
    energy_J +=
        body.m_tetras[i].m_element_measure * energyDensity(body.m_tetraScratches[i], law, settings.material);
  return energy_J;
}

}  // namespace fissure
