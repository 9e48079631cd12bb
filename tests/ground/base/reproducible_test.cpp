#include "base/reproducible.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/hash.h"

namespace fissure::reproducible_test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A function with its namesakes of C and MPFR. Those of one argument ignore the second.
struct Function {
  std::string name;
  std::function<double(double, double)> ours, of_c;
  std::function<int(mpfr_t, mpfr_t, mpfr_t)> exact;
  struct Range {
    double from, to;
  };
  std::vector<Range> x, y;  ///< arguments are drawn from these ranges in turn
};

template <class Ours, class OfC, class Exact>
Function unary(const std::string& name, Ours ours, OfC of_c, Exact exact, std::vector<Function::Range> x) {
  return {name,
          [=](double a, double) { return ours(a); },
          [=](double a, double) { return of_c(a); },
          [=](mpfr_t to, mpfr_t a, mpfr_t) { return exact(to, a, MPFR_RNDN); },
          std::move(x),
          {{0, 1}}};
}

template <class Exact>
auto rounded(Exact exact) {
  return [=](mpfr_t to, mpfr_t a, mpfr_t b) { return exact(to, a, b, MPFR_RNDN); };
}

using Unary = double (*)(double);
using Binary = double (*)(double, double);

std::vector<Function> functions() {
  const std::vector<Function::Range> angles = {{-7, 7}, {-1e-3, 1e-3}, {-1e6, 1e6}};
  const std::vector<Function::Range> sides = {{-1, 1}, {-1e-9, 1e-9}, {-1e9, 1e9}};
  return {
      {"pow",
       &reproducible::pow,
       Binary(std::pow),
       rounded(mpfr_pow),
       {{1e-6, 0.02}, {0, 4}, {1, 1e6}},
       {{0.2, 8}, {-3, 3}}},
      unary("exp", &reproducible::exp, Unary(std::exp), mpfr_exp, {{-1, 1}, {-700, 700}}),
      unary("expm1", &reproducible::expm1, Unary(std::expm1), mpfr_expm1,
            {{-1e-6, 1e-6}, {-2, 2}, {-40, 700}}),
      unary("log", &reproducible::log, Unary(std::log), mpfr_log,
            {{1, 10}, {0.9, 1.1}, {0, 1e-3}, {0, 1e300}}),
      unary("sin", &reproducible::sin, Unary(std::sin), mpfr_sin, angles),
      unary("cos", &reproducible::cos, Unary(std::cos), mpfr_cos, angles),
      unary("acos", &reproducible::acos, Unary(std::acos), mpfr_acos, {{-1, 1}, {0.999999, 1}}),
      {"atan2", &reproducible::atan2, Binary(std::atan2), rounded(mpfr_atan2), sides, sides},
      {"hypot", &reproducible::hypot, Binary(std::hypot), rounded(mpfr_hypot), sides, sides},
  };
}

/// Arguments in a fixed order: the standard's generator, and no distribution of the library's.
class Arguments {
 public:
  explicit Arguments(const Function& of) : of_(of) {}
  std::pair<double, double> next() {
    const std::size_t i = count_++;
    return {between(of_.x[i % of_.x.size()]), between(of_.y[i / of_.x.size() % of_.y.size()])};
  }

 private:
  double between(const Function::Range& range) {
    return range.from + (range.to - range.from) * static_cast<double>(random_() >> 11) / 9007199254740992.0;
  }

  const Function& of_;
  std::mt19937_64 random_{1};
  std::size_t count_ = 0;
};

/// Errors in units of the last place of the exact value.
class Oracle {
 public:
  Oracle() { mpfr_inits2(200, a_, b_, exact_, error_, nullptr); }
  ~Oracle() { mpfr_clears(a_, b_, exact_, error_, nullptr); }
  Oracle(const Oracle&) = delete;
  Oracle& operator=(const Oracle&) = delete;

  double error_ulp(const Function& of, double a, double b, double found) {
    mpfr_set_d(a_, a, MPFR_RNDN);
    mpfr_set_d(b_, b, MPFR_RNDN);
    of.exact(exact_, a_, b_);
    const double magnitude = std::abs(mpfr_get_d(exact_, MPFR_RNDZ));
    mpfr_d_sub(error_, found, exact_, MPFR_RNDN);
    return std::abs(mpfr_get_d(error_, MPFR_RNDN)) / (std::nextafter(magnitude, kInfinity) - magnitude);
  }

