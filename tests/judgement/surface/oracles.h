#pragma once

#include <random>

#include "base/scene.h"
#include "base/state.h"

namespace fissure::test {

/// Winding number as the plain sum of all triangles' solid angles over 4 pi (van Oosterom and Strackee 1983).
double solidAngleWinding(const TriangleMesh& mesh, const Vec3& point);

/// Least distance to any triangle: foot points on planes, on edges' lines, and corners, each if it exists.
double bruteDistance(const TriangleMesh& mesh, const Vec3& point);

Vec3 randomIn(std::mt19937& random, double half_extent);
Quat randomRotation(std::mt19937& random);
Pose randomPose(std::mt19937& random, double half_extent);

TriangleMesh moved(TriangleMesh mesh, const Pose& pose);
/// One mesh of both, not connected.
TriangleMesh together(const TriangleMesh& one, const TriangleMesh& other);
/// A sphere with every vertex thrown about by up to `noise` of the radius: folded and self-intersecting.
TriangleMesh crumpledSphere(double radius, int subdivisions, double noise, unsigned seed);

/// Bodies at rest as given, tools as boxes.
Scene makeScene(const std::vector<TriangleMesh>& bodies, const std::vector<Vec3>& box_tools);
/// The scene at rest, velocities zero, masses 1, with its tools at `poses`.
State restState(const Scene& scene, const std::vector<Pose>& poses);
Pose at(double x, double y, double z);

}  // namespace fissure::test
