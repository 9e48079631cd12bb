// The ray caster against a slow obvious one: 2.3 million rays, 0.5 million of them aimed at edges and
// vertices.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/face_tree.h"
#include "mesh/primitives.h"
#include "slow_caster.h"

namespace fissure::ray_oracle_test {

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int kShare = 4;  // sanitizers are several times slower
#else
constexpr int kShare = 1;
#endif

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t count) { return engine_() % count; }
  Vec3 in(const Vec3& half_m) {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return half_m.cwiseProduct(Vec3(x, y, z));
  }
  Vec3 direction() {
    const double height = uniform(-1, 1), angle = uniform(0, 6.283185307179586);
    const double width = std::sqrt(1 - height * height);
    return Vec3(width * std::cos(angle), height, width * std::sin(angle)).normalized();
  }

 private:
  std::mt19937_64 engine_;
};

struct Subject {
  const char* name;
  TriangleMesh mesh;
  Vec3 half_m;  ///< where rays start
  int random_rays, edge_rays;
};

TriangleMesh mapped(TriangleMesh mesh, const Mat3& map) {
  for (Vec3& v : mesh.vertices_m) v = map * v;
  return mesh;
}

/// Smoothly dented by 20 mm from above, so that it is concave, with a wave on its side.
TriangleMesh dented(TriangleMesh mesh) {
  for (Vec3& v : mesh.vertices_m) {
    v.y() -= 0.02 * std::exp(-(v.x() * v.x() + v.z() * v.z()) / 1e-4) * (v.y() > 0 ? 1 : 0);
    v.x() += 0.004 * std::sin(200 * v.y());
  }
  return mesh;
}

/// Every vertex thrown about: folded and self-intersecting, closed all the same.
TriangleMesh crumpled(TriangleMesh mesh, double by_m) {
  Random random(7);
  for (Vec3& v : mesh.vertices_m) v += random.in(Vec3::Constant(by_m));
  return mesh;
}

std::vector<Subject> subjects() {
  const Vec3 around = Vec3::Constant(0.045);
  const Mat3 turn = Quat(0.5, 0.1, -0.7, 0.5).normalized().toRotationMatrix();
  const Mat3 flat = Vec3(1, 0.001, 1).asDiagonal(), needle = Vec3(0.002, 1, 0.002).asDiagonal();
  return {
      {"box", makeBox({0.04, 0.03, 0.05}), around, 600'000, 100'000},
      {"turned box", mapped(makeBox({0.04, 0.03, 0.05}), turn), around, 300'000, 60'000},
      {"plate 0.02 mm thin", makeBox({0.04, 0.00002, 0.015}), {0.03, 0.0001, 0.012}, 250'000, 60'000},
      {"sphere 128", makeSphere(0.03, 2), around, 200'000, 60'000},
      {"sphere 512", makeSphere(0.03, 3), around, 60'000, 40'000},
      {"dented sphere 512", dented(makeSphere(0.03, 3)), around, 60'000, 40'000},
      {"crumpled sphere 128", crumpled(makeSphere(0.03, 2), 0.015), around, 150'000, 60'000},
      {"disc of slivers", mapped(makeSphere(0.03, 2), turn * flat), around, 80'000, 40'000},
      {"needle of slivers", mapped(makeSphere(0.03, 2), needle * turn), {0.001, 0.04, 0.001}, 80'000, 40'000},
  };
}

/// Casts `count` rays made by `make(origin, direction)`.
template <class Make>
void compare(const Subject& subject, int count, test::SlowCaster& slow, const Make& make) {
  const FaceTree tree(subject.mesh.vertices_m, subject.mesh.faces);
  long long tests = 0;
  for (int i = 0; i < count / kShare; ++i) {
    const auto [origin_m, direction, limit_m] = make(i);
    const auto hit = tree.firstHit(Ray(origin_m, direction, limit_m), subject.mesh.vertices_m, tests);
    const auto complaint = slow.complaint(origin_m, direction, limit_m, hit);
    ASSERT_FALSE(complaint) << subject.name << ", ray " << i << ": " << *complaint;
  }
}

