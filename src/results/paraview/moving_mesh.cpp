#include "paraview/moving_mesh.h"

#include <algorithm>

#include "base/error.h"
#include "base/geometry.h"

namespace fissure {

namespace {

const StoredQuantity& need(const RunReader& run, const std::string& name) {
  const StoredQuantity* quantity = run.find(name);
  if (!quantity)
    throw InputError(inFile(run.file()), "a run has snapshots but no " + name + ", expected both");
  return *quantity;
}

std::vector<double> read(const RunReader& run, const std::string& name) {
  return run.all(need(run, name));
}

/// For each snapshot the row of `time` that was recorded in the same step.
std::vector<std::size_t> rowsAt(const std::vector<double>& snapshots_s, const std::vector<double>& times_s) {
  std::vector<std::size_t> rows;
  for (const double snapshot_s : snapshots_s) {
    const auto row = std::lower_bound(times_s.begin(), times_s.end(), snapshot_s);
    if (row == times_s.end() || *row != snapshot_s) break;
    rows.push_back(static_cast<std::size_t>(row - times_s.begin()));
  }
  return rows;
}

/// The value of an object's points, each as often as it has points.
PointArray constantArray(const std::string& name, const std::vector<std::size_t>& points) {
  std::vector<double> values;
  for (std::size_t i = 0; i < points.size(); ++i)
    values.insert(values.end(), points[i], static_cast<double>(i));
  return {name, ValueType::count, 1, false, [values](std::size_t) { return values; }};
}

PointArray storedArray(const RunReader& run, const std::string& name, ValueType type = ValueType::flag) {
  return {name, type, 1, true,
          [&run, &stored = need(run, name)](std::size_t snapshot) { return run.rows(stored, snapshot, 1); }};
}

MovingMesh tissueOf(const RunReader& run) {
  const StoredQuantity& positions = need(run, "positions");
  MovingMesh mesh{.name = "tissue", .points = positions.columns() / 3};
  for (const double corner : read(run, "faces")) mesh.corners.push_back(static_cast<std::int64_t>(corner));
  const auto place = [&run, &positions](std::size_t snapshot) { return run.rows(positions, snapshot, 1); };
  mesh.positions_m = {"Points", ValueType::real, 3, true, place};
  mesh.arrays.push_back(
      {"displacement", ValueType::real, 3, true, [place, first_m = place(0)](std::size_t snapshot) {
         std::vector<double> moved_m = place(snapshot);
         for (std::size_t i = 0; i < moved_m.size(); ++i) moved_m[i] -= first_m[i];
         return moved_m;
       }});
  mesh.arrays.push_back(storedArray(run, "vertex_contact"));
  if (run.find("contact_pressure"))
    mesh.arrays.push_back(storedArray(run, "contact_pressure", ValueType::real));
  std::vector<double> first = read(run, "first_vertex");
  first.push_back(static_cast<double>(mesh.points));
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i + 1 < first.size(); ++i)
    counts.push_back(static_cast<std::size_t>(first[i + 1] - first[i]));
  mesh.arrays.push_back(constantArray("body", counts));
  return mesh;
}

/// Points of all tools, tool by tool, each in its tool's frame.
struct ToolPoints {
  std::vector<double> in_tool_m;
  std::vector<std::size_t> counts;

  void add(const std::vector<double>& positions_m) {
    in_tool_m.insert(in_tool_m.end(), positions_m.begin(), positions_m.end());
    counts.push_back(positions_m.size() / 3);
  }
};

/// Where they are at each snapshot; `rows` are those of the poses.
PointArray movedPoints(const RunReader& run, const ToolPoints& points, const std::vector<std::size_t>& rows) {
  return {"Points", ValueType::real, 3, true, [&run, points, rows](std::size_t snapshot) {
            const std::size_t row = rows.at(snapshot);
            const std::vector<double> origins_m = run.rows(need(run, "tool_position"), row, 1);
            const std::vector<double> turns = run.rows(need(run, "tool_quaternion"), row, 1);
            std::vector<double> moved_m = points.in_tool_m;
            double* point_m = moved_m.data();
            for (std::size_t tool = 0; tool < points.counts.size(); ++tool) {
              const double* turn = &turns[4 * tool];
              const Pose pose{Vec3(&origins_m[3 * tool]), Quat(turn[3], turn[0], turn[1], turn[2])};
              for (std::size_t i = 0; i < points.counts[tool]; ++i, point_m += 3)
                Eigen::Map<Vec3>{point_m} = pose.toScene(Vec3(point_m));
            }
            return moved_m;
          }};
}

void addTools(const RunReader& run, const std::vector<std::size_t>& rows, std::vector<MovingMesh>& meshes) {
  MovingMesh tools{.name = "tools"};
  ToolPoints surfaces, nodes;
  for (const std::string& tool : need(run, "tool_position").axes.at(0).labels) {
    const std::string group = "tools/" + tool + "/";
    const std::size_t before = surfaces.in_tool_m.size() / 3;
    for (const double corner : read(run, group + "faces"))
      tools.corners.push_back(static_cast<std::int64_t>(before) + static_cast<std::int64_t>(corner));
    surfaces.add(read(run, group + "vertices"));
    nodes.add(run.find(group + "nodes") ? read(run, group + "nodes") : std::vector<double>{});
  }
  tools.points = surfaces.in_tool_m.size() / 3;
  tools.positions_m = movedPoints(run, surfaces, rows);
  tools.arrays.push_back(constantArray("tool", surfaces.counts));
  meshes.push_back(tools);
  if (!run.find("node_state")) return;
  meshes.push_back({.name = "nodes",
                    .points = nodes.in_tool_m.size() / 3,
                    .positions_m = movedPoints(run, nodes, rows),
                    .arrays = {storedArray(run, "node_state"), constantArray("tool", nodes.counts)}});
}

}  // namespace

MovingMeshes movingMeshes(const RunReader& run) {
  MovingMeshes made;
  if (!run.find("positions")) return made;
  made.times_s = read(run, "snapshot_time");
  const std::vector<std::size_t> rows = rowsAt(made.times_s, read(run, "time"));
  made.times_s.resize(rows.size());
  if (rows.empty()) return made;
  made.meshes.push_back(tissueOf(run));
  if (run.find("tool_position")) addTools(run, rows, made.meshes);
  return made;
}

}  // namespace fissure
