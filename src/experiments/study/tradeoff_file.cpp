#include "study/tradeoff_file.h"

#include <fmt/core.h>

#include <set>

#include "base/error.h"
#include "scenario/range_check.h"
#include "scenario/read_nested.h"
#include "study/tradeoff_points.h"
#include "text/scalars.h"

namespace fissure {

const std::vector<CatalogEntry>& studyDesigns() {
  static const std::vector<CatalogEntry> table = {
      {"star", "each axis by itself, the others at their first values"},
      {"grid", "every combination of the values of all axes"},
  };
  return table;
}

const std::vector<CatalogEntry>& errorMeasures() {
  static const std::vector<CatalogEntry> table = {
      {"rms", "root of the mean square over time"},
      {"worst", "the largest at any time"},
      {"peak", "of the two peaks, whenever they are"},
  };
  return table;
}

namespace {

void checkLadder(const YamlNode& node, StudyReference& reference) {
  checkAxisGroups({*node.find("ladder")}, {reference.ladder});
  const StudyPoints rungs = pointsOf(reference.ladder);
  if (rungs.values.size() < 3)
    failAt(node.find("ladder")->origin,
           fmt::format("reference.ladder has {} rungs, expected at least three: fewer tell no order",
                       rungs.values.size()));
  const bool own = !reference.sizes.empty();
  const Origin origin = node.find(own ? "sizes" : "ladder")->origin;
  for (std::size_t i = 0; !own && i < rungs.values.size(); ++i) {
    const std::optional<double> size = toReal(rungs.values[i].front());
    if (!size)
      failAt(origin, fmt::format("reference.ladder: {} is no number, expected reference.sizes",
                                 rungs.values[i].front()));
    reference.sizes.push_back(*size);
  }
  if (reference.sizes.size() != rungs.values.size())
    failAt(origin, fmt::format("reference.sizes has {} values, expected one for each of the {} rungs",
                               reference.sizes.size(), rungs.values.size()));
  for (std::size_t i = 0; i < reference.sizes.size(); ++i)
    if (!(reference.sizes[i] > 0) || (i > 0 && !(reference.sizes[i] < reference.sizes[i - 1])))
      failAt(origin,
             fmt::format("{}: {} after {}, expected sizes above 0 that fall from rung to rung{}",
                         own ? "reference.sizes" : "reference.ladder", formatReal(reference.sizes[i]),
                         i > 0 ? formatReal(reference.sizes[i - 1]) : "nothing", own ? "" : ", or sizes"));
}

void checkErrors(const YamlNode& node, std::vector<StudyError>& errors) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    StudyError& error = errors[i];
    const YamlNode& of = node.children[i];
    error.size = parseErrorSize(error.tolerance, error.quantity, of.find("tolerance")->origin);
    if (error.law && error.quantity != ErrorQuantity::force)
      failAt(of.find("law")->origin,
             fmt::format("a law for {}, expected it only for force", nameOf(error.quantity)));
    if (!seen.insert(nameOf(error.quantity)).second)
      failAt(of.origin, fmt::format("{} again, expected each quantity once", nameOf(error.quantity)));
  }
}

/// Coefficients of laws move nothing: such settings are one simulation.
void refuseLaws(const YamlNode& node, const AxisGroup& group) {
  for (const SweepAxis& axis : group.axes)
    if (axis.path.starts_with("force."))
      failAt(node.origin, fmt::format("{} is of a force law, which moves nothing, expected an axis that "
                                      "changes the simulation",
                                      axis.path));
}

}  // namespace

TradeoffStudy loadTradeoff(const std::filesystem::path& file) {
  TradeoffStudy study;
  study.source = readYamlFile(file);
  const YamlNode root = parseYaml(study.source, inFile(file, 1));
  if (root.kind == YamlNode::Kind::nothing) failAt(inFile(file, 1), "empty, expected a study");
  if (root.kind == YamlNode::Kind::map && !root.find("reference"))
    for (const auto& [key, what, verb] :
         {std::tuple{"bodies", "a scenario", "run"}, std::tuple{"tools", "a scenario", "run"},
          std::tuple{"axes", "a sweep", "sweep"}})
      if (const YamlNode* other = root.find(key))
        failAt(other->origin, fmt::format("{} (it has {} and no reference), expected a study; type: fissure "
                                          "{} {}",
                                          what, key, verb, file.string()));
  readValue(root, "", study);
  requireRanges(root, study);
  checkAxisGroups(root.find("axes")->children, study.axes);
  for (std::size_t i = 0; i < study.axes.size(); ++i)
    refuseLaws(root.find("axes")->children[i], study.axes[i]);
  refuseLaws(*root.find("reference"), study.reference.ladder);
  checkLadder(*root.find("reference"), study.reference);
  checkErrors(*root.find("errors"), study.errors);
  study.file = file;
  const std::filesystem::path parent = file.parent_path();
  study.directory = parent.empty() ? std::filesystem::path(".") : parent;
  return study;
}

KeyNode tradeoffKeys() {
  return keyTree<TradeoffStudy>("tradeoff");
}

}  // namespace fissure
