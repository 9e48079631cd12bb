#pragma once

#include <string>
#include <vector>

#include "base/record.h"
#include "base/run_status.h"

namespace fissure {

/// The largest depth, metres, at which a tool counts as held outside of the tissue.
inline constexpr double kHeldDepth_m = 0.0005;

/// The grade of a run's verdict (measure/METHOD.md 7).
enum class VerdictGrade {
  held,      ///< no problem was found
  doubtful,  ///< the tool was held out, but something else failed, or nothing touched
  failed,    ///< the tool went in, or the tissue is unsound
};

/// The verdict on a run in words: "held to 0.06 mm", "held, proved" where every step is certified, "12.05 mm
/// inside, inverted".
struct Verdict {
  VerdictGrade grade = VerdictGrade::held;
  std::string text;  ///< "-" where no tool was measured
};

/// The verdict that follows from a run's summary.
Verdict verdictOf(const Summary& summary);

/// A caveat about a run's numbers, in one line.
struct Remark {
  bool serious = false;
  std::string text;
};

/// The caveats of a run: missing and thinned measurements, unsound tissue, the first step that is not
/// certified, tools that touched no tissue, samples coarser than the claimed depth, nodes too far apart for
/// the tissue, narrow rows that were moved obliquely, laws whose newtons are those of a whole probe.
std::vector<Remark> remarksOf(const Summary& summary);

/// A line on the meaning of the run's reaction (measure/METHOD.md 6); empty where there is none.
std::string reactionNote(const Summary& summary);

/// The end of a run for people: "finished" for ok, which is no statement about its numbers.
std::string endText(RunEnd end);

}  // namespace fissure
