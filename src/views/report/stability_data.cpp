#include "report/stability_data.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "base/error.h"
#include "report/json_map.h"
#include "table/sweep_names.h"
#include "text/scalars.h"

namespace fissure {

namespace {

constexpr std::size_t most_axes_of_map = 2;

/// The classes of a study, and how many cells have each.
struct StudyClasses {
  std::vector<std::string> names, meanings;
  std::vector<std::size_t> cells;

  std::size_t find(const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError(fmt::format("class \"{}\" is none of the study's classes", name));
    return static_cast<std::size_t>(found - names.begin());
  }
};

/// An axis of a panel, along which values have places.
struct PanelAxis {
  std::string path, scale;
  std::vector<std::string> multiplies, grid;

  double placeOf(const std::string& value) const {
    if (scale == "values") {
      const auto found = std::find(grid.begin(), grid.end(), value);
      if (found == grid.end()) throw InputError(fmt::format("{} is no value of axis {}", value, path));
      return static_cast<double>(found - grid.begin());
    }
    const std::optional<double> number = toReal(value);
    if (!number || (scale == "logarithmic" && *number <= 0))
      throw InputError(fmt::format("{} has no place on axis {}, which is {}", value, path, scale));
    return *number;
  }
};

PanelAxis axisOf(const PageJson& json) {
  const JsonMap entry(json);
  PanelAxis axis{entry.text("path"), entry.text("scale"), entry.texts("multiplies"), entry.texts("grid")};
  const std::vector<std::string> known = {"values", "linear", "logarithmic"};
  if (std::find(known.begin(), known.end(), axis.scale) == known.end())
    throw InputError(fmt::format("scale is \"{}\", expected values, linear or logarithmic", axis.scale));
  return axis;
}

/// The values of the first of two axes from below: numbers ascending, then texts. One row for a single axis.
std::vector<std::string> rowsOf(const std::vector<std::vector<std::string>>& points, std::size_t axes) {
  if (axes < most_axes_of_map) return {""};
  std::vector<std::string> rows;
  for (const std::vector<std::string>& point : points)
    if (std::find(rows.begin(), rows.end(), point[0]) == rows.end()) rows.push_back(point[0]);
  const auto key = [](const std::string& text) {
    const std::optional<double> number = toReal(text);
    return std::tuple(!number.has_value(), number.value_or(0), text);
  };
  std::sort(rows.begin(), rows.end(),
            [&](const std::string& a, const std::string& b) { return key(a) < key(b); });
  return rows;
}

std::size_t rowOf(const std::vector<std::string>& rows, const std::vector<std::string>& others) {
  if (others.empty()) return 0;
  const auto found = std::find(rows.begin(), rows.end(), others[0]);
  if (found == rows.end()) throw InputError(fmt::format("{} is no value of the first axis", others[0]));
  return static_cast<std::size_t>(found - rows.begin());
}

PageJson cellData(const PageJson& json, const std::vector<std::string>& values, const PanelAxis& last,
                  StudyClasses& classes) {
  const JsonMap cell(json);
  PageJson data = {
      {"x", last.placeOf(values.back())},      {"values", values}, {"round", cell.count("round")},
      {"wall_s", cell.numberOrNull("wall_s")}, {"class", nullptr}, {"command", cell.text("command")}};
  if (!cell.at("class", "a class or null").is_null()) {
    const std::size_t found = classes.find(cell.text("class"));
    ++classes.cells[found];
    data["class"] = found;
    data["reason"] = cell.text("reason");
  }
  if (json.contains("frequency_Hz")) data["frequency_Hz"] = cell.numberOrNull("frequency_Hz");
  if (json.contains("result")) data["result"] = cell.text("result");
  return data;
}

/// `middle` is where cells are added between the two: the geometric mean of numbers above 0.
PageJson boundaryData(const PageJson& json, const std::vector<std::string>& rows, const PanelAxis& last,
                      const StudyClasses& classes) {
  const JsonMap boundary(json);
  const double below = boundary.number("below"), above = boundary.number("above");
  if (last.scale == "values" || !(below < above) || (last.scale == "logarithmic" && below <= 0))
    throw InputError(
        fmt::format("between {} and {}, which is no part of a {} axis", below, above, last.scale));
  const std::vector<std::string> others = boundary.texts("others");
  if (others.empty() != (rows == std::vector<std::string>{""}))
    throw InputError("\"others\" is not the value of the first of two axes");
  return {{"row", rowOf(rows, others)},
          {"x", shortNumber(below > 0 ? std::sqrt(below) * std::sqrt(above) : (below + above) / 2)},
          {"below", below},
          {"above", above},
          {"class_below", classes.find(boundary.text("class_below"))},
          {"class_above", classes.find(boundary.text("class_above"))}};
}

PageJson panelData(const PageJson& json, StudyClasses& classes) {
  const JsonMap panel(json);
  std::vector<PanelAxis> axes;
  panel.each("axes", [&](const PageJson& axis) { axes.push_back(axisOf(axis)); });
  if (axes.empty() || axes.size() > most_axes_of_map)
    throw InputError(fmt::format("has {} axes, expected one or two", axes.size()));
  std::vector<std::vector<std::string>> points;
  panel.each("cells", [&](const PageJson& cell) {
    points.push_back(JsonMap(cell).texts("values"));
    if (points.back().size() != axes.size())
      throw InputError(fmt::format("has {} values, expected {}", points.back().size(), axes.size()));
  });
  const std::vector<std::string> rows = rowsOf(points, axes.size());
  PageJson cells = PageJson::array(), boundaries = PageJson::array(), axes_data = PageJson::array();
  panel.each("cells", [&](const PageJson& cell) {
    const std::vector<std::string>& values = points[cells.size()];
    PageJson data = cellData(cell, values, axes.back(), classes);
    data["row"] = axes.size() < most_axes_of_map ? 0 : rowOf(rows, values);
    cells.push_back(std::move(data));
  });
  panel.each("boundaries", [&](const PageJson& boundary) {
    boundaries.push_back(boundaryData(boundary, rows, axes.back(), classes));
  });
  std::vector<std::string> paths;
  for (const PanelAxis& axis : axes) paths.push_back(axis.path);
  const std::vector<std::string> names = sweepAxisNames(paths, {});
  for (std::size_t a = 0; a < axes.size(); ++a)
    axes_data.push_back({{"path", axes[a].path},
                         {"name", names[a]},
                         {"multiplies", axes[a].multiplies},
                         {"scale", axes[a].scale},
                         {"grid", axes[a].grid}});
  return {{"map", panel.text("map")},
          {"description", panel.text("description")},
          {"pipeline", panel.text("pipeline")},
          {"axes", axes_data},
          {"rows", rows},
          {"cells", cells},
          {"boundaries", boundaries}};
}

}  // namespace

PageJson stabilityData(const PageJson& study) {
  const JsonMap root(study);
  root.refuseOtherFormat("fissure-stability");
  StudyClasses classes;
  root.each("classes", [&](const PageJson& entry) {
    classes.names.push_back(JsonMap(entry).text("name"));
    classes.meanings.push_back(JsonMap(entry).text("means"));
  });
  classes.cells.resize(classes.names.size());
  PageJson panels = PageJson::array(), classes_data = PageJson::array();
  root.each("panels", [&](const PageJson& panel) { panels.push_back(panelData(panel, classes)); });
  for (std::size_t c = 0; c < classes.names.size(); ++c)
    classes_data.push_back(
        {{"name", classes.names[c]}, {"means", classes.meanings[c]}, {"cells", classes.cells[c]}});
  return {{"name", root.text("name")},
          {"description", root.text("description")},
          {"refine_to", root.number("refine_to")},
          {"criteria", root.map("criteria")},
          {"classes", classes_data},
          {"panels", panels}};
}

}  // namespace fissure
