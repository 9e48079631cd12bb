#pragma once

#include <string>
#include <vector>

#include "base/record.h"
#include "base/run_status.h"

namespace fissure {

/// Up to this depth a tool counts as held outside of the tissue, metres.
inline constexpr double kHeldDepth_m = 0.0005;

/// How far a reader may trust what a run shows.
enum class VerdictGrade {
  held,      ///< nothing was found against it
  doubtful,  ///< the tool held, but something else gave way, or nothing was tried
  failed,    ///< the tool went in, or tissue is no tissue any more
};

/// What the measures of a run say, in words: "held to 0.06 mm", "held, proved" where every step is certified,
/// "12.05 mm inside, inverted".
struct Verdict {
  VerdictGrade grade = VerdictGrade::held;
  std::string text;  ///< "-" where no tool was measured
};

Verdict verdictOf(const Summary& summary);

/// What must be known beside a run's numbers, one line.
struct Remark {
  bool serious = false;
  std::string text;
};

/// What was not measured, unsound tissue, the first step that is not certified, tools that met no tissue,
/// samples coarser than the depth claimed, nodes too wide apart for the tissue, narrow rows that were dragged
/// obliquely.
std::vector<Remark> remarksOf(const Summary& summary);

/// What a reaction is worth, where the run has one; else empty.
std::string reactionNote(const Summary& summary);

/// How a run ended, for people: "finished" for ok, which says nothing about its numbers.
std::string endText(RunEnd end);

}  // namespace fissure
