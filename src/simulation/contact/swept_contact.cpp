#include "contact/swept_contact.h"

#include <algorithm>

#include "contact/tool_escape.h"

namespace fissure {

namespace {

constexpr double kNearMargins = 3;       ///< pairs nearer than this many margins are contacts
constexpr double kLeastMobility = 0.01;  ///< of a contact's point over its most mobile vertex
constexpr double kSeparation = 0.01;     ///< of a margin: pairs that come nearer than that cross

/// How much of a contact's triangle counts: 1 up to a margin from the tool, 0 from kNearMargins of it on.
double weightAt(double margins) {
  const double u = std::clamp((kNearMargins - margins) / (kNearMargins - 1), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

}  // namespace

SweptContact::SweptContact(const Scene& scene, SweptContactSettings settings)
    : settings_(std::move(settings)),
      body_count_(scene.bodies.size()),
      tool_count_(scene.tools.size()),
      face_count_(scene.faceCount()),
      impulses_(scene.vertexCount(), settings_.sweeps, kLeastMobility),
      truncation_(scene.vertexCount(), settings_.ground, settings_.single_precision),
      beside_m_(scene.tools.size(), Vec3::Zero()),
      latest_(scene.vertexCount(), -1) {
  for (std::size_t b = 0; b < body_count_; ++b) {
    const std::size_t vertices = scene.bodies[b].rest.vertices_m.size();
    const double scale = settings_.time_scales.empty() ? 1 : settings_.time_scales.at(b);
    force_factors_.insert(force_factors_.end(), vertices, 1 / (scale * scale));
    if (!settings_.tool_frictions.empty())
      frictions_.insert(frictions_.end(), vertices, settings_.body_frictions.at(b));
  }
  if (settings_.ground)
    ground_.emplace(*settings_.ground, scene, settings_.margins_m, settings_.body_frictions);
  for (std::size_t t = 0; t < tool_count_; ++t)
    for (std::size_t b = 0; b < body_count_; ++b)
      obstacles_.emplace_back(scene, t, b, settings_.margins_m.at(b));
}

void SweptContact::step(const StepView& given, std::span<const double> inverse_masses,
                        ContactOutcome& outcome, ContactPatch& patch) {
  StageClock clock;
  placeTools(given);
  const StepView step{.positions_m = given.positions_m,
                      .before_m = given.before_m,
                      .tools_before = tools_before_,
                      .tools_now = tools_now_,
                      .tool_bodies = given.tool_bodies,
                      .dt_s = given.dt_s};
  solved_m_.assign(step.positions_m.begin(), step.positions_m.end());
  findNear(step);
  clock.lap(times_.search_s);
  bool crosses = true;
  for (int round = 0; crosses && round <= settings_.rounds; ++round) {
    if (round > 0) std::copy(solved_m_.begin(), solved_m_.end(), step.positions_m.begin());
    shareRoom(step);
    respond(step, inverse_masses);
    clock.lap(times_.displacement_s);
    crosses = findCrossings(step, round == 0);
    if (ground_) crosses |= ground_->findBelow(step.positions_m, inverse_masses);
    clock.lap(times_.search_s);
  }
  truncation_.clear();
  if (crosses) truncation_.apply(obstacles_, inverse_masses, step, impulses_.way_m(), impulses_.motion_m());
  may_overlap_ = truncation_.leftOverlap();
  clock.lap(times_.truncation_s);
  report(step, outcome, patch);
  clock.lap(times_.report_s);
}

void SweptContact::respond(const StepView& step, std::span<const double> inverse_masses) {
  if (ground_) ground_->append(constraints_);
  impulses_.apply(settings_.rounds > 0 ? std::span<const ContactConstraint>(constraints_)
                                       : std::span<const ContactConstraint>(),
                  inverse_masses, step);
  responders_.clear();
  for (const ContactConstraint& contact : constraints_)
    responders_.insert(responders_.end(), contact.vertices.begin(), contact.vertices.end());
  constraints_.resize(sources_.size());
  if (settings_.single_precision)
    for (const int vertex : responders_) roundToSingle(step.positions_m[vertex]);
  ++rounds_;
}

void SweptContact::placeTools(const StepView& step) {
  if (may_overlap_) freeTools(step);
  path_from_.assign(step.tools_before.begin(), step.tools_before.end());
  tools_before_.assign(step.tools_before.begin(), step.tools_before.end());
  tools_now_.assign(step.tools_now.begin(), step.tools_now.end());
  for (std::size_t t = 0; t < tool_count_; ++t) {
    const double length_m = beside_m_[t].norm();
    if (!(length_m > 0)) continue;
    path_from_[t].pose.position_m += beside_m_[t];
    beside_m_[t] *= std::max(length_m - settings_.max_displacement_m, 0.0) / length_m;
    tools_before_[t].pose.position_m += beside_m_[t];
    tools_now_[t].pose.position_m += beside_m_[t];
  }
  freeing_steps_ +=
      std::any_of(beside_m_.begin(), beside_m_.end(), [](const Vec3& way_m) { return !way_m.isZero(0); });
}

void SweptContact::freeTools(const StepView& step) {
  for (std::size_t t = 0; t < tool_count_; ++t) {
    Pose pose = step.tools_before[t].pose;
    pose.position_m += beside_m_[t];
    const std::span<SweptObstacle> obstacles = std::span(obstacles_).subspan(t * body_count_, body_count_);
    for (SweptObstacle& obstacle : obstacles) obstacle.setBefore(pose, step.before_m);
    const Mat3 scene_axes = pose.orientation.conjugate().toRotationMatrix();
    beside_m_[t] += pose.rotateToScene(escapeOf(obstacles, scene_axes));
  }
}

void SweptContact::findNear(const StepView& step) {
  for (const ContactConstraint& contact : constraints_) latest_[contact.vertices[0]] = -1;
  constraints_.clear();
  sources_.clear();
  for (std::size_t o = 0; o < obstacles_.size(); ++o) {
    SweptObstacle& obstacle = obstacles_[o];
    obstacle.setBefore(path_from_[obstacle.tool].pose, step.before_m);
    const double reach_m = kNearMargins * obstacle.margin_m;
    const TissuePath still{obstacle.before_m, obstacle.before_m};
    obstacle.pairs.gather(still, reach_m);
    found_.clear();
    obstacle.pairs.findNear(still, reach_m, found_);
    for (const SweptPair& pair : found_) add(step, {static_cast<int>(o), pair});
  }
  near_count_ = constraints_.size();
  if (ground_) ground_->begin(step);
}

// A pair that is near, or crossed before, is renewed. After the first response all of the tissue has a new
// path; after another one only what that one moved.
bool SweptContact::findCrossings(const StepView& step, bool whole_paths) {
  bool any = false;
  for (std::size_t o = 0; o < obstacles_.size(); ++o) {
    SweptObstacle& obstacle = obstacles_[o];
    const double separation_m = kSeparation * obstacle.margin_m;
    const Pose pose = movedPose(step, obstacle.tool);
    if (whole_paths || !step.tool_bodies.empty()) {
      obstacle.setNow(pose, step.positions_m);
      obstacle.pairs.gather(obstacle.path(), separation_m);
    } else {
      findMoved(obstacle);
      obstacle.setNow(pose, step.positions_m, moved_);
      obstacle.pairs.gather(obstacle.path(), separation_m, moved_);
    }
    found_.clear();
    obstacle.pairs.findCrossings(obstacle.path(), separation_m, found_);
    for (const SweptPair& pair : found_) {
      const Source source{static_cast<int>(o), pair};
      const int known = indexOf(source);
      if (known < 0)
        add(step, source);
      else
        constraints_[known] = constraintOf(step, source);
    }
    any |= !found_.empty();
  }
  return any;
}

void SweptContact::findMoved(const SweptObstacle& obstacle) {
  const int first = static_cast<int>(obstacle.first_vertex);
  const int end = first + static_cast<int>(obstacle.now_m.size());
  moved_.clear();
  for (const int vertex : responders_)
    if (vertex >= first && vertex < end) moved_.push_back(vertex - first);
}

// Where two contacts of one vertex, edge or face of the tissue face each other and leave less room than both
// targets, they share it.
void SweptContact::shareRoom(const StepView& step) {
  for (std::size_t i = 0; i < constraints_.size(); ++i)
    for (int j = sources_[i].earlier; j >= 0; j = sources_[j].earlier) {
      ContactConstraint &one = constraints_[i], &other = constraints_[j];
      if (one.vertices != other.vertices || one.normal.dot(other.normal) > -0.5) continue;
      const Vec3 between_m = pointOf(other, step.before_m) - pointOf(one, step.before_m);
      const double room_m = std::max((other.position_m - one.position_m - between_m).dot(one.normal), 0.0);
      if (one.target_m + other.target_m <= room_m) continue;
      one.target_m = std::min(one.target_m, 0.5 * room_m);
      other.target_m = std::min(other.target_m, 0.5 * room_m);
    }
}

void SweptContact::add(const StepView& step, const Source& source) {
  constraints_.push_back(constraintOf(step, source));
  sources_.push_back(source);
  int& latest = latest_[constraints_.back().vertices[0]];
  sources_.back().earlier = latest;
  latest = static_cast<int>(constraints_.size()) - 1;
}

int SweptContact::indexOf(const Source& source) const {
  const std::size_t first = obstacles_[source.obstacle].first_vertex + source.pair.vertices[0];
  int i = latest_[first];
  while (i >= 0 && !(sources_[i].obstacle == source.obstacle && sources_[i].pair.sameFeatures(source.pair)))
    i = sources_[i].earlier;
  return i;
}

ContactConstraint SweptContact::constraintOf(const StepView& step, const Source& source) const {
  const SweptObstacle& obstacle = obstacles_[source.obstacle];
  const Pose& pose = step.tools_now[obstacle.tool].pose;
  ContactConstraint contact;
  for (int j = 0; j < 3; ++j)
    contact.vertices[j] = static_cast<int>(obstacle.first_vertex) + source.pair.vertices[j];
  contact.weights = source.pair.weights;
  contact.position_m = pose.toScene(source.pair.tool_point_m);
  contact.normal = pose.rotateToScene(source.pair.normal);
  contact.tool = obstacle.tool;
  contact.target_m = obstacle.margin_m;
  if (!frictions_.empty())
    contact.friction = frictions_[contact.vertices[0]] * settings_.tool_frictions[contact.tool];
  if (ground_) ground_->makeRoomUnder(contact);
  return contact;
}

void SweptContact::report(const StepView& step, ContactOutcome& outcome, ContactPatch& patch) {
  const double dt_squared = step.dt_s * step.dt_s;
  outcome.reaction_on_tool_N =
      -(impulses_.total(force_factors_) + truncation_.total(force_factors_)) / dt_squared;
  outcome.tool_reactions_N.resize(tool_count_ > 1 ? tool_count_ : 0);
  for (std::size_t t = 0; t < outcome.tool_reactions_N.size(); ++t) {
    const int tool = static_cast<int>(t);
    outcome.tool_reactions_N[t] =
        -(impulses_.ofTool(tool, force_factors_) + truncation_.ofTool(tool, force_factors_)) / dt_squared;
  }
  if (ground_)
    outcome.ground_reaction_N =
        -(impulses_.ofTool(kGround, force_factors_) + truncation_.ofTool(kGround, force_factors_)) /
        dt_squared;
  outcome.tool_work_J = (impulses_.toolWork_kg_m2() + truncation_.toolWork_kg_m2()) / dt_squared;
  outcome.candidate_count = static_cast<int>(constraints_.size());
  outcome.contact_count = impulses_.pushing();
  outcome.infeasible_count = outcome.capped_count = 0;
  outcome.node_states.clear();
  patch.clear();
  if (!patch.tools.empty()) patch.face_weights.assign(face_count_, 0);
  for (std::size_t i = 0; i < near_count_; ++i) touch(step, i, {}, patch);
  near_contact_ = patch.vertex_contact;
  for (std::size_t i = near_count_; i < constraints_.size(); ++i) touch(step, i, near_contact_, patch);
}

void SweptContact::touch(const StepView& step, std::size_t index, std::span<const std::uint8_t> but_at,
                         ContactPatch& patch) const {
  const ContactConstraint& contact = constraints_[index];
  const SweptObstacle& obstacle = obstacles_[sources_[index].obstacle];
  const Vec3 moved_m =
      movedPose(step, contact.tool).position_m - step.tools_now[contact.tool].pose.position_m;
  const double gap_m =
      (pointOf(contact, step.positions_m) - contact.position_m - moved_m).dot(contact.normal);
  const double solved_m = (pointOf(contact, solved_m_) - contact.position_m).dot(contact.normal);
  const double weight = weightAt(gap_m / obstacle.margin_m);
  const double displacement_m = std::max(contact.target_m - solved_m, 0.0);
  for (int j = 0; j < 3; ++j) {
    const int vertex = contact.vertices[j];
    const double share = weight * contact.weights[j];
    if (!(share > 0) || (!but_at.empty() && but_at[vertex])) continue;
    patch.touchVertex(contact.tool, vertex, share, contact.normal, displacement_m);
    if (patch.face_weights.empty()) continue;
    for (const int f : obstacle.pairs.tissue().facesAt(vertex - static_cast<int>(obstacle.first_vertex))) {
      const std::size_t face = obstacle.first_face + static_cast<std::size_t>(f);
      patch.touchFace(contact.tool, static_cast<int>(face), share * contact.normal, share * displacement_m);
      patch.face_weights[face] = std::min(1.0, patch.face_weights[face] + share);
    }
  }
}

}  // namespace fissure
