#include "check/plausibility.h"

#include <algorithm>
#include <array>

#include "check/run_plan.h"
#include "measure/penetration.h"
#include "motion/jaw_poses.h"
#include "motion/motion.h"
#include "scenario/compose.h"
#include "scenario/rigid_tools.h"
#include "scenario/summary_keys.h"
#include "text/did_you_mean.h"
#include "text/scalars.h"
#include "text/units.h"

namespace fissure {

namespace {

constexpr double largest_m = 1, smallest_m = 1e-4;
/// How often a motion is looked at, evenly over the run: enough to see how far it goes.
constexpr int looks = 1000;
/// A box of 12 has corners alone.
constexpr std::size_t too_few_triangles = 12;
/// Less is touching.
constexpr double inside_m = 1e-6;

/// The edges of the box around a mesh along the axes of its frame.
Vec3 extentOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : mesh.vertices_m) box.extend(vertex);
  return box.sizes();
}

/// The values of a run's summary that are known before it: those of its probes, without those of an engine.
std::vector<std::string> knownQuantities(const CheckedScenario& checked, const PipelineSettings& run) {
  std::vector<std::string> names;
  for (const SummaryValue& value : emptySummaryOf(checked, run))
    if (!value.name.starts_with("timing/")) names.push_back(value.name);
  return names;
}

/// What only some runs have, or engines alone say.
bool isSometimesThere(const std::string& quantity, const Scenario& scenario) {
  static const std::array<const char*, 18> names = {"non_finite_at_step",
                                                    "first_uncertified_step",
                                                    "first_unsound_step",
                                                    "rays",
                                                    "ray_triangle_tests",
                                                    "displacement_sweeps",
                                                    "displacement_pushes",
                                                    "rounds",
                                                    "truncated_steps",
                                                    "truncated_vertices",
                                                    "no_room_steps",
                                                    "freeing_steps",
                                                    "substeps",
                                                    "first_uncertified",
                                                    "unsound_tissue",
                                                    "untouched_tools",
                                                    "laws_of_whole_probes",
                                                    "steps_per_measurement"};
  if (std::find(names.begin(), names.end(), quantity) != names.end()) return true;
  const std::vector<NamedKey> named = namedSummaryKeys(scenario);
  return std::any_of(named.begin(), named.end(), [&](const NamedKey& key) { return key.key == quantity; });
}

class Plausibility {
 public:
  explicit Plausibility(const CheckedScenario& checked)
      : checked_(checked),
        scenario_(checked.loaded.scenario),
        scene_(checked.prepared.scene),
        written_(parseYaml(checked.loaded.composed, inFile(checked.file, 1))) {}

