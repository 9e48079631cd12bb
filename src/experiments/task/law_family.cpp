#include "task/law_family.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

#include "base/error.h"
#include "scenario/catalog.h"

namespace fissure {

namespace {

/// Relative; the roundings of B / A, of -k / c and of the law's own products move the place where a triangle
/// starts to pull by at most three times 2^-52.
constexpr double kMargin = 8 * std::numeric_limits<double>::epsilon();

/// Laws that are evaluated in all steps before the next ones: so many, with what callers keep for them, stay
/// in a processor's cache.
constexpr std::size_t kLawsAtATime = 256;

/// Whether products of three such numbers are exact up to rounding: none overflows or becomes denormal.
bool isOrdinary(double value) {
  const double size = std::abs(value);
  return size == 0 || (size >= 1e-80 && size <= 1e80);
}

std::size_t channelOf(const ForceSettings& law, const std::vector<ForceSettings>& scenario_laws) {
  const auto found = std::find_if(scenario_laws.begin(), scenario_laws.end(), [&](const auto& of) {
    return of.deformation == law.deformation && of.rate == law.rate;
  });
  if (found == scenario_laws.end())
    throw InputError(fmt::format(
        "force law {}: no law of the scenario has deformation {} and rate {}, whose inputs it needs",
        law.name, nameIn(catalog().deformations, law.deformation), nameIn(catalog().rates, law.rate)));
  return static_cast<std::size_t>(found - scenario_laws.begin());
}

}  // namespace

LawValues::LawValues(std::size_t laws)
    : force_N(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(laws))),
      elastic_N(force_N),
      viscous_N(force_N),
      adhesion_clamped(laws) {}

LawValue LawValues::at(std::size_t place) const {
  const auto i = static_cast<Eigen::Index>(place);
  return {force_N[i], elastic_N[i], viscous_N[i], adhesion_clamped[place]};
}

LawFamily::LawFamily(const std::vector<ForceSettings>& laws, const std::vector<ForceSettings>& scenario_laws)
    : scenario_laws_(scenario_laws.size()), places_(laws.size()), values_(laws.size()) {
  std::map<std::tuple<std::size_t, bool, ForceModel, double>, Group> groups;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const ForceSettings& law = laws[i];
    const ForceLawEntry& entry = entryOf(law.model);
    const auto valueOf = [&](CoefficientRole role) {
      const LawCoefficient* coefficient = entry.find(role);
      return coefficient ? law.coefficients.*coefficient->member : 0;
    };
    laws_.emplace_back(law.model, law.coefficients);
    const std::size_t channel = channelOf(law, scenario_laws);
    Group& group = groups[{channel, law.per_area, law.model, valueOf(CoefficientRole::shape)}];
    group.law = &entry;
    group.coefficients = law.coefficients;
    group.per_area = law.per_area;
    group.channel = channel;
    const double k = valueOf(CoefficientRole::elastic), c = valueOf(CoefficientRole::damping);
    group.members.push_back({.law = i,
                             .k = k,
                             .c = c,
                             .threshold = c > 0 ? -k / c : -std::numeric_limits<double>::infinity(),
                             .extreme = !isOrdinary(k) || !isOrdinary(c) || c < 0});
  }
  std::size_t place = 0;
  for (auto& [key, group] : groups) {
    std::stable_sort(group.members.begin(), group.members.end(),
                     [](const Member& a, const Member& b) { return a.threshold < b.threshold; });
    group.first_place = place;
    group.k.resize(static_cast<Eigen::Index>(group.members.size()));
    group.c.resize(group.k.size());
    for (Eigen::Index m = 0; const Member& member : group.members) {
      places_[member.law] = place++;
      group.k[m] = member.k;
      group.c[m++] = member.c;
    }
    groups_.push_back(std::move(group));
  }
}

void LawFamily::evaluate(const std::vector<LawInput>& inputs) {
  evaluate({&inputs, 1}, [](std::size_t, std::size_t, std::size_t) {});
}

