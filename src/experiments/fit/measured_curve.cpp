#include "fit/measured_curve.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>

#include "base/counted.h"
#include "base/error.h"
#include "fit/depth_rates.h"
#include "text/delimited_text.h"
#include "text/log_text.h"
#include "text/scalars.h"

namespace fissure {

namespace {

struct RoleInfo {
  CurveRole role;
  std::string_view name;
  std::vector<std::string_view> stems;  ///< names of columns that are found without being named
  std::map<std::string_view, double> units;
};

const std::array<RoleInfo, 8>& roles() {
  static const std::array<RoleInfo, 8> all = {
      {{CurveRole::depth, "depth", {"depth"}, {{"m", 1}, {"mm", 1e-3}}},
       {CurveRole::force, "force", {"force"}, {{"N", 1}, {"mN", 1e-3}}},
       {CurveRole::time, "time", {"time", "t"}, {{"s", 1}, {"ms", 1e-3}}},
       {CurveRole::sigma, "sigma", {"sigma"}, {{"N", 1}, {"mN", 1e-3}}},
       {CurveRole::weight, "weight", {"weight"}, {}},
       {CurveRole::curve, "curve", {"curve", "probe"}, {}},
       {CurveRole::lower_quartile, "lower_quartile", {"lower_quartile"}, {{"N", 1}, {"mN", 1e-3}}},
       {CurveRole::upper_quartile, "upper_quartile", {"upper_quartile"}, {{"N", 1}, {"mN", 1e-3}}}}};
  return all;
}

const RoleInfo& infoOf(CurveRole role) {
  return *std::find_if(roles().begin(), roles().end(),
                       [&](const RoleInfo& info) { return info.role == role; });
}

std::string unitsOf(const RoleInfo& info) {
  std::string text;
  for (const auto& [unit, factor] : info.units) text += (text.empty() ? "" : " or ") + std::string(unit);
  return text;
}

struct NameParts {
  std::string_view stem, unit;
};

/// "depth_mm", "depth [mm]", "depth(mm)", "depth mm": a name and its unit, as far as it is one of these.
NameParts partsOf(std::string_view name, const RoleInfo& info) {
  std::string_view end = name;
  if (end.ends_with(']') || end.ends_with(')')) end.remove_suffix(1);
  for (const auto& [unit, factor] : info.units) {
    if (end.size() <= unit.size() || !end.ends_with(unit)) continue;
    const std::string_view rest = end.substr(0, end.size() - unit.size());
    const std::size_t stem_end = rest.find_last_not_of(" _[(");
    if (stem_end + 1 == rest.size() || stem_end == std::string_view::npos) continue;
    return {rest.substr(0, stem_end + 1), unit};
  }
  return {name, {}};
}

std::optional<double> factorOf(const std::string& text, const RoleInfo& info) {
  const auto unit = info.units.find(text);
  if (unit != info.units.end()) return unit->second;
  const std::optional<double> number = toReal(text);
  return number && std::isfinite(*number) && *number != 0 && !info.units.empty() ? number : std::nullopt;
}

CurveColumn parseColumn(const std::string& item) {
  const std::size_t equals = item.find('=');
  const auto role = std::find_if(roles().begin(), roles().end(),
                                 [&](const RoleInfo& info) { return info.name == item.substr(0, equals); });
  if (equals == std::string::npos || equals + 1 == item.size() || role == roles().end())
    throw InputError("--columns " + item +
                     ": expected ROLE=COLUMN[:UNIT] with a role of depth, force, time, sigma, weight, curve, "
                     "lower_quartile, upper_quartile");
  CurveColumn column{role->role, item.substr(equals + 1), std::nullopt};
  const std::size_t colon = column.column.rfind(':');
  if (colon == std::string::npos) return column;
  const std::string unit = column.column.substr(colon + 1);
  column.to_si = factorOf(unit, *role);
  if (!column.to_si)
    throw InputError(fmt::format("--columns {}: \"{}\" is no unit of a {}, expected {}", item, unit,
                                 role->name, role->units.empty() ? "none" : unitsOf(*role) + " or a factor"));
  column.column.resize(colon);
  return column;
}

void leaveOutBeforeContact(MeasuredCurve& curve) {
  std::vector<std::size_t> in_contact;
  for (std::size_t i = 0; i < curve.depth_m.size(); ++i)
    if (curve.depth_m[i] >= 0) in_contact.push_back(i);
  const std::size_t before = curve.depth_m.size() - in_contact.size();
  curve = pointsOf(curve, in_contact);
  curve.rows_before_contact = before;
}

/// Where no times order the points: neighbours are those of like depth, in whatever order rows stand.
void sortByDepth(MeasuredCurve& curve) {
  if (curve.depth_m.empty()) return;
  std::vector<std::size_t> order(curve.depth_m.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    return std::make_tuple(curve.depth_m[i], curve.force_N[i], curve.weights[i]);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  curve = pointsOf(curve, order);
}

std::string weightsOf(const MeasuredCurve& curve) {
  return fmt::format("{} by {}", labelOf(curve),
                     curve.weighted_by ? infoOf(*curve.weighted_by).name : "nothing");
}

/// Throws InputError where two curves that are to be fitted as one are not of one kind.
void refuseOtherKind(const MeasuredCurve& first, const MeasuredCurve& other) {
  if (first.depth_m.empty() != other.depth_m.empty())
    throw InputError(labelOf(first.depth_m.empty() ? first : other) + " has no depths, but " +
                     labelOf(first.depth_m.empty() ? other : first) + ", expected depths in all");
  if (first.weighted_by != other.weighted_by)
    throw InputError(fmt::format("weights of different kinds, {} and {}, expected one kind", weightsOf(first),
                                 weightsOf(other)));
}

/// Takes a file row by row.
class CurveReader {
 public:
  CurveReader(const std::filesystem::path& file, const std::vector<CurveColumn>& columns)
      : table_(file), stem_(file.stem().string()) {
    if (std::all_of(table_.names().begin(), table_.names().end(),
                    [](const std::string& name) { return toReal(name).has_value(); }))
      throw fileError("a header of numbers alone, the first point would be lost", "a line of names above it");
    for (const CurveColumn& column : columns) {
      if (columns_.contains(column.role))
        throw InputError("--columns: two columns for " + std::string(infoOf(column.role).name) +
                         ", expected one");
      use(infoOf(column.role), find(column.column), column.to_si);
    }
    for (const RoleInfo& info : roles())
      if (!columns_.contains(info.role)) findByName(info);
    if (columns_.contains(CurveRole::sigma) && columns_.contains(CurveRole::weight))
      throw fileError("both a sigma and a weight", "one of them");
    if (columns_.contains(CurveRole::lower_quartile) != columns_.contains(CurveRole::upper_quartile))
      throw fileError("one quartile alone", "a lower_quartile and an upper_quartile");
    if (!columns_.contains(CurveRole::force)) throw fileError("no column of forces", missing("force=F:N"));
    if (!columns_.contains(CurveRole::depth) && !columns_.contains(CurveRole::time))
      throw fileError("neither depths nor times", missing("depth=d:mm"));
  }

  std::vector<MeasuredCurve> read() {
    bool rows = false;
    for (; table_.next(); rows = true) takeRow();
    if (!rows) throw fileError("only a header line", "rows below it");
    std::vector<MeasuredCurve> measured;
    for (MeasuredCurve& curve : curves_) {
      if (columns_.contains(CurveRole::time) && !curve.depth_m.empty()) {
        curve.rate_m_s = ratesOf(curve.time_s, curve.depth_m);
        curve.rate_noise_m_s = rateNoiseOf(curve.time_s, curve.depth_m);
      }
      if (!columns_.contains(CurveRole::time)) sortByDepth(curve);
      if (!curve.depth_m.empty()) leaveOutBeforeContact(curve);
      if (curve.force_N.empty())
        throw InputError(inFile(table_.fileName()),
                         fmt::format("no row of curve {} is a point of contact, expected numbers and depths "
                                     ">= 0 (is the depth's sign turned? a factor of -0.001 makes it metres)",
                                     curve.name));
      warn(curve);
      curve.file = table_.fileName();
      for (const CurveRole role : {CurveRole::sigma, CurveRole::weight})
        if (columns_.contains(role)) curve.weighted_by = role;
      measured.push_back(std::move(curve));
    }
    return measured;
  }

 private:
  /// Where a role's numbers stand, and what makes them SI.
  struct FileColumn {
    std::size_t column = 0;
    double to_si = 1;
  };

  InputError fileError(const std::string& what, const std::string& expected) const {
    return {inFile(table_.fileName(), table_.headerLine()), what + ", expected " + expected};
  }

  std::string missing(const std::string& example) const {
    std::string names;
    for (const std::string& name : table_.names()) names += (names.empty() ? "" : ", ") + logExcerpt(name);
    return "--columns " + example + " to say which it is of " + names;
  }

  std::size_t find(const std::string& column) const {
    const std::vector<std::string>& names = table_.names();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(column.data(), column.data() + column.size(), number);
    const bool is_number = error == std::errc() && end == column.data() + column.size();
    if (!is_number || std::find(names.begin(), names.end(), column) != names.end())
      return table_.column(column);
    if (number < 1 || number > names.size())
      throw fileError("no column " + column, fmt::format("a number from 1 to {}", names.size()));
    return number - 1;
  }

  void use(const RoleInfo& info, std::size_t column, std::optional<double> to_si) {
    const std::string& name = table_.names()[column];
    const std::string_view unit = partsOf(name, info).unit;
    if (!to_si && !info.units.empty()) {
      if (unit.empty())
        throw fileError(fmt::format("column \"{}\" has no unit of a {}", logExcerpt(name), info.name),
                        fmt::format("it in the name, or after a colon: {}={}:{}", info.name, logExcerpt(name),
                                    info.units.begin()->first));
      to_si = info.units.at(unit);
    }
    columns_[info.role] = {column, to_si.value_or(1)};
  }

  void findByName(const RoleInfo& info) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < table_.names().size(); ++i) {
      std::string stem(partsOf(table_.names()[i], info).stem);
      std::transform(stem.begin(), stem.end(), stem.begin(),
                     [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
      if (std::find(info.stems.begin(), info.stems.end(), stem) != info.stems.end()) found.push_back(i);
    }
    if (found.size() > 1)
      throw fileError(fmt::format("{} columns may be the {}", found.size(), info.name),
                      "--columns to choose one");
    if (!found.empty()) use(info, found.front(), std::nullopt);
  }

  double number(CurveRole role) const {
    const auto column = columns_.find(role);
    if (column == columns_.end()) return 0;
    const double value = table_.number(column->second.column);
    if (std::isinf(value))
      throw InputError(
          inFile(table_.fileName(), table_.line()),
          fmt::format("an infinite {}, expected a number like 0.0125 or nothing", infoOf(role).name));
    return value * column->second.to_si;
  }

  MeasuredCurve& curveOfRow() {
    const auto column = columns_.find(CurveRole::curve);
    const std::string name =
        column == columns_.end() ? stem_ : fmt::format("{}:{}", stem_, table_.text(column->second.column));
    const auto [entry, is_new] = index_.try_emplace(name, curves_.size());
    if (is_new) curves_.emplace_back().name = name;
    return curves_[entry->second];
  }

  double weightOfRow() const {
    if (columns_.contains(CurveRole::weight)) {
      const double weight = number(CurveRole::weight);
      if (weight < 0)
        throw InputError(inFile(table_.fileName(), table_.line()), "a weight below 0, expected >= 0");
      return weight;
    }
    if (!columns_.contains(CurveRole::sigma)) return 1;
    const double sigma_N = number(CurveRole::sigma);
    if (sigma_N <= 0)
      throw InputError(inFile(table_.fileName(), table_.line()), "a sigma of 0 or less, expected > 0");
    return 1 / (sigma_N * sigma_N);
  }

  void takeRow() {
    MeasuredCurve& curve = curveOfRow();
    const double depth_m = number(CurveRole::depth), force_N = number(CurveRole::force),
                 time_s = number(CurveRole::time), weight = weightOfRow();
    if (std::isnan(depth_m) || std::isnan(force_N) || std::isnan(time_s) || !(weight > 0)) {
      ++curve.rows_without_numbers;
      return;
    }
    if (!curve.time_s.empty() && time_s < curve.time_s.back())
      throw InputError(inFile(table_.fileName(), table_.line()),
                       "the time goes back, expected times in order");
    if (columns_.contains(CurveRole::depth)) curve.depth_m.push_back(depth_m);
    if (columns_.contains(CurveRole::time)) curve.time_s.push_back(time_s);
    curve.force_N.push_back(force_N);
    curve.weights.push_back(weight);
    takeQuartiles(curve);
  }

  void takeQuartiles(MeasuredCurve& curve) const {
    if (!columns_.contains(CurveRole::lower_quartile)) return;
    const double lower_N = number(CurveRole::lower_quartile), upper_N = number(CurveRole::upper_quartile);
    if (lower_N > upper_N)
      throw InputError(inFile(table_.fileName(), table_.line()),
                       "a lower quartile above the upper one, expected it below");
    curve.lower_quartile_N.push_back(lower_N);
    curve.upper_quartile_N.push_back(upper_N);
  }

  static void warnOutside(double value, double least, double most, const std::string& what,
                          const std::string& unit, MeasuredCurve& curve) {
    if (value >= least && value <= most) return;
    curve.warnings.push_back(
        fmt::format("the largest {0} is {1} {2}, usual are {3} to {4} {2}: is its unit right?", what,
                    formatReal(value), unit, formatReal(least), formatReal(most)));
  }

  // Probing of organs with tools: beyond these a unit is more often wrong by 1000 than a value is right.
  static void warn(MeasuredCurve& curve) {
    double force_N = 0;
    for (const double force : curve.force_N) force_N = std::max(force_N, std::abs(force));
    warnOutside(force_N, 2e-3, 100, "force", "N", curve);
    if (curve.depth_m.empty()) return;
    warnOutside(*std::max_element(curve.depth_m.begin(), curve.depth_m.end()), 5e-5, 0.2, "depth", "m",
                curve);
    double rate_m_s = 0;
    for (const double rate : curve.rate_m_s) rate_m_s = std::max(rate_m_s, std::abs(rate));
    warnOutside(rate_m_s, 0, 5, "rate", "m/s", curve);
  }

  DelimitedText table_;
  std::string stem_;
  std::map<CurveRole, FileColumn> columns_;
  std::map<std::string, std::size_t> index_;
  std::vector<MeasuredCurve> curves_;
};

}  // namespace

std::vector<CurveColumn> parseCurveColumns(const std::string& text) {
  std::vector<CurveColumn> columns;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    columns.push_back(parseColumn(text.substr(start, end - start)));
    start = end + 1;
  }
  return columns;
}

std::vector<MeasuredCurve> readCurves(const std::filesystem::path& file,
                                      const std::vector<CurveColumn>& columns) {
  return CurveReader(file, columns).read();
}

MeasuredCurve pointsOf(const MeasuredCurve& curve, const std::vector<std::size_t>& points) {
  MeasuredCurve kept = curve;
  for (std::vector<double>* values :
       {&kept.depth_m, &kept.force_N, &kept.time_s, &kept.rate_m_s, &kept.rate_noise_m_s, &kept.weights,
        &kept.lower_quartile_N, &kept.upper_quartile_N}) {
    if (values->empty()) continue;
    std::vector<double> chosen;
    chosen.reserve(points.size());
    for (const std::size_t point : points) chosen.push_back((*values)[point]);
    *values = std::move(chosen);
  }
  return kept;
}

std::string labelOf(const MeasuredCurve& curve) {
  const std::size_t stem = std::filesystem::path(curve.file).stem().string().size();
  if (curve.file.empty()) return curve.name;
  return curve.file + (curve.name.size() <= stem ? "" : ", curve " + curve.name.substr(stem + 1));
}

MeasuredCurve joined(const std::vector<MeasuredCurve>& curves) {
  MeasuredCurve all;
  all.name = counted(curves.size(), "curve");
  const auto append = [](const std::vector<double>& from, std::vector<double>& to) {
    to.insert(to.end(), from.begin(), from.end());
  };
  std::string without_times;
  for (const MeasuredCurve& curve : curves) {
    refuseOtherKind(curves.front(), curve);
    append(curve.depth_m, all.depth_m);
    append(curve.force_N, all.force_N);
    append(curve.rate_m_s, all.rate_m_s);
    append(curve.rate_noise_m_s, all.rate_noise_m_s);
    append(curve.weights, all.weights);
    all.weighted_by = curve.weighted_by;
    all.rows_without_numbers += curve.rows_without_numbers;
    all.rows_before_contact += curve.rows_before_contact;
    for (const std::string& warning : curve.warnings) all.warnings.push_back(labelOf(curve) + ": " + warning);
    if (curve.rate_m_s.empty()) without_times += (without_times.empty() ? "" : "; ") + labelOf(curve);
  }
  if (all.rate_m_s.size() == all.force_N.size()) return all;
  if (!all.rate_m_s.empty())
    all.warnings.push_back("no times in " + without_times + ": the rates of the others are not used");
  all.rate_m_s.clear();
  all.rate_noise_m_s.clear();
  sortByDepth(all);
  return all;
}

}  // namespace fissure
