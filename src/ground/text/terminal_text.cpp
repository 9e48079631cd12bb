#include "text/terminal_text.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstring>
#include <ostream>

#include "base/error.h"
#include "base/utf8.h"

namespace fissure {

namespace {

std::string writtenOut(char byte) {
  return fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
}

}  // namespace

PlainTextBuffer::~PlainTextBuffer() {
  for (const char byte : begun_) put(writtenOut(byte));
}

bool PlainTextBuffer::noteError(bool good) {
  if (!good && error_ == 0) error_ = errno;
  return good;
}

bool PlainTextBuffer::put(std::string_view text) {
  const auto size = static_cast<std::streamsize>(text.size());
  errno = 0;
  return noteError(to_.sputn(text.data(), size) == size);
}

int PlainTextBuffer::sync() {
  errno = 0;
  return noteError(to_.pubsync() == 0) ? 0 : -1;
}

PlainTextBuffer::int_type PlainTextBuffer::overflow(int_type c) {
  if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
  const char byte = traits_type::to_char_type(c);
  return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
}

std::streamsize PlainTextBuffer::xsputn(const char* text, std::streamsize size) {
  const std::string all = begun_ + std::string(text, static_cast<std::size_t>(size));
  begun_.clear();
  std::string_view left = all;
  std::size_t shown = 0;  // of `left`, what can go on as it is
  const auto flush = [&] {
    const bool good = put(left.substr(0, shown));
    left.remove_prefix(shown);
    shown = 0;
    return good;
  };
  while (shown < left.size()) {
    const Utf8Start start = utf8Start(left.substr(shown));
    const bool line_or_tab = start.character == '\n' || start.character == '\t';
    if (start.isWhole() && (line_or_tab || !isControl(start.character))) {
      shown += start.bytes;
      continue;
    }
    if (!flush()) return 0;
    if (start.kind == Utf8Start::Kind::unfinished) {
      begun_ = left;
      return size;
    }
    const bool good = put(start.isWhole() ? fmt::format("\\u{:04x}", start.character) : writtenOut(left[0]));
    if (!good) return 0;
    left.remove_prefix(start.bytes);
  }
  return flush() ? size : 0;
}

PlainOutput::PlainOutput(std::ostream& stream)
    : stream_(stream), before_(stream.rdbuf()), plain_(*stream.rdbuf()) {
  stream_.rdbuf(&plain_);
}

void PlainOutput::requireWritten(const std::string& name) {
  if (stream_.flush()) return;
  const int error = plain_.error();
  if (error == EPIPE) return;
  throw RunError(name + ": cannot write" + (error == 0 ? "" : std::string(": ") + std::strerror(error)));
}

PlainOutput::~PlainOutput() {
  stream_.flush();
  stream_.rdbuf(before_);
}

}  // namespace fissure
