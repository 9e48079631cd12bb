#include "store/snapshot_writer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace fissure {

namespace {

const std::vector<std::string> xyz = {"x", "y", "z"};
const std::vector<std::string> colours = {"red", "green", "blue"};
constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

std::vector<std::int64_t> cornersOf(const std::vector<Face>& faces, int first_vertex) {
  std::vector<std::int64_t> corners;
  for (const Face& face : faces) {
    for (const int corner : face) corners.push_back(first_vertex + corner);
  }
  return corners;
}

void addFaces(GroupBuilder& group, const std::vector<std::int64_t>& corners) {
  const hsize_t count = corners.size() / 3;
  group.addIndex("face", count);
  group.addIndex("corner", 3);
  group.addFixed({"faces",
                  "1",
                  "vertices of each triangle, counter-clockwise seen from outside",
                  ValueType::count,
                  {{"face", count}, {"corner", 3}}},
                 corners);
}

/// `vertices_long_name`: what the vertices are, and in whose frame.
void addSurface(GroupBuilder& group, const TriangleMesh& surface, const std::string& vertices_long_name) {
  const hsize_t count = surface.vertices_m.size();
  group.addIndex("vertex", count);
  group.addLabels("xyz", xyz);
  group.addFixed({"vertices", "m", vertices_long_name, ValueType::real, {{"vertex", count}, {"xyz", 3}}},
                 surface.vertices_m);
  addFaces(group, cornersOf(surface.faces, 0));
}

void addVolume(GroupBuilder& group, const SceneVolume& volume) {
  const std::vector<Vec3>& vertices_m = volume.mesh.vertices_m;
  const std::vector<Tetrahedron>& tetrahedra = volume.mesh.tetrahedra;
  const Dimension vertex{"vertex", vertices_m.size()}, tetrahedron{"tetrahedron", tetrahedra.size()};
  group.addIndex("vertex", vertex.length);
  group.addLabels("xyz", xyz);
  group.addFixed({"vertices",
                  "m",
                  "vertices of the body at rest, those of its surface first, scene frame",
                  ValueType::real,
                  {vertex, {"xyz", 3}}},
                 vertices_m);
  std::vector<std::int64_t> corners;
  for (const Tetrahedron& one : tetrahedra) corners.insert(corners.end(), one.begin(), one.end());
  std::vector<std::int64_t> numbers(tetrahedra.size());
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  group.addFixedPacked({"tetrahedron", "1", "index of each tetrahedron", ValueType::count, {tetrahedron}},
                       numbers);
  group.addIndex("corner", 4);
  group.addFixedPacked({"tetrahedra",
                        "1",
                        "vertices of each tetrahedron, the first three counter-clockwise seen from the last",
                        ValueType::count,
                        {tetrahedron, {"corner", 4}}},
                       corners);
  if (!volume.regions.empty())
    group.addFixedPacked({"region",
                          "1",
                          "of each tetrahedron: 0, or 1 + the index of its region in the scenario",
                          ValueType::count,
                          {tetrahedron}},
                         std::vector<std::int64_t>(volume.regions.begin(), volume.regions.end()));
  if (volume.fixed_vertices.empty()) return;
  const Dimension fixed{"fixed_vertex", volume.fixed_vertices.size()};
  group.addIndex("fixed_vertex", fixed.length);
  group.addFixed({"fixed_vertices", "1", "vertices that never move, ascending", ValueType::count, {fixed}},
                 std::vector<std::int64_t>(volume.fixed_vertices.begin(), volume.fixed_vertices.end()));
}

void addNodes(GroupBuilder& group, const ToolNodes& nodes) {
  const hsize_t count = nodes.positions_m.size();
  std::vector<double> thicknesses_m = nodes.thicknesses_m;
  for (double& thickness_m : thicknesses_m) {
    if (!std::isfinite(thickness_m)) thickness_m = std::numeric_limits<double>::quiet_NaN();
  }
  const Dimension node{"node", count};
  group.addIndex("node", count);
  group.addFixed({"nodes", "m", "positions of the tool nodes", ValueType::real, {node, {"xyz", 3}}},
                 nodes.positions_m);
  group.addFixed(
      {"node_normals", "1", "unit normals of the tool nodes, outward", ValueType::real, {node, {"xyz", 3}}},
      nodes.normals);
  group.addFixed({"node_partner", "1", "node across the tool, -1: none", ValueType::count, {node}},
                 std::vector<std::int64_t>(nodes.partners.begin(), nodes.partners.end()));
  group.addFixed({"node_thickness", "m", "distance to the node across the tool", ValueType::real, {node}},
                 thicknesses_m);
}

}  // namespace

