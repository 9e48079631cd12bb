#include "sweep/sweep_points.h"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <numeric>

#include "base/reproducible.h"
#include "text/scalars.h"

namespace fissure {

namespace {

std::size_t lengthOf(const SweepAxis& axis) {
  if (axis.values) return axis.values->size();
  return static_cast<std::size_t>(axis.linear ? axis.linear->count : axis.logarithmic->count);
}

/// The number at `share` of the way, 0..1; the ends exactly.
double at(const SweepAxis& axis, double share) {
  const AxisRange& range = axis.linear ? *axis.linear : *axis.logarithmic;
  if (share <= 0) return range.from;
  if (share >= 1) return range.to;
  if (axis.linear) return range.from + share * (range.to - range.from);
  return range.from * reproducible::pow(range.to / range.from, share);
}

std::string gridText(const SweepAxis& axis, std::size_t i) {
  if (axis.values) return (*axis.values)[i];
  return formatReal(at(axis, static_cast<double>(i) / static_cast<double>(lengthOf(axis) - 1)));
}

/// `share` in [0, 1).
std::string sampleText(const SweepAxis& axis, double share) {
  if (!axis.values) return formatReal(at(axis, share));
  const std::size_t count = axis.values->size();
  return (*axis.values)[std::min(count - 1, static_cast<std::size_t>(share * static_cast<double>(count)))];
}

bool holds(const SweepCondition& condition, const std::string& text) {
  if (condition.values &&
      std::none_of(condition.values->begin(), condition.values->end(),
                   [&](const std::string& value) { return plainValue(value) == plainValue(text); }))
    return false;
  if (!condition.min && !condition.max) return true;
  const std::optional<double> number = toReal(text);
  return number && !(condition.min && *number < *condition.min) &&
         !(condition.max && *number > *condition.max);
}

using Shares = std::vector<std::vector<double>>;  // a row a point, a number in [0, 1) a group

Shares randomShares(std::size_t points, std::size_t groups, boost::random::mt19937_64& random) {
  boost::random::uniform_real_distribution<double> even(0, 1);
  Shares shares(points, std::vector<double>(groups));
  for (std::vector<double>& row : shares)
    for (double& share : row) share = even(random);
  return shares;
}

// McKay, Beckman and Conover (1979): each axis in as many strata as there are points, each hit once.
Shares latinShares(std::size_t points, std::size_t groups, boost::random::mt19937_64& random) {
  Shares shares = randomShares(points, groups, random);
  std::vector<std::size_t> order(points);
  for (std::size_t g = 0; g < groups; ++g) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = points; i > 1; --i)
      std::swap(order[i - 1], order[boost::random::uniform_int_distribution<std::size_t>(0, i - 1)(random)]);
    for (std::size_t i = 0; i < points; ++i)
      shares[i][g] = (static_cast<double>(order[i]) + shares[i][g]) / static_cast<double>(points);
  }
  return shares;
}

// Sobol's sequence from its first point, zero, on (Joe and Kuo's direction numbers), with a random digital
// shift (Matousek 1998), so that a seed means something, no point sits on all lower ends, and every power of
// two of points is still a net.
Shares sobolShares(std::size_t points, std::size_t groups, boost::random::mt19937_64& random) {
  std::vector<std::uint64_t> shift(groups);
  for (std::uint64_t& bits : shift) bits = random();
  boost::random::sobol sequence(groups);  // leaves out zero
  Shares shares(points, std::vector<double>(groups));
  for (std::size_t i = 0; i < points; ++i)
    for (std::size_t g = 0; g < groups; ++g) {
      const std::uint64_t bits = (i == 0 ? 0 : sequence()) ^ shift[g];
      shares[i][g] = std::ldexp(static_cast<double>(bits >> 11), -53);
    }
  return shares;
}

}  // namespace

double SweepPoints::designed(const SweepSettings& settings) {
  if (settings.design != SweepDesign::grid) return *settings.count;
  double points = 1;
  for (const AxisGroup& group : settings.axes) points *= static_cast<double>(lengthOf(group.axes.front()));
  return points;
}

SweepPoints::SweepPoints(const SweepSettings& settings) {
  for (const AxisGroup& group : settings.axes)
    for (const SweepAxis& axis : group.axes) paths_.push_back(axis.path);
  if (settings.design == SweepDesign::grid)
    makeGrid(settings);
  else
    makeSamples(settings);
}

void SweepPoints::makeGrid(const SweepSettings& settings) {
  std::vector<std::size_t> first_text;  // of each axis
  for (const AxisGroup& group : settings.axes) {
    for (const SweepAxis& axis : group.axes) {
      first_text.push_back(texts_.size());
      for (std::size_t i = 0; i < lengthOf(axis); ++i) texts_.push_back(gridText(axis, i));
    }
  }
  std::vector<std::size_t> place(settings.axes.size(), 0), point(paths_.size());
  for (bool more = true; more;) {
    std::size_t axis = 0;
    for (std::size_t g = 0; g < place.size(); ++g)
      for (std::size_t a = 0; a < settings.axes[g].axes.size(); ++a, ++axis)
        point[axis] = first_text[axis] + place[g];
    addUnlessExcluded(settings, point);
    more = false;
    for (std::size_t g = place.size(); g-- > 0 && !more;) {
      more = ++place[g] < lengthOf(settings.axes[g].axes.front());
      if (!more) place[g] = 0;
    }
  }
}

void SweepPoints::makeSamples(const SweepSettings& settings) {
  boost::random::mt19937_64 random(static_cast<std::uint64_t>(*settings.seed));
  const auto points = static_cast<std::size_t>(*settings.count);
  const std::size_t groups = settings.axes.size();
  const Shares shares = settings.design == SweepDesign::random ? randomShares(points, groups, random)
                        : settings.design == SweepDesign::latin_hypercube
                            ? latinShares(points, groups, random)
                            : sobolShares(points, groups, random);
  std::vector<std::size_t> point(paths_.size());
  for (const std::vector<double>& row : shares) {
    const std::size_t first = texts_.size();
    for (std::size_t g = 0; g < groups; ++g)
      for (const SweepAxis& axis : settings.axes[g].axes) texts_.push_back(sampleText(axis, row[g]));
    std::iota(point.begin(), point.end(), first);
    addUnlessExcluded(settings, point);
  }
}

void SweepPoints::addUnlessExcluded(const SweepSettings& settings, const std::vector<std::size_t>& texts) {
  const auto fits = [&](const SweepCondition& condition) {
    const auto axis = std::find(paths_.begin(), paths_.end(), condition.path) - paths_.begin();
    return holds(condition, texts_[texts[static_cast<std::size_t>(axis)]]);
  };
  for (const std::vector<SweepCondition>& all : settings.exclude)
    if (std::all_of(all.begin(), all.end(), fits)) return;
  points_.insert(points_.end(), texts.begin(), texts.end());
}

}  // namespace fissure
