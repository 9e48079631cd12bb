// How errors grow along the axes of a study.
#include <cmath>
#include <map>
#include <set>

#include "measure/statistics.h"
#include "study/tradeoff_result.h"
#include "text/scalars.h"

namespace fissure {

namespace {

/// The size that a value stands for: a subdivision halves the mesh. No value where it is no number above 0.
std::optional<double> sizeOf(const std::string& path, const std::string& value) {
  const std::optional<double> number = toReal(value);
  if (number && path.ends_with(".subdivisions")) return std::exp2(-*number);
  return number && *number > 0 ? number : std::nullopt;
}

struct OrderLine {
  std::vector<double> sizes, errors;
};

/// The lines of one pipeline along the group of axes with these places: [values of all other axes].
std::map<std::vector<std::string>, OrderLine> linesOf(const TradeoffResult& result,
                                                      const std::set<std::size_t>& group,
                                                      const std::string& pipeline, std::size_t error) {
  std::map<std::vector<std::string>, OrderLine> lines;
  const std::size_t first = *group.begin();
  for (const JudgedSetting& setting : result.settings) {
    if (setting.pipeline != pipeline) continue;
    const std::optional<double> size = sizeOf(result.paths[first], setting.values[first]);
    if (!size) continue;
    std::vector<std::string> others;
    for (std::size_t p = 0; p < setting.values.size(); ++p)
      if (!group.contains(p)) others.push_back(setting.values[p]);
    OrderLine& line = lines[others];
    line.sizes.push_back(*size);
    line.errors.push_back(setting.errors[error]);
  }
  return lines;
}

}  // namespace

std::vector<AxisOrder> ordersOf(const TradeoffStudy& study, const TradeoffResult& result) {
  std::vector<AxisOrder> orders;
  std::set<std::string> pipelines;
  for (const JudgedSetting& setting : result.settings) pipelines.insert(setting.pipeline);
  std::size_t next = 0;
  for (const AxisGroup& axes : study.axes) {
    std::set<std::size_t> group;
    for (std::size_t a = 0; a < axes.axes.size(); ++a) group.insert(next++);
    for (const std::string& pipeline : pipelines) {
      for (std::size_t error = 0; error < study.errors.size(); ++error) {
        const JudgedReference* reference = result.referenceOf(pipeline, error);
        if (!reference || !reference->refinement.refused.empty()) continue;
        std::vector<double> found;
        for (const auto& [others, line] : linesOf(result, group, pipeline, error))
          if (const ObservedOrder order = orderOf(line.sizes, line.errors, reference->refinement.error);
              std::isfinite(order.order))
            found.push_back(order.order);
        if (!found.empty())
          orders.push_back({result.paths[*group.begin()], pipeline, error, spreadOf(found), found.size()});
      }
    }
  }
  return orders;
}

}  // namespace fissure
