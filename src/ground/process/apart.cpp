#include "process/apart.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <string>

#include "files/descriptor.h"

namespace fissure {

namespace {

constexpr char done = 'd';
constexpr char bad_input = 'i';
constexpr char failed = 'f';

/// The fields of an error, each but the last ended by a NUL.
std::string packed(const InputError& error) {
  const Origin& origin = error.origin();
  std::string text;
  for (const std::string& field :
       {std::to_string(static_cast<int>(origin.kind)), origin.file, std::to_string(origin.line), origin.path})
    text += field + '\0';
  return text + error.text();
}

InputError unpacked(const std::string& text) {
  std::size_t at = 0;
  const auto next = [&] {
    const std::size_t from = at, end = text.find('\0', from);
    at = end + 1;
    return text.substr(from, end - from);
  };
  Origin origin;
  origin.kind = static_cast<Origin::Kind>(std::stoi(next()));
  origin.file = next();
  origin.line = std::stoi(next());
  origin.path = next();
  return {origin, text.substr(at)};
}

/// What `work` threw: its kind, then what there is to say.
std::string outcomeOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return bad_input + packed(error);
  } catch (const std::exception& error) {
    return failed + std::string(error.what());
  }
  return {done};
}

[[noreturn]] void workAndEnd(const std::function<void()>& work, unsigned long most_s, pid_t front, int to) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != front) ::_exit(1);  // it died before the line above
  const rlimit limits = {most_s, most_s};
  const rlimit no_core = {0, 0};
  ::setrlimit(RLIMIT_CPU, &limits);
  ::setrlimit(RLIMIT_CORE, &no_core);
  // What a crash has to say (a sanitizer's report, HDF5's complaints at its end) is no line of ours.
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  const std::string outcome = outcomeOf(work);
  const ssize_t written = ::write(to, outcome.data(), outcome.size());
  ::_exit(written == static_cast<ssize_t>(outcome.size()) ? 0 : 1);
}

std::string readAll(int from) {
  std::string text;
  std::array<char, 4096> bytes{};
  for (;;) {
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

void doApart(const std::function<void()>& work, unsigned long most_s) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RunError(std::string("cannot make a pipe: ") + std::strerror(errno));
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const pid_t front = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) throw RunError(std::string("cannot start a process: ") + std::strerror(errno));
  if (process == 0) workAndEnd(work, most_s, front, to.number());
  to = Descriptor();
  const std::string outcome = readAll(from.number());
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || outcome.empty()) throw LostApart(process);
  if (outcome.front() == bad_input) throw unpacked(outcome.substr(1));
  if (outcome.front() == failed) throw RunError(outcome.substr(1));
}

unsigned long patience_s(const std::filesystem::path& file) {
  constexpr unsigned long at_least_s = 3;
  constexpr unsigned long megabyte = 1000000;
  std::error_code missing;
  const std::uintmax_t bytes = std::filesystem::file_size(file, missing);
  return missing ? at_least_s : at_least_s + bytes / megabyte;
}

void tryReading(const std::filesystem::path& file, const std::function<void()>& read) {
  try {
    doApart(read, patience_s(file));
  } catch (const RunError& error) {
    throw InputError(inFile(file), std::string("a damaged file (") + error.what() + ")");
  }
}

}  // namespace fissure
