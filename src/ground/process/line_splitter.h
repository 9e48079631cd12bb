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

  /// Calls `line` with every line that `bytes` completes, without its '\n' and a '\r' before it.
  void feed(std::string_view bytes, const std::function<void(std::string_view)>& line);
  /// The same for a last line that no '\n' ended.
  void finish(const std::function<void(std::string_view)>& line);

 private:
  std::size_t longest_;
  std::string pending_;
  bool started_ = false;  ///< something of the current line was seen
};

/// `text` as one printable line: control characters and bytes that are no UTF-8 become '?'. What a stray
/// process wrote ends up in result files and on terminals.
std::string printableLine(std::string_view text);

}  // namespace fissure
