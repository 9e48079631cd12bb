#include "scenario/pipeline_table.h"

#include <algorithm>
#include <vector>

namespace fissure {

std::string pipelinesWith(std::initializer_list<ContactDetection> detections) {
  std::vector<std::string_view> names;
  for (const PipelineTraits& pipeline : pipeline_table)
    if (std::find(detections.begin(), detections.end(), pipeline.detection) != detections.end())
      names.push_back(pipeline.name);
  std::string text = names.size() == 1 ? "pipeline " : "pipelines ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

}  // namespace fissure