void addBodies(GroupBuilder& group, const Scene& scene) {
  std::vector<std::string> names;
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> first_vertices;
  std::vector<std::int64_t> first_faces;
  for (const SceneBody& body : scene.bodies) {
    names.push_back(body.name);
    first_vertices.push_back(body.first_vertex);
    first_faces.push_back(body.first_face);
    const std::vector<std::int64_t> own = cornersOf(body.rest.faces, body.first_vertex);
    corners.insert(corners.end(), own.begin(), own.end());
  }
  const Dimension body{"body", names.size()};
  addFaces(group, corners);
  group.addLabels("body", names);
  group.addFixed({"first_vertex", "1", "first vertex of each body", ValueType::count, {body}},
                 first_vertices);
  group.addFixed({"first_face", "1", "first face of each body", ValueType::count, {body}}, first_faces);
}

void addVolumes(GroupBuilder& group, const Scene& scene) {
  std::optional<GroupBuilder> volumes;
  for (const SceneBody& body : scene.bodies) {
    if (!body.volume) continue;
    if (!volumes) volumes.emplace(group.id(), "volumes");
    GroupBuilder own(volumes->id(), body.name);
    addVolume(own, *body.volume);
  }
}

void addTools(GroupBuilder& group, const Scene& scene) {
  if (scene.tools.empty()) return;
  const GroupBuilder tools(group.id(), "tools");
  std::vector<std::string> names;
  std::vector<std::int64_t> first_nodes;
  for (const SceneTool& tool : scene.tools) {
    names.push_back(tool.name);
    first_nodes.push_back(tool.first_node);
    GroupBuilder own(tools.id(), tool.name);
    addSurface(own, tool.surface, "vertices of the tool, in its frame");
    if (tool.nodes.size() > 0) addNodes(own, tool.nodes);
  }
  if (scene.nodeCount() == 0) return;
  group.addLabels("tool", names);
  group.addFixed({"first_node", "1", "first node of each tool", ValueType::count, {{"tool", names.size()}}},
                 first_nodes);
}

void addHandles(GroupBuilder& group, const Scene& scene) {
  if (!scene.hasHandles()) return;
  const GroupBuilder visuals(group.id(), "visuals");
  for (const SceneClamp& clamp : scene.clamps) {
    if (clamp.handle.faces.empty()) continue;
    GroupBuilder own(visuals.id(), clamp.name + "_handle");
    addSurface(own, clamp.handle, "vertices of the handle, in the clamp's frame");
  }
}

SnapshotWriter::SnapshotWriter(GroupBuilder& group, const Scene& scene, std::size_t expected)
    : vertices_(static_cast<std::size_t>(scene.vertexCount())),
      nodes_(static_cast<std::size_t>(scene.nodeCount())),
      placed_clamps_(scene.hasHandles() ? scene.clamps.size() : 0),
      has_pressures_(std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                 [](const SceneBody& body) { return body.volume.has_value(); })) {
  const std::size_t bytes = std::max<std::size_t>(1, vertices_ * sizeof(Vec3));
  chunk_ = std::clamp<std::size_t>(buffer_bytes / bytes, 1, expected == 0 ? 64 : expected);
  const Dimension time{"snapshot_time", chunk_, true};
  const Dimension vertex{"vertex", vertices_};
  time_data_ = group.addGrowing({"snapshot_time", "s", "time of each snapshot", ValueType::real, {time}});
  group.addIndex("vertex", vertices_);
  group.addLabels("xyz", xyz);
  position_data_ = group.addGrowing({"positions",
                                     "m",
                                     "positions of the tissue's vertices, scene frame",
                                     ValueType::real,
                                     {time, vertex, {"xyz", 3}}});
  contact_data_ = group.addGrowing(
      {"vertex_contact", "1", "whether a vertex is in contact with a tool", ValueType::flag, {time, vertex}});
  if (has_pressures_)
    pressure_data_ = group.addGrowing({"contact_pressure",
                                       "Pa",
                                       "normal stress of the contacts on the tissue at each vertex",
                                       ValueType::real,
                                       {time, vertex}});
  if (placed_clamps_ > 0) addClamps(group, scene);
  if (nodes_ == 0) return;
  group.addIndex("node", nodes_);
  node_data_ = group.addGrowing(
      {"node_state", "1", "what each tool node did in the step", ValueType::flag, {time, {"node", nodes_}}});
}

