#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>

#include "base/error.h"

namespace fissure {

/// A child process started by doApart() has crashed or used up its time.
class LostApart : public RunError {
 public:
  explicit LostApart(pid_t process)
      : RunError("the library that reads it crashes or never ends"), process_(process) {}
  pid_t process() const { return process_; }

 private:
  pid_t process_;
};

/// Limits of a child process started by doApart(), and whether it can be interrupted.
struct Allowance {
  /// Processor time, seconds.
  unsigned long processor_s = 0;
  /// Wall-clock time allowed in addition to ten times `processor_s`, for a slow disk or a busy machine;
  /// seconds.
  unsigned long waiting_s = 20;
  /// Address space in addition to what this process already has; 0: no limit of ours.
  std::uint64_t memory_bytes = 0;
  /// Whether a pending request to stop (see Interrupt) ends the work; false where a result would be lost.
  bool stoppable = true;
};

/// Does `work` in a child process, which dies with this one and leaves nothing behind but the files it has
/// written: HDF5 1.10 and Assimp may crash on damaged files, or loop for ever. Rethrows what `work` throws as
/// InputError (with its fields) or RunError. Throws LostApart when the child crashed or used up its time, and
/// Interrupted when a request to stop ended it.
void doApart(const std::function<void()>& work, const Allowance& allowance);

/// Generous limits for reading or copying the whole of `file`: 3 s and 1 s per megabyte, where 0.004 (series)
/// to 0.1 s (small pictures) per megabyte were measured, and 2 GiB plus 32 times the size of the file.
Allowance allowanceFor(const std::filesystem::path& file);

/// Calls `read` in a child process (doApart), to find out whether a file that may be damaged can be read.
/// Throws InputError about `file` when it cannot.
void tryReading(const std::filesystem::path& file, const std::function<void()>& read);

/// The same for a file that this program has made: no request to stop ends it, so that no result is lost.
void tryReadingOwn(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace fissure
