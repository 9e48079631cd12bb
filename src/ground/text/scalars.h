#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace fissure {

/// The text in double quotes, for messages: its whole characters within the first `most` bytes, and "..."
/// where it is longer. Nothing is escaped.
std::string inQuotes(const std::string& text, std::size_t most = 120);

/// The kind of value that a plain (unquoted) YAML scalar has.
enum class ScalarKind {
  text,
  integer,       ///< -12
  real,          ///< 0.5, 1e-3
  truth,         ///< true, false
  leading_zero,  ///< 010: eight for some readers of YAML, ten for others
  non_finite,    ///< .nan, .inf, nan, inf ...
};

/// The kind of an unquoted scalar.
ScalarKind scalarKind(const std::string& plain);

/// The value of an integer or real scalar; nothing where a double cannot hold it (1e999, 1e-999).
std::optional<double> toReal(const std::string& plain);

/// The value of an integer scalar; nothing where an int cannot hold it.
std::optional<int> toInt(const std::string& plain);

/// The shortest text that reads back to the same double.
std::string formatReal(double value);

/// `text` as a YAML scalar that reads back as this text: plain where that is safe, in double quotes
/// otherwise.
std::string formatText(const std::string& text);

}  // namespace fissure
