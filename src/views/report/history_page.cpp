#include "report/history_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace fissure {

namespace {

/// The commits and machines of a history, in the order of the page.
struct Places {
  std::vector<BenchCommit> commits;
  std::vector<BenchMachine> machines;
};

template <class Item>
std::size_t indexOf(const std::vector<Item>& items, const Item& item) {
  return static_cast<std::size_t>(std::find(items.begin(), items.end(), item) - items.begin());
}

Places placesOf(const BenchHistory& history) {
  std::set<BenchCommit> commits;
  std::set<BenchMachine> machines;
  for (const BenchFile& file : history.files) {
    commits.insert(file.commit);
    machines.insert(file.machine);
  }
  return {{commits.begin(), commits.end()}, {machines.begin(), machines.end()}};
}

PageJson commitsJson(const std::vector<BenchCommit>& commits) {
  PageJson json = PageJson::array();
  for (const BenchCommit& commit : commits)
    json.push_back({{"commit", commit.commit}, {"date", commit.date}, {"modified", commit.modified}});
  return json;
}

/// Machines are called by their processor, and by their number too where that is another's.
PageJson machinesJson(const std::vector<BenchMachine>& machines) {
  PageJson json = PageJson::array();
  for (std::size_t i = 0; i < machines.size(); ++i) {
    const BenchMachine& machine = machines[i];
    const auto same = std::count_if(machines.begin(), machines.end(),
                                    [&](const BenchMachine& other) { return other.cpu == machine.cpu; });
    json.push_back({{"name", same > 1 ? fmt::format("{} ({})", machine.cpu, i + 1) : machine.cpu},
                    {"cores", machine.cores},
                    {"compiler", machine.compiler},
                    {"flags", machine.flags}});
  }
  return json;
}

/// A benchmark on one machine, all its commits.
struct CommitCurve {
  std::vector<std::size_t> commits;
  std::vector<std::vector<double>> times_us;
};

PageJson curveJson(const CommitCurve& curve, std::size_t machine) {
  PageJson medians = PageJson::array(), lows = PageJson::array(), highs = PageJson::array();
  for (const std::vector<double>& times : curve.times_us) {
    medians.push_back(shortNumber(quantile(times, 0.5)));
    lows.push_back(shortNumber(quantile(times, 0.25)));
    highs.push_back(shortNumber(quantile(times, 0.75)));
  }
  PageJson steps = PageJson::array();
  for (const BenchStep& step : findSteps(curve.times_us))
    steps.push_back({{"commit", curve.commits[step.at]},
                     {"from", curve.commits[step.at - 1]},
                     {"ratio", shortNumber(step.ratio)},
                     {"p", shortNumber(step.p)}});
  return {{"machine", machine}, {"commits", curve.commits}, {"median_us", medians},
          {"low_us", lows},     {"high_us", highs},         {"steps", steps}};
}

/// [{name, values}]: a value a commit, null where none was counted; of two machines the first one's, and
/// `differs` where another counted something else.
PageJson countersJson(const BenchHistory& history, const Places& places, const std::string& name) {
  struct Counter {
    std::vector<PageJson> values;
    bool differs = false;
  };
  std::map<std::string, Counter> counters;
  for (const BenchFile& file : history.files) {
    const auto found = file.cases.find(name);
    if (found == file.cases.end()) continue;
    for (const auto& [key, value] : found->second.counters) {
      Counter& counter = counters[key];
      counter.values.resize(places.commits.size());
      PageJson& known = counter.values[indexOf(places.commits, file.commit)];
      if (known.is_null())
        known = value;
      else
        counter.differs |= known != PageJson(value);
    }
  }
  PageJson json = PageJson::array();
  for (const auto& [key, counter] : counters)
    json.push_back({{"name", key}, {"values", counter.values}, {"differs", counter.differs}});
  return json;
}

PageJson benchmarkJson(const BenchHistory& history, const Places& places, const std::string& name) {
  std::vector<CommitCurve> curves(places.machines.size());
  for (const BenchFile& file : history.files) {
    const auto found = file.cases.find(name);
    if (found == file.cases.end()) continue;
    CommitCurve& curve = curves[indexOf(places.machines, file.machine)];
    curve.commits.push_back(indexOf(places.commits, file.commit));
    curve.times_us.push_back(found->second.times_us);
  }
  PageJson json = PageJson::array();
  for (std::size_t machine = 0; machine < curves.size(); ++machine)
    if (!curves[machine].commits.empty()) json.push_back(curveJson(curves[machine], machine));
  return {{"name", name}, {"curves", json}, {"counters", countersJson(history, places, name)}};
}

}  // namespace

PageJson historyPage(const std::string& title, const std::string& program, const BenchHistory& history) {
  const Places places = placesOf(history);
  std::set<std::string> names;
  for (const BenchFile& file : history.files)
    for (const auto& [name, ignored] : file.cases) names.insert(name);
  PageJson benchmarks = PageJson::array();
  for (const std::string& name : names) benchmarks.push_back(benchmarkJson(history, places, name));
  PageJson problems = PageJson::array();
  for (const BenchHistory::Problem& problem : history.problems)
    problems.push_back({{"file", problem.file}, {"text", problem.text}});
  return {{"kind", "history"},
          {"title", title},
          {"program", program},
          {"commits", commitsJson(places.commits)},
          {"machines", machinesJson(places.machines)},
          {"criterion",
           {{"relative", step_relative},
            {"absolute_us", step_absolute_us},
            {"p", step_p},
            {"before", step_before},
            {"after", step_after}}},
          {"benchmarks", benchmarks},
          {"problems", problems}};
}

}  // namespace fissure