void LawFamily::evaluate(std::span<const std::vector<LawInput>> steps, const Visitor& visit) {
  for (const std::vector<LawInput>& inputs : steps)
    if (scenario_laws_ == 0 ? !inputs.empty() : inputs.size() % scenario_laws_ != 0)
      throw std::logic_error("the inputs of force laws are not of the scenario's number of laws");
  orders_.resize(std::max(orders_.size(), steps.size()));
  shared_.resize(orders_.size());
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const Group& group = groups_[i];
    for (std::size_t s = 0; s < steps.size(); ++s) {
      if (i == 0 || group.channel != groups_[i - 1].channel) orderByRate(group.channel, steps[s], orders_[s]);
      share(group, steps[s], orders_[s], shared_[s]);
    }
    for (std::size_t first = 0; first < group.members.size(); first += kLawsAtATime) {
      const std::size_t end = std::min(first + kLawsAtATime, group.members.size());
      for (std::size_t s = 0; s < steps.size(); ++s) {
        evaluate(group, steps[s], first, end, shared_[s]);
        visit(s, group.first_place + first, group.first_place + end);
      }
    }
  }
}

void LawFamily::orderByRate(std::size_t channel, const std::vector<LawInput>& inputs,
                            std::vector<std::size_t>& order) const {
  order.clear();
  for (std::size_t i = channel; i < inputs.size(); i += scenario_laws_) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double of_a = inputs[a].rate_m_s, of_b = inputs[b].rate_m_s;
    return of_a < of_b || (std::isnan(of_b) && !std::isnan(of_a));
  });
}

void LawFamily::share(const Group& group, const std::vector<LawInput>& inputs,
                      const std::vector<std::size_t>& order, Shared& shared) const {
  shared.terms.clear();
  shared.plain.clear();
  shared.pulling = shared.pushing = 0;
  const ForceLawEntry& law = *group.law;
  const bool damped = law.find(CoefficientRole::damping) != nullptr;
  // A damper of its own acts where there is no deformation yet.
  const bool acts_at_zero = damped && !law.damping_grows_with_elastic;
  for (const std::size_t i : order) {
    const LawInput& input = inputs[i];
    const double x_m = input.deformation_m, rate_m_s = damped ? input.rate_m_s : 0;
    const bool usual = input.direction.allFinite() && (!group.per_area || isOrdinary(input.area_m2));
    if (usual && (acts_at_zero ? x_m < 0 : x_m <= 0)) continue;  // as the law has it
    const LawTerms terms = law.terms(group.coefficients, x_m, rate_m_s);
    if (!usual || terms.elastic == 0 || !isOrdinary(terms.elastic) || !isOrdinary(rate_m_s))
      shared.plain.push_back(i);
    else
      shared.terms.push_back({terms.damping_over_elastic, terms.elastic, terms.damping, i});
  }
  const auto before = [](const Term& a, const Term& b) { return a.ratio < b.ratio; };
  if (!std::is_sorted(shared.terms.begin(), shared.terms.end(), before))
    std::sort(shared.terms.begin(), shared.terms.end(), before);
  makeTails(group, inputs, shared);
}

// From the fastest growing triangle down: sums of what counts, never differences of sums.
void LawFamily::makeTails(const Group& group, const std::vector<LawInput>& inputs, Shared& shared) const {
  shared.tails.resize(shared.terms.size() + 1);
  shared.tails.back() = {};
  for (std::size_t t = shared.terms.size(); t-- > 0;) {
    const Term& term = shared.terms[t];
    const LawInput& input = inputs[term.input];
    const double weight = group.per_area ? input.area_m2 : 1;
    const Tail& next = shared.tails[t + 1];
    shared.tails[t] = {next.a_direction + weight * term.a * input.direction,
                       next.b_direction + weight * term.b * input.direction, next.a + weight * term.a,
                       next.b + weight * term.b};
  }
}

void LawFamily::addPlainly(const Group& group, const Member& member, const LawInput& input, Sum& sum) const {
  const LawForce force = laws_[member.law].at(input.deformation_m, input.rate_m_s);
  const double area = group.per_area ? input.area_m2 : 1;
  sum.elastic_N += area * force.elastic_N;
  sum.viscous_N += area * force.viscous_N;
  sum.adhesion_clamped += force.adhesion_clamped ? 1 : 0;
  sum.force_N += area * (force.elastic_N + force.viscous_N) * input.direction;
}

