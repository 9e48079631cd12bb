#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// What a column of a file of measured curves means.
enum class CurveRole { depth, force, time, sigma, weight, curve, lower_quartile, upper_quartile };

/// Where one of them is found.
struct CurveColumn {
  CurveRole role = CurveRole::depth;
  std::string column;           ///< its name, or its number from 1
  std::optional<double> to_si;  ///< factor to m, N, s; without one the column's name must end in a unit
};

/// Reads "depth=d_mm,force=F:mN,time=3:s,curve=probe": for each role a column by name, or by number where no
/// name is the same, and after a colon its unit (m, mm, N, mN, s, ms) or a factor to m, N or s. Throws
/// InputError.
std::vector<CurveColumn> parseCurveColumns(const std::string& text);

/// One measured curve, in SI units: one value a point, or none where there is no such column. Points are in
/// the order of their times or, where there are none, of their depths.
struct MeasuredCurve {
  std::string name;             ///< of the file, and of the curve where a column names it
  std::string file;             ///< as it was given; empty: several
  std::vector<double> depth_m;  ///< into the tissue, >= 0
  std::vector<double> force_N;
  std::vector<double> time_s;          ///< never goes back
  std::vector<double> rate_m_s;        ///< of the depth, by ratesOf() over all rows with numbers
  std::vector<double> rate_noise_m_s;  ///< what noise of the depths makes of it, by rateNoiseOf()
  std::vector<double> weights;         ///< of squared residuals, > 0: 1 / sigma^2, or as the file says
  /// Quartiles of the force between probings, whose median is force_N; NaN where the file leaves them out.
  /// They are printed beside predictions and have no part in a fit.
  std::vector<double> lower_quartile_N, upper_quartile_N;

  std::optional<CurveRole> weighted_by;  ///< sigma or weight; nothing: all weights are 1

  std::size_t rows_without_numbers = 0;  ///< left out: an empty cell, NaN, weight 0
  std::size_t rows_before_contact = 0;   ///< left out: a negative depth
  std::vector<std::string> warnings;     ///< what a reader must know, as that a unit may be wrong
};

/// The curves of a file (see DelimitedText), in the order of their first rows. `columns` without a depth,
/// force, time, sigma, weight, curve or quartiles are found by name: "depth", "force", "time" or "t",
/// "sigma", "weight", "curve" or "probe", "lower_quartile" and "upper_quartile", followed by a unit as in
/// "depth_mm", "depth [mm]". A force and a depth or a time are needed. Throws InputError with file and line.
std::vector<MeasuredCurve> readCurves(const std::filesystem::path& file,
                                      const std::vector<CurveColumn>& columns);

/// The curve with these of its points alone, in this order.
MeasuredCurve pointsOf(const MeasuredCurve& curve, const std::vector<std::size_t>& points);

/// For messages: the file, and the curve where a column names it.
std::string labelOf(const MeasuredCurve& curve);

/// The points of all curves as one, without times; rates only where all have them, else a warning says which
/// have none. Throws InputError where some have depths and some do not, or their weights are not of one kind.
MeasuredCurve joined(const std::vector<MeasuredCurve>& curves);

}  // namespace fissure
