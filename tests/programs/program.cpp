#include "program.h"

#include <fcntl.h>
#include <pty.h>
#include <regex.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace fissure::programs {

namespace {

namespace fs = std::filesystem;

/// Empty when there is no such file, or no more: files of /proc end with their process.
std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  try {
    return {std::istreambuf_iterator<char>(stream), {}};
  } catch (const std::ios_base::failure&) {
    return "";
  }
}

/// Fields of /proc/PID/stat after the program's name: state, parent ...; empty when the process is gone.
std::vector<std::string> statOf(pid_t process) {
  const std::string text = contents("/proc/" + std::to_string(process) + "/stat");
  const std::size_t end = text.rfind(')');
  if (end == std::string::npos) return {};
  std::istringstream fields(text.substr(end + 1));
  return {std::istream_iterator<std::string>(fields), {}};
}

bool runs(pid_t process, const std::string& program) {
  std::error_code gone;
  return fs::read_symlink("/proc/" + std::to_string(process) + "/exe", gone)
      .filename()
      .string()
      .starts_with(program);
}

void redirect(const fs::path& file, int descriptor) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(125);
}

void setLimits(const Program::Limits& limits) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(number, SIG_DFL);
  if (!limits.file_bytes) return;
  const rlimit most = {*limits.file_bytes, *limits.file_bytes};
  if (::setrlimit(RLIMIT_FSIZE, &most) != 0) ::_exit(125);
}

}  // namespace

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "fissure-test-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void Folder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const {
  return contents(path_ / name);
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

Program::Program(const Folder& folder, const std::vector<std::string>& words, const Limits& limits) {
  static int count = 0;
  const std::string base = folder.path().string() + "-" + std::to_string(++count);
  out_ = base + ".out";
  err_ = base + ".err";
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int slave = -1;
  winsize size = {25, 100, 0, 0};
  if (limits.error_is_terminal && ::openpty(&terminal_, &slave, nullptr, nullptr, &size) != 0)
    throw std::runtime_error("no pseudo-terminal");
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("cannot fork");
  if (process_ == 0) {
    redirect(out_, STDOUT_FILENO);
    if (limits.out_is_terminal) ::dup2(slave, STDOUT_FILENO);
    if (slave < 0)
      redirect(err_, STDERR_FILENO);
    else
      ::dup2(slave, STDERR_FILENO);
    if (::chdir(folder.path().c_str()) != 0) ::_exit(125);
    setLimits(limits);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  if (slave >= 0) ::close(slave);
}

Program::~Program() {
  if (process_ >= 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (terminal_ >= 0) ::close(terminal_);
  std::error_code ignored;
  fs::remove(out_, ignored);
  fs::remove(err_, ignored);
}

void Program::send(int signal) const {
  ::kill(process_, signal);
}

bool Program::running() const {
  const std::vector<std::string> fields = statOf(process_);
  return !fields.empty() && fields[0] != "Z";
}

pid_t Program::waitForChild(const std::string& program, pid_t not_this) const {
  while (running()) {
    for (const auto& entry : fs::directory_iterator("/proc")) {
      const std::string name = entry.path().filename().string();
      if (name.find_first_not_of("0123456789") != std::string::npos) continue;
      const pid_t candidate = std::stoi(name);
      const std::vector<std::string> fields = statOf(candidate);
      const bool child = fields.size() > 1 && fields[0] != "Z" && fields[1] == std::to_string(process_);
      if (child && candidate != not_this && runs(candidate, program)) return candidate;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return 0;
}

Outcome Program::wait() {
  Outcome outcome;
  if (terminal_ >= 0) {  // until the other side is closed (EIO)
    std::array<char, 4096> bytes;
    for (ssize_t count = 0; (count = ::read(terminal_, bytes.data(), bytes.size())) > 0;)
      outcome.err.append(bytes.data(), static_cast<std::size_t>(count));
  }
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = contents(out_);
  if (terminal_ < 0) outcome.err = contents(err_);
  return outcome;
}

std::string fissureProgram() {
  return FISSURE_BINARY_DIR "/fissure";
}
std::string engineWorkerProgram() {
  return FISSURE_BINARY_DIR "/fissure-engine-f64";
}

Outcome runFissure(const Folder& folder, std::vector<std::string> words) {
  words.insert(words.begin(), fissureProgram());
  return Program(folder, words).wait();
}

Outcome runTool(const Folder& folder, const std::vector<std::string>& words) {
  return Program(folder, words).wait();
}

bool endsSoon(pid_t process, double most_s) {
  for (int i = 0; i <= most_s / 0.005; ++i) {
    const std::vector<std::string> fields = statOf(process);
    if (fields.empty() || fields[0] == "Z") return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

std::string pythonWith(const std::string& module) {
  const Folder folder;
  for (const std::string python : {"/usr/bin/python3", "python3"})
    if (runTool(folder, {python, "-c", "import " + module}).code == 0) return python;
  return "";
}

bool hasMatch(const std::string& text, const std::string& expression) {
  regex_t compiled;
  const int flags = REG_EXTENDED | REG_NEWLINE | REG_NOSUB;
  if (::regcomp(&compiled, expression.c_str(), flags) != 0)
    throw std::logic_error("no regular expression: " + expression);
  const bool found = ::regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
  ::regfree(&compiled);
  return found;
}

bool isOneLine(const std::string& text) {
  return text.size() > 1 && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

}  // namespace fissure::programs
