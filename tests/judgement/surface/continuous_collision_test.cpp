#include "surface/continuous_collision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <sstream>

#include "certificate_table.h"
#include "exact_collision.h"

namespace fissure::continuous_collision_test {

using test::Meeting;

using Pieces = std::array<std::vector<MovingPoint>, 2>;  // vertex and triangle, or two edges

bool mayMeet(const Pieces& pieces) {
  return earliestMeeting(pieces[0], pieces[1]).has_value();
}

/// FISSURE_CCD_QUERIES states how many random queries are asked; a tenth of them are adversarial.
long long queries() {
  const char* given = std::getenv("FISSURE_CCD_QUERIES");
  return given == nullptr ? 20'000 : std::atoll(given);
}

Pieces piecesOf(bool edges, const std::array<MovingPoint, 4>& p) {
  if (edges) return {std::vector{p[0], p[1]}, std::vector{p[2], p[3]}};
  return {std::vector{p[0]}, std::vector{p[1], p[2], p[3]}};
}

std::string described(const Pieces& pieces) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& piece : pieces)
    for (const MovingPoint& p : piece) text << p.start.transpose() << " -> " << p.end.transpose() << "\n";
  return text.str();
}

// Sample queries of Wang and others (2021), "A large-scale benchmark and an inclusion-based algorithm for
// continuous collision detection", with their exact truth: 8 rows of rational coordinates each.
struct Published {
  Pieces pieces;
  bool meet = false;
};

std::vector<Published> readPublished(const std::filesystem::path& file, bool edges) {
  std::ifstream in(file);
  std::vector<Published> all;
  std::array<Vec3, 8> points;
  std::string line;
  for (std::size_t row = 0; std::getline(in, line); ++row) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    for (int axis = 0; axis < 3; ++axis) {
      std::string above, below;
      numbers >> above >> below;
      const boost::multiprecision::cpp_rational exact{boost::multiprecision::cpp_int(above),
                                                      boost::multiprecision::cpp_int(below)};
      points[row % 8][axis] = static_cast<double>(exact);
      EXPECT_EQ(boost::multiprecision::cpp_rational(points[row % 8][axis]), exact) << file << ":" << row + 1;
    }
    bool meet = false;
    numbers >> meet;
    EXPECT_TRUE(numbers) << file << ":" << row + 1;
    if (row % 8 != 7) continue;
    std::array<MovingPoint, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = {points[i], points[i + 4]};
    all.push_back({piecesOf(edges, p), meet});
  }
  return all;
}

TEST(ContinuousCollision, MissesNoneOfThePublishedMeetings) {
  const std::filesystem::path folder =
      std::filesystem::path(FISSURE_SOURCE_DIR) / "tests/judgement/surface/ccd";
  long long asked = 0, met = 0, false_meetings = 0;
  for (const char* scene : {"erleben-sliding-wedge", "erleben-spikes", "erleben-wedges", "unit-tests"})
    for (const bool edges : {false, true}) {
      const std::string kind = edges ? "edge-edge" : "vertex-face";
      long long asked_here = 0, met_here = 0, false_here = 0;
      for (const auto& file : std::filesystem::directory_iterator(folder / scene / kind))
        for (const Published& query : readPublished(file.path(), edges)) {
          const bool found = mayMeet(query.pieces);
          EXPECT_TRUE(found || !query.meet) << file.path() << "\n" << described(query.pieces);
          ++asked_here;
          met_here += query.meet;
          false_here += found && !query.meet;
        }
      test::addCertificateRow(std::string(scene) + " " + kind, asked_here, met_here, 0, false_here);
      asked += asked_here;
      met += met_here;
      false_meetings += false_here;
    }
  EXPECT_EQ(asked, 1824);
  EXPECT_EQ(met, 233);
  EXPECT_LE(false_meetings, 21);  // all among the spikes, which nearly touch
}

// Against integer arithmetic on small integral coordinates, where 128 bits hold every product.
TEST(ContinuousCollision, MissesNoMeetingOfRandomPrimitives) {
  std::mt19937 random(7);
  std::map<Meeting, long long> truths, found_of;
  for (long long i = 0; i < queries(); ++i) {
    const bool edges = i % 2 == 0;
    const int reach = std::array{3, 20, 255}[static_cast<std::size_t>(i / 2 % 3)];
    const int motion = std::array{255, 20, 2}[static_cast<std::size_t>(i / 6 % 3)];
    std::array<MovingPoint, 4> p;
    for (MovingPoint& point : p)
      for (int axis = 0; axis < 3; ++axis) {
        const auto coordinate = [&](int most) { return std::uniform_int_distribution(-most, most)(random); };
        point.start[axis] = coordinate(reach);
        point.end[axis] = std::clamp(static_cast<int>(point.start[axis]) + coordinate(motion), -255, 255);
      }
    const Pieces pieces = piecesOf(edges, p);
    const bool found = mayMeet(pieces);
    const Meeting truth = test::exactMeeting(pieces[0], pieces[1]);
    ++truths[truth];
    found_of[truth] += found;
    ASSERT_TRUE(found || truth != Meeting::certain) << described(pieces);
  }
  test::addCertificateRow("random primitives", queries(), truths[Meeting::certain],
                          truths[Meeting::undecided], found_of[Meeting::never]);
  EXPECT_GT(truths[Meeting::certain], queries() / 50);
  EXPECT_LT(truths[Meeting::undecided], queries() / 100);
  EXPECT_LT(found_of[Meeting::never], queries() / 1000);
}

