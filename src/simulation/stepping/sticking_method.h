#pragma once

#include <memory>

#include "stepping/contact_method.h"

namespace fissure {

/// Makes the contact method of pipeline `prescribed`: vertices that a box tool reaches stick to it from then
/// on, so that tissue is deformed by prescribed vertices, without contacts that come and go. It is the
/// reference for the tissue's own part of a force curve. The reaction is the momentum that keeps these
/// vertices in place. All tools must be boxes. Fixed vertices do not stick.
std::unique_ptr<ContactMethod> makeStickingMethod(const ContactMethodContext& context);

}  // namespace fissure
