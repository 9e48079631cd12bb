#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace fissure {

/// The meaning of a column in a file of measured curves.
enum class CurveRole { depth, force, time, sigma, weight, curve, lower_quartile, upper_quartile };

/// The column for one role.
struct CurveColumn {
  CurveRole role = CurveRole::depth;
  std::string column;           ///< its name, or its number from 1
  std::optional<double> to_si;  ///< factor to m, N, s; without one the column's name must end in a unit
};

/// Parses "depth=d_mm,force=F:mN,time=3:s,curve=probe": for each role a column by name, or by number where no
/// column has that name, and after a colon its unit (m, mm, N, mN, s, ms) or a factor to m, N or s. Throws
/// InputError for anything else.
std::vector<CurveColumn> parseCurveColumns(const std::string& text);

/// One measured curve in SI units. Arrays have one value per point, or none where the file has no such
/// column. Points are in the order of their times or, without times, of their depths.
struct MeasuredCurve {
  std::string name;             ///< name of the file, and of the curve where a column names it
  std::string file;             ///< path as it was given; empty: joined from several files
  std::vector<double> depth_m;  ///< into the tissue, >= 0
  std::vector<double> force_N;
  std::vector<double> time_s;          ///< never decreases
  std::vector<double> rate_m_s;        ///< rate of the depth: ratesOf() over all rows with numbers
  std::vector<double> rate_noise_m_s;  ///< standard deviation of the rate: rateNoiseOf()
  std::vector<double> weights;  ///< weights of squared residuals, > 0: 1 / sigma^2, or those of the file
  /// Quartiles of the force over probings, of which force_N is the median; NaN where the file leaves them
  /// out. They are printed beside predictions and not used in fits.
  std::vector<double> lower_quartile_N, upper_quartile_N;

  std::optional<CurveRole> weighted_by;  ///< sigma or weight; no value: all weights are 1

  std::size_t rows_without_numbers = 0;  ///< number of rows left out for an empty cell, NaN or weight 0
  std::size_t rows_before_contact = 0;   ///< number of rows left out for a negative depth
  std::vector<std::string> warnings;     ///< warnings for people, for instance that a unit may be wrong
};

/// The curves of a file (see DelimitedText), in the order of their first rows. Roles that `columns` leaves
/// out are found by name: "depth", "force", "time" or "t", "sigma", "weight", "curve" or "probe",
/// "lower_quartile" and "upper_quartile", followed by a unit as in "depth_mm" or "depth [mm]". A force and
/// either a depth or a time are required. Throws InputError with file and line.
std::vector<MeasuredCurve> readCurves(const std::filesystem::path& file,
                                      const std::vector<CurveColumn>& columns);

/// The curve with only these of its points, in this order.
MeasuredCurve pointsOf(const MeasuredCurve& curve, const std::vector<std::size_t>& points);

/// The name of a curve in messages: the file, and the curve where a column names it.
std::string labelOf(const MeasuredCurve& curve);

/// The points of all curves as one curve, without times. It has rates only if all curves have them; otherwise
/// a warning names those without. Throws InputError where only some have depths, or their weights are of
/// different kinds.
MeasuredCurve joined(const std::vector<MeasuredCurve>& curves);

}  // namespace fissure
