#pragma once

#include <cstddef>
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

  /// The value of a law, which is named by its number in the constructor; zeros before the first evaluate().
  const LawValue& value(std::size_t law) const { return values_[places_[law]]; }
  /// The values of all laws, each at its place(law). They are computed in this order, so that whoever keeps
  /// something for each of a million laws in the same order goes through memory from end to end.
  const std::vector<LawValue>& valuesByPlace() const { return values_; }
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
  /// Partial sum of one law.
  struct Sum {
    Vec3 force_N = Vec3::Zero();
    LawValue value;
  };

  void orderByRate(std::size_t channel, const std::vector<LawInput>& inputs);
  void makeTerms(const Group& group, const std::vector<LawInput>& inputs);
  void makeTails(const Group& group, const std::vector<LawInput>& inputs);
  void addPlainly(const Group& group, const Member& member, const LawInput& input, Sum& sum) const;
  void evaluate(const Group& group, const std::vector<LawInput>& inputs);

  std::size_t scenario_laws_;
  std::vector<ForceLaw> laws_;
  std::vector<Group> groups_;        ///< groups of one channel are adjacent
  std::vector<std::size_t> places_;  ///< of each law in values_
  std::vector<LawValue> values_;     ///< group by group
  std::vector<std::size_t> order_;   ///< inputs of one channel in the order of their rates, NaN last
  std::vector<Term> terms_;          ///< terms of one group in the order of their ratios
  std::vector<std::size_t> plain_;   ///< inputs of one group that have no term
  std::vector<Tail> tails_;          ///< one more than terms; the last is zero
};

}  // namespace fissure
