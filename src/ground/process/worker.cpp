#include "process/worker.h"

#include <fmt/core.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <vector>

#include "process/spawn.h"

namespace fissure {

namespace {

constexpr std::size_t read_bytes = 65536;

/// Reads at most read_bytes that are there and hands them to `take`; closes the descriptor at its end. False:
/// nothing was there.
template <typename Take>
bool readSome(Descriptor& descriptor, const Take& take) {
  if (!descriptor.open()) return false;
  std::array<char, read_bytes> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled by read
  const ssize_t count = ::read(descriptor.number(), bytes.data(), bytes.size());
  if (count > 0) {
    take(std::string_view(bytes.data(), static_cast<std::size_t>(count)));
    return true;
  }
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  descriptor.reset();
  return false;
}

std::string signalName(int number) {
  const char* name = ::sigabbrev_np(number);
  return name ? fmt::format("{} (SIG{})", number, name) : std::to_string(number);
}

}  // namespace

Worker::Worker(const WorkerTask& task) : time_limit_s_(task.time_limit_s), start_(Clock::now()) {
  SpawnedProcess spawned = spawn(task);
  process_ = spawned.process;
  output_ = std::move(spawned.output);
  errors_ = std::move(spawned.errors);
  // By number: the declaration of glibc 2.36 has no linkage in C++.
  end_ = Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, process_, 0)));
}

Worker::~Worker() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Worker::takeError(std::string_view line) {
  if (line.find_first_not_of(" \t") == std::string_view::npos) return;
  constexpr std::string_view mark = "error: ";
  const bool marked = line.starts_with(mark);
  if (error_is_marked_ && !marked) return;
  if (marked) line.remove_prefix(mark.size());
  last_error_ = printableLine(line);
  error_is_marked_ = marked;
}

void Worker::read() {
  readSome(output_, [this](std::string_view bytes) {
    output_lines_.feed(bytes, [this](std::string_view line) {
      if (const auto progress = parseProgress(line)) progress_ = *progress;
    });
  });
  readSome(errors_, [this](std::string_view bytes) {
    error_lines_.feed(bytes, [this](std::string_view line) { takeError(line); });
  });
}

/// After the end: what the pipes still hold. Bounded, because a process it left behind may keep writing.
void Worker::drain() {
  constexpr int most_reads = 64;
  for (int i = 0; i < most_reads && (output_.open() || errors_.open()); ++i) read();
  error_lines_.finish([this](std::string_view line) { takeError(line); });
  output_.reset();
  errors_.reset();
}

double Worker::timeLeft_s() const {
  const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  return std::max(0.0, time_limit_s_ - elapsed_s);
}

RunStatus Worker::statusOf(int wait_status) const {
  const std::string line = last_error_.empty() ? "" : ": " + last_error_;
  if (WIFSIGNALED(wait_status))
    return {RunEnd::crashed, fmt::format("killed by signal {} {}{}", signalName(WTERMSIG(wait_status)),
                                         describe(progress_), line)};
  const int code = WEXITSTATUS(wait_status);
  if (code == 0) return {RunEnd::ok, ""};
  if (error_is_marked_) return {RunEnd::failed, last_error_};
  return {RunEnd::failed, fmt::format("exit code {} {}{}", code, describe(progress_), line)};
}

std::optional<RunStatus> Worker::poll() {
  int wait_status = 0;
  const pid_t ended = ::waitpid(process_, &wait_status, WNOHANG);
  if (ended == process_) {
    process_ = -1;
    drain();
    unwritten_ = WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == exit_unwritten;
    return statusOf(wait_status);
  }
  if (timeLeft_s() > 0) return std::nullopt;
  std::ostringstream reason;
  reason << "time limit of " << time_limit_s_ << " s reached";
  return stop(RunEnd::timeout, reason.str());
}

RunStatus Worker::stop(RunEnd end, const std::string& reason) {
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  drain();
  return {end, reason + " " + describe(progress_)};
}

}  // namespace fissure
