#include <gtest/gtest.h>

#include "allocations.h"
#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::allocation_test {

namespace {

// A blade is driven through a sphere that sinks: outside, touching, deep, and passing through.
TEST(Allocations, AStepMakesNone) {
  const Scene scene = test::makeScene({makeSphere(0.03, 3)}, {{0.04, 0.002, 0.015}});
  PenetrationMeter meter(scene, {});
  State state = test::restState(scene, {test::at(0, 0.05, 0)});
  meter.measure(state);
  const long long before = bench::allocations();
  for (int i = 0; i < 20; ++i) {
    state.tools[0].pose.position_m.y() -= 0.005;
    for (Vec3& vertex : state.positions_m) vertex.y() -= 0.0001;
    meter.measure(state);
  }
  EXPECT_EQ(bench::allocations(), before);
}

}  // namespace
}  // namespace fissure::allocation_test
