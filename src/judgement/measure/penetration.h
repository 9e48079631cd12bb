#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/scene.h"
#include "base/state.h"
#include "measure/clearances.h"
#include "measure/passage.h"
#include "measure/relative_motion.h"
#include "measure/sample_clusters.h"
#include "measure/tool_samples.h"
#include "measure/tool_shape.h"
#include "scenario/scenario.h"
#include "surface/distance.h"
#include "surface/surface_tree.h"
#include "surface/winding.h"

namespace fissure {

/// The largest distance between tool and tissue that is measured as stand-off, metres.
inline constexpr double kStandOffLimit_m = 0.01;
/// The largest coordinate, metres, at which penetration is measured: beyond it a double no longer resolves
/// the motion of tools of millimetres.
inline constexpr double kCoordinateLimit_m = 1e6;

/// Penetration in one step, measured independently of any detector (measure/METHOD.md 1 and 2).
struct Penetration {
  /// The larger of (a) over tool samples inside a body (its winding number above 0.5) the distance to that
  /// body's surface, (b) over soft vertices inside a tool the distance to the tool's surface; an open tool
  /// has no inside, and only (a). 0 when there are none. NaN when a position is not finite or beyond
  /// kCoordinateLimit_m.
  double depth_m = 0;
  /// The depth with inverted tissue: over tool samples whose winding number in a body is not 0, the shortest
  /// distance to the outside of all that this body fills, folds and inverted parts included. Never smaller
  /// than depth_m.
  double inversion_aware_m = 0;
  /// Number of tool samples that have passed right through a body at least once since the start (Passage).
  long long passed_through = 0;
  /// Number of triangles that do not bound their body from outside (countInvertedTriangles); that of all
  /// triangles where the depth is NaN.
  long long inverted_triangles = 0;
  /// The smallest distance between a tool sample and a tissue surface, or a tissue vertex and a tool's
  /// surface. NaN when something penetrates (depth > 0), when tool and tissue are kStandOffLimit_m or more
  /// apart, or when depth is NaN.
  double stand_off_m = 0;
};

/// Measures penetration step by step, in the same way for every pipeline: it uses only positions and tool
/// poses, not tool nodes.
class PenetrationMeter {
 public:
  /// Throws InputError for a sample spacing that is too fine.
  PenetrationMeter(const Scene& scene, const MeasureSettings& settings);

  /// Measures the state of the next step. Steps must come in order for passed_through.
  Penetration measure(const State& state);

  long long sampleCount() const;
  /// Number of searches for the surface around a sample since the start, a measure of cost.
  long long searches() const { return searches_; }
  /// Number of tests for a sample crossing a triangle since the start.
  long long crossingTests() const { return crossing_tests_; }
  /// Largest distance of any point of a tool's surface from its nearest sample, metres.
  double coverage_m() const;
  /// [body] number of triangles that do not bound it from outside, in the last step.
  const std::vector<long long>& inverted() const { return inverted_; }
  /// Whether a sample of the tool is in tissue, inverted or not, or has passed through some.
  bool isInTissue(std::size_t tool) const;

 private:
  struct Body {
    SurfaceTree surface;
    std::size_t first_vertex = 0;
    std::size_t vertex_count = 0;
    double way_m = 0;                  // largest displacement of a vertex in the last step
    Vec3 seen_from = kNowhere;         // countInvertedTriangles, from step to step
    std::vector<std::uint8_t> buried;  // [triangle] 1: no side of it is outside of the body
  };
  /// The state of the samples of one tool with respect to one body.
  struct Pair {
    Pair(std::size_t samples, std::size_t clusters)
        : passage(samples), clearances(samples), of_clusters(clusters), winding(samples, 0) {}
    bool isInside(std::size_t sample) const { return winding[sample] > 0; }

    Passage passage;
    Clearances clearances;
    Clearances of_clusters;    // [cluster] lower bounds for all samples of the cluster
    bool is_followed = false;  // whether the winding number of each sample is known
    double way_m = 0;  // largest displacement of near surface relative to the samples in the last step
    double horizon_m = kStandOffLimit_m;  // distance up to which the surface is searched
    std::vector<std::int8_t> winding;     // [sample] winding number at the last search
    std::size_t deepest = 0, deepest_inverted = 0, nearest = 0;  // samples of the last step, searched first
  };
  struct Tool {
    ToolShape shape;
    ToolSamples samples;
    std::vector<SampleCluster> clusters;  // of neighbouring samples
    TreeBox extent;                       // bounding box of the samples, tool frame
    ToolPlacement now, before;
    std::vector<std::uint8_t> passed;
    std::vector<Pair> pairs;  // one per body

    OrientedBox boxNow(const SampleCluster& cluster) const {
      return {now.of(cluster.centre_m), now.rotation, cluster.half_m};
    }
    Vec3 sampleNow(std::size_t i) const { return now.of(samples.points_m[i]); }
    Vec3 sampleBefore(std::size_t i) const { return before.of(samples.points_m[i]); }
  };

  bool isMeasurable(const State& state) const;
  std::span<const Vec3> verticesOf(const Body& body, const State& state) const;
  void moveTo(const State& state);
  double slack_m(std::size_t body_index) const;
  double look(Tool& tool, std::size_t body_index, std::size_t sample, const DistanceSearch& search);
  bool areFartherThan(Tool& tool, std::size_t body_index, std::size_t cluster, double distance_m,
                      double near_m);
  static std::size_t countWithin(const Tool& tool, const Pair& pair, std::size_t cluster, double distance_m);
  void follow(Tool& tool, std::size_t body_index);
  static double enoughFor(const Pair& pair, double depth_m);
  double sampleDepth_m(Tool& tool, std::size_t body_index, double at_least_m);
  double vertexDepth_m(const State& state) const;
  double inversionAwareDepth_m(double at_least_m);
  double nearDistance_m(const SurfaceTree& surface, const Vec3& sample);
  double standOff_m(const State& state);

  std::vector<Body> bodies_;
  std::vector<Tool> tools_;
  std::vector<long long> inverted_;  // [body]
  long long searches_ = 0;
  long long crossing_tests_ = 0;
  bool connected_ = false;  // the step before was measurable
  std::vector<Crossing> crossings_;
  std::vector<std::size_t> near_;  // triangles, of the cluster that was looked at last
};

}  // namespace fissure
