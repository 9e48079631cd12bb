#include "scenario/device_logs.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace fissure {

namespace {

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Whether the byte belongs to a word. Every byte of a UTF-8 character beyond ASCII does, as in a micro sign.
bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

bool isHump(char before, char c) {
  return std::islower(static_cast<unsigned char>(before)) != 0 &&
         std::isupper(static_cast<unsigned char>(c)) != 0;
}

std::string inLowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return c < 0x80 ? static_cast<char>(std::tolower(c)) : c; });
  return lower;
}

/// "ms", "msecs", "millis", "milliseconds", ...: a part of a second and a second.
std::optional<TimeUnit> spelledOut(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, TimeUnit>, 9> parts = {{{"milli", TimeUnit::ms},
                                                                           {"micro", TimeUnit::us},
                                                                           {"nano", TimeUnit::ns},
                                                                           {"m", TimeUnit::ms},
                                                                           {"u", TimeUnit::us},
                                                                           {"\xc2\xb5", TimeUnit::us},
                                                                           {"\xce\xbc", TimeUnit::us},
                                                                           {"n", TimeUnit::ns},
                                                                           {"", TimeUnit::s}}};
  constexpr std::array<std::string_view, 5> seconds = {"s", "sec", "secs", "second", "seconds"};
  for (const auto& [part, unit] : parts)
    if (word.starts_with(part) &&
        std::find(seconds.begin(), seconds.end(), word.substr(part.size())) != seconds.end())
      return unit;
  return std::nullopt;
}

/// Also one that is written together with what it is the unit of: "timems".
std::optional<TimeUnit> unitOf(const std::string& word) {
  if (const std::optional<TimeUnit> unit = spelledOut(word)) return unit;
  for (const std::string_view what : {"timestamp", "time", "stamp", "elapsed", "t"})
    if (word.starts_with(what) && word.size() > what.size() + 1)  // "times" and "ts" are no seconds
      if (const std::optional<TimeUnit> unit = spelledOut(std::string_view(word).substr(what.size())))
        return unit;
  return std::nullopt;
}

bool isOtherUnit(const std::string& word) {
  constexpr std::array<std::string_view, 16> others = {
      "min",   "mins", "minute", "minutes", "h",       "hr", "hrs", "hour",
      "hours", "days", "tick",   "ticks",   "jiffies", "ps", "cs",  "ds"};
  const std::array<std::string_view, 5> beginnings = {"milli", "micro", "nano", "pico", "centi"};
  return std::find(others.begin(), others.end(), word) != others.end() ||
         std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return word.starts_with(beginning); });
}

/// Looks at the name of a column word by word.
class UnitInName {
 public:
  explicit UnitInName(std::string_view name) {
    for (std::size_t at = 0; at < name.size();) {
      std::size_t end = at;
      while (end < name.size() && (isLetter(name[end]) || isDigit(name[end]))) ++end;
      if (end > at) look(name.substr(at, end - at));
      at = end + 1;
    }
    hints_ |= hasWordInBrackets(name);
  }

  std::optional<TimeUnit> unit() const {
    if (contradicts_ || (!unit_ && hints_)) return std::nullopt;
    return unit_.value_or(TimeUnit::s);
  }

 private:
  static bool hasWordInBrackets(std::string_view name) {
    const std::size_t open = name.find_first_of("([{"), close = name.find_last_of(")]}");
    return open < close && close != std::string_view::npos &&
           std::any_of(name.begin() + static_cast<std::ptrdiff_t>(open),
                       name.begin() + static_cast<std::ptrdiff_t>(close), isLetter);
  }

  /// `run`: letters and digits.
  void look(std::string_view run) {
    const auto letters =
        static_cast<std::size_t>(std::find_if(run.begin(), run.end(), isLetter) - run.begin());
    behind_number_ |= letters > 0;
    if (letters == run.size()) return;
    lookAtLetters(run.substr(letters));
    behind_number_ = false;
  }

  /// `run` begins with a letter. Its end counts first: "timeMSec" ends in a unit of two humps.
  void lookAtLetters(std::string_view run) {
    std::vector<std::size_t> starts = {0};
    for (std::size_t i = 1; i < run.size(); ++i)
      if (isHump(run[i - 1], run[i])) starts.push_back(i);
    for (const std::size_t start : starts)
      if (const std::optional<TimeUnit> unit = unitOf(inLowerCase(run.substr(start)))) return take(*unit);
    starts.push_back(run.size());
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
      const std::string word = inLowerCase(run.substr(starts[i], starts[i + 1] - starts[i]));
      if (const std::optional<TimeUnit> unit = unitOf(word)) take(*unit);
      hints_ |= isOtherUnit(word);
    }
  }

  void take(TimeUnit unit) {
    contradicts_ |= behind_number_ || (unit_ && *unit_ != unit);
    unit_ = unit;
  }

  std::optional<TimeUnit> unit_;
  bool hints_ = false;          ///< at another unit
  bool contradicts_ = false;    ///< two units, or a number of one
  bool behind_number_ = false;  ///< as "ns" in "100 ns"
};

}  // namespace

std::optional<TimeUnit> timeUnitIn(std::string_view column) {
  return UnitInName(column).unit();
}

}  // namespace fissure
