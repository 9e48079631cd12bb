#include "store/snapshot_reader.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace fissure {

namespace {

constexpr std::size_t any_length = static_cast<std::size_t>(-1);

Vec3 vectorAt(const std::vector<double>& values, std::size_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

Pose poseAt(const std::vector<double>& positions, const std::vector<double>& quaternions, std::size_t index) {
  const double* const q = &quaternions[4 * index];
  return {vectorAt(positions, index), Quat(q[3], q[0], q[1], q[2])};
}

std::vector<Vec3> vectorsOf(const std::vector<double>& values) {
  std::vector<Vec3> vectors(values.size() / 3);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = vectorAt(values, i);
  return vectors;
}

/// Nothing when one of them is not a whole number from `first` up to, but not including, `end`.
std::optional<std::vector<int>> indices(const std::vector<double>& values, double first, double end) {
  std::vector<int> whole;
  for (const double value : values) {
    if (!(value >= first && value < end) || value != std::floor(value)) return std::nullopt;
    whole.push_back(static_cast<int>(value - first));
  }
  return whole;
}

std::vector<Face> facesOf(const std::vector<int>& corners) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
    faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return faces;
}

/// Groups below `prefix` that hold `dataset`, in the order of the file.
std::vector<std::string> groupsWith(const RunReader& run, const std::string& prefix,
                                    const std::string& dataset) {
  std::vector<std::string> names;
  const std::string ending = "/" + dataset;
  for (const StoredQuantity& quantity : run.quantities())
    if (quantity.name.starts_with(prefix) && quantity.name.ends_with(ending) &&
        quantity.name.size() > prefix.size() + ending.size())
      names.push_back(
          quantity.name.substr(prefix.size(), quantity.name.size() - prefix.size() - ending.size()));
  return names;
}

}  // namespace

SnapshotReader::SnapshotReader(const std::filesystem::path& file, const std::string& pipeline)
    : path_(file), run_(file, pipeline) {
  const StoredQuantity* const times = run_.find("snapshot_time");
  if (times == nullptr || times->rows == 0) return;
  times_s_ = run_.all(*times);
  step_times_s_ = run_.all(need("time", {}));
  for (const std::vector<double>& ascending : {times_s_, step_times_s_})
    if (std::any_of(ascending.begin(), ascending.end(),
                    [](double time_s) { return !std::isfinite(time_s); }) ||
        !std::is_sorted(ascending.begin(), ascending.end()))
      throw InputError(inFile(path_), "damaged: the times of a run do not ascend");
  readBodies();
  readTools();
  readHandles();
}

/// `shape`: what it must have beside its rows.
const StoredQuantity& SnapshotReader::need(const std::string& name, std::vector<std::size_t> shape) const {
  const StoredQuantity* const quantity = run_.find(name);
  const auto fits = [](const StoredAxis& axis, std::size_t length) {
    return length == any_length || axis.length == length;
  };
  if (quantity == nullptr) throw InputError(inFile(path_), "damaged: there is no " + name);
  if (!std::equal(quantity->axes.begin(), quantity->axes.end(), shape.begin(), shape.end(), fits))
    throw InputError(inFile(path_), "damaged: " + name + " is not of the size that the others have");
  return *quantity;
}

std::vector<double> SnapshotReader::row(const std::string& name, std::size_t row,
                                        std::vector<std::size_t> shape) const {
  const StoredQuantity& quantity = need(name, std::move(shape));
  if (row >= quantity.rows) throw InputError(inFile(path_), "damaged: " + name + " ends before its times");
  return run_.rows(quantity, row, 1);
}

/// The row of the record that a snapshot belongs to.
std::size_t SnapshotReader::stepOf(std::size_t snapshot) const {
  const auto found = std::lower_bound(step_times_s_.begin(), step_times_s_.end(), times_s_[snapshot]);
  if (found == step_times_s_.end() || *found != times_s_[snapshot])
    throw InputError(inFile(path_), "damaged: a snapshot is of no recorded step");
  return static_cast<std::size_t>(found - step_times_s_.begin());
}

TriangleMesh SnapshotReader::readSurface(const std::string& group) const {
  const std::vector<double> vertices = run_.all(need(group + "/vertices", {any_length, 3}));
  const auto corners =
      indices(run_.all(need(group + "/faces", {any_length, 3})), 0, static_cast<double>(vertices.size()) / 3);
  if (!corners) throw InputError(inFile(path_), "damaged: " + group + "/faces name no vertices");
  return {vectorsOf(vertices), facesOf(*corners)};
}

