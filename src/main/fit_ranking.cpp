#include "main/fit_ranking.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "base/error.h"
#include "fit/law_model.h"
#include "main/fit_output.h"
#include "main/text_table.h"
#include "text/units.h"

namespace fissure {

namespace {

constexpr std::size_t kBlock = 512;  // rows that are read at once

const CurveQuantity& curveOf(const SweepTable& table, const std::string& name, const std::string& what_for) {
  for (const CurveQuantity& curve : table.layout().curves)
    if (curve.name == name) return curve;
  throw InputError(
      fmt::format("the sweep keeps no curve {}, {}, expected it among its file's curves", name, what_for));
}

/// The points within what the sweep's curves reach at most.
MeasuredCurve reachable(const MeasuredCurve& curve, MatchBy by, double least, double most) {
  const std::vector<double>& measured = by == MatchBy::time ? curve.time_s : curve.depth_m;
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (measured[i] >= least && measured[i] <= most) reached.push_back(i);
  MeasuredCurve kept = pointsOf(curve, reached);
  if (reached.size() < measured.size())
    kept.warnings.push_back(fmt::format("left out {} of {} points that no run reaches",
                                        measured.size() - reached.size(), measured.size()));
  const std::string note = by == MatchBy::depth ? wayBackNote(kept) : "";
  if (!note.empty()) kept.warnings.push_back(note);
  return kept;
}

/// Takes blocks of rows: first for how deep the runs get, then for their misfits.
class Ranker {
 public:
  Ranker(const SweepTable& table, MatchBy by)
      : table_(table), by_(by), force_(curveOf(table, "force", "which is compared")) {
    if (by == MatchBy::depth)
      way_ = &curveOf(table, "indentation", "which measured depths are compared with");
  }

  double deepest_m() const {
    double deepest = 0;
    for (std::size_t first = 0; first < table_.runs(); first += kBlock)
      for (const double way : table_.curves(*way_, first, std::min(kBlock, table_.runs() - first)))
        if (way > deepest) deepest = way;
    return deepest;
  }

  std::vector<Misfit> misfits(const MeasuredCurve& curve, std::optional<double> fixed_offset_N) const {
    std::vector<Misfit> all;
    for (std::size_t first = 0; first < table_.runs(); first += kBlock) {
      const std::size_t count = std::min(kBlock, table_.runs() - first);
      const std::vector<double> forces_N = table_.curves(force_, first, count);
      const std::vector<double> ways_m =
          way_ == nullptr ? std::vector<double>() : table_.curves(*way_, first, count);
      for (std::size_t row = 0; row < count; ++row)
        for (std::size_t law = 0; law < laws(); ++law) {
          Misfit misfit = ofRow(curve, forces_N, ways_m, row, law, fixed_offset_N);
          misfit.run = first + row;
          misfit.law = law;
          all.push_back(misfit);
        }
    }
    rank(all);
    return all;
  }

 private:
  std::size_t times() const { return table_.layout().curve_time_s.size(); }
  std::size_t laws() const { return force_.per_law ? table_.layout().laws.size() : 1; }

  Misfit ofRow(const MeasuredCurve& curve, const std::vector<double>& forces_N,
               const std::vector<double>& ways_m, std::size_t row, std::size_t law,
               std::optional<double> fixed_offset_N) const {
    const auto start = forces_N.begin() + static_cast<std::ptrdiff_t>((row * laws() + law) * times());
    std::vector<double> force_N(start, start + static_cast<std::ptrdiff_t>(times()));
    if (by_ == MatchBy::time)
      return misfitOf(curve, by_, table_.layout().curve_time_s, force_N, fixed_offset_N);
    const auto way_start = ways_m.begin() + static_cast<std::ptrdiff_t>(row * times());
    std::vector<double> way_m(way_start, way_start + static_cast<std::ptrdiff_t>(times()));
    keepDeepening(way_m, force_N);
    return misfitOf(curve, by_, way_m, force_N, fixed_offset_N);
  }

