#include "main/shard.h"

#include <optional>

#include "base/error.h"
#include "text/scalars.h"

namespace fissure {

Shard parseShard(const std::string& text) {
  if (text.empty()) return {};
  const std::size_t slash = text.find('/');
  const std::optional<int> index = toInt(text.substr(0, slash));
  const std::optional<int> count = slash == std::string::npos ? std::nullopt : toInt(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *count < *index)
    throw InputError("--shard " + text + ": not a shard, expected I/N with I from 1 to N");
  return {static_cast<std::size_t>(*index), static_cast<std::size_t>(*count)};
}

}  // namespace fissure
