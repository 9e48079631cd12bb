#include "measure/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/distance.h"
#include "surface/winding.h"

namespace fissure {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool isUsable(const Vec3& point) {
  return (point.array().abs() <= kCoordinateLimit_m).all();
}  // false for NaN

/// Closer than this share of a surface's extent a bound of a distance says nothing: for rounding, which is
/// largest (5e-5 of its edge) at triangles that are nearly slivers, and for the slack of crossings.
constexpr double kSlack = 1e-4;

/// No lower bound of a distance is larger: only surface that is not much farther than this from a tool can
/// make one fall.
constexpr double kReach_m = 2 * kStandOffLimit_m;

/// A cluster with at most this many samples left is not bounded as a whole: each sample is looked at by
/// itself.
constexpr std::size_t kFewSamples = 3;

/// Nothing is as near as this.
constexpr double kNowhere_m = -std::numeric_limits<double>::infinity();

/// A distance is looked for as far as some steps go: farther costs more than it saves.
constexpr double kShortestLook_m = 0.0005;

/// The box around points, at least one.
TreeBox boxAround(std::span<const Vec3> points) {
  TreeBox box{points.front(), points.front()};
  for (const Vec3& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

bool areUsable(std::span<const Vec3> points) {
  return std::all_of(points.begin(), points.end(), isUsable);
}

}  // namespace

PenetrationMeter::PenetrationMeter(const Scene& scene, const MeasureSettings& settings) {
  for (const SceneBody& body : scene.bodies) {
    bodies_.push_back(
        {SurfaceTree(body.rest), static_cast<std::size_t>(body.first_vertex), body.rest.vertices_m.size()});
    bodies_.back().buried.resize(body.rest.faces.size());
  }
  inverted_.resize(bodies_.size());
  for (const SceneTool& tool : scene.tools) {
    ToolSamples samples = makeToolSamples(scene, tool, settings.sample_spacing_m);
    std::vector<SampleCluster> clusters = clusterSamples(samples.points_m);
    const std::size_t count = samples.points_m.size();
    const TreeBox extent = boxAround(samples.points_m);
    tools_.push_back({ToolShape(tool),
                      std::move(samples),
                      clusters,
                      extent,
                      {},
                      {},
                      std::vector<std::uint8_t>(count, 0),
                      std::vector<Pair>(bodies_.size(), Pair(count, clusters.size()))});
  }
  crossings_.reserve(64);
  near_.reserve(kMostNear + 1);
}

long long PenetrationMeter::sampleCount() const {
  long long count = 0;
  for (const Tool& tool : tools_) count += static_cast<long long>(tool.samples.points_m.size());
  return count;
}

double PenetrationMeter::coverage_m() const {
  double coverage = 0;
  for (const Tool& tool : tools_) coverage = std::max(coverage, tool.samples.coverage_m);
  return coverage;
}

bool PenetrationMeter::isInTissue(std::size_t tool) const {
  const Tool& t = tools_[tool];
  return std::any_of(t.passed.begin(), t.passed.end(), [](std::uint8_t passed) { return passed != 0; }) ||
         std::any_of(t.pairs.begin(), t.pairs.end(), [](const Pair& pair) {
           return std::any_of(pair.winding.begin(), pair.winding.end(), [](std::int8_t w) { return w != 0; });
         });
}

std::span<const Vec3> PenetrationMeter::verticesOf(const Body& body, const State& state) const {
  return std::span(state.positions_m).subspan(body.first_vertex, body.vertex_count);
}

bool PenetrationMeter::isMeasurable(const State& state) const {
  return areUsable(state.positions_m) &&
         std::all_of(state.tools.begin(), state.tools.end(), [](const ToolState& tool) {
           return isUsable(tool.pose.position_m) && tool.pose.orientation.coeffs().allFinite();
         });
}

void PenetrationMeter::moveTo(const State& state) {
  for (Body& body : bodies_) {
    body.surface.update(verticesOf(body, state));
    if (!connected_) body.surface.forgetMotion();
    body.way_m = longestWay_m(body.surface);
  }
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    Tool& tool = tools_[t];
    const Pose& pose = state.tools[t].pose;
    tool.before = tool.now;
    tool.now = {SurfaceTree::frame() * pose.orientation.toRotationMatrix(),
                SurfaceTree::toTree(pose.position_m)};
    if (connected_) {
      const double way_m = longestWay_m(tool.extent, tool.before, tool.now);
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        Pair& pair = tool.pairs[b];
        const double both_m = way_m + bodies_[b].way_m;
        pair.way_m = both_m;
        // Seen from a tool that turns further, a straight path in the scene is no short one.
        if (turnIsAcute(tool.before, tool.now))
          pair.way_m = std::min(
              both_m, nearWay_m(tool.extent, tool.before, tool.now, bodies_[b].surface, kReach_m + both_m));
        pair.clearances.move(pair.way_m, both_m);
        pair.of_clusters.move(pair.way_m, both_m);
        pair.horizon_m = std::clamp(16 * pair.way_m, kShortestLook_m, kStandOffLimit_m);
      }
      continue;
    }
    tool.before = tool.now;
    for (Pair& pair : tool.pairs) {
      pair.passage.restart();
      pair.clearances.forget();
      pair.of_clusters.forget();
      pair.is_followed = false;
    }
  }
  connected_ = true;
}

