#include "engine/soft_body.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "engine/contact_trees.h"
#include "engine/convert.h"

namespace fissure {

namespace {

btScalar scalar(double value) {
  return static_cast<btScalar>(value);
}

/// Edges in the order in which CreateFromTriMesh meets them: (2,0), (0,1), (1,2) of each triangle, each once.
void appendMeshLinks(btSoftBody& body, const TriangleMesh& rest) {
  std::set<std::pair<int, int>> seen;
  for (const Face& face : rest.faces) {
    for (int j = 2, k = 0; k < 3; j = k++) {
      if (seen.insert(std::minmax(face[j], face[k])).second) body.appendLink(face[j], face[k]);
    }
    body.appendFace(face[0], face[1], face[2]);
  }
}

/// Links between all vertices whose shortest way over links has exactly `distance` steps, ordered as
/// btSoftBody::generateBendingConstraints orders them: by the lower, then by the higher vertex.
void appendBendingLinks(btSoftBody& body, int distance) {
  const int vertices = body.m_nodes.size();
  std::vector<std::vector<int>> neighbours(vertices);
  for (int i = 0; i < body.m_links.size(); ++i) {
    const int a = static_cast<int>(body.m_links[i].m_n[0] - &body.m_nodes[0]);
    const int b = static_cast<int>(body.m_links[i].m_n[1] - &body.m_nodes[0]);
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<int> visited_from(vertices, -1);
  for (int start = 0; start < vertices; ++start) {
    std::vector<int> ring = {start};
    visited_from[start] = start;
    for (int step = 0; step < distance; ++step) {
      std::vector<int> next;
      for (const int vertex : ring) {
        for (const int neighbour : neighbours[vertex]) {
          if (visited_from[neighbour] == start) continue;
          visited_from[neighbour] = start;
          next.push_back(neighbour);
        }
      }
      ring = std::move(next);
    }
    std::sort(ring.begin(), ring.end());
    for (const int end : ring) {
      if (end <= start) continue;
      body.appendLink(end, start, body.m_materials[0]);
      body.m_links[body.m_links.size() - 1].m_bbending = 1;
    }
  }
}

/// Before the pose is set, which fixed vertices hold. Links between two of them do nothing, and Bullet would
/// divide by their mobility.
void fixVertices(btSoftBody& body, std::span<const int> vertices) {
  if (vertices.empty()) return;
  for (const int vertex : vertices) body.setMass(vertex, 0);
  int kept = 0;
  for (int i = 0; i < body.m_links.size(); ++i) {
    const btSoftBody::Link& link = body.m_links[i];
    if (link.m_n[0]->m_im > 0 || link.m_n[1]->m_im > 0) body.m_links[kept++] = link;
  }
  body.m_links.resize(kept);
}

/// How the body meets rigid shapes, by the pipeline, and other soft bodies. (Bullet's flag for clusters that
/// collide with their own body, CL_SELF, switches cluster contact off altogether in 3.24: not offered.)
int collisionFlags(const BodySettings& settings, const PipelineSettings& pipeline) {
  using Flags = btSoftBody::fCollision;
  const int rigid = pipeline.usesClusters() ? Flags::CL_RS : Flags::SDF_RS;
  if (settings.soft_contact == SoftContact::vertices) return rigid | Flags::VF_SS;
  if (settings.soft_contact == SoftContact::clusters) return rigid | Flags::CL_SS;
  return rigid;
}

// AeroModel has Bullet's values.
static_assert(static_cast<int>(AeroModel::V_Point) == btSoftBody::eAeroModel::V_Point);
static_assert(static_cast<int>(AeroModel::V_OneSided) == btSoftBody::eAeroModel::V_OneSided);
static_assert(static_cast<int>(AeroModel::F_TwoSided) == btSoftBody::eAeroModel::F_TwoSided);
static_assert(static_cast<int>(AeroModel::F_OneSided) == btSoftBody::eAeroModel::F_OneSided);

void applySolverSettings(btSoftBody::Config& config, const SolverSettings& solver,
                         double kinematic_hardness) {
  config.aeromodel = static_cast<btSoftBody::eAeroModel::_>(solver.aero_model);
  config.kVCF = scalar(solver.velocity_correction);
  config.kDP = scalar(solver.damping);
  config.kDG = scalar(solver.drag);
  config.kLF = scalar(solver.lift);
  config.kPR = scalar(solver.pressure);
  config.kVC = scalar(solver.volume_conservation);
  config.kDF = scalar(solver.dynamic_friction);
  config.kMT = scalar(solver.pose_matching);
  config.kCHR = scalar(solver.rigid_hardness);
  config.kKHR = scalar(kinematic_hardness);
  config.kSHR = scalar(solver.soft_hardness);
  config.kAHR = scalar(solver.anchor_hardness);
  config.maxvolume = scalar(solver.max_volume);
  config.timescale = scalar(solver.time_scale);
  config.viterations = solver.velocity_iterations;
  config.piterations = solver.position_iterations;
  config.diterations = solver.drift_iterations;
}

void makeClusters(btSoftBody& body, const ClusterSettings& clusters, int least_iterations) {
  btSoftBody::Config& config = body.m_cfg;
  config.citerations = std::max(clusters.iterations, least_iterations);
  config.kSRHR_CL = scalar(clusters.rigid_hardness);
  config.kSKHR_CL = scalar(clusters.kinematic_hardness);
  config.kSSHR_CL = scalar(clusters.soft_hardness);
  config.kSR_SPLT_CL = scalar(clusters.rigid_split);
  config.kSK_SPLT_CL = scalar(clusters.kinematic_split);
  config.kSS_SPLT_CL = scalar(clusters.soft_split);
  body.generateClusters(clusters.count);
  for (int i = 0; i < body.m_clusters.size(); ++i) {
    btSoftBody::Cluster& cluster = *body.m_clusters[i];
    cluster.m_ndamping = scalar(clusters.node_damping);
    cluster.m_ldamping = scalar(clusters.linear_damping);
    cluster.m_adamping = scalar(clusters.angular_damping);
    cluster.m_matching = scalar(clusters.matching);
  }
}

}  // namespace

std::unique_ptr<btSoftBody> makeSoftBody(btSoftBodyWorldInfo& world_info, const TriangleMesh& rest,
                                         const BodySettings& settings, const PipelineSettings& pipeline,
                                         std::span<const int> fixed_vertices) {
  std::vector<btVector3> vertices;
  for (const Vec3& v : rest.vertices_m) vertices.push_back(toBullet(v));
  auto body =
      std::make_unique<btSoftBody>(&world_info, static_cast<int>(vertices.size()), vertices.data(), nullptr);
  btSoftBody::Material& material = *body->m_materials[0];
  material.m_kLST = scalar(settings.material.linear_stiffness);
  material.m_kAST = scalar(settings.material.angular_stiffness);
  material.m_kVST = scalar(settings.material.volume_stiffness);
  appendMeshLinks(*body, rest);
  if (settings.randomize_links) body->randomizeConstraints();
  if (settings.bending_distance > 1) appendBendingLinks(*body, settings.bending_distance);
  applySolverSettings(body->m_cfg, settings.solver, pipeline.kinematicHardness());
  body->m_cfg.collisions = collisionFlags(settings, pipeline);
  body->getCollisionShape()->setMargin(scalar(settings.margin_m));
  body->setTotalMass(scalar(settings.mass_kg), settings.mass_from_faces);
  fixVertices(*body, fixed_vertices);
  body->setPose(settings.pose_volume, settings.pose_frame);
  if (pipeline.usesClusters() || settings.soft_contact == SoftContact::clusters)
    makeClusters(*body, settings.clusters, pipeline.tuning().least_cluster_iterations);
  makeTreesOfPieces(*body);
  body->setActivationState(DISABLE_DEACTIVATION);
  return body;
}

}  // namespace fissure
