#include "scenario/checker.h"

namespace fissure {

void checkPipeline(Checker check, const PipelineSettings& pipeline) {
  check.require(!pipeline.usesNodes() || !pipeline.ownGround() ||
                    pipeline.contactResponse() == ContactResponse::momentum,
                "ground_contact",
                "is half_space, expected bullet with response none, which carries no weight");
}

}  // namespace fissure
