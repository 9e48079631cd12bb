#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fissure {

/// Words separated by blanks in lines of at most 100 characters: the first line is indented by `indent`
/// blanks, the others by four more.
std::string wrappedText(const std::vector<std::string>& words, std::size_t indent);

}  // namespace fissure
