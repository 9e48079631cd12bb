#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// Numbers packed for the page's script, four bytes each: {f32: base64, little endian}, with NaN for missing
/// ones; {same: number or null} where all are equal.
PageJson packedNumbers(const std::vector<double>& numbers);

/// Integers from 0 to 65535, two bytes each: {u16: base64}.
PageJson packedCodes(const std::vector<std::size_t>& codes);

/// The texts of `runs` as indices into the list of distinct texts: {values: [text], codes: {u16}}. `values`
/// are in the order of their first appearance in `all`, without texts that none of `runs` has.
PageJson packedTexts(const std::vector<std::string>& all, const std::vector<std::size_t>& runs);

/// The same for numbers, with ascending values: {values: [number], codes: {u16}}; null where there are more
/// than `most` distinct numbers.
PageJson packedLevels(const std::vector<double>& numbers, std::size_t most);

}  // namespace fissure