// What a bound of a distance may be wrong by.
double PenetrationMeter::slack_m(std::size_t body_index) const {
  const TreeBox& whole = bodies_[body_index].surface.boxes()[0];
  return kSlack * (whole.high - whole.low).maxCoeff();
}

// The distance of a sample; any up to search.enough_m as soon as one is found, infinite beyond
// search.limit_m.
double PenetrationMeter::look(Tool& tool, std::size_t body_index, std::size_t sample,
                              const DistanceSearch& search) {
  const double found_m = distance_m(bodies_[body_index].surface, tool.sampleNow(sample), search);
  Clearances& clearances = tool.pairs[body_index].clearances;
  if (found_m > search.enough_m)
    clearances.noteAtLeast(sample, std::min({found_m, search.limit_m, kReach_m}) - slack_m(body_index));
  if (found_m < search.limit_m) clearances.noteAtMost(sample, found_m + slack_m(body_index));
  ++searches_;
  return found_m;
}

// Whether all samples of a cluster are surely farther from the surface than a distance. Of a cluster of which
// that is not known, its box is looked at, and near_ becomes the triangles that samples may be nearer to than
// `near_m`.
bool PenetrationMeter::areFartherThan(Tool& tool, std::size_t body_index, std::size_t cluster,
                                      double distance_m, double near_m) {
  Pair& pair = tool.pairs[body_index];
  if (pair.of_clusters.atLeast_m(cluster) > distance_m) return true;
  const double slack = slack_m(body_index);
  near_.clear();
  if (std::max(distance_m, near_m) + slack >= kReach_m) return false;
  ++searches_;
  const double bound_m =
      distanceBound_m(bodies_[body_index].surface, tool.boxNow(tool.clusters[cluster]),
                      std::min(distance_m + slack + pair.horizon_m, kReach_m), near_m + slack, near_);
  pair.of_clusters.noteAtLeast(cluster, bound_m - slack);
  return bound_m - slack > distance_m;
}

// How many samples of a cluster may be nearer to the surface than a distance, or on it.
std::size_t PenetrationMeter::countWithin(const Tool& tool, const Pair& pair, std::size_t cluster,
                                          double distance_m) {
  const auto may_be = [&](double at_least_m) { return at_least_m < distance_m || !(at_least_m > 0); };
  if (!may_be(pair.of_clusters.atLeast_m(cluster))) return 0;
  const SampleCluster& samples = tool.clusters[cluster];
  std::size_t count = 0;
  for (std::size_t i = samples.first; i < samples.first + samples.count; ++i)
    count += may_be(pair.clearances.atLeast_m(i));
  return count;
}

