#include "process/line_splitter.h"

#include "base/utf8.h"

namespace fissure {

void LineSplitter::feed(std::string_view bytes, const std::function<void(std::string_view)>& line) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    const std::string_view piece = bytes.substr(0, end);
    pending_.append(piece.substr(0, longest_ - pending_.size()));
    started_ = true;
    if (end == std::string_view::npos) return;
    finish(line);
    bytes.remove_prefix(end + 1);
  }
}

void LineSplitter::finish(const std::function<void(std::string_view)>& line) {
  if (!started_) return;
  if (!pending_.empty() && pending_.back() == '\r') pending_.pop_back();
  line(pending_);
  pending_.clear();
  started_ = false;
}

std::string printableLine(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    const Utf8Start start = utf8Start(text);
    const bool printable = start.isWhole() && !isControl(start.character);
    const std::size_t taken = start.isWhole() ? start.bytes : 1;
    line += printable ? text.substr(0, taken) : "?";
    text.remove_prefix(taken);
  }
  return line;
}

}  // namespace fissure
