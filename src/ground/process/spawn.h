#pragma once

#include <sys/types.h>

#include "files/descriptor.h"
#include "process/worker.h"

namespace fissure {

/// A process just started, with our ends of its pipes (non-blocking).
struct SpawnedProcess {
  pid_t process = -1;
  Descriptor output;  ///< its stdout
  Descriptor errors;  ///< its stderr
  Descriptor input;   ///< its stdin, where WorkerTask::fed asks for it
};

/// Starts `task` as a child process under the rules of Worker. Throws RunError with the system's reason when
/// it cannot start.
SpawnedProcess spawn(const WorkerTask& task);

}  // namespace fissure