// Where a sample may have met the surface since the last look. Elsewhere it crossed nothing and is inside as
// before.
void PenetrationMeter::follow(Tool& tool, std::size_t body_index) {
  const SurfaceTree& surface = bodies_[body_index].surface;
  Pair& pair = tool.pairs[body_index];
  const auto followSample = [&](std::size_t i) {
    const Vec3 now = tool.sampleNow(i);
    pair.winding[i] = static_cast<std::int8_t>(std::clamp(windingNumber(surface, now), -100, 100));
    crossing_tests_ += static_cast<long long>(findCrossings(surface, tool.sampleBefore(i), now, crossings_));
    if (pair.passage.advance(i, crossings_, pair.isInside(i))) tool.passed[i] = 1;
    look(tool, body_index, i, {.limit_m = pair.horizon_m});
  };
  for (std::size_t c = 0; c < tool.clusters.size(); ++c) {
    const std::size_t in_question = countWithin(tool, pair, c, 0);
    if (in_question == 0) continue;
    if (pair.is_followed && in_question > kFewSamples &&
        areFartherThan(tool, body_index, c, pair.way_m, kNowhere_m))
      continue;
    const SampleCluster& samples = tool.clusters[c];
    for (std::size_t i = samples.first; i < samples.first + samples.count; ++i)
      if (!(pair.clearances.atLeast_m(i) > 0)) followSample(i);
  }
  pair.is_followed = true;
}

// A little less than enough for a sample not to be the deepest: it then need not be looked at in the next
// steps.
double PenetrationMeter::enoughFor(const Pair& pair, double depth_m) {
  return depth_m - std::min(pair.horizon_m, depth_m / 2);
}

double PenetrationMeter::sampleDepth_m(Tool& tool, std::size_t body_index, double at_least_m) {
  Pair& pair = tool.pairs[body_index];
  double depth = at_least_m;
  const auto deepen = [&](std::size_t i) {
    const double found = look(tool, body_index, i, {.enough_m = enoughFor(pair, depth)});
    if (!(found > depth)) return;
    depth = found;
    pair.deepest = i;
  };
  // The deepest sample of the step before goes first: most others are known not to be as deep.
  if (pair.isInside(pair.deepest)) deepen(pair.deepest);
  for (std::size_t i = 0; i < pair.winding.size(); ++i)
    if (pair.isInside(i) && pair.clearances.atMost_m(i) > depth) deepen(i);
  return depth;
}

// Beyond the plain depth: samples in tissue that is inside out, and ways out past triangles that lead from
// one fold into another.
double PenetrationMeter::inversionAwareDepth_m(double at_least_m) {
  double depth = at_least_m;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    if (inverted_[b] == 0) continue;
    const std::vector<std::uint8_t>& buried = bodies_[b].buried;
    const bool folded = std::find(buried.begin(), buried.end(), 1) != buried.end();
    for (Tool& tool : tools_) {
      Pair& pair = tool.pairs[b];
      const auto deepen = [&](std::size_t i) {
        // Without folds the way out is the distance to the surface, of which bounds are known.
        const double found = folded ? distance_m(bodies_[b].surface, tool.sampleNow(i),
                                                 {.enough_m = depth, .left_out = buried})
                                    : look(tool, b, i, {.enough_m = enoughFor(pair, depth)});
        if (!std::isfinite(found) || !(found > depth)) return;
        depth = found;
        pair.deepest_inverted = i;
      };
      const auto counts = [&](std::size_t i) {
        if (folded) return pair.winding[i] != 0;
        return pair.winding[i] < 0 && pair.clearances.atMost_m(i) > depth;
      };
      if (counts(pair.deepest_inverted)) deepen(pair.deepest_inverted);
      for (std::size_t i = 0; i < pair.winding.size(); ++i)
        if (counts(i)) deepen(i);
    }
  }
  return depth;
}