 private:
  mpfr_t a_, b_, exact_, error_;
};

TEST(Reproducible, ErrorsAreBelowOneUlp) {
  Oracle oracle;
  for (const Function& function : functions()) {
    Arguments arguments(function);
    double worst_ulp = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto [a, b] = arguments.next();
      const double found = function.ours(a, b);
      worst_ulp = std::max(worst_ulp, oracle.error_ulp(function, a, b, found));
    }
    EXPECT_LE(worst_ulp, 1) << function.name;
    EXPECT_GE(worst_ulp, 0.49) << function.name << ": no error at all, which nothing that rounds has";
    RecordProperty(function.name + "_ulp", std::to_string(worst_ulp));
  }
}

// NaN where C has it, infinities, zeros with their signs. One exception: pow() overflows a little early, so
// that the largest number to the power 1 is infinite. Nothing that is simulated is as large.
TEST(Reproducible, SpecialValuesAreThoseOfC) {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const std::vector<double> special = {kNan, kInfinity, most,   1e300, 1e9,   3,          2,     1.5,  1,
                                       0.5,  1e-9,      1e-300, least, 0,     -least,     -1e-9, -0.5, -1,
                                       -1.5, -2,        -3,     -1e9,  -most, -kInfinity, -0.0};
  int compared = 0;
  for (const Function& function : functions()) {
    for (const double a : special) {
      for (const double b : special) {
        const double ours = function.ours(a, b), of_c = function.of_c(a, b);
        ++compared;
        if (std::isnan(of_c) || std::isnan(ours)) {
          EXPECT_EQ(std::isnan(ours), std::isnan(of_c)) << function.name << "(" << a << ", " << b << ")";
          continue;
        }
        EXPECT_EQ(std::signbit(ours), std::signbit(of_c)) << function.name << "(" << a << ", " << b << ")";
        if (function.name == "pow" && std::abs(a) == most && b == 1) continue;
        EXPECT_EQ(std::isinf(ours), std::isinf(of_c)) << function.name << "(" << a << ", " << b << ")";
        EXPECT_LE(std::abs(std::bit_cast<std::int64_t>(ours) - std::bit_cast<std::int64_t>(of_c)), 1)
            << function.name << "(" << a << ", " << b << "): " << ours << ", C: " << of_c;
      }
    }
  }
  EXPECT_GT(compared, 5000);
}

TEST(Reproducible, PowersOfOneAndOfTwoAreExact) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10000; ++i) {
    const double x = static_cast<double>(random() >> 11) / 9007199254740992.0;
    ASSERT_EQ(reproducible::pow(x, 1), x);  // a law with the exponent 1 is the linear one
    ASSERT_EQ(reproducible::pow(x, 0), 1);
  }
  for (int i = -1000; i <= 1000; ++i) ASSERT_EQ(reproducible::pow(2, i), std::ldexp(1, i));
}

// The bits themselves: whichever machine this is, they are these. scripts/determinism.py runs whole
// simulations with other processors' variants of the C library.
TEST(Reproducible, BitsAreTheSameEverywhere) {
  std::string all;
  for (const Function& function : functions()) {
    Arguments arguments(function);
    std::string bytes(8 * 20000, ' ');
    for (std::size_t i = 0; i < bytes.size(); i += 8) {
      const auto [a, b] = arguments.next();
      const double found = function.ours(a, b);
      std::memcpy(&bytes[i], &found, 8);
    }
    all += function.name + " " + fnv1a64(bytes) + "\n";
  }
  EXPECT_EQ(all,
            "pow a45321a091e6b60e\n"
            "exp b80e3ff178ae3a0a\n"
            "expm1 21b629e8523d23a8\n"
            "log c5fca17de9eddec0\n"
            "sin ac0f1483df041887\n"
            "cos e2a605c2728efaf9\n"
            "acos 2d79d6557ebc3416\n"
            "atan2 4607c3ccba123e66\n"
            "hypot 828fefef37fd1de3\n");
}

}  // namespace
}  // namespace fissure::reproducible_test