struct Cast {
  Vec3 origin_m, direction;
  double limit_m;
};

TEST(RayOracle, RandomRaysFirstMeetWhatTheSlowCasterSays) {
  for (const Subject& subject : subjects()) {
    Random random(101);
    test::SlowCaster slow(subject.mesh);
    compare(subject, subject.random_rays, slow, [&](int i) {
      const Vec3 origin_m = random.in(subject.half_m);
      return Cast{origin_m, random.direction(), i % 4 == 0 ? random.uniform(0, 0.06) : 1.0};
    });
    EXPECT_LT(slow.undecided(), subject.random_rays / kShare / 500) << subject.name;
  }
}

// Rays from inside and outside at computed points of edges (rational and other shares) and at vertices: no
// triangle of two that face alike lets them through.
TEST(RayOracle, RaysAtEdgesAndVerticesDoNotLeak) {
  for (const Subject& subject : subjects()) {
    Random random(202);
    test::SlowCaster slow(subject.mesh);
    compare(subject, subject.edge_rays, slow, [&](int i) {
      const Face& face = subject.mesh.faces[random.below(subject.mesh.faces.size())];
      const std::size_t edge = random.below(3);
      const Vec3& a = subject.mesh.vertices_m[static_cast<std::size_t>(face[edge])];
      const Vec3& b = subject.mesh.vertices_m[static_cast<std::size_t>(face[(edge + 1) % 3])];
      const double share = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 : random.uniform(0, 1);
      const Vec3 target_m = a + share * (b - a);
      const Vec3 origin_m = random.in(subject.half_m);
      return Cast{origin_m, (target_m - origin_m).normalized(), 1.0};
    });
    EXPECT_GT(slow.on_edges(), subject.edge_rays / kShare / 10) << subject.name;
    EXPECT_LT(slow.undecided(), subject.edge_rays / kShare / 50) << subject.name;
  }
}

// The tree spares triangles, and nothing else: bit for bit what trying all of them gives, lowest index first.
TEST(RayOracle, TheTreeGivesWhatAllTrianglesOneByOneGive) {
  for (const Subject& subject : subjects()) {
    Random random(303);
    FaceTree tree(mapped(subject.mesh, Vec3(3, 1, -0.2).asDiagonal()).vertices_m, subject.mesh.faces);
    tree.refit(subject.mesh.vertices_m);
    const std::vector<Vec3>& vertices_m = subject.mesh.vertices_m;
    long long tests = 0;
    for (int i = 0; i < 6'000 / kShare; ++i) {
      const Vec3 origin_m = random.in(subject.half_m);
      const Vec3 direction =
          i % 2 == 0 ? random.direction()
                     : Vec3((vertices_m[random.below(vertices_m.size())] - origin_m).normalized());
      const Ray ray(origin_m, direction, 0.05);
      std::optional<SurfaceHit> expected;
      for (std::size_t f = 0; f < subject.mesh.faces.size(); ++f) {
        const Face& face = subject.mesh.faces[f];
        const auto at = ray.intersect(vertices_m[static_cast<std::size_t>(face[0])],
                                      vertices_m[static_cast<std::size_t>(face[1])],
                                      vertices_m[static_cast<std::size_t>(face[2])]);
        if (at && (!expected || at->distance_m < expected->at.distance_m))
          expected = SurfaceHit{static_cast<int>(f), *at};
      }
      const auto hit = tree.firstHit(ray, vertices_m, tests);
      ASSERT_EQ(hit.has_value(), expected.has_value()) << subject.name << ", ray " << i;
      if (!hit) continue;
      ASSERT_EQ(hit->face, expected->face) << subject.name << ", ray " << i;
      ASSERT_EQ(hit->at.distance_m, expected->at.distance_m);
    }
  }
}

}  // namespace
}  // namespace fissure::ray_oracle_test
