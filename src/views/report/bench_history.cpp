#include "report/bench_history.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <utility>

#include "base/error.h"
#include "report/report_run.h"
#include "text/text_file.h"

namespace fissure {

namespace {

namespace fs = std::filesystem;

constexpr const char* format_name = "fissure-bench";
constexpr int format_version = 1;

/// An entry of a map, of type T; throws InputError without a file.
template <class T>
T entryOf(const PageJson& map, const char* key, const char* expected) {
  if (!map.is_object() || !map.contains(key))
    throw InputError(fmt::format("missing \"{}\", expected {}", key, expected));
  try {
    return map.at(key).get<T>();
  } catch (const PageJson::exception&) {
    throw InputError(
        fmt::format("\"{}\" is {}, expected {}", key, map.at(key).dump().substr(0, 40), expected));
  }
}

/// An entry of a map that is a count.
int countOf(const PageJson& map, const char* key, const char* expected) {
  const auto number = entryOf<PageJson>(map, key, expected);
  const double value = number.is_number_integer() ? number.get<double>() : -1;
  if (value < 0 || value > 1e6)
    throw InputError(fmt::format("\"{}\" is {}, expected {}", key, number.dump().substr(0, 40), expected));
  return static_cast<int>(value);
}

double finite(const PageJson& number, const std::string& name, const char* what) {
  const double value = number.is_number() ? number.get<double>() : NAN;
  if (!std::isfinite(value))
    throw InputError(
        fmt::format("{} of {} is {}, expected a finite number", what, name, number.dump().substr(0, 40)));
  return value;
}

BenchCase caseOf(const PageJson& entry, const std::string& name) {
  BenchCase found;
  for (const PageJson& time : entryOf<PageJson>(entry, "time_us", "a list of times")) {
    found.times_us.push_back(finite(time, name, "a time"));
    if (found.times_us.back() <= 0)
      throw InputError(fmt::format("a time of {} is {}, expected more than 0", name, found.times_us.back()));
  }
  if (found.times_us.empty()) throw InputError(fmt::format("{} has no times, expected some", name));
  const auto counters = entryOf<PageJson>(entry, "counters", "a map of counters");
  for (const auto& [key, value] : counters.items()) found.counters[key] = finite(value, name, "a counter");
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

BenchFile fromJson(const PageJson& root) {
  const auto format = entryOf<std::string>(root, "format", "\"fissure-bench\"");
  if (format != format_name)
    throw InputError(fmt::format("format is \"{}\", expected \"{}\"", format, format_name));
  if (countOf(root, "format_version", "1") > format_version)
    throw InputError("of a newer fissure, expected format_version 1");
  BenchFile file;
  file.commit = {entryOf<std::string>(root, "commit_date", "a date"),
                 entryOf<std::string>(root, "commit", "a commit's hash"),
                 entryOf<bool>(root, "modified", "true or false")};
  if (!isDate(file.commit.date))
    throw InputError(
        fmt::format("commit_date is \"{}\", expected UTC as 2026-01-31T12:00:00Z", file.commit.date));
  const auto machine = entryOf<PageJson>(root, "machine", "a map");
  const auto build = entryOf<PageJson>(root, "build", "a map");
  file.machine = {entryOf<std::string>(machine, "cpu", "a text"),
                  entryOf<std::string>(build, "compiler", "a text"),
                  entryOf<std::string>(build, "flags", "a text"), countOf(machine, "cores", "a count")};
  for (const PageJson& entry : entryOf<PageJson>(root, "benchmarks", "a list")) {
    const auto name = entryOf<std::string>(entry, "name", "a benchmark's name");
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
