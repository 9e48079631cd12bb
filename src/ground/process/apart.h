#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>

#include "base/error.h"

namespace fissure {

/// A process that worked apart has crashed, or used up its time.
class LostApart : public RunError {
 public:
  explicit LostApart(pid_t process)
      : RunError("the library that reads it crashes or never ends"), process_(process) {}
  pid_t process() const { return process_; }

 private:
  pid_t process_;
};

/// What a process that works apart may use up, and whether it can be stopped.
struct Allowance {
  /// Processor time.
  unsigned long processor_s = 0;
  /// Time by the clock beside ten times the processor time, for a slow disk or a busy machine.
  unsigned long waiting_s = 20;
  /// Address space beside what this process has already; 0: as much as the system gives.
  std::uint64_t memory_bytes = 0;
  /// Whether a request to stop that an Interrupt holds back ends it: not where a result would be lost.
  bool stoppable = true;
};

/// Does `work` in a process of its own, which dies with this one and leaves nothing behind but the files it
/// has written: HDF5 1.10 and Assimp may crash on damaged files, or loop for ever. Throws what `work` throws,
/// as InputError (with its fields) or RunError, LostApart when it crashed or used up its time, and
/// Interrupted when somebody asked for that.
void doApart(const std::function<void()>& work, const Allowance& allowance);

/// What a whole `file` is read or copied with by far. Time: 3 s and one a megabyte, where 0.004 (series) to
/// 0.1 (small pictures) were measured. Memory: 2 GiB and 32 times the file.
Allowance allowanceFor(const std::filesystem::path& file);

/// Reads a file that may be damaged apart first. Throws InputError about `file`, also when `read` does.
void tryReading(const std::filesystem::path& file, const std::function<void()>& read);

/// The same of a file that this program has made: no request to stop ends it, so that no result is lost.
void tryReadingOwn(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace fissure
