#pragma once

// Vectors of FISSURE_LANE_WIDTH doubles. Each source that includes this header is compiled for one
// instruction set, so everything here has internal linkage (element_kernels.h).

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace fissure {
namespace {

constexpr int kWidth = FISSURE_LANE_WIDTH;
using Lanes = double __attribute__((vector_size(8 * FISSURE_LANE_WIDTH)));
using Mask = long long __attribute__((vector_size(8 * FISSURE_LANE_WIDTH)));
using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));

template <class Vector>
inline Vector load(const double* from) {
  Vector values;
  __builtin_memcpy(&values, from, sizeof values);
  return values;
}

template <class Vector>
inline void store(const Vector& values, double* to) {
  __builtin_memcpy(to, &values, sizeof values);
}

inline Lanes all(double value) {
  return value - Lanes{};
}

inline Lanes larger(const Lanes& a, const Lanes& b) {
  return a > b ? a : b;
}

#if FISSURE_LANE_WIDTH == 8
inline Lanes squareRoot(const Lanes& x) {
  return _mm512_maskz_sqrt_pd(0xff, x);
}
inline bool any(const Mask& mask) {
  return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask)) != 0;
}
#elif FISSURE_LANE_WIDTH == 4
inline Lanes squareRoot(const Lanes& x) {
  return _mm256_sqrt_pd(x);
}
inline bool any(const Mask& mask) {
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(mask)) != 0;
}
#elif defined(__x86_64__)
inline Lanes squareRoot(const Lanes& x) {
  return _mm_sqrt_pd(x);
}
inline bool any(const Mask& mask) {
  return _mm_movemask_pd(reinterpret_cast<__m128d>(mask)) != 0;
}
#else
inline Lanes squareRoot(const Lanes& x) {
  return Lanes{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
}
inline bool any(const Mask& mask) {
  return mask[0] != 0 || mask[1] != 0;
}
#endif

}  // namespace
}  // namespace fissure
