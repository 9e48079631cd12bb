#include "report/packed.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "report/base64.h"

namespace fissure {

namespace {

void addLittleEndian(std::uint32_t bits, int bytes, std::string& to) {
  for (int i = 0; i < bytes; ++i) to += static_cast<char>(bits >> (8 * i) & 0xffu);
}

}  // namespace

PageJson packedNumbers(const std::vector<double>& numbers) {
  const auto alike = [&](double number) {
    return std::isnan(number) ? std::isnan(numbers.front()) : number == numbers.front();
  };
  if (!numbers.empty() && std::all_of(numbers.begin(), numbers.end(), alike)) {
    if (std::isfinite(numbers.front())) return {{"same", numbers.front()}};
    return {{"same", nullptr}};
  }
  std::string bytes;
  bytes.reserve(4 * numbers.size());
  for (const double number : numbers)
    addLittleEndian(std::bit_cast<std::uint32_t>(static_cast<float>(number)), 4, bytes);
  return {{"f32", base64(bytes)}};
}

PageJson packedCodes(const std::vector<std::size_t>& codes) {
  std::string bytes;
  bytes.reserve(2 * codes.size());
  for (const std::size_t code : codes) addLittleEndian(static_cast<std::uint32_t>(code), 2, bytes);
  return {{"u16", base64(bytes)}};
}

PageJson packedTexts(const std::vector<std::string>& all, const std::vector<std::size_t>& runs) {
  std::set<std::string> wanted;
  for (const std::size_t run : runs) wanted.insert(all[run]);
  std::map<std::string, std::size_t> places;
  PageJson values = PageJson::array();
  for (std::size_t run = 0; run < all.size() && places.size() < wanted.size(); ++run) {
    if (wanted.contains(all[run]) && places.emplace(all[run], places.size()).second)
      values.push_back(all[run]);
  }
  std::vector<std::size_t> codes;
  codes.reserve(runs.size());
  for (const std::size_t run : runs) codes.push_back(places.at(all[run]));
  return {{"values", values}, {"codes", packedCodes(codes)}};
}

PageJson packedLevels(const std::vector<double>& numbers, std::size_t most) {
  const std::set<double> levels(numbers.begin(), numbers.end());
  if (levels.size() > most) return nullptr;
  std::vector<std::size_t> codes;
  codes.reserve(numbers.size());
  for (const double number : numbers)
    codes.push_back(static_cast<std::size_t>(std::distance(levels.begin(), levels.find(number))));
  return {{"values", levels}, {"codes", packedCodes(codes)}};
}

}  // namespace fissure
