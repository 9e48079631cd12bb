#include "report/bench_history.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <utility>

#include "base/error.h"
#include "report/json_map.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

double finite(const PageJson& number, const std::string& name, const char* what) {
  const double value = number.is_number() ? number.get<double>() : NAN;
  if (!std::isfinite(value))
    throw InputError(
        fmt::format("{} of {} is {}, expected a finite number", what, name, number.dump().substr(0, 40)));
  return value;
}

BenchCase caseOf(const PageJson& entry, const std::string& name) {
  BenchCase found;
  for (const PageJson& time : JsonMap(entry).list("time_us")) {
    found.times_us.push_back(finite(time, name, "a time"));
    if (found.times_us.back() <= 0)
      throw InputError(fmt::format("a time of {} is {}, expected more than 0", name, found.times_us.back()));
  }
  if (found.times_us.empty()) throw InputError(fmt::format("{} has no times, expected some", name));
  for (const auto& [key, value] : JsonMap(entry).map("counters").items())
    found.counters[key] = finite(value, name, "a counter");
  return found;
}

/// A time as in BenchCommit: such texts sort by time.
bool isDate(const std::string& text) {
  constexpr std::string_view pattern = "0000-00-00T00:00:00Z";
  return text.size() == pattern.size() &&
         std::equal(text.begin(), text.end(), pattern.begin(), [](char c, char expected) {
           return expected == '0' ? c >= '0' && c <= '9' : c == expected;
         });
}

BenchFile fromJson(const PageJson& json) {
  const JsonMap root(json);
  root.refuseOtherFormat("fissure-bench");
  BenchFile file;
  file.commit = {root.text("commit_date", "a date"), root.text("commit", "a commit's hash"),
                 root.truth("modified")};
  if (!isDate(file.commit.date))
    throw InputError(
        fmt::format("commit_date is \"{}\", expected UTC as 2026-01-31T12:00:00Z", file.commit.date));
  const JsonMap machine(root.map("machine")), build(root.map("build"));
  file.machine = {machine.text("cpu"), build.text("compiler"), build.text("flags"),
                  static_cast<int>(machine.count("cores"))};
  for (const PageJson& entry : root.list("benchmarks")) {
    const std::string name = JsonMap(entry).text("name", "a benchmark's name");
    if (!file.cases.emplace(name, caseOf(entry, name)).second)
      throw InputError(fmt::format("{} is there twice, expected once", name));
  }
  if (file.cases.empty()) throw InputError("has no benchmarks, expected some");
  return file;
}

/// The times of commits `from` to `to` - 1 together.
std::vector<double> pooled(const std::vector<std::vector<double>>& times, std::size_t from, std::size_t to) {
  std::vector<double> all;
  for (std::size_t i = from; i < to; ++i) all.insert(all.end(), times[i].begin(), times[i].end());
  return all;
}

}  // namespace

BenchFile readBenchFile(const fs::path& file) {
  try {
    return fromJson(PageJson::parse(readTextFile(file)));
  } catch (const InputError& error) {
    if (error.isAbout(file)) throw;
    throw InputError(inFile(file), error.text());
  } catch (const PageJson::exception&) {
    throw InputError(inFile(file), "no whole JSON, expected a file of scripts/bench");
  }
}

std::vector<fs::path> benchFilesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json" && !entry.path().filename().string().starts_with('.'))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

BenchHistory readBenchHistory(const fs::path& folder) {
  BenchHistory history;
  std::map<std::pair<BenchCommit, BenchMachine>, std::string> seen;
  for (const fs::path& path : benchFilesIn(folder)) {
    const std::string name = path.filename().string();
    try {
      BenchFile file = readBenchFile(path);
      const auto [same, is_new] = seen.try_emplace({file.commit, file.machine}, name);
      if (is_new)
        history.files.push_back(std::move(file));
      else
        history.problems.push_back(
            {name, "of the same commit and machine as " + same->second + ", which is shown"});
    } catch (const InputError& error) {
      history.problems.push_back({name, error.isAbout(path) ? error.text() : error.what()});
    }
  }
  if (history.files.empty())
    throw InputError(inFile(folder),
                     history.problems.empty()
                         ? "holds no files of scripts/bench"
                         : fmt::format("holds neither results (*.h5) nor files of scripts/bench: {}: {}",
                                       history.problems.front().file, history.problems.front().text));
  std::stable_sort(history.files.begin(), history.files.end(),
                   [](const BenchFile& a, const BenchFile& b) { return a.commit < b.commit; });
  return history;
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double uTest(const std::vector<double>& one, const std::vector<double>& other) {
  double u = 0;
  for (const double a : one)
    for (const double b : other) u += a > b ? 1 : a == b ? 0.5 : 0;
  const auto n = static_cast<double>(one.size()), m = static_cast<double>(other.size());
  const double spread = std::sqrt(n * m * (n + m + 1) / 12);
  const double z = std::max(0.0, std::abs(u - n * m / 2) - 0.5) / spread;
  return std::erfc(z / std::numbers::sqrt2);
}

std::vector<BenchStep> findSteps(const std::vector<std::vector<double>>& times_us) {
  std::vector<BenchStep> steps;
  std::size_t start = 0;  // of the stretch since the last step
  for (std::size_t at = 1; at < times_us.size(); ++at) {
    const std::vector<double> before = pooled(times_us, std::max(start, at - std::min(at, step_before)), at);
    const std::size_t end = std::min(times_us.size(), at + step_after);
    const double was = quantile(before, 0.5);
    const double sign = quantile(times_us[at], 0.5) > was ? 1 : -1;
    bool lasts = true;
    for (std::size_t i = at; i < end; ++i) {
      const double change = sign * (quantile(times_us[i], 0.5) - was);
      lasts = lasts && change > step_relative * was && change > step_absolute_us;
    }
    if (!lasts) continue;
    const std::vector<double> after = pooled(times_us, at, end);
    const double p = uTest(before, after);
    if (p >= step_p) continue;
    steps.push_back({at, quantile(after, 0.5) / was, p});
    start = at;
  }
  return steps;
}

}  // namespace fissure
