#pragma once

#include <cstddef>
#include <string>

namespace fissure {

/// One of several shares of the simulations of a sweep, counted from 1.
struct Shard {
  std::size_t index = 1, count = 1;
};

/// Reads `--shard I/N`; an empty text is the only share. Throws InputError about any other text.
Shard parseShard(const std::string& text);

}  // namespace fissure
