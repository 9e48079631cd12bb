#pragma once

#include <algorithm>
#include <string>

namespace fissure {

/// The message on one line: final line ends are removed, others become blanks.
inline std::string oneLine(std::string message) {
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

}  // namespace fissure
