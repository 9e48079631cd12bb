#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/report_run.h"

namespace fissure {

/// Numbers as the page's script reads them, four bytes each: {f32: base64, little endian}, missing ones NaN;
/// {same: number or null} where all are equal.
PageJson packedNumbers(const std::vector<double>& numbers);

/// Numbers from 0 to 65535, two bytes each: {u16: base64}.
PageJson packedCodes(const std::vector<std::size_t>& codes);

/// The texts of some runs by their places among the different ones of all, which keep the order of their
/// first appearance: {values: [text], codes: {u16}}. Texts that none of `runs` has are left out.
PageJson packedTexts(const std::vector<std::string>& all, const std::vector<std::size_t>& runs);

/// The same of numbers, ascending: {values: [number], codes: {u16}}; null where more than `most` differ.
PageJson packedLevels(const std::vector<double>& numbers, std::size_t most);

}  // namespace fissure
