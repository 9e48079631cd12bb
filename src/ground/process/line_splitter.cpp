#include "process/line_splitter.h"

#include <algorithm>

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

namespace {

/// Length of the valid UTF-8 sequence of two to four bytes that `text` begins with; 0: none (RFC 3629,
/// section 4).
std::size_t sequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool surrogate = first == 0xED && byte(1) > 0x9F;
  const bool beyond = first == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

}  // namespace

std::string printableLine(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    const unsigned char first = static_cast<unsigned char>(text.front());
    const bool ascii = first >= 0x20 && first < 0x7F;
    const std::size_t length = ascii ? 1 : first < 0x80 ? 0 : sequenceLength(text);
    if (length == 0)
      line += '?';
    else
      line += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
}

}  // namespace fissure
