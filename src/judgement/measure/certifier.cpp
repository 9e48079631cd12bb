#include "measure/certifier.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fissure {

namespace {

// Of the distance from the tool's origin: more than the rounding of a vertex's way into the tool's frame.
constexpr double kFrameRounding = 2e-14;
// Farther from a tool, coordinates no longer resolve what tools of millimetres do.
constexpr double kFarthest_m = 1e6;

std::array<MovingPoint, 3> movingTriangle(const Face& face, const std::vector<Vec3>& from_m,
                                          const std::vector<Vec3>& to_m) {
  std::array<MovingPoint, 3> points;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto vertex = static_cast<std::size_t>(face[i]);
    points[i] = {from_m[vertex], to_m[vertex]};
  }
  return points;
}

TreeBox boxAround(const std::array<MovingPoint, 3>& points, double margin) {
  TreeBox box{points[0].start, points[0].start};
  for (const MovingPoint& p : points) {
    box.low = box.low.cwiseMin(p.start).cwiseMin(p.end);
    box.high = box.high.cwiseMax(p.start).cwiseMax(p.end);
  }
  box.low.array() -= margin;
  box.high.array() += margin;
  return box;
}

bool meet(const TreeBox& one, const TreeBox& other) {
  return (one.low.array() <= other.high.array()).all() && (other.low.array() <= one.high.array()).all();
}

std::string edgeText(int from, int to) {  // alike from both of its triangles
  return fmt::format("edge {}-{}", std::min(from, to), std::max(from, to));
}

}  // namespace

Certifier::Certifier(const Scene& scene) {
  for (const SceneBody& body : scene.bodies)
    bodies_.push_back(
        {body.name, body.rest.faces, static_cast<std::size_t>(body.first_vertex), partsOf(body.rest)});
  for (const SceneTool& tool : scene.tools)
    tools_.push_back({tool.name, tool.surface, tool.closed, SurfaceTree(tool.surface, Mat3::Identity()),
                      partsOf(tool.surface)});
  for (std::size_t t = 0; t < tools_.size(); ++t)
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      Pair pair{.body = b, .tool = t, .before_m = {}, .now_m = {}};
      pair.before_m.resize(scene.bodies[b].rest.vertices_m.size());
      pair.now_m.resize(pair.before_m.size());
      pairs_.push_back(std::move(pair));
    }
}

std::optional<Objection> Certifier::certify(const State& state) {
  std::optional<Objection> first;
  for (Pair& pair : pairs_) {
    pair.before_m.swap(pair.now_m);
    std::optional<Objection> objection;
    if (!moveTo(state, bodies_[pair.body], pair)) {
      objection = Objection{pair.body, pair.tool,
                            fmt::format("{} is too far from {} to be resolved, or not finite",
                                        bodies_[pair.body].name, tools_[pair.tool].name),
                            1};
      pair.is_free = false;
    } else if (pair.is_free) {
      objection = followPaths(pair);
      pair.is_free = !objection || !testOverlap(pair);
    } else {
      objection = testOverlap(pair);
      pair.is_free = !objection;
    }
    if (objection && (!first || objection->time < first->time)) first = std::move(objection);
  }
  return first;
}

bool Certifier::moveTo(const State& state, const Body& body, Pair& pair) {
  const Pose& pose = state.tools[pair.tool].pose;
  const Mat3 to_tool = pose.orientation.conjugate().toRotationMatrix();
  Vec3 farthest = Vec3::Zero();
  bool finite = true;
  for (std::size_t i = 0; i < pair.now_m.size(); ++i) {
    const Vec3 from_origin = state.positions_m[body.first_vertex + i] - pose.position_m;
    pair.now_m[i] = to_tool * from_origin;
    finite = finite && pair.now_m[i].allFinite();
    farthest = farthest.cwiseMax(pair.now_m[i].cwiseAbs());
  }
  pair.separation_m = kFrameRounding * farthest.maxCoeff();
  return finite && farthest.maxCoeff() < kFarthest_m;
}

