#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "measure/clearances.h"
#include "measure/passage.h"
#include "measure/tool_samples.h"
#include "measure/tool_shape.h"
#include "scenario/scenario.h"
#include "surface/distance.h"
#include "surface/surface_tree.h"

namespace fissure {

/// Farther apart than this, tool and tissue have no stand-off.
inline constexpr double kStandOffLimit_m = 0.01;
/// Coordinates beyond this are not measured: a double there no longer resolves what tools of millimetres do.
inline constexpr double kCoordinateLimit_m = 1e6;

/// What one step looks like from outside any detector (METHOD section 7).
struct Penetration {
  /// The larger of (a) over tool samples inside a body (its winding number above 0.5) the distance to that
  /// body's surface, (b) over soft vertices inside a tool the distance to the tool's surface; an open tool
  /// has no inside, and only (a). 0 when there are none. NaN when a position is not finite or beyond
  /// kCoordinateLimit_m.
  double depth_m = 0;
  /// The same where inverted tissue counts too: over tool samples whose winding number in a body is not 0,
  /// the shortest way out of all that this body fills, folds and what is inside out included. Never smaller
  /// than depth_m.
  double inversion_aware_m = 0;
  /// Tool samples that have passed right through a body at least once since the start (Passage).
  long long passed_through = 0;
  /// Triangles that do not bound their body from outside (countInvertedTriangles); all there are where depth
  /// is NaN.
  long long inverted_triangles = 0;
  /// The smallest distance between a tool sample and a soft surface or a soft vertex and a tool's surface.
  /// NaN when something penetrates (depth > 0), when tool and tissue are kStandOffLimit_m apart or farther,
  /// or depth is NaN.
  double stand_off_m = 0;
};

/// Measures penetration step by step. The same for every pipeline: it sees positions and tool poses only, not
/// tool nodes.
class PenetrationMeter {
 public:
  /// Throws InputError for a spacing that is too fine.
  PenetrationMeter(const Scene& scene, const MeasureSettings& settings);

  /// The state of the next step; steps must come in order for passed_through.
  Penetration measure(const State& state);

  long long sampleCount() const;
  /// How often the surface was searched around a sample, since the start: what measuring costs.
  long long searches() const { return searches_; }
  /// How often a sample was looked for crossing a triangle, since the start.
  long long crossingTests() const { return crossing_tests_; }
  /// The farthest that any point of a tool's surface is from its nearest sample.
  double coverage_m() const;
  /// Triangles of each body that do not bound it from outside, in the last step.
  const std::vector<long long>& inverted() const { return inverted_; }
  /// Whether a sample of the tool is in tissue of any kind, or has passed through some.
  bool isInTissue(std::size_t tool) const;

 private:
  struct Body {
    SurfaceTree surface;
    std::size_t first_vertex = 0;
    std::size_t vertex_count = 0;
    double way_m = 0;                  // the longest of any vertex in the last step
    std::vector<std::uint8_t> buried;  // 1: no side of the triangle is outside of the body
  };
  /// The samples of one tool against one body.
  struct Pair {
    explicit Pair(std::size_t samples) : passage(samples), clearances(samples), winding(samples, 0) {}
    bool isInside(std::size_t sample) const { return winding[sample] > 0; }

    Passage passage;
    Clearances clearances;
    double horizon_m = kStandOffLimit_m;                         // how far to look for the surface
    std::vector<std::int8_t> winding;                            // number, after the last look
    std::size_t deepest = 0, deepest_inverted = 0, nearest = 0;  // of the last step, looked at first
  };
  /// Where a tool is, in the frame of the surface trees.
  struct ToolPlacement {
    Mat3 rotation = Mat3::Identity();
    Vec3 origin_m = Vec3::Zero();
    Vec3 of(const Vec3& point) const { return rotation * point + origin_m; }
  };
  struct Tool {
    ToolShape shape;
    ToolSamples samples;
    TreeBox extent;  // of the samples, in the tool's frame
    ToolPlacement now, before;
    std::vector<std::uint8_t> passed;
    std::vector<Pair> pairs;  // one a body

    Vec3 sampleNow(std::size_t i) const { return now.of(samples.points_m[i]); }
    Vec3 sampleBefore(std::size_t i) const { return before.of(samples.points_m[i]); }
  };

  bool isMeasurable(const State& state) const;
  std::span<const Vec3> verticesOf(const Body& body, const State& state) const;
  void moveTo(const State& state);
  static double longestWay_m(const Tool& tool);
  double slack_m(std::size_t body_index) const;
  double look(Tool& tool, std::size_t body_index, std::size_t sample, const DistanceSearch& search);
  void follow(Tool& tool, std::size_t body_index);
  static double enoughFor(const Pair& pair, double depth_m);
  double sampleDepth_m(Tool& tool, std::size_t body_index, double at_least_m);
  double vertexDepth_m(const State& state) const;
  double inversionAwareDepth_m(double at_least_m);
  double standOff_m(const State& state);

  std::vector<Body> bodies_;
  std::vector<Tool> tools_;
  std::vector<long long> inverted_;  // one a body
  long long searches_ = 0;
  long long crossing_tests_ = 0;
  bool connected_ = false;  // a measurable step came before
  std::vector<Crossing> crossings_;
};

}  // namespace fissure
