#include "process/interrupt.h"

#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.h"

namespace fissure {

Interrupt::Interrupt() {
  sigset_t requests;
  sigemptyset(&requests);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action = {};
    sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&requests, number);
  }
  descriptor_ = Descriptor(::signalfd(-1, &requests, SFD_NONBLOCK | SFD_CLOEXEC));
  if (!descriptor_.open()) throw RunError(std::string("cannot watch signals: ") + std::strerror(errno));
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
