#include "scenario/pipeline_table.h"

#include <algorithm>
#include <vector>

#include "text/lists.h"

namespace fissure {

std::string pipelinesWith(std::initializer_list<ContactDetection> detections) {
  std::vector<std::string_view> names;
  for (const PipelineTraits& pipeline : pipeline_table)
    if (std::find(detections.begin(), detections.end(), pipeline.detection) != detections.end())
      names.push_back(pipeline.name);
  return withNoun("pipeline", names);
}

}  // namespace fissure
