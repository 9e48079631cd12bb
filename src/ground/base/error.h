#pragma once

#include <stdexcept>
#include <string>

namespace fissure {

/// Bad input or usage: exit code 2. what() is one line, `file:line: what is wrong, what was expected`.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error(message) {}
  InputError(const std::string& file, int line, const std::string& message)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + message) {}
};

/// A run, a worker or the disk failed: exit code 3. what() is one line.
class RunError : public std::runtime_error {
 public:
  explicit RunError(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace fissure
