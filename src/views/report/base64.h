#pragma once

#include <string>
#include <string_view>

namespace fissure {

/// RFC 4648, with padding: 4 characters for every 3 bytes begun.
std::string base64(std::string_view bytes);

}  // namespace fissure
