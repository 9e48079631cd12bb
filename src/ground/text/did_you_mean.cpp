#include "text/did_you_mean.h"

#include <algorithm>

namespace fissure {

int editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = static_cast<int>(i);
  for (std::size_t j = 0; j <= b.size(); ++j) cost[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({replaced, cost[i - 1][j] + 1, cost[i][j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
    }
  }
  return cost[a.size()][b.size()];
}

const std::string* nearestName(std::string_view given, const std::vector<std::string>& known) {
  const std::string* nearest = nullptr;
  // A third of the letters may be wrong. Beyond that (or for absurdly long input) a suggestion would be
  // noise.
  int best = given.size() > 100 ? 0 : std::max<int>(1, static_cast<int>(given.size()) / 3) + 1;
  for (const std::string& name : known) {
    const bool unit_forgotten = !given.empty() && name.starts_with(std::string(given) + "_");
    const int distance = unit_forgotten ? 0 : best > 0 ? editDistance(given, name) : best;
    if (distance < best) {
      best = distance;
      nearest = &name;
    }
  }
  return nearest;
}

std::string didYouMean(std::string_view given, const std::vector<std::string>& known) {
  if (const std::string* nearest = nearestName(given, known)) return ", did you mean \"" + *nearest + "\"?";
  if (known.empty()) return ", expected none here";
  std::string message = ", expected one of ";
  for (std::size_t i = 0; i < known.size(); ++i) message += (i ? ", " : "") + known[i];
  return message;
}

}  // namespace fissure
