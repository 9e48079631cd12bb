#pragma once

#include <csignal>
#include <stdexcept>

#include "files/descriptor.h"

namespace fissure {

/// Somebody asked for work to stop that leaves nothing behind when it does.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Readable, to poll, when a request waits that an Interrupt holds back and that its owner has not noticed
/// yet. Throws RunError.
Descriptor heldBackRequests();

/// While it lives, SIGINT, SIGTERM and SIGHUP no longer end this process but are a request to stop, which the
/// owner notices when it is ready. Signals that were ignored before (nohup, a background job of a script)
/// stay ignored.
class Interrupt {
 public:
  Interrupt();   ///< throws RunError
  ~Interrupt();  ///< forgets requests that nobody asked for, and restores the signals
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Readable when a request came; to poll.
  int descriptor() const { return descriptor_.number(); }
  /// Whether a request came, now or before.
  bool requested();

 private:
  sigset_t before_{};
  Descriptor descriptor_;
  bool requested_ = false;
};

}  // namespace fissure
