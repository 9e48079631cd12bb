#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/descriptor.h"
#include "process/line_splitter.h"

namespace fissure {

/// The first folder of $PATH that has a program of that name; no value: none has.
std::optional<std::filesystem::path> programOnPath(const std::string& name);

/// A program that works on what it is fed through its standard input. It dies with the process that made it,
/// which must ignore SIGPIPE.
/// Of what it prints only the last line on stderr is kept.
class FedProcess {
 public:
  /// Starts the program, without a shell. Whoever waits for it in write() or finish() gives up when
  /// `stop_descriptor` becomes readable (-1: never), or when the program has neither taken nor said anything
  /// for `most_idle_s` seconds. Throws RunError when the system cannot; call from the
  /// process's main thread, as for Worker.
  FedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
             int stop_descriptor, int most_idle_s = 300);
  ~FedProcess();  ///< kills it when it still runs
  FedProcess(const FedProcess&) = delete;
  FedProcess& operator=(const FedProcess&) = delete;

  /// Hands on all bytes. Throws RunError, with the program's last line, when it takes no more.
  void write(std::span<const std::uint8_t> bytes);
  /// Tells it that there is no more, and waits for its end. Throws RunError, with its last line, when that is
  /// not exit code 0 or it has printed an error.
  void finish();

 private:
  /// Until the input takes more (`writing`) or stdout and stderr are closed.
  void wait(bool writing);
  void listen(Descriptor& from, bool is_errors);
  void takeError(std::string_view line);
  /// All that it had to say, and its end.
  int reapAfterLastWords();
  [[noreturn]] void fail(int status) const;
  int reap();

  std::string name_;
  int stop_descriptor_ = -1;
  int most_idle_s_ = 0;
  pid_t process_ = -1;
  Descriptor input_;
  Descriptor output_;
  Descriptor errors_;
  LineSplitter error_lines_{500};
  std::string last_error_;
};

}  // namespace fissure
