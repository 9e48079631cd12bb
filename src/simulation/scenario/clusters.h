#pragma once

#include "scenario/key.h"

namespace fissure {

/// Bullet's clusters of tissue vertices, each of which contacts move as one rigid piece. They are built only
/// for the pipeline `cluster` and for `soft_contact: clusters`. The defaults are Bullet's, except for the
/// count, for which Bullet has none.
struct ClusterSettings {
  int count = 32;
  int iterations = 4;
  double rigid_hardness = 0.1;
  double kinematic_hardness = 1.0;
  double soft_hardness = 0.5;
  double rigid_split = 0.5;
  double kinematic_split = 0.5;
  double soft_split = 0.5;
  double node_damping = 0.0;
  double linear_damping = 0.0;
  double angular_damping = 0.0;
  double matching = 0.0;

  bool operator==(const ClusterSettings&) const = default;
};

template <class Io>
void describe(Io& io, ClusterSettings& c) {
  io.field("count", c.count, Key("Number of clusters; 0 makes one of each triangle.").count(0, 65536));
  io.field("iterations", c.iterations,
           Key("Iterations of the cluster solver in a step [citerations]; `settings: tuned` of a run takes "
               "at least 20.")
               .count(1, 1000));
  io.field("rigid_hardness", c.rigid_hardness,
           Key("Hardness of contacts with dynamic rigid bodies [kSRHR_CL].").share());
  io.field("kinematic_hardness", c.kinematic_hardness,
           Key("Hardness of contacts with tools [kSKHR_CL].").share());
  io.field("soft_hardness", c.soft_hardness,
           Key("Hardness of contacts with soft bodies [kSSHR_CL].").share());
  io.field(
      "rigid_split", c.rigid_split,
      Key("Share of the overlap with a dynamic rigid body that is removed as displacement [kSR_SPLT_CL].")
          .share());
  io.field("kinematic_split", c.kinematic_split,
           Key("Share of the overlap with a tool that is removed as displacement [kSK_SPLT_CL].").share());
  io.field(
      "soft_split", c.soft_split,
      Key("Share of the overlap with a soft body that is removed as displacement [kSS_SPLT_CL].").share());
  io.field("node_damping", c.node_damping,
           Key("Damping of the vertices of a cluster towards its rigid motion [m_ndamping].").share());
  io.field("linear_damping", c.linear_damping, Key("Damping of a cluster's velocity [m_ldamping].").share());
  io.field("angular_damping", c.angular_damping,
           Key("Damping of a cluster's rotation [m_adamping].").share());
  io.field("matching", c.matching, Key("Shape matching of a cluster [m_matching].").share());
}

}  // namespace fissure
