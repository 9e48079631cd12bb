#include "process/apart.h"

#include <fcntl.h>
#include <poll.h>
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
#include <fstream>
#include <new>
#include <optional>
#include <string>

#include "files/descriptor.h"
#include "process/interrupt.h"

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
  } catch (const std::bad_alloc&) {
    return failed + std::string("reading it takes more memory than a file of its size should");
  } catch (const std::exception& error) {
    return failed + std::string(error.what());
  }
  return {done};
}

void limit(int resource, rlim_t most) {
  const rlimit limits = {most, most};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limits);
}

/// Size of the address space of this process; 0 where the system does not report it.
std::uint64_t addressSpace_bytes() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

[[noreturn]] void workAndEnd(const std::function<void()>& work, const Allowance& allowance, pid_t front,
                             int to) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != front) ::_exit(1);  // it died before the line above
  limit(RLIMIT_CPU, allowance.processor_s);
  limit(RLIMIT_CORE, 0);
  if (allowance.memory_bytes > 0) limit(RLIMIT_AS, addressSpace_bytes() + allowance.memory_bytes);
  // What a crash has to say (a sanitizer's report, HDF5's complaints at its end) is no line of ours.
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  const std::string outcome = outcomeOf(work);
  const ssize_t written = ::write(to, outcome.data(), outcome.size());
  ::_exit(written == static_cast<ssize_t>(outcome.size()) ? 0 : 1);
}

/// A child of this process, killed unless it has been waited for.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {}
  ~Child() {
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int wait() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return status;
  }

 private:
  pid_t process_;
};

/// What comes from `from` until it ends; no value: not within `most_s`. Throws Interrupted when `requests`
/// (-1: none) becomes readable.
std::optional<std::string> listen(int from, int requests, unsigned long most_s) {
  constexpr unsigned long slices_a_second = 10;
  std::string text;
  std::array<pollfd, 2> polled = {{{from, POLLIN, 0}, {requests, POLLIN, 0}}};
  // Waited in slices, so that the time in which a terminal has stopped both processes (Ctrl-Z) does not
  // count.
  for (unsigned long slices = 0; slices < slices_a_second * most_s;) {
    const int ready = ::poll(polled.data(), polled.size(), static_cast<int>(1000 / slices_a_second));
    if (ready == 0) ++slices;
    if (ready <= 0) continue;
    if (polled[1].revents != 0) throw Interrupted();
    if (polled[0].revents == 0) continue;
    std::array<char, 4096> bytes{};
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

void tryWith(const std::filesystem::path& file, const std::function<void()>& read,
             const Allowance& allowance) {
  try {
    doApart(read, allowance);
  } catch (const RunError& error) {
    throw InputError(inFile(file), std::string("a damaged file (") + error.what() + ")");
  }
}

}  // namespace

void doApart(const std::function<void()>& work, const Allowance& allowance) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RunError(std::string("cannot make a pipe: ") + std::strerror(errno));
  const Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const Descriptor requests = allowance.stoppable ? heldBackRequests() : Descriptor();
  const pid_t front = ::getpid();
  const pid_t process = ::fork();
  if (process < 0) throw RunError(std::string("cannot start a process: ") + std::strerror(errno));
  if (process == 0) workAndEnd(work, allowance, front, to.number());
  Child child(process);
  to = Descriptor();
  const unsigned long most_s = allowance.waiting_s + 10 * allowance.processor_s;
  const std::optional<std::string> outcome = listen(from.number(), requests.number(), most_s);
  if (!outcome) throw LostApart(process);
  const int status = child.wait();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || outcome->empty()) throw LostApart(process);
  if (outcome->front() == bad_input) throw unpacked(outcome->substr(1));
  if (outcome->front() == failed) throw RunError(outcome->substr(1));
}

Allowance allowanceFor(const std::filesystem::path& file) {
  constexpr std::uintmax_t megabyte = 1000000;
  std::error_code missing;
  const std::uintmax_t found = std::filesystem::file_size(file, missing);
  const std::uintmax_t bytes = missing ? 0 : found;
  return {.processor_s = 3 + static_cast<unsigned long>(bytes / megabyte),
          .memory_bytes = (std::uint64_t{2} << 30) + 32 * bytes};
}

void tryReading(const std::filesystem::path& file, const std::function<void()>& read) {
  tryWith(file, read, allowanceFor(file));
}

void tryReadingOwn(const std::filesystem::path& file, const std::function<void()>& read) {
  Allowance allowance = allowanceFor(file);
  allowance.stoppable = false;
  tryWith(file, read, allowance);
}

}  // namespace fissure
