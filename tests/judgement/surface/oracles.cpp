#include "oracles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/primitives.h"

namespace fissure::test {

double solidAngleWinding(const TriangleMesh& mesh, const Vec3& point) {
  double total = 0;
  for (const Face& f : mesh.faces) {
    const Vec3 r1 = mesh.vertices_m[static_cast<std::size_t>(f[0])] - point;
    const Vec3 r2 = mesh.vertices_m[static_cast<std::size_t>(f[1])] - point;
    const Vec3 r3 = mesh.vertices_m[static_cast<std::size_t>(f[2])] - point;
    const double n1 = r1.norm(), n2 = r2.norm(), n3 = r3.norm();
    const double numerator = r1.cross(r2).dot(r3);
    const double denominator = n1 * n2 * n3 + r1.dot(r2) * n3 + r1.dot(r3) * n2 + r2.dot(r3) * n1;
    total += 2 * std::atan2(numerator, denominator);
  }
  return total / (4 * std::numbers::pi);
}

double bruteDistance(const TriangleMesh& mesh, const Vec3& point) {
  double best = std::numeric_limits<double>::infinity();
  for (const Face& f : mesh.faces) {
    Vec3 corner[3];
    for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.vertices_m[static_cast<std::size_t>(f[i])];
    const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    const double height = normal.dot(point - corner[0]);
    const Vec3 foot = point - height * normal;
    bool covered = normal.norm() > 0.5;  // 0 for a triangle without area
    for (int i = 0; i < 3; ++i) {
      const Vec3& from = corner[i];
      const Vec3& to = corner[(i + 1) % 3];
      covered = covered && (to - from).cross(foot - from).dot(normal) >= 0;
      best = std::min(best, (point - from).norm());
      const Vec3 along = (to - from).normalized();
      const double reach = along.dot(point - from);
      if (reach > 0 && reach < (to - from).norm())
        best = std::min(best, (point - from - reach * along).norm());
    }
    if (covered) best = std::min(best, std::abs(height));
  }
  return best;
}

Vec3 randomIn(std::mt19937& random, double half_extent) {
  std::uniform_real_distribution<double> coordinate(-half_extent, half_extent);
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

Quat randomRotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random), w = normal(random);
  return Quat(w, x, y, z).normalized();
}

Pose randomPose(std::mt19937& random, double half_extent) {
  const Vec3 position = randomIn(random, half_extent);
  return {position, randomRotation(random)};
}

TriangleMesh moved(TriangleMesh mesh, const Pose& pose) {
  for (Vec3& vertex : mesh.vertices_m) vertex = pose.toScene(vertex);
  return mesh;
}

TriangleMesh together(const TriangleMesh& one, const TriangleMesh& other) {
  TriangleMesh mesh = one;
  const int shift = static_cast<int>(one.vertices_m.size());
  mesh.vertices_m.insert(mesh.vertices_m.end(), other.vertices_m.begin(), other.vertices_m.end());
  for (const Face& f : other.faces) mesh.faces.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
  return mesh;
}

TriangleMesh crumpledSphere(double radius, int subdivisions, double noise, unsigned seed) {
  std::mt19937 random(seed);
  TriangleMesh mesh = makeSphere(radius, subdivisions);
  for (Vec3& vertex : mesh.vertices_m) vertex += randomIn(random, noise * radius);
  return mesh;
}

Scene makeScene(const std::vector<TriangleMesh>& bodies, const std::vector<Vec3>& box_tools) {
  Scene scene;
  for (const TriangleMesh& mesh : bodies) {
    scene.bodies.push_back(
        {"body" + std::to_string(scene.bodies.size()), mesh, scene.vertexCount(), scene.faceCount()});
  }
  for (const Vec3& size : box_tools) {
    scene.tools.push_back(
        {.name = "tool" + std::to_string(scene.tools.size()), .surface = makeBox(size), .box_size_m = size});
  }
  return scene;
}

State restState(const Scene& scene, const std::vector<Pose>& poses) {
  State state;
  for (const SceneBody& body : scene.bodies) {
    state.positions_m.insert(state.positions_m.end(), body.rest.vertices_m.begin(),
                             body.rest.vertices_m.end());
  }
  state.velocities_m_s.assign(state.positions_m.size(), Vec3::Zero());
  state.masses_kg.assign(state.positions_m.size(), 1.0);
  for (const Pose& pose : poses) {
    ToolState tool;
    tool.pose = pose;
    state.tools.push_back(tool);
  }
  return state;
}

Pose at(double x, double y, double z) {
  return {Vec3(x, y, z), Quat::Identity()};
}

}  // namespace fissure::test
