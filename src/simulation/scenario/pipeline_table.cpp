#include "scenario/pipeline_table.h"

#include <algorithm>
#include <vector>

#include "text/lists.h"
#include "text/scalars.h"

namespace fissure {

std::string pipelinesWith(std::initializer_list<ContactDetection> detections) {
  std::vector<std::string_view> names;
  for (const PipelineTraits& pipeline : pipeline_table)
    if (std::find(detections.begin(), detections.end(), pipeline.detection) != detections.end())
      names.push_back(pipeline.name);
  return withNoun("pipeline", names);
}

std::string nodeDefault(std::string (*textOf)(const PipelineTraits&)) {
  std::string text;
  for (const PipelineTraits& pipeline : pipeline_table) {
    if (pipeline.detection != ContactDetection::nodes) continue;
    text.append(text.empty() ? "" : ", ").append(pipeline.name).append(" ").append(textOf(pipeline));
  }
  return text;
}

std::string tuningDefault(double BulletTuning::*value) {
  const auto text = [&](const BulletTuning& stock, const BulletTuning& tuned) {
    return "stock " + formatReal(stock.*value) + ", tuned " + formatReal(tuned.*value);
  };
  const std::string usual = text(stock_tuning, fine_tuning),
                    deformable = text(stock_deformable_tuning, fine_tuning);
  if (stock_deformable_tuning.*value == 0 || deformable == usual) return usual;
  return usual + " (" + pipelinesWith({ContactDetection::volume}) + ": " + deformable + ")";
}

}  // namespace fissure
