#pragma once

#include <string>
#include <vector>

#include "motion/motion.h"

namespace fissure {

/// A motion of waypoints and holds. Path and opening are continuous and reach exactly the targets of each
/// segment at its end.
class ScriptedMotion final : public Motion {
 public:
  /// `where`: the key path of the settings, for messages. Throws InputError for a segment without a target or
  /// whose duration is not determined: neither speed nor duration, a rotation on the spot without a duration,
  /// and the like.
  ScriptedMotion(const ScriptMotion& settings, const std::string& where);

  Pose poseAt(double time_s) const override;
  double openingAt(double time_s) const override;
  double duration_s() const override { return duration_s_; }

 private:
  struct Piece {
    double start_s = 0;
    double duration_s = 0;  ///< > 0
    Pose from;
    Pose to;                  ///< its quaternion is in the hemisphere of that of `from`
    double opening_from = 0;  ///< metres or degrees
    double opening_to = 0;
    Timing timing = Timing::constant;
    double ramp_fraction = 0.25;
  };
  /// The piece at `time_s`, and in `way` the share of its path that is covered then; null outside of all
  /// pieces.
  const Piece* pieceAt(double time_s, double& way) const;

  Pose first_;
  Pose last_;
  double first_opening_ = 0;
  double last_opening_ = 0;
  std::vector<Piece> pieces_;
  double duration_s_ = 0;
};

}  // namespace fissure
