#include "study/stability_file.h"
#include "study/tradeoff_file.h"
#include "target.h"

namespace fissure::fuzz {

/// Both kinds of study files are read from any text.
void takeStudy(const std::string& bytes) {
  const std::filesystem::path file = put("fuzzed.yaml", bytes);
  const Refusal refusal = ofYaml(bytes);
  accepts(file, refusal, [&] {
    const StabilitySettings study = loadStability(file);
    require(!study.maps.empty() && study.refine_to > 0 && study.refine_to <= 1, "a study has maps");
    for (const StabilityMap& map : study.maps) {
      require(!study.baseOf(map).empty(), "a map has a scenario");
      study.pressOf(map);
    }
  });
  accepts(file, refusal, [&] {
    const TradeoffStudy study = loadTradeoff(file);
    require(study.source == bytes && !study.errors.empty() && study.repeats >= 1,
            "a study has errors to judge");
  });
}

}  // namespace fissure::fuzz
