#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace fissure {

/// Cuts a stream of bytes into lines, in bounded memory: of a line longer than `longest`, only its first
/// `longest` bytes are kept.
class LineSplitter {
 public:
  explicit LineSplitter(std::size_t longest) : longest_(longest) {}

  /// Calls `line` with every line that `bytes` completes, without its end (' ' or "\r ").
  void feed(std::string_view bytes, const std::function<void(std::string_view)>& line);
  /// Calls `line` with the rest, where the last line has no ' '.
  void finish(const std::function<void(std::string_view)>& line);

 private:
  std::size_t longest_;
  std::string pending_;
  bool started_ = false;  ///< the current line has begun
};

/// `text` as one printable line, fit for result files and terminals: control characters and bytes that are no
/// UTF-8 become '?'.
std::string printableLine(std::string_view text);

}  // namespace fissure