/// Two primitives that meet, and where: shares of their points at a time.
struct Witnessed {
  bool edges = false;
  std::array<MovingPoint, 4> points;
  double time = 0;
  std::vector<double> one, other;
};

/// Coordinates of few digits, so that what is computed from them stays exact.
class Adversary {
 public:
  Witnessed next(long long i) {
    Witnessed query = meeting(i % 2 == 0, static_cast<int>(i / 2 % 10));
    disguise(query, static_cast<int>(i / 20 % 8));
    return query;
  }

 private:
  int integer(int most) { return std::uniform_int_distribution(-most, most)(random_); }
  Vec3 vector(int most) { return {1.0 * integer(most), 1.0 * integer(most), 1.0 * integer(most)}; }
  double eighth() { return std::uniform_int_distribution(0, 8)(random_) / 8.0; }

  static Vec3 at(const MovingPoint& p, double time) { return p.start + time * (p.end - p.start); }

  Witnessed meeting(bool edges, int kind) {
    Witnessed q;
    q.edges = edges;
    for (MovingPoint& p : q.points) p = {vector(60), vector(60)};
    const double a = eighth(), b = eighth() * (1 - a);
    q.one = edges ? std::vector{1 - a, a} : std::vector{1.0};
    const double c = eighth();
    q.other = edges ? std::vector{1 - c, c} : std::vector{1 - a - b, a, b};
    q.time = std::array{0.25, 0.5, 1.0, 0.0}[static_cast<std::size_t>(integer(1) + 1 + (kind == 4))];
    if (kind == 1) {  // nothing moves
      for (MovingPoint& p : q.points) p.end = p.start;
    } else if (kind == 2) {  // all in one plane, always
      for (MovingPoint& p : q.points) p.start.z() = p.end.z() = p.start.x() + 2 * p.start.y();
      for (MovingPoint& p : q.points) p.end.z() = p.end.x() + 2 * p.end.y();
    } else if (kind == 3) {  // without area or length
      q.points[3] = q.points[2];
      if (!edges) q.points[1] = q.points[2];
    } else if (kind == 5) {  // grazing: the volume has a double root
      return grazing(edges);
    } else if (kind == 6) {  // a point shared throughout
      q.points[edges ? 2 : 1] = q.points[0];
      q.one.assign(q.one.size(), 0.0);
      q.other.assign(q.other.size(), 0.0);
      q.one[0] = q.other[0] = 1;
      return q;
    } else if (kind == 7 && edges) {  // collinear edges
      const Vec3 along = vector(7);
      for (std::size_t i = 1; i < 4; ++i) q.points[i].start = q.points[0].start + integer(7) * along;
      for (std::size_t i = 1; i < 4; ++i) q.points[i].end = q.points[0].end + integer(7) * along;
    } else if (kind == 8) {  // along a plane that rests
      for (std::size_t i = edges ? 2 : 1; i < 4; ++i) {
        q.points[i].start.z() = 5;
        q.points[i].end = q.points[i].start;
      }
      for (std::size_t i = 0; i < (edges ? 2U : 1U); ++i) q.points[i].start.z() = q.points[i].end.z() = 5;
    }
    // The first point, or the whole first edge, is moved so that both meet at that time.
    Vec3 gap = Vec3::Zero();
    for (std::size_t i = 0; i < q.other.size(); ++i)
      gap += q.other[i] * at(q.points[i + q.one.size()], q.time);
    for (std::size_t i = 0; i < q.one.size(); ++i) gap -= q.one[i] * at(q.points[i], q.time);
    const bool starts = kind == 1 || kind == 2 || kind == 8 || q.time == 0;
    for (std::size_t i = 0; i < q.one.size(); ++i) {
      if (starts || q.time < 1) q.points[i].start += gap;
      if (starts || q.time < 1 || q.time == 1) q.points[i].end += gap;
    }
    return q;
  }

