#include "process/fed_process.h"

#include <fmt/core.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "base/error.h"
#include "process/spawn.h"

namespace fissure {

namespace {

struct Ready {
  bool input = false;
  bool output = false;
  bool errors = false;
  bool stop = false;
};

/// Waits until one of them is, `most_s` at most; those that are -1 never are. A closed one is ready: using it
/// tells.
Ready waitFor(int input, int output, int errors, int stop, int most_s) {
  std::array<pollfd, 4> polled = {
      {{input, POLLOUT, 0}, {output, POLLIN, 0}, {errors, POLLIN, 0}, {stop, POLLIN, 0}}};
  while (::poll(polled.data(), polled.size(), 1000 * most_s) < 0 && errno == EINTR) {
  }
  return {polled[0].revents != 0, polled[1].revents != 0, polled[2].revents != 0, polled[3].revents != 0};
}

}  // namespace

std::optional<std::filesystem::path> programOnPath(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path program = std::filesystem::path(folder.empty() ? "." : folder) / name;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(program, ignored) && ::access(program.c_str(), X_OK) == 0)
      return program;
  }
  return std::nullopt;
}

FedProcess::FedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                       int stop_descriptor, int most_idle_s)
    : name_(program.filename().string()), stop_descriptor_(stop_descriptor), most_idle_s_(most_idle_s) {
  SpawnedProcess spawned = spawn({.program = program, .arguments = arguments, .fed = true});
  process_ = spawned.process;
  input_ = std::move(spawned.input);
  output_ = std::move(spawned.output);
  errors_ = std::move(spawned.errors);
}

FedProcess::~FedProcess() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  reap();
}

/// Reads what is there.
void FedProcess::listen(Descriptor& from, bool is_errors) {
  std::array<char, 4096> bytes{};
  const ssize_t count = ::read(from.number(), bytes.data(), bytes.size());
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count <= 0) return from.reset();
  if (is_errors)
    error_lines_.feed({bytes.data(), static_cast<std::size_t>(count)},
                      [&](std::string_view line) { takeError(line); });
}

void FedProcess::takeError(std::string_view line) {
  if (line.find_first_not_of(" \t") != std::string_view::npos) last_error_ = printableLine(line);
}

void FedProcess::wait(bool writing) {
  const Ready ready = waitFor(writing ? input_.number() : -1, output_.number(), errors_.number(),
                              stop_descriptor_, most_idle_s_);
  if (!ready.input && !ready.output && !ready.errors && !ready.stop)
    throw RunError(fmt::format("{}: took and said nothing for {} s", name_, most_idle_s_));
  if (ready.stop) throw RunError(name_ + ": stopped");
  if (ready.output) listen(output_, false);
  if (ready.errors) listen(errors_, true);
}

void FedProcess::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(input_.number(), bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno == EAGAIN) {
      wait(true);
    } else if (errno != EINTR) {
      fail(reapAfterLastWords());
    }
  }
}

void FedProcess::finish() {
  const int status = reapAfterLastWords();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !last_error_.empty()) fail(status);
}

int FedProcess::reapAfterLastWords() {
  input_.reset();
  while (output_.open() || errors_.open()) wait(false);
  error_lines_.finish([&](std::string_view line) { takeError(line); });
  return reap();
}

void FedProcess::fail(int status) const {
  if (!last_error_.empty()) throw RunError(name_ + ": " + last_error_);
  if (WIFSIGNALED(status)) throw RunError(fmt::format("{}: killed by signal {}", name_, WTERMSIG(status)));
  throw RunError(fmt::format("{}: exit code {} without a word", name_, WEXITSTATUS(status)));
}

int FedProcess::reap() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

}  // namespace fissure
