#pragma once

/// Elementary functions that return the same bits on every x86-64 processor. Those of the C library differ in
/// the last bit between processors, because it chooses variants with or without fused multiply-add when a
/// program starts; these are SLEEF's for SSE2, which are compiled once and use none. Errors are below 1
/// ulp (tests/ground/base/reproducible_test.cpp), special values are those of C, but for pow()
/// of the largest number. sqrt, fma, fmod, ldexp and
/// what rounds to integers are exact or correctly rounded everywhere, and are std's.
namespace fissure::reproducible {

double pow(double base, double exponent);
double exp(double x);
double expm1(double x);
double log(double x);
double sin(double angle_rad);
double cos(double angle_rad);
double acos(double cosine);
double atan2(double y, double x);
double hypot(double x, double y);

}  // namespace fissure::reproducible
