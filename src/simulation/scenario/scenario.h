#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenario/bodies.h"
#include "scenario/forces.h"
#include "scenario/pipelines.h"
#include "scenario/tools.h"

namespace fissure {

struct TimeSettings {
  double step_s = 0.001;  ///< fixed time step dt, > 0
  /// Simulated before time zero with the tools at their first pose, not recorded; >= 0.
  double settle_s = 0.0;
  std::optional<double>
      duration_s;  ///< >= step_s, from time zero; default: until the longest tool motion ends

  bool operator==(const TimeSettings&) const = default;
};

/// Fields of Bullet's world that soft bodies read (btSoftBodyWorldInfo).
struct WorldSettings {
  Vec3 gravity_m_s2 = {0, -9.81, 0};
  double air_density_kg_m3 = 1.2;      ///< only matters with drag or lift
  double max_displacement_m = 1000.0;  ///< Bullet's cap on the velocity change by forces in a step, times dt

  bool operator==(const WorldSettings&) const = default;
};

/// A horizontal half-space under the tissue. Tissue stands on it with pipeline swept and with ground_contact
/// half_space, as one more obstacle of the tools' contacts; else Bullet solves one analytic contact a vertex,
/// which holds it a margin above, and gives way.
struct GroundSettings {
  double height_m = 0.0;
  /// Bullet's default for a rigid body; times the body's own. With the half-space the product is Coulomb's
  /// coefficient; Bullet's contact takes that share of what slips, once an iteration.
  double friction = 0.5;
  /// 0..1: Bullet's contact takes a vertex back by its way into the ground and lifts it by this share of its
  /// overlap besides. 1 throws it as far above: under load tissue then rattles at metres a second.
  double hardness = 0.3;

  bool operator==(const GroundSettings&) const = default;
};

struct CameraSettings {
  Vec3 position_m = {0, 0.1, 0.2};
  Vec3 look_at_m = {0, 0, 0};
  Vec3 up = {0, 1, 0};
  double field_of_view_deg = 35;  ///< vertical, 1..150

  bool operator==(const CameraSettings&) const = default;
};

struct FrameSettings {
  double every_s = 0.05;
  int width_px = 640;   ///< 16..4096
  int height_px = 480;  ///< 16..4096
  /// Default: the whole first state in view, seen from the front, above.
  std::optional<CameraSettings> camera;

  bool operator==(const FrameSettings&) const = default;
};

struct RecordSettings {
  std::optional<double> snapshots_every_s;  ///< vertex positions; default: none kept
  std::optional<FrameSettings> frames;      ///< default: none drawn, no renderer loaded
  /// What the force laws see of each colliding triangle in each step, so that other laws can be evaluated
  /// without simulating again; needs a force law.
  bool force_inputs = false;

  bool operator==(const RecordSettings&) const = default;
};

struct MeasureSettings {
  /// Distance between the tool-surface samples that penetration is measured on, metres; default: fine enough
  /// for the thinnest tool and the finest tissue edge, within measure's stated limits on their number.
  std::optional<double> sample_spacing_m;
  /// Whether each step's end is proved free of overlap between tools and tissue, by continuous collision
  /// detection over all their triangles; costs up to a fifth of a step.
  bool certify = false;

  bool operator==(const MeasureSettings&) const = default;
};

/// What an expectation asks of contact; without it an upper bound on depth, passing through or inversion does
/// not hold in a run in which a tool never touched tissue, which proves nothing.
enum class ExpectedContact {
  any,  ///< bounds hold without contact too
};

/// What the summary of a run must say: a value within a tolerance, or bounds. Checked after the run.
struct Expectation {
  std::optional<std::string> pipeline;  ///< name of the entry; default: every one
  std::string quantity;                 ///< of the summary: "max_penetration_depth_m"; no time of the machine
  std::optional<double> value;          ///< in the quantity's unit, with a tolerance
  std::optional<double> tolerance;      ///< >= 0: |found - value| may be so large
  std::optional<double> min;            ///< included
  std::optional<double> max;            ///< included
  std::optional<ExpectedContact> contact;

  bool operator==(const Expectation&) const = default;
};

/// One experiment: what is simulated, through which pipelines, what is recorded. Plain data, every default
/// here.
struct Scenario {
  int format = 1;
  std::string name;         ///< letters, digits, '_', '-'; names the result file
  std::string description;  ///< one line
  TimeSettings time;
  WorldSettings world;
  std::optional<GroundSettings> ground;
  std::vector<BodySettings> bodies;  ///< at least one
  std::vector<ToolSettings> tools;
  std::vector<PipelineSettings> pipelines;  ///< at least one; each is one run in a process of its own
  std::vector<ForceSettings> force;         ///< all evaluated in every run
  RecordSettings record;
  MeasureSettings measure;
  std::vector<Expectation> expect;

  /// Where relative file names of this scenario start. Not part of the file.
  std::filesystem::path directory = ".";

  bool operator==(const Scenario&) const = default;
};

/// Whether `text` can name a scenario or an item of it: 1 to 64 letters, digits, '_' and '-' (ASCII).
bool isName(std::string_view text);

/// More steps than this are refused, recorded or settling.
constexpr double max_steps = 1e8;

/// One thing wrong with a scenario; `path` as in `tools.spatula.shape.size_m` or `pipelines.0.sweeps`.
struct Problem {
  std::string path;
  std::string message;                   ///< what is wrong and what was expected
  std::vector<std::string> others = {};  ///< paths of what else it is about
};

/// Checks every value and every relation between them that needs no file. Empty: the scenario can be run.
std::vector<Problem> validate(const Scenario& scenario);
/// The same for pictures alone; paths as in `camera.up`.
std::vector<Problem> validate(const FrameSettings& frames);

}  // namespace fissure
