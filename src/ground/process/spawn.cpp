#include "process/spawn.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstring>

#include "base/error.h"

namespace fissure {

namespace {

struct Pipe {
  Descriptor reading;
  Descriptor writing;
};

Pipe makePipe() {
  std::array<int, 2> ends = {-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RunError(std::string("cannot make a pipe: ") + std::strerror(errno));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// Signals as a program expects them at its start, except those that only the front acts on. SIGXFSZ stays as
/// it is: where it is ignored, a file size limit becomes a failed write with a message.
void setWorkerSignals() {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(SIGPIPE, SIG_DFL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
}

/// Runs in the child, between fork and exec: system calls only. Returns only when exec failed, with errno
/// set.
void becomeWorker(pid_t parent, const Pipe& input, const Pipe& output, const Pipe& errors,
                  const rlimit& memory, char* const* arguments, char* const* environment) {
  if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) return;
  if (::getppid() != parent) ::_exit(1);  // it died before the line above
  const int read = input.reading.open() ? input.reading.number() : ::open("/dev/null", O_RDONLY);
  if (read < 0 || ::dup2(read, STDIN_FILENO) < 0) return;
  if (::dup2(output.writing.number(), STDOUT_FILENO) < 0) return;
  if (::dup2(errors.writing.number(), STDERR_FILENO) < 0) return;
  if (::close_range(STDERR_FILENO + 1, UINT_MAX, CLOSE_RANGE_CLOEXEC) != 0) return;
  if (memory.rlim_cur > 0 && ::setrlimit(RLIMIT_DATA, &memory) != 0) return;
  setWorkerSignals();
  ::execve(arguments[0], arguments, environment);
}

/// "NAME=value" of each variable of this process, with another $TMPDIR where one is asked for.
std::vector<std::string> environmentOf(const WorkerTask& task) {
  const std::string name = "TMPDIR=";
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) variables.emplace_back(*variable);
  if (task.temporary_folder.empty()) return variables;
  std::erase_if(variables, [&](const std::string& variable) { return variable.starts_with(name); });
  variables.push_back(name + std::filesystem::absolute(task.temporary_folder).string());
  return variables;
}

/// As exec takes them; `texts` must outlive it.
std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

SpawnedProcess spawn(const WorkerTask& task) {
  std::vector<std::string> words = {task.program.string()};
  words.insert(words.end(), task.arguments.begin(), task.arguments.end());
  const std::vector<char*> arguments = pointersTo(words);
  std::vector<std::string> variables = environmentOf(task);
  const std::vector<char*> environment = pointersTo(variables);

  Pipe input = task.fed ? makePipe() : Pipe();
  Pipe output = makePipe();
  Pipe errors = makePipe();
  Pipe failure = makePipe();  // closed by a successful exec, else brings errno
  const pid_t parent = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) throw RunError(std::string("cannot start a process: ") + std::strerror(errno));
  if (process == 0) {
    const auto bytes = static_cast<rlim_t>(task.memory_limit_mib * 1048576);
    becomeWorker(parent, input, output, errors, {bytes, bytes}, arguments.data(), environment.data());
    const int reason = errno;
    const ssize_t written = ::write(failure.writing.number(), &reason, sizeof reason);
    ::_exit(written == sizeof reason ? 127 : 126);
  }
  failure.writing.reset();
  int reason = 0;
  ssize_t got = 0;
  do got = ::read(failure.reading.number(), &reason, sizeof reason);
  while (got < 0 && errno == EINTR);
  if (got == sizeof reason) {
    ::waitpid(process, nullptr, 0);
    throw RunError("cannot start " + task.program.filename().string() + ": " + std::strerror(reason));
  }
  ::fcntl(output.reading.number(), F_SETFL, O_NONBLOCK);
  ::fcntl(errors.reading.number(), F_SETFL, O_NONBLOCK);
  if (task.fed) ::fcntl(input.writing.number(), F_SETFL, O_NONBLOCK);
  return {process, std::move(output.reading), std::move(errors.reading), std::move(input.writing)};
}

}  // namespace fissure