/// Reads how many vertices each body has. A picture shows positions, so the rest shapes are not needed.
void SnapshotReader::readBodies() {
  const StoredQuantity& first_vertices = need("first_vertex", {any_length});
  const std::size_t count = first_vertices.axes.front().length;
  std::vector<double> vertices = run_.all(first_vertices);
  std::vector<double> faces = run_.all(need("first_face", {count}));
  const std::vector<double> corners = run_.all(need("faces", {any_length, 3}));
  vertices.push_back(static_cast<double>(need("positions", {any_length, 3}).axes.front().length));
  faces.push_back(static_cast<double>(corners.size()) / 3);
  for (std::size_t b = 0; b < count; ++b) {
    const bool ascends = vertices[b] >= 0 && vertices[b] <= vertices[b + 1] &&
                         vertices[b + 1] <= vertices[count] && faces[b] >= 0 && faces[b] <= faces[b + 1] &&
                         faces[b + 1] <= faces[count];
    if (!ascends) throw InputError(inFile(path_), "damaged: the bodies do not follow each other");
    const auto own = indices({corners.begin() + 3 * static_cast<std::ptrdiff_t>(faces[b]),
                              corners.begin() + 3 * static_cast<std::ptrdiff_t>(faces[b + 1])},
                             vertices[b], vertices[b + 1]);
    if (!own) throw InputError(inFile(path_), "damaged: faces name no vertices of their body");
    SceneBody body;
    body.rest = {std::vector<Vec3>(static_cast<std::size_t>(vertices[b + 1] - vertices[b]), Vec3::Zero()),
                 facesOf(*own)};
    body.first_vertex = static_cast<int>(vertices[b]);
    body.first_face = static_cast<int>(faces[b]);
    scene_.bodies.push_back(std::move(body));
  }
}

void SnapshotReader::readTools() {
  const bool with_nodes = run_.find("node_state") != nullptr;
  for (const std::string& name : groupsWith(run_, "tools/", "vertices")) {
    SceneTool tool{.name = name, .surface = readSurface("tools/" + name)};
    tool.first_node = scene_.nodeCount();
    const std::string nodes = "tools/" + name + "/nodes";
    if (with_nodes && run_.find(nodes) != nullptr)
      tool.nodes.positions_m = vectorsOf(run_.all(need(nodes, {any_length, 3})));
    scene_.tools.push_back(std::move(tool));
  }
}

void SnapshotReader::readHandles() {
  const std::string ending = "_handle";
  for (const std::string& name : groupsWith(run_, "visuals/", "vertices")) {
    if (!name.ends_with(ending)) continue;
    const StoredAxis& axis = need("clamp_position", {any_length, 3}).axes.front();
    const std::string clamp = name.substr(0, name.size() - ending.size());
    const auto found = std::find(axis.labels.begin(), axis.labels.end(), clamp);
    if (found == axis.labels.end()) throw InputError(inFile(path_), "damaged: " + name + " is of no clamp");
    all_clamps_ = axis.length;
    clamps_.push_back(static_cast<std::size_t>(found - axis.labels.begin()));
    scene_.clamps.push_back({.name = clamp, .handle = readSurface("visuals/" + name)});
  }
}

State SnapshotReader::at(std::size_t snapshot) const {
  State state;
  state.time_s = times_s_.at(snapshot);
  state.positions_m =
      vectorsOf(row("positions", snapshot, {static_cast<std::size_t>(scene_.vertexCount()), 3}));
  if (run_.find("contact_pressure"))
    state.volume.emplace().pressures_Pa =
        row("contact_pressure", snapshot, {static_cast<std::size_t>(scene_.vertexCount())});
  const std::size_t tools = scene_.tools.size();
  if (tools > 0) {
    const std::size_t step = stepOf(snapshot);
    const std::vector<double> positions = row("tool_position", step, {tools, 3});
    const std::vector<double> quaternions = row("tool_quaternion", step, {tools, 4});
    for (std::size_t t = 0; t < tools; ++t)
      state.tools.push_back({.pose = poseAt(positions, quaternions, t)});
  }
  if (!clamps_.empty()) {
    const std::vector<double> positions = row("clamp_position", snapshot, {all_clamps_, 3});
    const std::vector<double> quaternions = row("clamp_quaternion", snapshot, {all_clamps_, 4});
    for (const std::size_t c : clamps_) state.clamps.push_back({.pose = poseAt(positions, quaternions, c)});
  }
  if (scene_.nodeCount() > 0) {
    const auto states =
        indices(row("node_state", snapshot, {static_cast<std::size_t>(scene_.nodeCount())}), 0, 4);
    if (!states) throw InputError(inFile(path_), "damaged: node_state holds no states of nodes");
    for (const int value : *states) state.contact.node_states.push_back(static_cast<NodeState>(value));
  }
  return state;
}

FrameMeasures SnapshotReader::depths(std::size_t snapshot) const {
  const auto value = [&](const char* name) {
    return run_.find(name) ? std::optional(row(name, stepOf(snapshot), {}).front()) : std::nullopt;
  };
  return {value("penetration_depth"), value("inversion_aware_depth"), value("ground_depth"),
          value("certified"), value("max_pressure")};
}

}  // namespace fissure