  std::vector<std::string> take() {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) lookAtBody(scenario_.bodies[b], scene_.bodies[b]);
    for (const SceneTool& tool : scene_.tools) lookAtTool(tool);
    for (std::size_t t = 0; t < scenario_.tools.size(); ++t) lookAtMotion(t);
    for (const ForceSettings& law : scenario_.force) lookAtLaw(law);
    lookAtStart();
    for (std::size_t i = 0; i < scenario_.expect.size(); ++i) lookAtExpectation(i);
    return std::move(warnings_);
  }

 private:
  void warn(const std::string& path, const std::string& text) {
    warnings_.push_back("warning: " + path + ": " + text);
  }

  bool isWritten(const std::string& path) { return findNode(written_, path) != nullptr; }

  void lookAtSize(const std::string& path, const char* what, const Vec3& extent_m) {
    const double size_m = extent_m.maxCoeff();
    if (size_m >= smallest_m && size_m <= largest_m) return;
    warn(path, std::string(what) + " of " + fourDigits(size_m) +
                   " m, expected 0.0001 m to 1 m (lengths are in metres)");
  }

  void lookAtBody(const BodySettings& settings, const SceneBody& body) {
    const std::string path = "bodies." + body.name;
    const Vec3 extent_m = extentOf(body.rest);
    lookAtSize(path + ".shape", "a body", extent_m);
    if (settings.margin_m > extent_m.minCoeff())
      warn(path + ".margin_m", "the margin, " + fourDigits(settings.margin_m) +
                                   " m, is larger than the body is thick, " +
                                   fourDigits(extent_m.minCoeff()) + " m, expected a small part of that");
    if (!scene_.tools.empty() && body.rest.faces.size() <= too_few_triangles)
      warn(path + ".shape", "a body of " + std::to_string(body.rest.faces.size()) +
                                " triangles has nothing between its corners that tools could press in, "
                                "expected finer ones" +
                                finerBy(settings.shape));
    if (!settings.isElastic() && !isWritten(path + ".mass_kg"))
      warn(path + ".mass_kg", "is not given and is " + formatReal(settings.mass_kg) +
                                  " kg whatever the body's size, expected the mass of the body");
    if (settings.isElastic() && !settings.elastic.preset && !isWritten(path + ".elastic.youngs_modulus_Pa"))
      warn(path + ".elastic.youngs_modulus_Pa", "is not given and is " +
                                                    formatReal(settings.elastic.youngs_modulus_Pa) +
                                                    " Pa, expected the modulus of the tissue, or a preset");
  }

  static std::string finerBy(const SurfaceShape& shape) {
    if (std::holds_alternative<BoxShape>(shape)) return " (`cells`)";
    return std::holds_alternative<FileShape>(shape) ? " (`max_edge_m`)" : "";
  }

  void lookAtTool(const SceneTool& tool) {
    const std::string path = "tools." + tool.name;
    const double size_m = extentOf(tool.surface).maxCoeff();
    lookAtSize(path + ".shape", "a tool", extentOf(tool.surface));
    for (const BodySettings& body : scenario_.bodies)
      if (body.margin_m > size_m)
        warn("bodies." + body.name + ".margin_m",
             "the margin, " + fourDigits(body.margin_m) + " m, is larger than tool " + tool.name + ", " +
                 fourDigits(size_m) + " m, expected a small part of that");
  }

  void lookAtMotion(std::size_t tool) {
    const Motion& motion = *checked_.prepared.motions[tool];
    Eigen::AlignedBox3d path_m;
    for (int i = 0; i <= looks; ++i) path_m.extend(motion.poseAt(checked_.duration_s * i / looks).position_m);
    const double size_m = path_m.sizes().maxCoeff();
    if (size_m <= largest_m) return;
    const bool is_replay = std::holds_alternative<ReplayMotion>(scenario_.tools[tool].motion);
    warn("tools." + scenario_.tools[tool].name + ".motion",
         "the tool travels over " + fourDigits(size_m) + " m, expected at most 1 m" +
             (is_replay ? " (of a log in the unit that `position_unit` says)" : " (lengths are in metres)"));
  }

  bool pushesACoupledTool(const ForceSettings& law) const {
    return std::any_of(scenario_.tools.begin(), scenario_.tools.end(), [&](const ToolSettings& tool) {
      return tool.coupling && tool.coupling->force == law.name;
    });
  }

  void lookAtLaw(const ForceSettings& law) {
    if (law.model == ForceModel::hunt_crossley && law.coefficients.n < 1 && pushesACoupledTool(law))
      warn("force." + law.name + ".n",
           "is " + formatReal(law.coefficients.n) +
               ": where contact begins the law's stiffness, k n x^(n-1), has no bound, and a tool that feels "
               "it one step late chatters at any step, expected at least 1 for a law that pushes a coupled "
               "tool");
    if (law.tissue) return;
    std::string missing;
    for (const LawCoefficient& of : entryOf(law.model).coefficients) {
      const std::string name(of.name);
      if (!isWritten("force." + law.name + "." + name))
        missing += (missing.empty() ? "" : ", ") + name + " " + formatReal(of.default_value);
    }
    if (!missing.empty())
      warn("force." + law.name, "coefficients are not given and are those of no tissue (" + missing +
                                    "), expected them, or a tissue");
  }

  /// Poses of the scene's tools at time zero.
  std::vector<ToolState> firstPoses() const {
    std::vector<ToolState> tools;
    for (std::size_t t = 0; t < scenario_.tools.size(); ++t) {
      const ToolSettings& tool = scenario_.tools[t];
      const Motion& motion = *checked_.prepared.motions[t];
      if (!tool.clamp) {
        tools.push_back({motion.poseAt(0)});
        continue;
      }
      for (const Pose& jaw : jawPoses(*tool.clamp, closedJaws(tool), motion.poseAt(0), motion.openingAt(0)))
        tools.push_back({jaw});
    }
    return tools;
  }

  void lookAtStart() {
    if (scene_.tools.empty()) return;
    State start;
    start.tools = firstPoses();
    for (const SceneBody& body : scene_.bodies)
      start.positions_m.insert(start.positions_m.end(), body.rest.vertices_m.begin(),
                               body.rest.vertices_m.end());
    PenetrationMeter meter(scene_, scenario_.measure);
    const double depth_m = meter.measure(start).depth_m;
    if (!(depth_m > inside_m)) return;
    bool named = false;
    for (std::size_t t = 0; t < scene_.tools.size(); ++t) {
      if (!meter.isInTissue(t)) continue;
      named = true;
      warn("tools." + scene_.tools[t].name + ".motion",
           "the tool starts inside tissue, up to " + fourDigits(1e3 * depth_m) +
               " mm deep before anything moves, expected a start outside");
    }
    if (!named)
      warn("tools", "tissue lies " + fourDigits(1e3 * depth_m) +
                        " mm deep in a tool before anything moves, expected tools that start outside");
  }

  void lookAtExpectation(std::size_t index) {
    const Expectation& expected = scenario_.expect[index];
    if (isSometimesThere(expected.quantity, scenario_)) return;
    for (const PipelineSettings& run : scenario_.pipelines) {
      if (expected.pipeline && *expected.pipeline != run.name) continue;
      const std::vector<std::string> known = knownQuantities(checked_, run);
      if (std::find(known.begin(), known.end(), expected.quantity) != known.end()) continue;
      const std::string* meant = nearestName(expected.quantity, known);
      warn("expect." + std::to_string(index) + ".quantity",
           "run " + run.name + " will have no value \"" + expected.quantity + "\" and fail" +
               (meant ? ", did you mean \"" + *meant + "\"?" : ", expected one of its summary"));
    }
  }

  const CheckedScenario& checked_;
  const Scenario& scenario_;
  const Scene& scene_;
  YamlNode written_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::vector<std::string> plausibilityWarnings(const CheckedScenario& checked) {
  return Plausibility(checked).take();
}

}  // namespace fissure