  /// z of the gap is (t - 1/2)^2 times an integer: paths that touch at half of the step and part again.
  Witnessed grazing(bool edges) {
    Witnessed q;
    q.edges = edges;
    q.time = 0.5;
    const double k = 1 + std::abs(integer(6)), side = 8;
    // A plane that turns about the y axis through flat, and a point (edge) that crosses its axis meanwhile.
    const auto onPlane = [&](double x, double y) { return MovingPoint{{x, y, -x * k}, {x, y, x * k}}; };
    const double swing = integer(1) >= 0 ? 4 : -4;
    if (edges) {
      q.points = {MovingPoint{{swing, -side, 0}, {-swing, -side, 0}},
                  {{swing, side, 0}, {-swing, side, 0}},
                  onPlane(-side, 0),
                  onPlane(side, 0)};
      q.one = q.other = {0.5, 0.5};
    } else {
      q.points = {MovingPoint{{swing, 0, 0}, {-swing, 0, 0}}, onPlane(-2 * side, -side),
                  onPlane(2 * side, -side), onPlane(0, 2 * side)};
      // 0 = a (-2, -1) + b (2, -1) + c (0, 2): thirds, not dyadic; a point beside is.
      q.one = {1.0};
      q.other = {0.25, 0.25, 0.5};
      for (Vec3* end : {&q.points[0].start, &q.points[0].end}) end->y() = 0.5 * side;
    }
    Mat3 map;
    do {
      for (double& entry : map.reshaped()) entry = integer(3);
    } while (map.determinant() == 0);
    for (MovingPoint& p : q.points) p = {Vec3(map * p.start), Vec3(map * p.end)};
    return q;
  }

  /// Keeps the meeting exact: powers of two, shifts of few digits, motion in common.
  void disguise(Witnessed& q, int kind) {
    const double factor = std::array{
        1.0, 0x1p-300, 0x1p300, 0x1p-900, 0x1p900, 0x1p-14, 1.0, 1.0}[static_cast<std::size_t>(kind)];
    const Vec3 shift = kind == 6 ? Vec3(vector(1000) * 0x1p20) : Vec3(Vec3::Zero());
    const Vec3 motion = kind == 7 ? Vec3(vector(1000) * 0x1p20) : Vec3(Vec3::Zero());
    for (MovingPoint& p : q.points) p = {factor * (p.start + shift), factor * (p.end + shift + motion)};
  }

  std::mt19937 random_{11};
};

// Meetings made to be overlooked, each with a rational witness.
TEST(ContinuousCollision, MissesNoMeetingThatAnAdversaryMakes) {
  Adversary adversary;
  for (long long i = 0; i < queries() / 10; ++i) {
    const Witnessed query = adversary.next(i);
    const Pieces pieces = piecesOf(query.edges, query.points);
    ASSERT_TRUE(test::isWitness(pieces[0], pieces[1], query.time, query.one, query.other))
        << i << "\n"
        << described(pieces);
    ASSERT_TRUE(mayMeet(pieces)) << i << "\n" << described(pieces);
  }
  test::addCertificateRow("primitives of an adversary", queries() / 10, queries() / 10, 0, 0);
}

TEST(ContinuousCollision, ProvesApartWhatIsApartByMoreThanTheSeparation) {
  const std::vector<MovingPoint> vertex{{{0, 1, 0}, {0, 0.25, 0}}};
  const std::vector<MovingPoint> triangle{
      {{-1, 0, -1}, {-1, 0, -1}}, {{1, 0, -1}, {1, 0, -1}}, {{0, 0, 2}, {0, 0, 2}}};
  EXPECT_FALSE(earliestMeeting(vertex, triangle));
  EXPECT_FALSE(earliestMeeting(vertex, triangle, 0.2499));
  const auto near = earliestMeeting(vertex, triangle, 0.2501);
  ASSERT_TRUE(near);
  EXPECT_NEAR(*near, 1, 1e-3);
  EXPECT_LT(*near, 1);
}

TEST(ContinuousCollision, SaysTheTimeBeforeWhichNothingMeets) {
  const std::vector<MovingPoint> one{{{-1, 1, 0}, {-1, -3, 0}}, {{1, 1, 0}, {1, -3, 0}}};
  const std::vector<MovingPoint> other{{{0, 0, -1}, {0, 0, -1}}, {{0, 0, 1}, {0, 0, 1}}};
  const auto time = earliestMeeting(one, other);
  ASSERT_TRUE(time);
  EXPECT_LE(*time, 0.25);
  EXPECT_NEAR(*time, 0.25, 1e-9);
}

TEST(ContinuousCollision, TakesWhatIsNotFiniteForAMeeting) {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {inf, -inf, nan, 1.7e308}) {
    const std::vector<MovingPoint> vertex{{{0, 1, 0}, {0, bad, 0}}};
    const std::vector<MovingPoint> triangle{
        {{-1, 0, -1}, {-1, 0, -1}}, {{1, 0, -1}, {1, -bad, -1}}, {{0, 0, 2}, {0, 0, 2}}};
    EXPECT_TRUE(earliestMeeting(vertex, triangle)) << bad;
  }
}

}  // namespace fissure::continuous_collision_test
