#include "main/try_reading.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <string>

#include "base/error.h"

namespace fissure {

namespace {

/// Of processor time: a slow disk is no loop.
constexpr rlim_t most_s = 3;

[[noreturn]] void readAndEnd(const std::function<void()>& read) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit limits = {most_s, most_s};
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CPU, &limits);
  ::setrlimit(RLIMIT_CORE, &no_core);
  try {
    read();
  } catch (const std::exception&) {
    ::_exit(0);
  }
  ::_exit(0);
}

}  // namespace

void tryReading(const std::filesystem::path& file, const std::function<void()>& read) {
  const pid_t reader = ::fork();
  if (reader < 0) throw RunError(std::string("cannot start a process: ") + std::strerror(errno));
  if (reader == 0) readAndEnd(read);
  int status = 0;
  while (::waitpid(reader, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw InputError(file.string() + ": a damaged file, HDF5 crashes on it or never ends");
}

}  // namespace fissure
