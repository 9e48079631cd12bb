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

/// One program to run and to watch.
struct WorkerTask {
  std::filesystem::path program;
  std::vector<std::string> arguments;  ///< without the program's name; passed on as they are, no shell
  double time_limit_s = 3600;          ///< wall clock, from its start
  double memory_limit_mib = 0;         ///< of data that it may hold (RLIMIT_DATA); 0: no limit
  bool fed = false;  ///< reads what it is given (FedProcess); otherwise there is nothing to read
};

/// A worker process. Contract of the program: on stdout lines `progress <step> <steps>`, on stderr at most
/// one line `error: ...`; exit code 0 when its work is done. It reads nothing, inherits no descriptor but its
/// pipes, ignores SIGINT, SIGTERM and SIGHUP (the front alone decides), and dies with the process that made
/// it.
class Worker {
 public:
  /// Starts the program. Throws RunError when the system cannot; call from the process's main thread, because
  /// the worker dies with the thread that made it.
  explicit Worker(const WorkerTask& task);
  ~Worker();  ///< kills it when it still runs
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Its stdout and stderr, to poll for reading; -1 where the worker closed it.
  std::array<int, 2> descriptors() const { return {output_.number(), errors_.number()}; }
  /// Reads what is there, without waiting and at most 64 KiB of each, so that a flood cannot hold the caller.
  void read();
  const Progress& progress() const { return progress_; }

  /// How it ended; no value while it runs. `ok` says exit code 0 and no more. Past its time limit it is
  /// killed here.
  std::optional<RunStatus> poll();
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
  LineSplitter output_lines_{256};
  LineSplitter error_lines_{2000};
  Progress progress_;
  std::string last_error_;
  bool error_is_marked_ = false;  ///< last_error_ began with "error: "; other lines no longer replace it
};

}  // namespace fissure
