#include "study/study_command.h"

#include <fmt/core.h>

namespace fissure {

namespace {

/// As a shell reads it back.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

std::string runCommand(const std::filesystem::path& scenario, const std::string& pipeline,
                       const std::vector<Override>& overrides) {
  std::string text = fmt::format("fissure run {} --pipeline {} --no-frames",
                                 quoted(scenario.generic_string()), quoted(pipeline));
  for (const Override& change : overrides) text += " --set " + quoted(change.path + "=" + change.value);
  return text;
}

}  // namespace fissure
