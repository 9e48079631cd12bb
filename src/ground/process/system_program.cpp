#include "process/system_program.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <sstream>

#include "process/interrupt.h"
#include "process/line_splitter.h"
#include "process/spawn.h"

namespace fissure {

namespace {

using Clock = std::chrono::steady_clock;

/// Appends what is there; closes the descriptor at its end.
void listen(Descriptor& from, std::string& text) {
  if (!from.open()) return;
  std::array<char, 65536> bytes;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled by read
  const ssize_t count = ::read(from.number(), bytes.data(), bytes.size());
  if (count > 0)
    text.append(bytes.data(), static_cast<std::size_t>(count));
  else if (count == 0 || (errno != EAGAIN && errno != EINTR))
    from.reset();
}

enum class Heard { all, time_is_up, stop };

/// Collects both streams until they end.
Heard listenUntil(Clock::time_point end, int stop_descriptor, SpawnedProcess& process, std::string& output,
                  std::string& errors) {
  while (process.output.open() || process.errors.open()) {
    const double left_s = std::chrono::duration<double>(end - Clock::now()).count();
    if (left_s <= 0) return Heard::time_is_up;
    std::array<pollfd, 3> polled = {{{process.output.number(), POLLIN, 0},
                                     {process.errors.number(), POLLIN, 0},
                                     {stop_descriptor, POLLIN, 0}}};
    const int ready =
        ::poll(polled.data(), polled.size(), static_cast<int>(std::ceil(std::min(left_s, 60.0) * 1e3)));
    if (ready > 0 && polled[2].revents != 0) return Heard::stop;
    listen(process.output, output);
    listen(process.errors, errors);
  }
  return Heard::all;
}

std::string lastLine(const std::string& text) {
  std::istringstream lines(text);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = printableLine(line);
  return last;
}

}  // namespace

ProgramOutcome runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          double most_s, int stop_descriptor) {
  const std::string name = program.filename().string();
  const auto end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(most_s));
  SpawnedProcess process = spawn({.program = program, .arguments = arguments});
  ProgramOutcome outcome;
  std::string errors;
  const Heard heard = listenUntil(end, stop_descriptor, process, outcome.output, errors);
  outcome.in_time = heard == Heard::all;
  if (!outcome.in_time) ::kill(process.process, SIGKILL);
  int status = 0;
  while (::waitpid(process.process, &status, 0) < 0 && errno == EINTR) {
  }
  if (heard == Heard::stop) throw Interrupted();
  outcome.error = lastLine(errors);
  if (!outcome.in_time) return outcome;
  if (!WIFEXITED(status)) throw KilledProgram(name, WTERMSIG(status));
  outcome.code = WEXITSTATUS(status);
  return outcome;
}

}  // namespace fissure
