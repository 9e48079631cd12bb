#include "report/sweep_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "report/packed.h"

namespace fissure {

namespace {

constexpr std::size_t most_times = 96;
constexpr std::size_t most_values = 300000;  // two bytes each, four characters for every three
constexpr std::size_t missing_code = 65535;
constexpr std::size_t values_a_read = std::size_t{1} << 21;

using Track = std::vector<float>;  // of one run

struct Sizes {
  std::size_t stored = 0;  ///< instants
  std::size_t every = 1;
  std::size_t times() const { return (stored + every - 1) / every; }
};

/// The shown runs' values of all tracks of one curve: law by law, run by run.
std::vector<std::vector<Track>> readTracks(const SweepTable& table, const CurveQuantity& curve,
                                           const std::vector<std::size_t>& runs, const Sizes& sizes) {
  const std::size_t width = table.layout().width(curve);
  const std::size_t block = std::max<std::size_t>(1, values_a_read / width);
  std::vector<std::vector<Track>> tracks(width / sizes.stored, std::vector<Track>(runs.size()));
  std::size_t place = 0;
  for (std::size_t first = 0; first < table.runs() && place < runs.size(); first += block) {
    if (runs[place] >= first + block) continue;
    const std::vector<double> read = table.curves(curve, first, std::min(block, table.runs() - first));
    for (; place < runs.size() && runs[place] < first + block; ++place) {
      const double* value = &read[(runs[place] - first) * width];
      for (std::vector<Track>& track : tracks) {
        for (std::size_t i = 0; i < sizes.stored; i += sizes.every)
          track[place].push_back(static_cast<float>(value[i]));
        value += sizes.stored;
      }
    }
  }
  return tracks;
}

/// The quantile of sorted values, interpolated linearly between two of them.
double quantile(const std::vector<float>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const double next = sorted[std::min(below + 1, sorted.size() - 1)];
  return sorted[below] + (at - static_cast<double>(below)) * (next - sorted[below]);
}

PageJson bandsJson(const std::vector<Track>& track, const ShownRuns& shown, std::size_t times) {
  const std::size_t pipelines =
      shown.pipeline.empty() ? 0 : 1 + *std::max_element(shown.pipeline.begin(), shown.pipeline.end());
  PageJson bands = PageJson::array();
  for (std::size_t pipeline = 0; pipeline < pipelines; ++pipeline) {
    PageJson band = {{"pipeline", pipeline}};
    for (const auto& [name, share] :
         {std::pair("low", 0.1), std::pair("median", 0.5), std::pair("high", 0.9)})
      band[name] = PageJson::array();
    for (std::size_t i = 0; i < times; ++i) {
      std::vector<float> values;
      for (std::size_t run = 0; run < track.size(); ++run) {
        if (shown.pipeline[run] == pipeline && shown.good[run] && !std::isnan(track[run][i]))
          values.push_back(track[run][i]);
      }
      std::sort(values.begin(), values.end());
      for (const auto& [name, share] :
           {std::pair("low", 0.1), std::pair("median", 0.5), std::pair("high", 0.9)})
        band[name].push_back(values.empty() ? PageJson() : shortNumber(quantile(values, share)));
    }
    bands.push_back(band);
  }
  return bands;
}

/// Whose own curves the page holds.
std::vector<std::size_t> keptRows(const ShownRuns& shown, std::size_t values_a_run) {
  const std::size_t most = std::max<std::size_t>(20, most_values / std::max<std::size_t>(1, values_a_run));
  std::vector<std::size_t> order = shown.first, all(shown.runs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  // Evenly spread over what is left, whatever the order of the axes.
  std::stable_sort(all.begin(), all.end(),
                   [](std::size_t a, std::size_t b) { return scattered(a) < scattered(b); });
  order.insert(order.end(), all.begin(), all.end());
  std::vector<std::size_t> kept;
  std::vector<bool> taken(shown.runs.size(), false);
  for (const std::size_t place : order) {
    if (kept.size() == most) break;
    if (!taken[place]) kept.push_back(place);
    taken[place] = true;
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

void addRows(const std::vector<Track>& track, const std::vector<std::size_t>& kept, PageJson& json) {
  std::vector<double> lows, highs;
  std::vector<std::size_t> codes;
  for (const std::size_t place : kept) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double value : track[place]) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    lows.push_back(low);
    highs.push_back(high);
    const double step = high > low ? (high - low) / static_cast<double>(missing_code - 1) : 1;
    for (const double value : track[place])
      codes.push_back(std::isfinite(value) ? static_cast<std::size_t>(std::lround((value - low) / step))
                                           : missing_code);
  }
  json["low"] = packedNumbers(lows);
  json["high"] = packedNumbers(highs);
  json["values"] = packedCodes(codes);
}

std::size_t trackCount(const SweepTableLayout& layout) {
  std::size_t count = 0;
  for (const CurveQuantity& curve : layout.curves) count += curve.per_law ? layout.laws.size() : 1;
  return count;
}

}  // namespace

std::uint64_t scattered(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15u;
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
  number = (number ^ (number >> 27)) * 0x94d049bb133111ebu;
  return number ^ (number >> 31);
}

PageJson sweepCurves(const SweepTable& table, const ShownRuns& shown) {
  const SweepTableLayout& layout = table.layout();
  if (layout.curves.empty() || layout.curve_time_s.empty() || shown.runs.empty()) return nullptr;
  Sizes sizes{layout.curve_time_s.size()};
  sizes.every = std::max<std::size_t>(1, (sizes.stored + most_times - 1) / most_times);
  PageJson times = PageJson::array(), measured = PageJson::array(), tracks = PageJson::array();
  for (std::size_t i = 0; i < sizes.stored; i += sizes.every) {
    times.push_back(shortNumber(layout.curve_time_s[i]));
    if (!layout.measured_N.empty()) measured.push_back(shortNumber(layout.measured_N[i]));
  }
  const std::vector<std::size_t> kept = keptRows(shown, sizes.times() * trackCount(layout));
  for (const CurveQuantity& curve : layout.curves) {
    const std::vector<std::vector<Track>> read = readTracks(table, curve, shown.runs, sizes);
    for (std::size_t law = 0; law < read.size(); ++law) {
      PageJson track = {{"curve", curve.name},
                        {"law", curve.per_law ? layout.laws[law] : ""},
                        {"unit", curve.units},
                        {"long_name", curve.long_name},
                        {"bands", bandsJson(read[law], shown, sizes.times())}};
      addRows(read[law], kept, track);
      tracks.push_back(track);
    }
  }
  return {{"times_s", times},          {"every", sizes.every}, {"stored", sizes.stored},
          {"rows", packedCodes(kept)}, {"tracks", tracks},     {"measured", measured}};
}

}  // namespace fissure
