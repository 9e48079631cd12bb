#include "scenario/device_logs.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace fissure {

namespace {

/// Of UTF-8 too: the bytes of a micro sign belong to a word.
bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

constexpr std::array<std::pair<std::string_view, TimeUnit>, 10> spellings = {{{"s", TimeUnit::s},
                                                                              {"sec", TimeUnit::s},
                                                                              {"ms", TimeUnit::ms},
                                                                              {"msec", TimeUnit::ms},
                                                                              {"us", TimeUnit::us},
                                                                              {"usec", TimeUnit::us},
                                                                              {"\xc2\xb5s", TimeUnit::us},
                                                                              {"\xce\xbcs", TimeUnit::us},
                                                                              {"ns", TimeUnit::ns},
                                                                              {"nsec", TimeUnit::ns}}};

/// Endings of names that put no sign before the unit.
constexpr std::array<std::pair<std::string_view, TimeUnit>, 3> humps = {
    {{"Ms", TimeUnit::ms}, {"Us", TimeUnit::us}, {"Ns", TimeUnit::ns}}};

template <std::size_t N>
std::optional<TimeUnit> find(const std::array<std::pair<std::string_view, TimeUnit>, N>& table,
                             std::string_view text) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.first == text; });
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<TimeUnit> timeUnitIn(std::string_view column) {
  while (!column.empty() && (column.back() == ')' || column.back() == ']' || column.back() == ' '))
    column.remove_suffix(1);
  std::size_t start = column.size();
  while (start > 0 && isLetter(column[start - 1])) --start;
  const std::string_view word = column.substr(start);
  const bool apart = start == 0 || std::isalnum(static_cast<unsigned char>(column[start - 1])) == 0;
  if (apart)
    if (const std::optional<TimeUnit> unit = find(spellings, word)) return unit;
  const bool hump = word.size() > 2 && std::islower(static_cast<unsigned char>(word[word.size() - 3])) != 0;
  return hump ? find(humps, word.substr(word.size() - 2)) : std::nullopt;
}

}  // namespace fissure
