#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "base/state.h"
#include "law/force_law.h"
#include "scenario/forces.h"

namespace fissure {

/// The value of a force law over all triangles in one step, as in ForceSample.
struct LawValue {
  double force_N = 0;    ///< magnitude of the total force on the tools together
  double elastic_N = 0;  ///< sum of the triangles' elastic terms (magnitudes)
  double viscous_N = 0;  ///< sum of the triangles' viscous terms (signed magnitudes)
  int adhesion_clamped = 0;
};

/// The values of many force laws in one step, each as in LawValue.
struct LawValues {
  explicit LawValues(std::size_t laws);
  LawValue at(std::size_t place) const;
  std::size_t size() const { return adhesion_clamped.size(); }

  Eigen::ArrayXd force_N, elastic_N, viscous_N;
  std::vector<int> adhesion_clamped;
};

/// Evaluates many force laws over the same simulation, ten thousand at the cost of a few. Every law is a sum
/// of k A + c B over triangles, with its two terms A and B (LawTerms; Hunt-Crossley: x^n and x^n x'), and a
/// triangle would pull where B / A < -k / c. Laws with the same A and B therefore share the triangles sorted
/// by B / A and the partial sums of A and B from each place to the end: each law needs only its place in that
/// order and one sum. Triangles at which rounding could decide, and extreme or non-finite values, are
/// evaluated one by one with ForceLaw. So values differ from plain sums only by rounding, counts are exact,
/// and no law's value depends on the other laws.
class LawFamily {
 public:
  /// Each law uses the inputs of the first scenario law with the same deformation and rate. Throws InputError
  /// where there is none.
  LawFamily(const std::vector<ForceSettings>& laws, const std::vector<ForceSettings>& scenario_laws);

  /// Evaluates all laws for the `inputs` of one step: [triangle x number of scenario laws + law], as
  /// State::law_inputs. Throws std::logic_error when they are no whole number of triangles.
  void evaluate(const std::vector<LawInput>& inputs);

  /// Called when the values at the places from `first` to before `end` are those of one of several steps,
  /// which is named by its index.
  using Visitor = std::function<void(std::size_t step, std::size_t first, std::size_t end)>;
  /// Evaluates all laws for the inputs of several steps in turn. `visit` sees every place in every step, the
  /// steps in their order, but some places in all steps before it sees the next ones: what is kept for each
  /// of a million laws is then read from memory once for all steps, and from the cache for the others.
  void evaluate(std::span<const std::vector<LawInput>> steps, const Visitor& visit);

  /// The value of a law in the last step, which is named by its number in the constructor; zeros before the
  /// first evaluate().
  LawValue value(std::size_t law) const { return values_.at(places_[law]); }
  /// The values of all laws, each at its place(law), in the order in which they are computed.
  const LawValues& valuesByPlace() const { return values_; }
  std::size_t place(std::size_t law) const { return places_[law]; }

 private:
  struct Member {
    std::size_t law = 0;
    double k = 0, c = 0;   ///< factors of A and B
    double threshold = 0;  ///< -k / c, -infinity where no triangle can pull
    bool extreme = false;  ///< c < 0, or products that may leave the range of a double
  };
  /// Laws that share A and B.
  struct Group {
    const ForceLawEntry* law = nullptr;
    LawCoefficients coefficients;  ///< those of one of the laws; only the shape is used, which all share
    bool per_area = false;
    std::size_t channel = 0;      ///< index of the scenario law whose inputs they use
    std::vector<Member> members;  ///< in ascending order of threshold
    Eigen::ArrayXd k, c;          ///< the factors of all members
    std::size_t first_place = 0;  ///< of the first member in values_; the others follow
  };
  struct Term {
    double ratio = 0;  ///< B / A
    double a = 0, b = 0;
    std::size_t input = 0;
  };
  /// Sums over all terms from one term to the last.
  struct Tail {
    Vec3 a_direction = Vec3::Zero(), b_direction = Vec3::Zero();
    double a = 0, b = 0;
  };
  /// What the laws of a group share in one step.
  struct Shared {
    std::vector<Term> terms;         ///< in the order of their ratios
    std::vector<std::size_t> plain;  ///< inputs that have no term
    std::vector<Tail> tails;         ///< one more than terms; the last is zero
    /// For the law at hand: terms before `pulling` pull, those from `pushing` on push; rounding decides
    /// between.
    std::size_t pulling = 0, pushing = 0;
  };
  /// Partial sum of one law.
  struct Sum {
    Vec3 force_N = Vec3::Zero();
    double elastic_N = 0, viscous_N = 0;
    int adhesion_clamped = 0;
  };

  void orderByRate(std::size_t channel, const std::vector<LawInput>& inputs,
                   std::vector<std::size_t>& order) const;
  void share(const Group& group, const std::vector<LawInput>& inputs, const std::vector<std::size_t>& order,
             Shared& shared) const;
  void makeTails(const Group& group, const std::vector<LawInput>& inputs, Shared& shared) const;
  void addPlainly(const Group& group, const Member& member, const LawInput& input, Sum& sum) const;
  Sum sumPlainly(const Group& group, const Member& member, const std::vector<LawInput>& inputs,
                 const Shared& shared) const;
  void evaluate(const Group& group, const std::vector<LawInput>& inputs, std::size_t first, std::size_t end,
                Shared& shared);
  void evaluateSingly(const Group& group, const std::vector<LawInput>& inputs, std::size_t member,
                      const Shared& shared);
  void evaluateAlike(const Group& group, std::size_t first, std::size_t end, const Shared& shared);

  std::size_t scenario_laws_;
  std::vector<ForceLaw> laws_;
  std::vector<Group> groups_;                     ///< groups of one channel are adjacent
  std::vector<std::size_t> places_;               ///< of each law in values_
  LawValues values_;                              ///< group by group
  std::vector<std::vector<std::size_t>> orders_;  ///< [step] a channel's inputs by their rates, NaN last
  std::vector<Shared> shared_;                    ///< [step] of one group
};

}  // namespace fissure
