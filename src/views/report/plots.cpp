#include "report/plots.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "report/plot_table.h"
#include "report/series.h"

namespace fissure {

namespace {

/// A label on each of some axes of a quantity, by the name of the axis.
using AxisLabels = std::map<std::string, std::string>;

struct Source {
  std::size_t run = 0;
  const StoredQuantity* quantity = nullptr;
  std::size_t column = 0;
  std::size_t count = 1;  ///< columns whose length, as a vector, is shown
};

struct Variant {
  std::string label;
  std::vector<Source> sources;
};

struct Plot {
  const PlotQuantity* quantity = nullptr;
  std::string label;  ///< along `each`
  std::vector<Variant> variants;
};

std::vector<std::string> labelsAlong(const std::vector<ReportRun>& runs, const PlotQuantity& quantity,
                                     const std::string& axis_name) {
  if (axis_name.empty()) return {""};
  std::vector<std::string> labels;
  for (const ReportRun& run : runs) {
    const StoredQuantity* stored = run.reader.find(quantity.dataset);
    if (!stored) continue;
    for (const StoredAxis& axis : stored->axes) {
      if (axis.name != axis_name) continue;
      for (const std::string& label : axis.labels)
        if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
    }
  }
  return labels;
}

/// No value where the quantity has nothing there.
std::optional<Source> sourceAt(std::size_t run, const StoredQuantity& quantity, const AxisLabels& place) {
  Source source{run, &quantity, 0, 1};
  std::size_t stride = quantity.columns();
  for (const StoredAxis& axis : quantity.axes) {
    if (axis.length == 0) return std::nullopt;
    stride /= axis.length;
    const auto wanted = place.find(axis.name);
    if (wanted == place.end()) {
      if (axis.name != "xyz" && axis.length != 1) return std::nullopt;
      source.count = axis.length;
      continue;
    }
    const auto label = std::find(axis.labels.begin(), axis.labels.end(), wanted->second);
    if (label == axis.labels.end()) return std::nullopt;
    source.column += stride * static_cast<std::size_t>(label - axis.labels.begin());
  }
  return source;
}

std::vector<Source> sourcesAt(const std::vector<ReportRun>& runs, const PlotQuantity& quantity,
                              const AxisLabels& place) {
  std::vector<Source> sources;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const StoredQuantity* stored = runs[r].reader.find(quantity.dataset);
    if (!stored || stored->row_axis != "time" || stored->rows != runs[r].times_s.size()) continue;
    if (const auto source = sourceAt(r, *stored, place)) sources.push_back(*source);
  }
  return sources;
}

std::vector<Plot> planPlots(const std::vector<ReportRun>& runs) {
  std::vector<Plot> plots;
  for (const PlotQuantity& quantity : plot_quantities) {
    const std::vector<std::string> each = labelsAlong(runs, quantity, quantity.each);
    if (quantity.several_only && each.size() < 2) continue;
    for (const std::string& label : each) {
      Plot plot{&quantity, label, {}};
      for (const std::string& variant : labelsAlong(runs, quantity, quantity.select)) {
        AxisLabels place;
        if (*quantity.each) place[quantity.each] = label;
        if (*quantity.select) place[quantity.select] = variant;
        std::vector<Source> sources = sourcesAt(runs, quantity, place);
        if (!sources.empty()) plot.variants.push_back({variant, std::move(sources)});
      }
      if (!plot.variants.empty()) plots.push_back(std::move(plot));
    }
  }
  return plots;
}

std::vector<double> valuesOf(const std::vector<ReportRun>& runs, const Source& source, PlotScale scale) {
  const std::vector<double> all = runs[source.run].reader.all(*source.quantity);
  const std::size_t columns = source.quantity->columns();
  std::vector<double> values(source.quantity->rows);
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double* first = &all[row * columns + source.column];
    double squares = 0;
    for (std::size_t i = 0; i < source.count; ++i) squares += first[i] * first[i];
    values[row] = source.count == 1 ? *first : std::sqrt(squares);
  }
  if (scale == PlotScale::length)
    for (double& value : values) value *= 1e3;
  if (scale == PlotScale::relative_percent && !values.empty()) {
    const double start = values.front();
    for (double& value : values) value = 100 * (value - start) / std::abs(start);
  }
  return values;
}

struct ShownUnit {
  double factor = 1;
  std::string name;
};

/// So that the largest value is at least one.
ShownUnit unitFor(const Plot& plot, double largest) {
  const std::string& stored = plot.variants.front().sources.front().quantity->units;
  const PlotScale scale = plot.quantity->scale;
  if (scale == PlotScale::length) return {1, "mm"};
  if (scale == PlotScale::relative_percent) return {1, "%"};
  if (scale == PlotScale::plain || !(largest > 0))
    return {1, stored == "1" ? "" : stored == "degree" ? "°" : stored};
  constexpr std::array<std::pair<double, const char*>, 7> prefixes = {
      {{1e-9, "G"}, {1e-6, "M"}, {1e-3, "k"}, {1, ""}, {1e3, "m"}, {1e6, "µ"}, {1e9, "n"}}};
  for (const auto& [factor, prefix] : prefixes)
    if (largest * factor >= 1) return {factor, prefix + stored};
  return {prefixes.back().first, prefixes.back().second + stored};
}