LawFamily::Sum LawFamily::sumPlainly(const Group& group, const Member& member,
                                     const std::vector<LawInput>& inputs, const Shared& shared) const {
  Sum sum;
  const std::size_t first = member.extreme ? 0 : shared.pulling;
  const std::size_t end = member.extreme ? shared.terms.size() : shared.pushing;
  for (std::size_t t = first; t < end; ++t) addPlainly(group, member, inputs[shared.terms[t].input], sum);
  for (const std::size_t i : shared.plain) addPlainly(group, member, inputs[i], sum);
  return sum;
}

// Evaluates the group's members from `first` to before `end`, which must follow those of the call before.
void LawFamily::evaluate(const Group& group, const std::vector<LawInput>& inputs, std::size_t first,
                         std::size_t end, Shared& shared) {
  const std::vector<Term>& terms = shared.terms;
  while (first < end) {
    const Member& member = group.members[first];
    const double above = member.threshold * (1 - kMargin), below = member.threshold * (1 + kMargin);
    while (shared.pulling < terms.size() && terms[shared.pulling].ratio < below) ++shared.pulling;
    while (shared.pushing < terms.size() && terms[shared.pushing].ratio <= above) ++shared.pushing;
    if (member.extreme || shared.pulling != shared.pushing || !shared.plain.empty()) {
      evaluateSingly(group, inputs, first++, shared);
      continue;
    }
    // The members for which the same triangles pull.
    const double next =
        shared.pushing < terms.size() ? terms[shared.pushing].ratio : std::numeric_limits<double>::infinity();
    std::size_t alike = first + 1;
    while (alike < end && !group.members[alike].extreme &&
           group.members[alike].threshold * (1 - kMargin) < next)
      ++alike;
    evaluateAlike(group, first, alike, shared);
    first = alike;
  }
}

void LawFamily::evaluateSingly(const Group& group, const std::vector<LawInput>& inputs, std::size_t m,
                               const Shared& shared) {
  const Member& member = group.members[m];
  Sum sum = sumPlainly(group, member, inputs, shared);
  if (!member.extreme) sum.adhesion_clamped += static_cast<int>(shared.pulling);
  const Tail& pushed = shared.tails[member.extreme ? shared.terms.size() : shared.pushing];
  sum.force_N += member.k * pushed.a_direction + member.c * pushed.b_direction;
  const std::size_t place = group.first_place + m;
  const auto i = static_cast<Eigen::Index>(place);
  values_.force_N[i] = sum.force_N.norm();
  values_.elastic_N[i] = sum.elastic_N + member.k * pushed.a;
  values_.viscous_N[i] = sum.viscous_N + member.c * pushed.b;
  values_.adhesion_clamped[place] = sum.adhesion_clamped;
}

// Bit by bit as singly: each sum begins with 0, the square of a norm with the sum over y and z.
void LawFamily::evaluateAlike(const Group& group, std::size_t first, std::size_t end, const Shared& shared) {
  const Tail& pushed = shared.tails[shared.pushing];
  const auto count = static_cast<Eigen::Index>(end - first);
  const auto k = group.k.segment(static_cast<Eigen::Index>(first), count);
  const auto c = group.c.segment(static_cast<Eigen::Index>(first), count);
  const std::size_t place = group.first_place + first;
  const auto i = static_cast<Eigen::Index>(place);
  const auto squared = [&](Eigen::Index axis) {
    return (k * pushed.a_direction[axis] + c * pushed.b_direction[axis]).square();
  };
  values_.force_N.segment(i, count) = (squared(0) + (squared(1) + squared(2))).sqrt();
  values_.elastic_N.segment(i, count) = 0.0 + k * pushed.a;
  values_.viscous_N.segment(i, count) = 0.0 + c * pushed.b;
  std::fill_n(values_.adhesion_clamped.begin() + static_cast<std::ptrdiff_t>(place), count,
              static_cast<int>(shared.pulling));
}

}  // namespace fissure
