#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario/load.h"

namespace fissure {

/// A scenario that is `base` with one of its pipelines and these overrides, whole by itself, as the text of
/// the file `file`, which need not exist: names of other files start from its folder. It begins with
/// `comment`, lines without the sign. `expect` is left out. Throws InputError as loadScenario() does.
std::string recommendedText(const std::filesystem::path& base, const std::filesystem::path& file,
                            const std::string& pipeline, const std::vector<Override>& overrides,
                            const std::vector<std::string>& comment);

}  // namespace fissure
