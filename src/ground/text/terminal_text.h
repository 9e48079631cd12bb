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

  /// The system's number of what kept the first text from being written; 0: nothing, or it does not say.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  bool put(std::string_view text);
  /// Notes the system's error unless `good`, which it returns.
  bool noteError(bool good);

  std::streambuf& to_;
  std::string begun_;  ///< the first bytes of a character whose last ones have not come
  int error_ = 0;
};

/// While it lives, what is written to a stream goes through a PlainTextBuffer.
class PlainOutput {
 public:
  explicit PlainOutput(std::ostream& stream);
  ~PlainOutput();
  PlainOutput(const PlainOutput&) = delete;
  PlainOutput& operator=(const PlainOutput&) = delete;

  /// Throws RunError about `name`, with the system's reason, unless all that was printed is written: that
  /// must not look like success.
  void requireWritten(const std::string& name);

 private:
  std::ostream& stream_;
  std::streambuf* before_;
  PlainTextBuffer plain_;
};

}  // namespace fissure
