#pragma once

#include "law/force_law.h"

namespace fissure {

// One entry per law, each in a file of its own; forceLaws() is their table.
ForceLawEntry huntCrossleyLaw();
ForceLawEntry kelvinVoigtLaw();
ForceLawEntry linearElasticLaw();
ForceLawEntry exponentialLaw();

}  // namespace fissure
