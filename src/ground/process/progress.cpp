#include "process/progress.h"

#include <fmt/core.h>

#include <charconv>

namespace fissure {

namespace {

std::optional<std::int64_t> takeNumber(std::string_view& text) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

}  // namespace

std::optional<Progress> parseProgress(std::string_view line) {
  constexpr std::string_view word = "progress ";
  if (!line.starts_with(word)) return std::nullopt;
  line.remove_prefix(word.size());
  const auto step = takeNumber(line);
  if (!step || !line.starts_with(' ')) return std::nullopt;
  line.remove_prefix(1);
  const auto steps = takeNumber(line);
  if (!steps || !line.empty() || *steps == 0 || *step > *steps) return std::nullopt;
  return Progress{*step, *steps};
}

std::string describe(const Progress& progress) {
  if (progress.step == 0) return "before its first step";
  return fmt::format("after step {} of {}", progress.step, progress.steps);
}

}  // namespace fissure
