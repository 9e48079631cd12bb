#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/run_status.h"
#include "files/descriptor.h"
#include "process/line_splitter.h"
#include "process/progress.h"

namespace fissure {

/// The exit code of a worker that could not write its files.
inline constexpr int exit_unwritten = 4;

/// A program to be run as a worker, and its limits.
struct WorkerTask {
  std::filesystem::path program;
  std::vector<std::string> arguments;           ///< without the program's name; passed on verbatim, no shell
  double time_limit_s = 3600;                   ///< wall-clock time from its start
  double memory_limit_mib = 0;                  ///< limit of its data segment (RLIMIT_DATA); 0: no limit
  std::filesystem::path temporary_folder = {};  ///< its $TMPDIR; empty: that of this process
  bool fed = false;  ///< it reads from a pipe (FedProcess); otherwise its standard input is empty
};

/// A worker process. Contract of the program: on stdout lines `progress <step> <steps>`, on stderr at most
/// one line `error: ...`; exit code 0 when its work is done. It reads nothing, inherits no descriptors but
/// its pipes, ignores SIGINT, SIGTERM and SIGHUP (only the process that started it decides on its end), and
/// dies with that process.
class Worker {
 public:
  /// Starts the program. Throws RunError when it cannot be started. Call from the process's main thread,
  /// because the worker dies with the thread that started it.
  explicit Worker(const WorkerTask& task);
  ~Worker();  ///< kills it when it still runs
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Descriptors of its stdout and stderr, to be polled for reading; -1 where the worker has closed it.
  std::array<int, 2> descriptors() const { return {output_.number(), errors_.number()}; }
  /// A descriptor that can be read as soon as the process has ended; -1 where the system gives none.
  int endDescriptor() const { return end_.number(); }
  /// Reads what is available without blocking, at most 64 KiB of each, so that a flood of output cannot block
  /// the caller.
  void read();
  /// The last progress that the worker has printed.
  const Progress& progress() const { return progress_; }

  /// How it ended; no value while it runs. `ok` means exit code 0 and nothing else. A worker past its time
  /// limit is killed here.
  std::optional<RunStatus> poll();
  /// Whether it has ended with exit_unwritten.
  bool unwritten() const { return unwritten_; }
  /// Kills it and waits for its end; returns {end, "<reason> after step N of M"}.
  RunStatus stop(RunEnd end, const std::string& reason);
  /// Seconds until the time limit, 0 when it is past.
  double timeLeft_s() const;

 private:
  using Clock = std::chrono::steady_clock;

  void takeError(std::string_view line);
  void drain();
  RunStatus statusOf(int wait_status) const;

  double time_limit_s_;
  Clock::time_point start_;
  pid_t process_ = -1;
  Descriptor output_;
  Descriptor errors_;
  Descriptor end_;
  LineSplitter output_lines_{256};
  LineSplitter error_lines_{2000};
  Progress progress_;
  std::string last_error_;
  /// last_error_ began with "error: "; other lines no longer replace it.
  bool error_is_marked_ = false;
  bool unwritten_ = false;
};

}  // namespace fissure
