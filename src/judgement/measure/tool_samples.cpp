#include "measure/tool_samples.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/reproducible.h"

namespace fissure {

namespace {

// A row of samples starts and ends this share of a gap inside its edge. Both are irrational, and so is every
// sum of them with rational weights that are not both zero: a sample at the fraction kFirst (1 - i/n) + kLast
// i/n + rational of an edge is never at a rational fraction of it.
const double kFirst = (std::numbers::sqrt2 - 1) / 10;
const double kLast = (std::numbers::sqrt3 - 1) / 10;

// Place of the sample in a piece of a triangle: rationally independent for the same reason.
const double kAlong = std::numbers::sqrt2 / 3;
const double kAcross = std::numbers::sqrt3 / 4;

double gapsAlong(double length_m, double spacing_m) {
  return std::max(2.0, std::ceil(length_m / spacing_m));
}

std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, const Face& face) {
  const auto corner = [&](int i) { return mesh.vertices_m[static_cast<std::size_t>(i)]; };
  return {corner(face[0]), corner(face[1]), corner(face[2])};
}

using Corners = std::array<Vec3, 3>;

double longestEdge_m(const Corners& c) {
  return std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
}

double area_m2(const Corners& c) {
  return (c[1] - c[0]).cross(c[2] - c[0]).norm() / 2;
}

/// A length in spacings as a whole number of cells, at least one; there is an end to them.
double cellsOf(double spacings) {
  constexpr double most = 1e15;
  return std::min(std::max(1.0, std::ceil(spacings)), most);
}

/// Cuts a right triangle into slabs across its longer leg, and each slab into cells, none longer or wider
/// than the spacing but for the slope of its third side, and calls `cell(sample, corners)` for each. Ends
/// early when that returns false; returns whether it did not.
template <class Cell>
bool cutRight(const Vec3& right, Vec3 one, Vec3 other, double spacing_m, const Cell& cell) {
  if ((other - right).squaredNorm() > (one - right).squaredNorm()) std::swap(one, other);
  const Vec3 along = one - right, across = other - right;
  const auto point = [&](double f, double g) { return Vec3(right + f * along + (g * (1 - f)) * across); };
  const double slabs = cellsOf(along.norm() / spacing_m);
  for (std::int64_t slab = 0; slab < static_cast<std::int64_t>(slabs); ++slab) {
    const auto i = static_cast<double>(slab);
    const double begin = i / slabs, end = (i + 1) / slabs;
    const double rows = cellsOf(across.norm() * (1 - begin) / spacing_m);
    for (std::int64_t row = 0; row < static_cast<std::int64_t>(rows); ++row) {
      const auto j = static_cast<double>(row);
      const double low = j / rows, high = (j + 1) / rows;
      const Vec3 sample = point((i + kAlong) / slabs, (j + kAcross) / rows);
      if (!cell(sample, {point(begin, low), point(begin, high), point(end, low), point(end, high)}))
        return false;
    }
  }
  return true;
}

/// The same of any triangle, by its height on the longest edge: as many cells as its area asks for, or a row
/// of them along it where it is narrower than the spacing; one for a triangle that is smaller.
template <class Cell>
bool cutUp(const Corners& corners, double spacing_m, const Cell& cell) {
  std::size_t first = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if ((corners[(i + 1) % 3] - corners[i]).squaredNorm() >
        (corners[(first + 1) % 3] - corners[first]).squaredNorm())
      first = i;
  const Vec3 &a = corners[first], &b = corners[(first + 1) % 3], &c = corners[(first + 2) % 3];
  const Vec3 edge = b - a;
  if (!(edge.norm() > spacing_m))
    return cell(Vec3(a + (kAlong * (1 - kAcross)) * edge + kAcross * (c - a)), {a, b, c, c});
  const Vec3 foot = a + (edge.dot(c - a) / edge.squaredNorm()) * edge;
  return cutRight(foot, a, c, spacing_m, cell) && cutRight(foot, b, c, spacing_m, cell);
}

/// How many samples a spacing leads to, where it is not above `limit`, else something above it. A double, so
/// that an absurd spacing does not overflow.
double countSamples(const SceneTool& tool, double spacing_m, double limit) {
  double count = 0;
  if (tool.box_size_m) {
    const Vec3& size = *tool.box_size_m;
    for (int axis = 0; axis < 3; ++axis) {
      count += 2 * (gapsAlong(size[(axis + 1) % 3], spacing_m) + 1) *
               (gapsAlong(size[(axis + 2) % 3], spacing_m) + 1);
    }
    return count;
  }
  // At least so many: no cell is longer than the spacing, none larger than its square.
  double least = 0;
  for (const Face& face : tool.surface.faces) {
    const Corners corners = cornersOf(tool.surface, face);
    least += std::max({1.0, longestEdge_m(corners) / spacing_m, area_m2(corners) / (spacing_m * spacing_m)});
  }
  if (!(least <= limit)) return least;
  for (const Face& face : tool.surface.faces) {
    const bool all = cutUp(cornersOf(tool.surface, face), spacing_m,
                           [&](const Vec3&, const std::array<Vec3, 4>&) { return ++count <= limit; });
    if (!all) return count;
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
    samples.coverage_m =
        std::max(samples.coverage_m, reproducible::hypot(size[one] / n, size[other] / m) / 2);
  }
}

void sampleTriangle(const Corners& corners, double spacing_m, ToolSamples& samples) {
  cutUp(corners, spacing_m, [&](const Vec3& sample, const std::array<Vec3, 4>& around) {
    samples.points_m.push_back(sample);
    for (const Vec3& corner : around)  // the farthest points of a cell
      samples.coverage_m = std::max(samples.coverage_m, (corner - sample).norm());
    return true;
  });
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
  const double limit = static_cast<double>(kDefaultSampleLimit);
  while (spacing < largestExtent_m(tool) && countSamples(tool, spacing, limit) > limit) spacing *= 1.02;
  return spacing;
}

}  // namespace

ToolSamples makeToolSamples(const Scene& scene, const SceneTool& tool, std::optional<double> spacing_m) {
  const double limit = static_cast<double>(kStatedSampleLimit);
  if (spacing_m && countSamples(tool, *spacing_m, limit) > limit) {
    throw InputError(
        fmt::format("measure.sample_spacing_m: too fine for tool '{}', expected at most {} samples",
                    tool.name, kStatedSampleLimit));
  }
  const double spacing = spacing_m ? *spacing_m : defaultSpacing_m(scene, tool);
  ToolSamples samples;
  if (tool.box_size_m) {
    sampleBox(*tool.box_size_m, spacing, samples);
  } else {
    for (const Face& face : tool.surface.faces)
      sampleTriangle(cornersOf(tool.surface, face), spacing, samples);
  }
  return samples;
}

}  // namespace fissure
