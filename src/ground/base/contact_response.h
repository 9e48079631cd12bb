#pragma once

namespace fissure {

/// What contacts between tool and tissue do to the tissue's momentum.
enum class ContactResponse {
  none,      ///< nothing: tissue is displaced and keeps its velocities (the paper)
  momentum,  ///< velocities follow the displacement, friction included (ContactImpulses)
};

}  // namespace fissure
