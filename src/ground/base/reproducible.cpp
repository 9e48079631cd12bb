#include "base/reproducible.h"

#include <sleef.h>

namespace fissure::reproducible {

// "cinz": without fused multiply-add, the same bits in every variant. "u10", "u05": errors up to 1.0 and 0.5
// ulp. "sse2" is faster than plain C, and every x86-64 processor has it; one of its two lanes is used.
double pow(double base, double exponent) {
  return _mm_cvtsd_f64(Sleef_cinz_powd2_u10sse2(_mm_set1_pd(base), _mm_set1_pd(exponent)));
}

double exp(double x) {
  return _mm_cvtsd_f64(Sleef_cinz_expd2_u10sse2(_mm_set1_pd(x)));
}

double expm1(double x) {
  return _mm_cvtsd_f64(Sleef_cinz_expm1d2_u10sse2(_mm_set1_pd(x)));
}

double log(double x) {
  return _mm_cvtsd_f64(Sleef_cinz_logd2_u10sse2(_mm_set1_pd(x)));
}

double sin(double angle_rad) {
  return _mm_cvtsd_f64(Sleef_cinz_sind2_u10sse2(_mm_set1_pd(angle_rad)));
}

double cos(double angle_rad) {
  return _mm_cvtsd_f64(Sleef_cinz_cosd2_u10sse2(_mm_set1_pd(angle_rad)));
}

double acos(double cosine) {
  return _mm_cvtsd_f64(Sleef_cinz_acosd2_u10sse2(_mm_set1_pd(cosine)));
}

double atan2(double y, double x) {
  return _mm_cvtsd_f64(Sleef_cinz_atan2d2_u10sse2(_mm_set1_pd(y), _mm_set1_pd(x)));
}

double hypot(double x, double y) {
  return _mm_cvtsd_f64(Sleef_cinz_hypotd2_u05sse2(_mm_set1_pd(x), _mm_set1_pd(y)));
}

}  // namespace fissure::reproducible
