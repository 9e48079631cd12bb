#include "measure/penetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/distance.h"
#include "measure/winding.h"

namespace fissure {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool isUsable(const Vec3& point) {
  return (point.array().abs() <= kCoordinateLimit_m).all();
}  // false for NaN

bool areUsable(std::span<const Vec3> points) {
  return std::all_of(points.begin(), points.end(), isUsable);
}

}  // namespace

PenetrationMeter::PenetrationMeter(const Scene& scene, const MeasureSettings& settings) {
  for (const SceneBody& body : scene.bodies) {
    bodies_.push_back(
        {SurfaceTree(body.rest), static_cast<std::size_t>(body.first_vertex), body.rest.vertices_m.size()});
  }
  std::size_t most = 0;
  for (const SceneTool& tool : scene.tools) {
    ToolSamples samples = makeToolSamples(scene, tool, settings.sample_spacing_m);
    const std::size_t count = samples.points_m.size();
    most = std::max(most, count);
    tools_.push_back({ToolShape(tool), std::move(samples), std::vector<Vec3>(count), std::vector<Vec3>(count),
                      std::vector<std::uint8_t>(count, 0),
                      std::vector<Passage>(bodies_.size(), Passage(count)),
                      std::vector<std::size_t>(bodies_.size(), 0)});
  }
  inside_.reserve(most);
  crossings_.reserve(64);
}

long long PenetrationMeter::sampleCount() const {
  long long count = 0;
  for (const Tool& tool : tools_) count += static_cast<long long>(tool.samples.points_m.size());
  return count;
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
  }
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    Tool& tool = tools_[t];
    tool.now.swap(tool.before);
    const Pose& pose = state.tools[t].pose;
    const Mat3 rotation = SurfaceTree::frame() * pose.orientation.toRotationMatrix();
    const Vec3 origin = SurfaceTree::toTree(pose.position_m);
    for (std::size_t i = 0; i < tool.now.size(); ++i) {
      tool.now[i] = rotation * tool.samples.points_m[i] + origin;
    }
    if (connected_) continue;
    tool.before = tool.now;
    for (Passage& passage : tool.passages) passage.restart();
  }
  connected_ = true;
}

double PenetrationMeter::sampleDepth_m(Tool& tool, std::size_t body_index, double at_least_m) {
  const SurfaceTree& surface = bodies_[body_index].surface;
  inside_.clear();
  for (std::size_t i = 0; i < tool.now.size(); ++i) {
    const bool inside = windingNumber(surface, tool.now[i]) > 0;
    findCrossings(surface, tool.before[i], tool.now[i], crossings_);
    if (tool.passages[body_index].advance(i, crossings_, inside)) tool.passed[i] = 1;
    if (inside) inside_.push_back(i);
  }
  double depth = at_least_m;
  std::size_t& deepest = tool.deepest[body_index];
  const auto deepen = [&](std::size_t i) {
    const double found = distance_m(surface, tool.now[i], {.enough_m = depth});
    if (found > depth) {
      depth = found;
      deepest = i;
    }
  };
  // The deepest sample of the step before goes first: most others then end at the first triangle that is near
  // enough.
  if (std::binary_search(inside_.begin(), inside_.end(), deepest)) deepen(deepest);
  for (const std::size_t i : inside_) deepen(i);
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

double PenetrationMeter::standOff_m(const State& state) const {
  double nearest = kStandOffLimit_m;
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    for (const Body& body : bodies_) {
      for (const Vec3& vertex : verticesOf(body, state)) {
        nearest =
            std::min(nearest, tools_[t].shape.signedDistance_m(state.tools[t].pose.toBody(vertex), nearest));
      }
      for (const Vec3& sample : tools_[t].now) {
        nearest = std::min(nearest, distance_m(body.surface, sample, {.limit_m = nearest}));
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
      for (std::size_t b = 0; b < bodies_.size(); ++b)
        result.depth_m = sampleDepth_m(tool, b, result.depth_m);
    }
    result.stand_off_m = result.depth_m > 0 ? kNaN : standOff_m(state);
    for (const Body& body : bodies_) result.inverted_triangles += countInvertedTriangles(body.surface);
  } else {
    connected_ = false;
    result.depth_m = kNaN;
    result.stand_off_m = kNaN;
    for (const Body& body : bodies_) {
      result.inverted_triangles += static_cast<long long>(body.surface.triangles().size());
    }
  }
  for (const Tool& tool : tools_) {
    result.passed_through += std::count(tool.passed.begin(), tool.passed.end(), std::uint8_t{1});
  }
  return result;
}

}  // namespace fissure
