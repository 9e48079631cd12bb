#include "study/tradeoff_choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fissure {

namespace {

bool isFinitePair(double cost, double error) {
  return std::isfinite(cost) && std::isfinite(error);
}

/// The index with the least of `keys`, two numbers each, among those that `may` be taken.
template <class May, class Keys>
std::optional<std::size_t> leastOf(std::size_t count, May may, Keys keys) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < count; ++i)
    if (may(i) && (!found || keys(i) < keys(*found))) found = i;
  return found;
}

}  // namespace

std::vector<bool> paretoFront(std::span<const double> costs, std::span<const double> errors) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < costs.size(); ++i)
    if (isFinitePair(costs[i], errors[i])) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(costs[a], errors[a], a) < std::tuple(costs[b], errors[b], b);
  });
  std::vector<bool> front(costs.size(), false);
  std::vector<std::size_t> kept;  // only these rule others out, or small differences would add up
  for (const std::size_t i : order) {
    front[i] = std::none_of(kept.begin(), kept.end(), [&](std::size_t j) {
      const bool is_better = costs[j] < costs[i] || errors[j] < errors[i];
      return is_better && errors[j] <= errors[i] * (1 + same_error);
    });
    if (front[i]) kept.push_back(i);
  }
  return front;
}

ObservedOrder orderOf(std::span<const double> sizes, std::span<const double> errors, double floor) {
  ObservedOrder found;
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const bool speaks = std::isfinite(errors[i]) && errors[i] > 0 && errors[i] >= 2 * floor && sizes[i] > 0;
    if (!speaks) continue;
    const double log_size = std::log(sizes[i]), log_error = std::log(errors[i]);
    x += log_size, y += log_error, xx += log_size * log_size, xy += log_size * log_error;
    ++found.values;
  }
  const auto count = static_cast<double>(found.values);
  const double spread = count * xx - x * x;
  if (found.values >= 3 && spread > 0) found.order = (count * xy - x * y) / spread;
  return found;
}

Choice mostAccurate(std::span<const double> costs, std::span<const double> errors, double budget) {
  Choice choice;
  const auto may = [&](std::size_t i) { return isFinitePair(costs[i], errors[i]) && costs[i] <= budget; };
  choice.best = leastOf(costs.size(), may, [&](std::size_t i) { return std::tuple(errors[i], costs[i]); });
  if (choice.best) {
    const double enough = errors[*choice.best] * (1 + same_error);
    choice.best = leastOf(
        costs.size(), [&](std::size_t i) { return may(i) && errors[i] <= enough; },
        [&](std::size_t i) { return std::tuple(costs[i], errors[i]); });
  }
  if (choice.best) return choice;
  choice.nearest = leastOf(
      costs.size(), [&](std::size_t i) { return isFinitePair(costs[i], errors[i]); },
      [&](std::size_t i) { return std::tuple(costs[i], errors[i]); });
  if (choice.nearest) choice.times_over = costs[*choice.nearest] / budget;
  return choice;
}

Choice cheapest(std::span<const double> costs, std::span<const double> excess) {
  Choice choice;
  choice.best = leastOf(
      costs.size(), [&](std::size_t i) { return isFinitePair(costs[i], excess[i]) && excess[i] <= 1; },
      [&](std::size_t i) { return std::tuple(costs[i], excess[i]); });
  if (choice.best) return choice;
  const auto known = [&](std::size_t i) { return isFinitePair(costs[i], excess[i]); };
  choice.nearest =
      leastOf(costs.size(), known, [&](std::size_t i) { return std::tuple(excess[i], costs[i]); });
  if (!choice.nearest) return choice;
  const double as_near = excess[*choice.nearest] * (1 + same_error);
  choice.nearest = leastOf(
      costs.size(), [&](std::size_t i) { return known(i) && excess[i] <= as_near; },
      [&](std::size_t i) { return std::tuple(costs[i], excess[i]); });
  choice.times_over = excess[*choice.nearest];
  return choice;
}

Spread spreadOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  Spread spread;
  spread.count = values.size();
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 == values.size()) return values.back();
    const double rest = place - static_cast<double>(below);
    return (1 - rest) * values[below] + rest * values[below + 1];
  };
  spread.low = at(0.25);
  spread.median = at(0.5);
  spread.high = at(0.75);
  return spread;
}

}  // namespace fissure
