#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fissure {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance).
int editDistance(std::string_view a, std::string_view b);

/// The name in `known` that is most like `given`: within an edit distance of about a third of its length, or
/// `given` with its unit added ("step_s" for "step"). Null when no name is that near.
const std::string* nearestName(std::string_view given, const std::vector<std::string>& known);

/// The end of an error message about an unknown name: `, did you mean "x"?` with nearestName(), otherwise `,
/// expected one of a, b, c`.
std::string didYouMean(std::string_view given, const std::vector<std::string>& known);

}  // namespace fissure
