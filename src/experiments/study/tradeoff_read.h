#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/geometry.h"
#include "study/tradeoff_curve.h"
#include "study/tradeoff_file.h"

namespace fissure {

/// The surfaces of a run's tissue over time.
struct TissueShape {
  std::vector<Face> faces;
  std::vector<double> time_s;                 ///< of the snapshots
  std::vector<std::vector<Vec3>> vertices_m;  ///< [snapshot] positions, scene frame
};

/// What a study compares of one run.
struct StudyRecord {
  std::vector<StudyCurve> curves;  ///< one for each error, over time; empty for the shape
  TissueShape shape;               ///< empty unless an error is of the shape
  double end_s = 0;                ///< simulated time
};

/// Reads a run's result. A quantity that the run does not have is left empty; one that is missing in a step
/// is NaN there. Throws InputError when the file is damaged.
StudyRecord readRecord(const std::filesystem::path& file, const std::string& pipeline,
                       const std::vector<StudyError>& errors);

/// How far the tissue's surface is from the reference's: over the reference's vertices, at its snapshots, the
/// distance to the run's surface, which is taken to go straight between its own snapshots. So meshes of any
/// fineness compare, and how far tissue slides along itself does not count. `rms` is over vertices and
/// snapshots, `worst` of all, `peak` the difference of the largest displacements since the first snapshot.
/// NaN where either has no snapshots, a position is not finite, or the run ended earlier by more than the
/// time between two.
CurveError shapeErrorOf(const TissueShape& run, const TissueShape& reference);

/// The largest displacement of a vertex since the first snapshot; NaN where there is none.
double largestDisplacement_m(const TissueShape& shape);

/// The error of a run in one of the study's errors; `index` is its place among them.
CurveError errorOf(const StudyRecord& run, const StudyRecord& reference, ErrorQuantity quantity,
                   std::size_t index);

}  // namespace fissure
