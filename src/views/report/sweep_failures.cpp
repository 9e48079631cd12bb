#include "report/sweep_failures.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

namespace fissure {

namespace {

constexpr std::size_t most_examples = 3;
constexpr std::size_t most_axes = 3;
constexpr double most_share = 0.75;
constexpr std::size_t most_texts = 12;

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
std::vector<SweepFailure> failuresOf(const std::vector<RunEnd>& ends,
                                     const std::vector<std::string>& details) {
  std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> found;
  for (std::size_t run = 0; run < ends.size(); ++run) {
    if (ends[run] != RunEnd::ok && ends[run] != RunEnd::missing)
      found[{nameOf(ends[run]), withoutNumbers(details[run])}].push_back(run);
  }
  std::vector<SweepFailure> failures;
  for (const auto& [key, runs] : found) failures.push_back({ends[runs.front()], key.second, runs, {}});
  std::stable_sort(failures.begin(), failures.end(), [](const SweepFailure& a, const SweepFailure& b) {
    return a.runs.size() > b.runs.size();
  });
  return failures;
}

/// What share of the runs of a failure's pipelines lies `inside`.
template <typename Inside>
double shareOf(const SweepFailure& failure, const std::vector<std::string>& pipelines, const Inside& inside) {
  std::set<std::string> own;
  for (const std::size_t run : failure.runs) own.insert(pipelines[run]);
  double all = 0, some = 0;
  for (std::size_t run = 0; run < pipelines.size(); ++run) {
    if (!own.contains(pipelines[run])) continue;
    ++all;
    if (inside(run)) ++some;
  }
  return some / all;
}

/// Where along one numeric axis a failure's runs lie.
FailurePlace placeOf(const SweepFailure& failure, const std::string& axis, const std::vector<double>& values,
                     const std::vector<std::string>& pipelines) {
  const auto less = [&](std::size_t a, std::size_t b) { return values[a] < values[b]; };
  const auto [low, high] = std::minmax_element(failure.runs.begin(), failure.runs.end(), less);
  FailurePlace place{axis, values[*low], values[*high], {}};
  place.share = shareOf(failure, pipelines, [&](std::size_t run) {
    return values[run] >= place.from && values[run] <= place.to;
  });
  return place;
}

/// At which values of an axis of texts a failure's runs lie.
FailurePlace placeOf(const SweepFailure& failure, const std::string& axis,
                     const std::vector<std::string>& values, const std::vector<std::string>& pipelines) {
  std::set<std::string> texts;
  for (const std::size_t run : failure.runs) texts.insert(values[run]);
  FailurePlace place{axis, 0, 0, {texts.begin(), texts.end()}};
  place.share = shareOf(failure, pipelines, [&](std::size_t run) { return texts.contains(values[run]); });
  return place;
}

void findPlaces(const SweepTable& table, const std::vector<std::string>& pipelines,
                std::vector<SweepFailure>& failures) {
  for (const SweepAxisColumn& axis : table.layout().axes) {
    const auto find = [&](const auto& values, const auto& says) {
      for (SweepFailure& failure : failures) {
        const FailurePlace place = placeOf(failure, axis.name, values, pipelines);
        if (says(place)) failure.where.push_back(place);
      }
    };
    if (axis.numeric)
      find(table.numbers(axis.name), [](const FailurePlace& place) { return place.share <= most_share; });
    else
      find(table.texts(axis.name), [](const FailurePlace& place) { return place.share < 1; });
  }
  for (SweepFailure& failure : failures) {
    std::stable_sort(failure.where.begin(), failure.where.end(),
                     [](const FailurePlace& a, const FailurePlace& b) { return a.share < b.share; });
    failure.where.resize(std::min(failure.where.size(), most_axes));
  }
}

PageJson pipelinesOf(const SweepFailure& failure, const std::vector<std::string>& pipelines) {
  std::map<std::string, std::size_t> counts;
  for (const std::size_t run : failure.runs) ++counts[pipelines[run]];
  PageJson json = PageJson::array();
  for (const auto& [name, count] : counts) json.push_back({name, count});
  return json;
}

PageJson placeJson(const FailurePlace& place) {
  if (place.texts.empty())
    return {{"axis", place.axis}, {"from", place.from}, {"to", place.to}, {"share", place.share}};
  std::vector<std::string> values = place.texts;
  values.resize(std::min(values.size(), most_texts));
  return {{"axis", place.axis},
          {"values", values},
          {"more", place.texts.size() - values.size()},
          {"share", place.share}};
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
  ends.ends = table.ends();
  ends.pipelines = table.texts("pipeline");
  ends.failures = failuresOf(ends.ends, table.texts("status_detail"));
  findPlaces(table, ends.pipelines, ends.failures);
  ends.reasons.assign(table.runs(), ends.failures.size());
  for (std::size_t i = 0; i < ends.failures.size(); ++i)
    for (const std::size_t run : ends.failures[i].runs) ends.reasons[run] = i;
  return ends;
}

PageJson failuresJson(const SweepEnds& ends) {
  PageJson json = PageJson::array();
  for (const SweepFailure& failure : ends.failures) {
    std::vector<std::size_t> examples = failure.runs;
    examples.resize(std::min(examples.size(), most_examples));
    PageJson where = PageJson::array();
    for (const FailurePlace& place : failure.where) where.push_back(placeJson(place));
    json.push_back({{"status", nameOf(failure.end)},
                    {"reason", failure.reason},
                    {"count", failure.runs.size()},
                    {"examples", examples},
                    {"pipelines", pipelinesOf(failure, ends.pipelines)},
                    {"where", where}});
  }
  return json;
}

}  // namespace fissure
