#include "process/progress_display.h"

#include <fmt/core.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string_view>

namespace fissure {

namespace {

constexpr std::chrono::milliseconds terminal_every{100};

}  // namespace

std::optional<std::size_t> terminalColumns(int descriptor) {
  if (::isatty(descriptor) == 0) return std::nullopt;
  winsize size = {};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

std::string durationText(double seconds) {
  if (seconds < 60) return fmt::format("{} s", std::lround(seconds));
  const long minutes = std::lround(seconds / 60);
  if (minutes < 60) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

std::string progressLine(const std::vector<RunProgress>& runs, double elapsed_s) {
  std::ostringstream line;
  std::size_t ended = 0;
  std::int64_t stepped = 0;  // by the workers
  std::int64_t left = 0;
  for (const RunProgress& run : runs) {
    if (run.phase == RunProgress::Phase::ended) ++ended;
    stepped += run.progress.step;
    if (run.phase != RunProgress::Phase::ended) left += run.progress.steps - run.progress.step;
  }
  line << ended << "/" << runs.size() << " runs";
  for (const RunProgress& run : runs)
    if (run.phase == RunProgress::Phase::running && run.progress.steps > 0)
      line << ", " << run.name << " " << 100 * run.progress.step / run.progress.steps << "%";
  const double rate_per_s = elapsed_s > 0 ? static_cast<double>(stepped) / elapsed_s : 0;
  line << ", " << std::lround(rate_per_s) << " steps/s";
  if (rate_per_s > 0) line << ", " << durationText(static_cast<double>(left) / rate_per_s) << " left";
  return line.str();
}

ProgressDisplay::ProgressDisplay(std::ostream& stream, int descriptor)
    : stream_(stream),
      descriptor_(descriptor),
      columns_(terminalColumns(descriptor)),
      start_(Clock::now()),
      next_(start_ + terminal_every) {}

void ProgressDisplay::update(const std::vector<RunProgress>& runs) {
  show([&](double elapsed_s) { return progressLine(runs, elapsed_s); });
}

void ProgressDisplay::show(const std::function<std::string(double elapsed_s)>& make_line) {
  if (!columns_) return;
  const Clock::time_point now = Clock::now();
  if (now < next_) return;
  next_ = now + terminal_every;
  const std::string line = make_line(std::chrono::duration<double>(now - start_).count());
  emptyLine();
  columns_ = terminalColumns(descriptor_).value_or(*columns_);  // somebody may have drawn it wider
  stream_ << line.substr(0, *columns_ - 1) << std::flush;
  shown_ = true;
}

void ProgressDisplay::clear() {
  if (shown_) emptyLine();
  shown_ = false;
}

// To the terminal itself: the stream lets no text command it.
void ProgressDisplay::emptyLine() {
  constexpr std::string_view to_empty = "\r\x1b[K";
  stream_.flush();
  while (::write(descriptor_, to_empty.data(), to_empty.size()) < 0 && errno == EINTR) {
  }
}

}  // namespace fissure
