#include "report/sweep_failures.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

namespace fissure {

namespace {

constexpr std::size_t most_examples = 3;
constexpr std::size_t most_axes = 3;
constexpr double most_share = 0.75;

struct Cause {
  std::string status;
  std::string reason;
  std::vector<std::size_t> runs;
};

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Past the number that begins at `at`: digits, a point, an exponent.
std::size_t endOfNumber(const std::string& text, std::size_t at) {
  const auto digits = [&] {
    while (at < text.size() && isDigit(text[at])) ++at;
  };
  digits();
  if (at + 1 < text.size() && text[at] == '.' && isDigit(text[at + 1])) {
    ++at;
    digits();
  }
  std::size_t power = at;
  if (power < text.size() && (text[power] == 'e' || text[power] == 'E')) ++power;
  if (power > at && power < text.size() && (text[power] == '-' || text[power] == '+')) ++power;
  if (power > at && power < text.size() && isDigit(text[power])) {
    at = power;
    digits();
  }
  return at;
}

/// Most frequent first, then by name.
std::vector<Cause> causesOf(const std::vector<std::string>& status, const std::vector<std::string>& details) {
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> found;
  for (std::size_t run = 0; run < status.size(); ++run) {
    if (status[run] != good_run && status[run] != missing_run)
      found[{status[run], withoutNumbers(details[run])}].push_back(run);
  }
  std::vector<Cause> causes;
  for (const auto& [key, runs] : found) causes.push_back({key.first, key.second, runs});
  std::stable_sort(causes.begin(), causes.end(),
                   [](const Cause& a, const Cause& b) { return a.runs.size() > b.runs.size(); });
  return causes;
}

/// Where along each numeric axis a cause's runs lie.
PageJson whereOf(const Cause& cause, const std::vector<SweepAxisColumn>& axes,
                 const std::vector<std::vector<double>>& values, const std::vector<std::string>& pipelines) {
  std::set<std::string> own;
  for (const std::size_t run : cause.runs) own.insert(pipelines[run]);
  std::vector<PageJson> found;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    if (values[axis].empty()) continue;
    const auto less = [&](std::size_t a, std::size_t b) { return values[axis][a] < values[axis][b]; };
    const auto [low, high] = std::minmax_element(cause.runs.begin(), cause.runs.end(), less);
    const double from = values[axis][*low], to = values[axis][*high];
    double all = 0, inside = 0;
    for (std::size_t run = 0; run < pipelines.size(); ++run) {
      if (!own.contains(pipelines[run])) continue;
      ++all;
      if (values[axis][run] >= from && values[axis][run] <= to) ++inside;
    }
    if (inside <= most_share * all)
      found.push_back({{"axis", axes[axis].name}, {"from", from}, {"to", to}, {"share", inside / all}});
  }
  std::stable_sort(found.begin(), found.end(), [](const PageJson& a, const PageJson& b) {
    return a.at("share").get<double>() < b.at("share").get<double>();
  });
  if (found.size() > most_axes) found.resize(most_axes);
  return found;
}

PageJson pipelinesOf(const Cause& cause, const std::vector<std::string>& pipelines) {
  std::map<std::string, std::size_t> counts;
  for (const std::size_t run : cause.runs) ++counts[pipelines[run]];
  PageJson json = PageJson::array();
  for (const auto& [name, count] : counts) json.push_back({name, count});
  return json;
}

}  // namespace

std::string withoutNumbers(const std::string& reason) {
  std::string text;
  for (std::size_t at = 0; at < reason.size();) {
    const bool in_name =
        at > 0 && (std::isalnum(static_cast<unsigned char>(reason[at - 1])) != 0 || reason[at - 1] == '_');
    const bool sign = (reason[at] == '-' || reason[at] == '+') && !in_name && at + 1 < reason.size() &&
                      isDigit(reason[at + 1]);
    if ((isDigit(reason[at]) && !in_name) || sign) {
      text += '#';
      at = endOfNumber(reason, at + (sign ? 1 : 0));
    } else {
      text += reason[at++];
    }
  }
  return text;
}

SweepEnds sweepEnds(const SweepTable& table) {
  SweepEnds ends;
  ends.status = table.texts("status");
  const std::vector<std::string> pipelines = table.texts("pipeline");
  std::vector<std::vector<double>> values;
  for (const SweepAxisColumn& axis : table.layout().axes)
    values.push_back(axis.numeric ? table.numbers(axis.name) : std::vector<double>());
  const std::vector<Cause> causes = causesOf(ends.status, table.texts("status_detail"));
  ends.reasons.assign(table.runs(), causes.size());
  ends.failures = PageJson::array();
  for (const Cause& cause : causes) {
    for (const std::size_t run : cause.runs) ends.reasons[run] = ends.failures.size();
    std::vector<std::size_t> examples = cause.runs;
    examples.resize(std::min(examples.size(), most_examples));
    ends.failures.push_back({{"status", cause.status},
                             {"reason", cause.reason},
                             {"count", cause.runs.size()},
                             {"examples", examples},
                             {"pipelines", pipelinesOf(cause, pipelines)},
                             {"where", whereOf(cause, table.layout().axes, values, pipelines)}});
  }
  return ends;
}

}  // namespace fissure