  const SweepTable& table_;
  MatchBy by_;
  const CurveQuantity& force_;
  const CurveQuantity* way_ = nullptr;
};

std::string lawOf(const SweepTable& table, const Misfit& misfit) {
  const std::vector<std::string>& laws = table.layout().laws;
  return misfit.law < laws.size() ? laws[misfit.law] : "";
}

}  // namespace

SweepRanking rankSweep(const SweepTable& table, const MeasuredCurve& curve, MatchBy by,
                       std::optional<double> fixed_offset_N) {
  const Ranker ranker(table, by);
  const std::vector<double>& time_s = table.layout().curve_time_s;
  if ((by == MatchBy::time ? curve.time_s : curve.depth_m).empty())
    throw InputError(fmt::format("the curve has no {}, expected a column of them",
                                 by == MatchBy::time ? "times" : "depths"));
  if (time_s.empty()) throw InputError("the sweep keeps no curves, expected some");
  SweepRanking ranking;
  ranking.curve = by == MatchBy::time ? reachable(curve, by, time_s.front(), time_s.back())
                                      : reachable(curve, by, 0, ranker.deepest_m());
  ranking.misfits = ranker.misfits(ranking.curve, fixed_offset_N);
  if (ranking.misfits.empty() || std::isnan(ranking.misfits.front().rms_N))
    throw InputError("no run reaches the measured points, expected simulations as long or deep as these");
  return ranking;
}

void readRanked(const SweepTable& table) {
  for (const CurveQuantity& curve : table.layout().curves) {
    if (curve.name != "force" && curve.name != "indentation") continue;
    for (std::size_t first = 0; first < table.runs(); first += kBlock)
      table.curves(curve, first, std::min(kBlock, table.runs() - first));
  }
  for (const char* column : {"point", "repeat"}) table.numbers(column);
  for (const char* column : {"pipeline", "file"}) table.texts(column);
  for (const SweepAxisColumn& axis : table.layout().axes) {
    if (axis.numeric)
      table.numbers(axis.name);
    else
      table.texts(axis.name);
  }
}

std::string rankingText(const SweepTable& table, const SweepRanking& ranking, std::size_t most) {
  const SweepTableLayout& layout = table.layout();
  std::vector<TextRow> rows(1, {"misfit N", "F0 N", "point", "repeat", "pipeline", "law"});
  for (const SweepAxisColumn& axis : layout.axes) rows[0].push_back(axis.name);
  rows[0].emplace_back("file");
  const auto compared =
      static_cast<std::size_t>(std::count_if(ranking.misfits.begin(), ranking.misfits.end(),
                                             [](const Misfit& misfit) { return !std::isnan(misfit.rms_N); }));
  for (std::size_t i = 0; i < std::min(most, compared); ++i) {
    const Misfit& misfit = ranking.misfits[i];
    const auto number = [&](const std::string& column) {
      return fourDigits(table.numbers(column, misfit.run, 1).front());
    };
    const auto text = [&](const std::string& column) { return table.texts(column, misfit.run, 1).front(); };
    TextRow& row =
        rows.emplace_back(TextRow{fourDigits(misfit.rms_N), fourDigits(misfit.F0_N), number("point"),
                                  number("repeat"), text("pipeline"), lawOf(table, misfit)});
    for (const SweepAxisColumn& axis : layout.axes)
      row.push_back(axis.numeric ? number(axis.name) : text(axis.name));
    row.push_back(text("file"));
  }
  std::string ranked =
      fmt::format("{}: {} of {} simulated curves compared at {} points\n{}", ranking.curve.name, compared,
                  ranking.misfits.size(), ranking.curve.force_N.size(), alignedText(rows, 0));
  for (const std::string& note : curveNotes(ranking.curve)) ranked += note + "\n";
  return ranked;
}

nlohmann::ordered_json rankingJson(const SweepTable& table, const SweepRanking& ranking) {
  using Json = nlohmann::ordered_json;
  const SweepTableLayout& layout = table.layout();
  const std::vector<double> points = table.numbers("point"), repeats = table.numbers("repeat");
  const std::vector<std::string> pipelines = table.texts("pipeline"), files = table.texts("file");
  std::vector<Json> axes;
  for (const SweepAxisColumn& axis : layout.axes)
    axes.push_back(axis.numeric ? Json(table.numbers(axis.name)) : Json(table.texts(axis.name)));
  Json ranked = Json::array();
  for (const Misfit& misfit : ranking.misfits) {
    Json values = Json::object();
    for (std::size_t a = 0; a < axes.size(); ++a) values[layout.axes[a].path] = axes[a][misfit.run];
    ranked.push_back({{"misfit_N", misfit.rms_N},
                      {"F0_N", misfit.F0_N},
                      {"run", misfit.run},
                      {"point", static_cast<long long>(points[misfit.run])},
                      {"repeat", static_cast<long long>(repeats[misfit.run])},
                      {"pipeline", pipelines[misfit.run]},
                      {"law", lawOf(table, misfit)},
                      {"values", values},
                      {"file", files[misfit.run]}});
  }
  return {{"curve", ranking.curve.name},
          {"file", fileJson(ranking.curve)},
          {"points", ranking.curve.force_N.size()},
          {"notes", curveNotes(ranking.curve)},
          {"ranking", ranked}};
}

}  // namespace fissure
