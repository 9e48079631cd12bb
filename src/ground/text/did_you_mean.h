#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance).
int editDistance(std::string_view a, std::string_view b);

/// The end of an error message: `, did you mean "x"?` for the known name nearest to `given`, where one is
/// near enough or is `given` with a forgotten unit ("step" for "step_s"); otherwise `, expected one of a, b,
/// c`.
std::string didYouMean(std::string_view given, const std::vector<std::string>& known);

}  // namespace fissure