template <class Visit>
void Certifier::forNearTriangles(const Pair& pair, const std::vector<Vec3>& from_m, const Visit& visit) {
  const SurfaceTree& tree = tools_[pair.tool].tree;
  const TriangleMesh& surface = tools_[pair.tool].surface;
  for (const Face& face : bodies_[pair.body].faces) {
    const std::array<MovingPoint, 3> moving = movingTriangle(face, from_m, pair.now_m);
    const TreeBox box = boxAround(moving, pair.separation_m);
    for (std::size_t i = 0; i < tree.nodes().size();) {
      const TreeNode& node = tree.nodes()[i];
      if (!meet(box, tree.boxes()[i])) {
        i = static_cast<std::size_t>(node.skip);
        continue;
      }
      ++i;
      for (std::size_t k = 0; k < static_cast<std::size_t>(node.count); ++k) {
        const auto triangle = static_cast<std::size_t>(node.first) + k;
        const Face& of_tool = surface.faces[static_cast<std::size_t>(tree.faceIndices()[triangle])];
        const std::array<MovingPoint, 3> resting =
            movingTriangle(of_tool, surface.vertices_m, surface.vertices_m);
        if (!meet(box, boxAround(resting, 0))) continue;
        ++pairs_asked_;
        const std::optional<double> time = earliestMeeting(moving, resting, pair.separation_m);
        if (time && !visit(face, of_tool, *time)) return;
      }
    }
  }
}

std::optional<Objection> Certifier::followPaths(const Pair& pair) {
  Encounter earliest;
  forNearTriangles(pair, pair.before_m, [&](const Face& of_body, const Face& of_tool, double time) {
    if (time < earliest.time) refine(pair, of_body, of_tool, earliest);
    return true;
  });
  if (earliest.what.empty()) return std::nullopt;
  return Objection{pair.body, pair.tool, earliest.what, earliest.time};
}

/// Two triangles that are apart at first meet first with a vertex of one on the other, or edge on edge.
void Certifier::refine(const Pair& pair, const Face& of_body, const Face& of_tool,
                       Encounter& earliest) const {
  const std::string &body = bodies_[pair.body].name, &tool = tools_[pair.tool].name;
  const TriangleMesh& surface = tools_[pair.tool].surface;
  const std::array<MovingPoint, 3> moving = movingTriangle(of_body, pair.before_m, pair.now_m);
  const std::array<MovingPoint, 3> resting = movingTriangle(of_tool, surface.vertices_m, surface.vertices_m);
  const auto note = [&](std::span<const MovingPoint> one, std::span<const MovingPoint> other,
                        const auto& text) {
    const std::optional<double> time = earliestMeeting(one, other, pair.separation_m);
    if (time && *time < earliest.time) earliest = {text(), *time};
  };
  const auto triangleText = [](const Face& face) {
    return fmt::format("triangle {}-{}-{}", face[0], face[1], face[2]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    note({&moving[i], 1}, resting, [&] {
      return fmt::format("vertex {} of {} may meet {} of {}", of_body[i], body, triangleText(of_tool), tool);
    });
    note(moving, {&resting[i], 1}, [&] {
      return fmt::format("{} of {} may meet corner {} of {}", triangleText(of_body), body, of_tool[i], tool);
    });
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t i2 = (i + 1) % 3, j2 = (j + 1) % 3;
      note(std::array{moving[i], moving[i2]}, std::array{resting[j], resting[j2]}, [&] {
        return fmt::format("{} of {} may meet {} of {}", edgeText(of_body[i], of_body[i2]), body,
                           edgeText(of_tool[j], of_tool[j2]), tool);
      });
    }
  }
}

std::optional<Objection> Certifier::testOverlap(const Pair& pair) {
  const Body& body = bodies_[pair.body];
  const Tool& tool = tools_[pair.tool];
  bool crosses = false;
  forNearTriangles(pair, pair.now_m, [&](const Face&, const Face&, double) {
    crosses = true;
    return false;
  });
  const auto objection = [&](const std::string& what) { return Objection{pair.body, pair.tool, what, 1}; };
  if (crosses)
    return objection(fmt::format("the surfaces of {} and {} may cross at its end", body.name, tool.name));
  for (const SurfacePart& part : tool.parts)
    if (!isProvedOutside(body.parts, pair.now_m,
                         tool.surface.vertices_m[static_cast<std::size_t>(part.corner)]))
      return objection(fmt::format("{} may lie inside {} at its end", tool.name, body.name));
  if (!tool.closed) return std::nullopt;
  for (const SurfacePart& part : body.parts)
    if (!isProvedOutside(tool.parts, tool.surface.vertices_m,
                         pair.now_m[static_cast<std::size_t>(part.corner)]))
      return objection(fmt::format("{} may lie inside {} at its end", body.name, tool.name));
  return std::nullopt;
}

}  // namespace fissure
