#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "measure/penetration.h"
#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace {
long long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// Of temporary buffers, as std::stable_sort has them.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace fissure::allocation_test {

namespace {

// A blade is driven through a sphere that sinks: outside, touching, deep, and passing through.
TEST(Allocations, AStepMakesNone) {
  const Scene scene = test::makeScene({makeSphere(0.03, 3)}, {{0.04, 0.002, 0.015}});
  PenetrationMeter meter(scene, {});
  State state = test::restState(scene, {test::at(0, 0.05, 0)});
  meter.measure(state);
  const long long before = allocations;
  for (int i = 0; i < 20; ++i) {
    state.tools[0].pose.position_m.y() -= 0.005;
    for (Vec3& vertex : state.positions_m) vertex.y() -= 0.0001;
    meter.measure(state);
  }
  EXPECT_EQ(allocations, before);
}

}  // namespace
}  // namespace fissure::allocation_test
