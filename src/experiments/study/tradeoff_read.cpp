#include "study/tradeoff_read.h"

#include <algorithm>
#include <cmath>

#include "measure/statistics.h"
#include "store/run_reader.h"
#include "surface/distance.h"

namespace fissure {

namespace {

/// The magnitudes of vectors, three numbers each.
std::vector<double> magnitudes(const std::vector<double>& xyz) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
    lengths.push_back(Vec3(xyz[i], xyz[i + 1], xyz[i + 2]).norm());
  return lengths;
}

/// The rows of one law in a quantity over laws, of which each has `width` numbers; the first law by default.
std::vector<double> rowsOfLaw(const RunReader& run, const StoredQuantity& quantity,
                              const std::optional<std::string>& law, std::size_t width) {
  if (quantity.axes.empty()) return {};
  const std::vector<std::string>& names = quantity.axes.front().labels;
  const auto found = law ? std::find(names.begin(), names.end(), *law) : names.begin();
  if (found == names.end()) return {};
  const auto at = static_cast<std::size_t>(found - names.begin());
  const std::vector<double> all = run.all(quantity);
  std::vector<double> rows;
  for (std::size_t row = 0; row < quantity.rows; ++row)
    for (std::size_t i = 0; i < width; ++i) rows.push_back(all[(row * names.size() + at) * width + i]);
  return rows;
}

std::vector<double> valuesOf(const RunReader& run, const StudyError& error) {
  if (error.quantity == ErrorQuantity::depth) {
    const StoredQuantity* depth = run.find("penetration_depth");
    return depth ? run.all(*depth) : std::vector<double>();
  }
  if (error.quantity == ErrorQuantity::reaction) {
    const StoredQuantity* reaction = run.find("reaction_force");
    return reaction ? magnitudes(run.all(*reaction)) : std::vector<double>();
  }
  const StoredQuantity* force = run.find("force");
  return force ? magnitudes(rowsOfLaw(run, *force, error.law, 3)) : std::vector<double>();
}

TissueShape readShape(const RunReader& run) {
  TissueShape shape;
  const StoredQuantity* faces = run.find("faces");
  const StoredQuantity* times = run.find("snapshot_time");
  const StoredQuantity* positions = run.find("positions");
  if (!faces || !times || !positions || positions->rows == 0) return shape;
  const std::vector<double> corners = run.all(*faces);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    shape.faces.push_back(
        {static_cast<int>(corners[i]), static_cast<int>(corners[i + 1]), static_cast<int>(corners[i + 2])});
  shape.time_s = run.all(*times);
  const std::size_t width = positions->columns();
  const std::vector<double> all = run.all(*positions);
  for (std::size_t row = 0; row < positions->rows; ++row) {
    std::vector<Vec3>& vertices = shape.vertices_m.emplace_back();
    for (std::size_t i = row * width; i < (row + 1) * width; i += 3)
      vertices.emplace_back(all[i], all[i + 1], all[i + 2]);
  }
  return shape;
}

/// The vertices at a time within the snapshots, linear between two; at most `after_s` behind the last its
/// own.
std::optional<std::vector<Vec3>> verticesAt(const TissueShape& shape, double time_s, double after_s) {
  const std::vector<double>& times = shape.time_s;
  const double near_s = 1e-6 * after_s;
  if (time_s < times.front() - near_s || time_s > times.back() + after_s) return std::nullopt;
  const auto found = std::lower_bound(times.begin(), times.end(), time_s - near_s);
  if (found == times.end()) return shape.vertices_m.back();
  const auto at = static_cast<std::size_t>(found - times.begin());
  if (at == 0 || times[at] - time_s <= near_s) return shape.vertices_m[at];
  const double share = (time_s - times[at - 1]) / (times[at] - times[at - 1]);
  std::vector<Vec3> vertices = shape.vertices_m[at];
  for (std::size_t v = 0; v < vertices.size(); ++v)
    vertices[v] = (1 - share) * shape.vertices_m[at - 1][v] + share * vertices[v];
  return vertices;
}

bool allFinite(const std::vector<Vec3>& vertices) {
  return std::all_of(vertices.begin(), vertices.end(), [](const Vec3& v) { return v.allFinite(); });
}

}  // namespace

StudyRecord readRecord(const std::filesystem::path& file, const std::string& pipeline,
                       const std::vector<StudyError>& errors) {
  const RunReader run(file, pipeline);
  StudyRecord record;
  const StoredQuantity* time = run.find("time");
  const std::vector<double> times_s = time ? run.all(*time) : std::vector<double>();
  if (!times_s.empty()) record.end_s = times_s.back();
  for (const StudyError& error : errors) {
    StudyCurve& curve = record.curves.emplace_back();
    if (error.quantity == ErrorQuantity::shape) {
      record.shape = readShape(run);
      continue;
    }
    std::vector<double> values = valuesOf(run, error);
    if (values.size() == times_s.size()) curve = {times_s, std::move(values)};
  }
  return record;
}

double largestDisplacement_m(const TissueShape& shape) {
  double most_m = shape.vertices_m.empty() ? kMissing : 0;
  for (const std::vector<Vec3>& vertices : shape.vertices_m) {
    if (!allFinite(vertices)) return kMissing;
    for (std::size_t v = 0; v < vertices.size(); ++v)
      most_m = std::max(most_m, (vertices[v] - shape.vertices_m.front()[v]).norm());
  }
  return most_m;
}

CurveError shapeErrorOf(const TissueShape& run, const TissueShape& reference) {
  if (run.vertices_m.empty() || reference.vertices_m.empty() || run.faces.empty()) return {};
  const std::size_t snapshots = reference.time_s.size();
  const double spacing_s = snapshots > 1 ? (reference.time_s.back() - reference.time_s.front()) /
                                               static_cast<double>(snapshots - 1)
                                         : 0;
  if (!allFinite(run.vertices_m.front())) return {};
  SurfaceTree tree(TriangleMesh{run.vertices_m.front(), run.faces});
  CurveError error{0, 0, 0};
  double count = 0;
  for (std::size_t s = 0; s < snapshots; ++s) {
    const std::optional<std::vector<Vec3>> vertices = verticesAt(run, reference.time_s[s], spacing_s);
    if (!vertices || !allFinite(*vertices) || !allFinite(reference.vertices_m[s])) return {};
    tree.update(*vertices);
    for (const Vec3& vertex : reference.vertices_m[s]) {
      const double distance = distance_m(tree, SurfaceTree::toTree(vertex));
      error.rms += distance * distance;
      error.worst = std::max(error.worst, distance);
      ++count;
    }
  }
  error.rms = std::sqrt(error.rms / count);
  error.peak = std::abs(largestDisplacement_m(run) - largestDisplacement_m(reference));
  return error;
}

CurveError errorOf(const StudyRecord& run, const StudyRecord& reference, ErrorQuantity quantity,
                   std::size_t index) {
  if (quantity == ErrorQuantity::shape) return shapeErrorOf(run.shape, reference.shape);
  return errorOf(run.curves[index], reference.curves[index]);
}

}  // namespace fissure
