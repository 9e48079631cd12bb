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

/// The path of the first program of that name in the folders of $PATH; no value: none has it.
std::optional<std::filesystem::path> programOnPath(const std::string& name);

/// A running program that processes what is written to its standard input. It dies with the process that
/// started it, which must ignore SIGPIPE. Of its output only the last line on stderr is kept.
class FedProcess {
 public:
  /// Starts the program, without a shell. write() and finish() give up when `stop_descriptor` becomes
  /// readable (-1: never), or when the program has neither read nor printed anything for `most_idle_s`
  /// seconds. Throws RunError when the program cannot be started. Call from the process's main thread, as for
  /// Worker.
  FedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
             int stop_descriptor, int most_idle_s = 300);
  ~FedProcess();  ///< kills it when it still runs
  FedProcess(const FedProcess&) = delete;
  FedProcess& operator=(const FedProcess&) = delete;

  /// Writes all bytes to its standard input. Throws RunError, with the program's last line, when it reads no
  /// more.
  void write(std::span<const std::uint8_t> bytes);
  /// Closes its standard input and waits for its end. Throws RunError, with its last line, when its exit code
  /// is not 0 or it has printed an error.
  void finish();

 private:
  /// Waits until the program reads more (`writing`) or has closed stdout and stderr.
  void wait(bool writing);
  void listen(Descriptor& from, bool is_errors);
  void takeError(std::string_view line);
  /// Reads the rest of its output and waits for its end; returns the wait status.
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
