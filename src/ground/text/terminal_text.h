#pragma once

#include <iosfwd>
#include <streambuf>
#include <string>
#include <string_view>

namespace fissure {

/// Hands text on to another buffer in a form that controls no terminal: a character that would (isControl)
/// is written as \u009b, as in JSON, and a byte that belongs to no UTF-8 as \xff. Line ends and tabs stay. A
/// character may come in pieces.
class PlainTextBuffer : public std::streambuf {
 public:
  explicit PlainTextBuffer(std::streambuf& to) : to_(to) {}
  ~PlainTextBuffer() override;
  PlainTextBuffer(const PlainTextBuffer&) = delete;
  PlainTextBuffer& operator=(const PlainTextBuffer&) = delete;

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override { return to_.pubsync(); }

 private:
  bool put(std::string_view text);

  std::streambuf& to_;
  std::string begun_;  ///< the first bytes of a character whose last ones have not come
};

/// While it lives, what is written to a stream goes through a PlainTextBuffer.
class PlainOutput {
 public:
  explicit PlainOutput(std::ostream& stream);
  ~PlainOutput();
  PlainOutput(const PlainOutput&) = delete;
  PlainOutput& operator=(const PlainOutput&) = delete;

 private:
  std::ostream& stream_;
  std::streambuf* before_;
  PlainTextBuffer plain_;
};

}  // namespace fissure
