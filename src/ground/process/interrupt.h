#pragma once

#include <csignal>
#include <stdexcept>

#include "files/descriptor.h"

namespace fissure {

/// Thrown by work that was stopped on request and left nothing behind.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// A descriptor that becomes readable when a request to stop is pending that an Interrupt or RequestsHeldBack
/// holds back and nobody has noticed yet. Throws RunError when the system gives none.
Descriptor heldBackRequests();

/// During its lifetime requests to stop are held back; afterwards they end this process, or go to the
/// Interrupt around it. It is for work that would leave files behind if it were killed, and that ends early
/// when heldBackRequests() becomes readable.
class RequestsHeldBack {
 public:
  RequestsHeldBack();
  ~RequestsHeldBack();
  RequestsHeldBack(const RequestsHeldBack&) = delete;
  RequestsHeldBack& operator=(const RequestsHeldBack&) = delete;

 private:
  sigset_t before_{};
};

/// During its lifetime SIGINT, SIGTERM and SIGHUP do not end this process but count as a request to stop,
/// which the owner polls for. Signals that were ignored before (nohup, a background job of a script) stay
/// ignored.
class Interrupt {
 public:
  Interrupt();   ///< throws RunError
  ~Interrupt();  ///< drops requests that the owner has not polled for, and restores the signals
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  /// Becomes readable when a request has come.
  int descriptor() const { return descriptor_.number(); }
  /// Whether a request has come since construction.
  bool requested();

 private:
  sigset_t before_{};
  Descriptor descriptor_;
  bool requested_ = false;
};

}  // namespace fissure