void SnapshotWriter::addClamps(GroupBuilder& group, const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneClamp& clamp : scene.clamps) names.push_back(clamp.name);
  const Dimension time{"snapshot_time", chunk_, true};
  const Dimension clamp{"clamp", placed_clamps_};
  group.addLabels("clamp", names);
  group.addLabels("quat", {"x", "y", "z", "w"});
  clamp_position_data_ = group.addGrowing({"clamp_position",
                                           "m",
                                           "origin of each clamp, scene frame",
                                           ValueType::real,
                                           {time, clamp, {"xyz", 3}}});
  clamp_quaternion_data_ = group.addGrowing({"clamp_quaternion",
                                             "1",
                                             "orientation of each clamp, scene frame",
                                             ValueType::real,
                                             {time, clamp, {"quat", 4}}});
}

bool SnapshotWriter::append(const State& state) {
  const auto fits = [](std::size_t size, std::size_t expected) { return size == 0 || size == expected; };
  if (state.positions_m.size() != vertices_ || !fits(state.contact.vertex_contact.size(), vertices_) ||
      !fits(state.contact.node_states.size(), nodes_) ||
      (has_pressures_ && (!state.volume || state.volume->pressures_Pa.size() != vertices_)) ||
      state.clamps.size() < placed_clamps_) {
    throw std::logic_error("a snapshot does not fit its scene");
  }
  for (const Vec3& position_m : state.positions_m) {
    positions_.insert(positions_.end(), position_m.data(), position_m.data() + 3);
  }
  contacts_.insert(contacts_.end(), state.contact.vertex_contact.begin(), state.contact.vertex_contact.end());
  for (const NodeState node : state.contact.node_states)
    node_states_.push_back(static_cast<std::uint8_t>(node));
  if (has_pressures_) {
    const std::vector<double>& pressures_Pa = state.volume.value().pressures_Pa;
    pressures_Pa_.insert(pressures_Pa_.end(), pressures_Pa.begin(), pressures_Pa.end());
  }
  for (std::size_t c = 0; c < placed_clamps_; ++c) {
    const Pose& pose = state.clamps[c].pose;
    clamp_positions_.insert(clamp_positions_.end(), pose.position_m.data(), pose.position_m.data() + 3);
    const double* const quaternion = pose.orientation.coeffs().data();  // x, y, z, w
    clamp_quaternions_.insert(clamp_quaternions_.end(), quaternion, quaternion + 4);
  }
  times_.push_back(state.time_s);
  ++unwritten_;
  contacts_.resize(unwritten_ * vertices_, 0);
  node_states_.resize(unwritten_ * nodes_, static_cast<std::uint8_t>(NodeState::free));
  if (++in_chunk_ < chunk_) return false;
  in_chunk_ = 0;
  return true;
}

void SnapshotWriter::writeData() {
  if (unwritten_ == 0) return;
  position_data_->append(positions_.data(), unwritten_);
  contact_data_->append(contacts_.data(), unwritten_);
  if (pressure_data_) pressure_data_->append(pressures_Pa_.data(), unwritten_);
  if (node_data_) node_data_->append(node_states_.data(), unwritten_);
  if (clamp_position_data_) clamp_position_data_->append(clamp_positions_.data(), unwritten_);
  if (clamp_quaternion_data_) clamp_quaternion_data_->append(clamp_quaternions_.data(), unwritten_);
  unwritten_ = 0;
  positions_.clear();
  contacts_.clear();
  pressures_Pa_.clear();
  clamp_positions_.clear();
  clamp_quaternions_.clear();
  node_states_.clear();
}

void SnapshotWriter::writeTimes() {
  if (times_.empty()) return;
  time_data_->append(times_.data(), times_.size());
  times_.clear();
}

FrameWriter::FrameWriter(GroupBuilder& group, int width_px, int height_px)
    : width_px_(width_px), height_px_(height_px) {
  const auto height = static_cast<hsize_t>(height_px);
  const auto width = static_cast<hsize_t>(width_px);
  time_data_ = group.addGrowing(
      {"frame_time", "s", "time of each frame", ValueType::real, {{"frame_time", 64, true}}});
  group.addIndex("image_y", height);
  group.addIndex("image_x", width);
  group.addLabels("channel", colours);
  picture_data_ =
      group.addPictures({"frames",
                         "1",
                         "pictures of the scene, rows from top to bottom",
                         ValueType::flag,
                         {{"frame_time", 1, true}, {"image_y", height}, {"image_x", width}, {"channel", 3}}});
}

void FrameWriter::append(double time_s, const Image& image) {
  const auto bytes = static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_) * 3;
  if (image.width_px != width_px_ || image.height_px != height_px_ || image.rgb.size() != bytes) {
    throw std::logic_error("a frame is not of the size the scenario asks for");
  }
  picture_data_->append(image.rgb.data(), 1);
  times_.push_back(time_s);
}

void FrameWriter::writeTimes() {
  if (times_.empty()) return;
  time_data_->append(times_.data(), times_.size());
  times_.clear();
}

}  // namespace fissure
