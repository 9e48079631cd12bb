#pragma once

#include <memory>

#include "stepping/contact_method.h"

namespace fissure {

/// The reference for what is the tissue's own in a force curve, as a method after the engine's solve:
/// vertices that a box tool reaches stick to it from then on, so that tissue is compressed by prescribed
/// vertices, without contacts that come and go. What holds them is measured: the momentum that keeps them in
/// place. All tools must be boxes. Fixed vertices are left where they are.
std::unique_ptr<ContactMethod> makeStickingMethod(const ContactMethodContext& context);

}  // namespace fissure
