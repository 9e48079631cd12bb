#pragma once

#include <cstddef>
#include <vector>

#include "base/state.h"
#include "law/force_law.h"
#include "scenario/forces.h"

namespace fissure {

/// A force law over all triangles of one step, as ForceSample has it.
struct LawValue {
  double force_N = 0;    ///< magnitude of the total force on the tools together
  double elastic_N = 0;  ///< sum of the triangles' elastic terms (magnitudes)
  double viscous_N = 0;  ///< sum of the triangles' viscous terms (signed magnitudes)
  int adhesion_clamped = 0;
};

/// Many force laws over the same simulation, ten thousand for the price of a few. Every law is k A + c B over
/// the triangles, A and B its two terms (LawTerms; Hunt-Crossley: x^n and x^n x'), and a
/// triangle would pull where B / A < -k / c. Laws that share A and B therefore share the triangles in the
/// order of B / A and the sums of A and B over their tails: a law costs a place in that order and one sum.
/// What rounding could decide, and what is extreme or no number, goes through ForceLaw triangle by triangle:
/// values differ from the plain sums by rounding, counts do not, and no law's value depends on the others.
class LawFamily {
 public:
  /// Each law takes the inputs of the first scenario law with the same deformation and rate. Throws
  /// InputError where there is none.
  LawFamily(const std::vector<ForceSettings>& laws, const std::vector<ForceSettings>& scenario_laws);

  /// `inputs` of one step: triangle x number of scenario laws + law, as State::law_inputs has them. Throws
  /// std::logic_error when they are no whole number of triangles.
  void evaluate(const std::vector<LawInput>& inputs);

  /// One a law, in the order of the constructor; zeros before the first evaluate.
  const std::vector<LawValue>& values() const { return values_; }

 private:
  struct Member {
    std::size_t law = 0;
    double k = 0, c = 0;   ///< of A and of B
    double threshold = 0;  ///< -k / c, -infinity where no triangle can pull
    bool extreme = false;  ///< c < 0, or products that may leave the range of a double
  };
  /// Laws that share A and B.
  struct Group {
    const ForceLawEntry* law = nullptr;
    LawCoefficients coefficients;  ///< of one of them; only the shape is read, which all share
    bool per_area = false;
    std::size_t channel = 0;      ///< the scenario law whose inputs they see
    std::vector<Member> members;  ///< by threshold, ascending
  };
  struct Term {
    double ratio = 0;  ///< B / A
    double a = 0, b = 0;
    std::size_t input = 0;
  };
  /// Sums over all terms from one on.
  struct Tail {
    Vec3 a_direction = Vec3::Zero(), b_direction = Vec3::Zero();
    double a = 0, b = 0;
  };
  /// What one law has come to while its triangles are summed.
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
  std::vector<Group> groups_;  ///< those of one channel side by side
  std::vector<LawValue> values_;
  std::vector<std::size_t> order_;  ///< inputs of one channel by rate, NaN last
  std::vector<Term> terms_;         ///< of one group, by ratio
  std::vector<std::size_t> plain_;  ///< inputs of one group that have no term
  std::vector<Tail> tails_;         ///< one more than terms: the last is empty
};

}  // namespace fissure
