#pragma once

#include <algorithm>
#include <string>

namespace fissure {

/// Errors are one line, whatever a library puts into its messages.
inline std::string oneLine(std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

}  // namespace fissure
