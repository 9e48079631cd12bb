#include "process/interrupt.h"

#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.h"

namespace fissure {

namespace {

/// Those signals that ask a process to stop, without the ones it ignores.
sigset_t requestsHeard() {
  sigset_t requests;
  sigemptyset(&requests);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&requests, number);
  }
  return requests;
}

Descriptor watch(const sigset_t& requests) {
  Descriptor watching(::signalfd(-1, &requests, SFD_NONBLOCK | SFD_CLOEXEC));
  if (!watching.open()) throw RunError(std::string("cannot watch signals: ") + std::strerror(errno));
  return watching;
}

}  // namespace

Descriptor heldBackRequests() {
  sigset_t blocked;
  sigprocmask(SIG_BLOCK, nullptr, &blocked);
  const sigset_t heard = requestsHeard();
  sigset_t held_back;
  sigandset(&held_back, &heard, &blocked);
  return watch(held_back);
}

RequestsHeldBack::RequestsHeldBack() {
  const sigset_t requests = requestsHeard();
  sigprocmask(SIG_BLOCK, &requests, &before_);
}

RequestsHeldBack::~RequestsHeldBack() {
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

Interrupt::Interrupt() {
  const sigset_t requests = requestsHeard();
  descriptor_ = watch(requests);
  sigprocmask(SIG_BLOCK, &requests, &before_);
}

Interrupt::~Interrupt() {
  requested();
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

bool Interrupt::requested() {
  signalfd_siginfo signal = {};
  while (::read(descriptor_.number(), &signal, sizeof signal) == sizeof signal) requested_ = true;
  return requested_;
}

}  // namespace fissure
