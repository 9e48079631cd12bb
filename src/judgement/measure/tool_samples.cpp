#include "measure/tool_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"

namespace fissure {

namespace {

// A row of samples starts and ends this share of a gap inside its edge. Both are irrational, and so is every
// sum of them with rational weights that are not both zero: a sample at the fraction kFirst (1 - i/n) + kLast
// i/n + rational of an edge is never at a rational fraction of it.
const double kFirst = (std::numbers::sqrt2 - 1) / 10;
const double kLast = (std::numbers::sqrt3 - 1) / 10;

// Barycentric place of the sample in a small triangle: rationally independent for the same reason.
const double kAlong = std::numbers::sqrt2 / 5;
const double kAcross = std::numbers::sqrt3 / 5;

double gapsAlong(double length_m, double spacing_m) {
  return std::max(2.0, std::ceil(length_m / spacing_m));
}

double rowsAcross(const std::array<Vec3, 3>& corners, double spacing_m) {
  const double longest = std::max(
      {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(), (corners[0] - corners[2]).norm()});
  return std::max(2.0, std::ceil(longest / spacing_m));
}

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, const Face& face) {
  const auto corner = [&](int i) { return mesh.vertices_m[static_cast<std::size_t>(i)]; };
  return {corner(face[0]), corner(face[1]), corner(face[2])};
}

/// How many samples a spacing leads to; a double, so that an absurd spacing does not overflow.
double countSamples(const SceneTool& tool, double spacing_m) {
  double count = 0;
  if (tool.box_size_m) {
    const Vec3& size = *tool.box_size_m;
    for (int axis = 0; axis < 3; ++axis) {
      count += 2 * (gapsAlong(size[(axis + 1) % 3], spacing_m) + 1) *
               (gapsAlong(size[(axis + 2) % 3], spacing_m) + 1);
    }
    return count;
  }
  for (const Face& face : tool.surface.faces) {
    count += std::pow(rowsAcross(cornersOf(tool.surface, face), spacing_m), 2);
  }
  return count;
}

void sampleBox(const Vec3& size, double spacing_m, ToolSamples& samples) {
  for (int axis = 0; axis < 3; ++axis) {
    const int one = (axis + 1) % 3, other = (axis + 2) % 3;
    const int n = static_cast<int>(gapsAlong(size[one], spacing_m));
    const int m = static_cast<int>(gapsAlong(size[other], spacing_m));
    const auto place = [](int i, int gaps) {
      const double share = static_cast<double>(i) / gaps;
      return share + (kFirst * (1 - share) - kLast * share) / gaps - 0.5;
    };
    for (const double side : {-0.5, 0.5}) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= m; ++j) {
          Vec3 point = Vec3::Zero();
          point[axis] = side * size[axis];
          point[one] = place(i, n) * size[one];
          point[other] = place(j, m) * size[other];
          samples.points_m.push_back(point);
        }
      }
    }
    samples.coverage_m = std::max(samples.coverage_m, std::hypot(size[one] / n, size[other] / m) / 2);
  }
}

void sampleTriangle(const std::array<Vec3, 3>& corners, double spacing_m, ToolSamples& samples) {
  const int rows = static_cast<int>(rowsAcross(corners, spacing_m));
  const Vec3 u = (corners[1] - corners[0]) / rows;
  const Vec3 v = (corners[2] - corners[0]) / rows;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; i + j < rows; ++j) {
      samples.points_m.push_back(corners[0] + (i + kAlong) * u + (j + kAcross) * v);
      if (i + j + 1 < rows)
        samples.points_m.push_back(corners[0] + (i + 1 - kAlong) * u + (j + 1 - kAcross) * v);
    }
  }
  // From the sample to the farthest corner of its small triangle, all of which are congruent.
  const Vec3 sample = kAlong * u + kAcross * v;
  for (const Vec3& corner : {Vec3(Vec3::Zero()), u, v}) {
    samples.coverage_m = std::max(samples.coverage_m, (corner - sample).norm());
  }
}

double thickness_m(const SceneTool& tool) {
  if (tool.box_size_m) return tool.box_size_m->minCoeff();
  Vec3 low = tool.surface.vertices_m.front(), high = low;
  for (const Vec3& vertex : tool.surface.vertices_m) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (high - low).minCoeff();
}

double shortestEdge_m(const Scene& scene) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const SceneBody& body : scene.bodies) {
    for (const Face& face : body.rest.faces) {
      const std::array<Vec3, 3> corners = cornersOf(body.rest, face);
      for (std::size_t i = 0; i < 3; ++i)
        shortest = std::min(shortest, (corners[i] - corners[(i + 1) % 3]).norm());
    }
  }
  return shortest;
}

double largestExtent_m(const SceneTool& tool) {
  if (tool.box_size_m) return tool.box_size_m->maxCoeff();
  double extent = 0;
  for (const Vec3& vertex : tool.surface.vertices_m) {
    extent = std::max(extent, (vertex - tool.surface.vertices_m.front()).norm());
  }
  return extent;
}

double defaultSpacing_m(const Scene& scene, const SceneTool& tool) {
  // A flat tool or a degenerate edge would ask for no spacing at all; the limit decides then.
  double spacing =
      std::max(std::min(0.375 * thickness_m(tool), shortestEdge_m(scene) / 3), 1e-6 * largestExtent_m(tool));
  while (spacing < largestExtent_m(tool) &&
         countSamples(tool, spacing) > static_cast<double>(kDefaultSampleLimit)) {
    spacing *= 1.02;
  }
  return spacing;
}

}  // namespace

ToolSamples makeToolSamples(const Scene& scene, const SceneTool& tool, std::optional<double> spacing_m) {
  if (spacing_m && countSamples(tool, *spacing_m) > static_cast<double>(kStatedSampleLimit)) {
    throw InputError("measure.sample_spacing_m: too fine for tool '" + tool.name + "', expected at most " +
                     std::to_string(kStatedSampleLimit) + " samples");
  }
  const double spacing = spacing_m ? *spacing_m : defaultSpacing_m(scene, tool);
  ToolSamples samples;
  samples.points_m.reserve(static_cast<std::size_t>(countSamples(tool, spacing)));
  if (tool.box_size_m) {
    sampleBox(*tool.box_size_m, spacing, samples);
  } else {
    for (const Face& face : tool.surface.faces)
      sampleTriangle(cornersOf(tool.surface, face), spacing, samples);
  }
  return samples;
}

}  // namespace fissure