struct Curve {
  std::size_t run = 0;
  ThinnedSeries points;
};

PageJson curveJson(const Curve& curve, double factor) {
  PageJson rows = PageJson::array(), values = PageJson::array();
  std::size_t before = 0;
  for (const std::size_t row : curve.points.rows) {
    rows.push_back(row - before);
    before = row;
  }
  for (const double value : curve.points.values) values.push_back(shortNumber(value * factor));
  return {{"run", curve.run}, {"rows", rows}, {"values", values}};
}

/// What a plot shows, read and thinned out.
struct Content {
  std::vector<std::vector<Curve>> variants;
  std::vector<std::size_t> missing;  ///< runs without any value
  double largest = 0;
  std::size_t preferred = 0;  ///< the variant that moves most
};

Content readContent(const std::vector<ReportRun>& runs, const Plot& plot, std::size_t buckets) {
  Content content;
  double widest = 0;
  for (std::size_t v = 0; v < plot.variants.size(); ++v) {
    std::vector<Curve>& curves = content.variants.emplace_back();
    for (const Source& source : plot.variants[v].sources) {
      Curve curve{source.run, thinSeries(valuesOf(runs, source, plot.quantity->scale), buckets)};
      bool any = false;
      double width = 0;
      for (const double value : curve.points.values) {
        any = any || std::isfinite(value);
        if (std::isfinite(value)) width = std::max(width, std::abs(value));
      }
      content.largest = std::max(content.largest, width);
      if (width > widest) content.preferred = v;
      widest = std::max(widest, width);
      if (any)
        curves.push_back(std::move(curve));
      else if (std::find(content.missing.begin(), content.missing.end(), source.run) == content.missing.end())
        content.missing.push_back(source.run);
    }
  }
  return content;
}

/// Whether a common linear axis would hide the smaller runs.
bool areFarApart(const std::vector<Curve>& curves) {
  constexpr double far = 1000;
  double smallest = INFINITY, largest = 0;
  for (const Curve& curve : curves) {
    double most = 0;
    for (const double value : curve.points.values)
      if (value > most) most = value;
    smallest = std::min(smallest, most);
    largest = std::max(largest, most);
  }
  return smallest > 0 && largest > far * smallest;
}

std::string titleOf(const Plot& plot) {
  std::string title = plot.quantity->title;
  if (const std::size_t at = title.find("{}"); at != std::string::npos) title.replace(at, 2, plot.label);
  return title;
}

PageJson plotJson(const Plot& plot, const Content& content) {
  const ShownUnit unit = unitFor(plot, content.largest);
  PageJson variants = PageJson::array();
  bool any = false;
  for (std::size_t v = 0; v < plot.variants.size(); ++v) {
    PageJson series = PageJson::array();
    for (const Curve& curve : content.variants[v]) series.push_back(curveJson(curve, unit.factor));
    any = any || !series.empty();
    variants.push_back({{"label", plot.variants[v].label}, {"series", series}});
  }
  const bool zero = any && content.largest == 0;
  const PlotQuantity& quantity = *plot.quantity;
  const bool by_axis = std::string_view(quantity.select) == "xyz";
  return {{"id", quantity.dataset + (plot.label.empty() ? "" : "/" + plot.label)},
          {"section", quantity.section},
          {"title", titleOf(plot)},
          {"note", quantity.note},
          {"unit", unit.name},
          {"from_zero", quantity.scale != PlotScale::relative_percent},
          {"far_apart", quantity.may_be_log && areFarApart(content.variants.front())},
          {"select", quantity.select},
          {"preferred", by_axis ? content.preferred : 0},
          {"constant_zero", zero},
          {"missing", content.missing},
          {"variants", any && !zero ? variants : PageJson::array()}};
}

}  // namespace

PageJson plotsJson(const std::vector<ReportRun>& runs, std::size_t most_points) {
  const std::vector<Plot> plots = planPlots(runs);
  std::size_t series = 1;
  for (const Plot& plot : plots)
    for (const Variant& variant : plot.variants) series += variant.sources.size();
  constexpr std::size_t fewest = 60, most = 400;
  const std::size_t buckets = std::clamp(most_points / (2 * series), fewest, most);
  PageJson json = PageJson::array();
  for (const Plot& plot : plots) json.push_back(plotJson(plot, readContent(runs, plot, buckets)));
  return json;
}

}  // namespace fissure
