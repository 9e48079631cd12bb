#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

#include "files/descriptor.h"
#include "target.h"

// libFuzzer's counters of edges, where this is built for it.
extern "C" {
extern std::uint8_t __start___sancov_cntrs[] __attribute__((weak, visibility("hidden")));
extern std::uint8_t __stop___sancov_cntrs[] __attribute__((weak, visibility("hidden")));
void __sanitizer_set_death_callback(void (*callback)()) __attribute__((weak));
}

namespace fissure::fuzz {

namespace {

/// The counters of this process, and a copy that a child can write.
class Counters {
 public:
  Counters()
      : size_(static_cast<std::size_t>(__stop___sancov_cntrs - __start___sancov_cntrs)),
        shared_(size_ == 0
                    ? nullptr
                    : ::mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {}

  void fromHere() const {
    if (size_ > 0) std::memcpy(shared_, __start___sancov_cntrs, size_);
  }
  void toHere() const {
    const auto* seen = static_cast<const std::uint8_t*>(shared_);
    for (std::size_t i = 0; i < size_; ++i)
      __start___sancov_cntrs[i] = std::max(__start___sancov_cntrs[i], seen[i]);
  }

 private:
  std::size_t size_;
  void* shared_;
};

[[noreturn]] void workAndEnd(int errors, const Counters& counters, const std::function<void()>& work) {
  ::dup2(errors, STDERR_FILENO);
  // libFuzzer would keep the input as one that crashes; the parent judges.
  if (__sanitizer_set_death_callback) __sanitizer_set_death_callback(nullptr);
  for (const int signal : {SIGABRT, SIGALRM, SIGTERM, SIGINT, SIGXFSZ, SIGUSR1, SIGUSR2})
    ::signal(signal, SIG_DFL);
  constexpr rlim_t most_s = 5;
  const rlimit time = {most_s, most_s}, no_core = {0, 0};
  ::setrlimit(RLIMIT_CPU, &time);
  ::setrlimit(RLIMIT_CORE, &no_core);
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most_bytes = pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE)) + (rlim_t{2} << 30);
  const rlimit memory = {most_bytes, most_bytes};
  ::setrlimit(RLIMIT_AS, &memory);
  work();
  counters.fromHere();
  ::_exit(0);
}

std::string textIn(int file) {
  std::string text(static_cast<std::size_t>(::lseek(file, 0, SEEK_END)), '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::pread(file, text.data(), text.size(), 0))));
  return text;
}

/// Whether a report of the address sanitizer is about `library`: the first function on its first stack that
/// is neither the sanitizer's nor the C library's is there. So is one about memory that there is not.
bool isAbout(const std::string& report, const std::string& library) {
  for (const char* memory :
       {"out-of-memory", "allocation-size-too-big", "out of memory", "failed to allocate"})
    if (report.find(memory) != std::string::npos) return true;
  constexpr std::array<const char*, 10> passed_over = {
      "__interceptor", "__asan", "__sanitizer", "operator new", "libc.so",
      "malloc",        "calloc", "realloc",     "memcpy",       "libasan"};
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("    #") != 0) continue;
    const bool passes = std::any_of(passed_over.begin(), passed_over.end(),
                                    [&](const char* name) { return line.find(name) != std::string::npos; });
    if (!passes) return line.find(library) != std::string::npos;
  }
  return false;
}

}  // namespace

bool survives(const std::string& library, const std::function<void()>& work) {
  static const Counters counters;
  const Descriptor errors(::memfd_create("errors", MFD_CLOEXEC));
  const pid_t child = ::fork();
  require(child >= 0, "a process can be started");
  if (child == 0) workAndEnd(errors.number(), counters, work);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    counters.toHere();
    return true;
  }
  const std::string said = textIn(errors.number());
  const bool broken = said.find("broken promise") != std::string::npos ||
                      said.find("runtime error:") != std::string::npos ||
                      said.find("terminate called") != std::string::npos;
  const bool reported = said.find("AddressSanitizer") != std::string::npos;
  // Without a sanitizer nobody says where it ended: an input of the repository must not end it at all, but by
  // its limits.
  const bool crashed = !reported && WIFSIGNALED(status) && WTERMSIG(status) != SIGXCPU &&
                       WTERMSIG(status) != SIGKILL && WTERMSIG(status) != SIGALRM;
  if (broken || crashed || (reported && !isAbout(said, library))) {
    std::cerr << said;
    require(false, "a child ends well, or in " + library);
  }
  return false;
}

}  // namespace fissure::fuzz