double PenetrationMeter::vertexDepth_m(const State& state) const {
  double depth = 0;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    for (const Body& body : bodies_) {
      for (const Vec3& vertex : verticesOf(body, state)) {
        depth = std::max(depth, -tools_[t].shape.signedDistance_m(state.tools[t].pose.toBody(vertex), 0.0));
      }
    }
  }
  return depth;
}

// The distance from the nearest of the triangles of near_.
double PenetrationMeter::nearDistance_m(const SurfaceTree& surface, const Vec3& sample) {
  ++searches_;
  double squared = std::numeric_limits<double>::infinity();
  for (const std::size_t triangle : near_)
    squared = std::min(squared, distanceSquared(surface.triangles()[triangle], sample));
  return std::sqrt(squared);
}

double PenetrationMeter::standOff_m(const State& state) {
  double nearest = kStandOffLimit_m;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    Tool& tool = tools_[t];
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (const Vec3& vertex : verticesOf(bodies_[b], state)) {
        nearest = std::min(nearest, tool.shape.signedDistance_m(state.tools[t].pose.toBody(vertex), nearest));
      }
      Pair& pair = tool.pairs[b];
      const auto approach = [&](std::size_t i) {
        const double found = look(tool, b, i, {.limit_m = nearest + pair.horizon_m});
        if (!(found < nearest)) return;
        nearest = found;
        pair.nearest = i;
      };
      approach(pair.nearest);
      for (std::size_t c = 0; c < tool.clusters.size(); ++c) {
        const std::size_t in_question = countWithin(tool, pair, c, nearest);
        if (in_question == 0) continue;
        const bool are_few = in_question <= kFewSamples;
        const double near_m = nearest + 2 * pair.way_m;  // so that bounds of samples last for a step or two
        if (!are_few && areFartherThan(tool, b, c, nearest, near_m)) continue;
        const bool are_listed = !are_few && !near_.empty() && near_.size() <= kMostNear;
        const SampleCluster& samples = tool.clusters[c];
        for (std::size_t i = samples.first; i < samples.first + samples.count; ++i) {
          if (!(pair.clearances.atLeast_m(i) < nearest)) continue;
          if (!are_listed) {
            approach(i);
            continue;
          }
          const double found = nearDistance_m(bodies_[b].surface, tool.sampleNow(i));
          pair.clearances.noteAtLeast(i, std::min(found - slack_m(b), near_m));
          if (!(found < nearest)) continue;
          nearest = found;
          pair.nearest = i;
        }
      }
    }
  }
  return nearest < kStandOffLimit_m ? std::max(nearest, 0.0) : kNaN;
}

Penetration PenetrationMeter::measure(const State& state) {
  Penetration result;
  const bool measurable = isMeasurable(state);
  if (measurable) {
    moveTo(state);
    result.depth_m = vertexDepth_m(state);
    for (Tool& tool : tools_) {
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        follow(tool, b);
        result.depth_m = sampleDepth_m(tool, b, result.depth_m);
      }
    }
    result.stand_off_m = result.depth_m > 0 ? kNaN : standOff_m(state);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      inverted_[b] = countInvertedTriangles(bodies_[b].surface, bodies_[b].buried, &bodies_[b].seen_from);
    result.inversion_aware_m = inversionAwareDepth_m(result.depth_m);
  } else {
    connected_ = false;
    result.depth_m = kNaN;
    result.inversion_aware_m = kNaN;
    result.stand_off_m = kNaN;
    for (std::size_t b = 0; b < bodies_.size(); ++b)
      inverted_[b] = static_cast<long long>(bodies_[b].surface.triangles().size());
  }
  for (const long long inverted : inverted_) result.inverted_triangles += inverted;
  for (const Tool& tool : tools_) {
    result.passed_through += std::count(tool.passed.begin(), tool.passed.end(), std::uint8_t{1});
  }
  return result;
}

}  // namespace fissure
