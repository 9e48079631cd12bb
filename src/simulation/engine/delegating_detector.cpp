#include <BulletSoftBody/btSoftRigidCollisionAlgorithm.h>

#include "engine/collision_pools.h"
#include "engine/pipeline.h"

namespace fissure {

namespace {

/// A detector of ours that hands every call to Bullet's: the null test of the harness
/// (engine/METHOD.md 1).
class DelegatingAlgorithm : public btCollisionAlgorithm {
 public:
  DelegatingAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
                      const btCollisionObjectWrapper* b, bool swapped)
      : btCollisionAlgorithm(info), inner_(nullptr, info, a, b, swapped) {}
  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo& info, btManifoldResult* result) override {
    inner_.processCollision(a, b, info, result);
  }
  btScalar calculateTimeOfImpact(btCollisionObject* a, btCollisionObject* b, const btDispatcherInfo& info,
                                 btManifoldResult* result) override {
    return inner_.calculateTimeOfImpact(a, b, info, result);
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    inner_.getAllContactManifolds(manifolds);
  }

 private:
  btSoftRigidCollisionAlgorithm inner_;
};

class DelegatingCreator : public btCollisionAlgorithmCreateFunc {
 public:
  explicit DelegatingCreator(bool swapped) { m_swapped = swapped; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* a,
                                                 const btCollisionObjectWrapper* b) override {
    void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(DelegatingAlgorithm));
    return new (memory) DelegatingAlgorithm(info, a, b, m_swapped);
  }
};

class DelegatingConfiguration : public btSoftBodyRigidBodyCollisionConfiguration {
 public:
  DelegatingConfiguration() : btSoftBodyRigidBodyCollisionConfiguration(roomyPool()) {}
  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type_a, int type_b) override {
    const bool soft_first = type_a == SOFTBODY_SHAPE_PROXYTYPE && type_b < CONCAVE_SHAPES_START_HERE;
    const bool soft_second = type_b == SOFTBODY_SHAPE_PROXYTYPE && type_a < CONCAVE_SHAPES_START_HERE;
    if (soft_first) return &direct_;
    if (soft_second) return &swapped_;
    return btSoftBodyRigidBodyCollisionConfiguration::getCollisionAlgorithmCreateFunc(type_a, type_b);
  }

 private:
  static btDefaultCollisionConstructionInfo roomyPool() {
    btDefaultCollisionConstructionInfo info = collisionPools();
    // The pool's elements must hold our algorithm, larger than Bullet's own.
    info.m_customCollisionAlgorithmMaxElementSize = sizeof(DelegatingAlgorithm);
    return info;
  }
  DelegatingCreator direct_{false};
  DelegatingCreator swapped_{true};
};

}  // namespace

std::unique_ptr<btSoftBodyRigidBodyCollisionConfiguration> makeDelegatingConfiguration() {
  return std::make_unique<DelegatingConfiguration>();
}

}  // namespace fissure
