#include "text/scalars.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

namespace fissure {

namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Removes and counts the digits in front.
std::size_t takeDigits(std::string_view& rest) {
  std::size_t count = 0;
  while (count < rest.size() && isDigit(rest[count])) ++count;
  rest.remove_prefix(count);
  return count;
}

bool takeSign(std::string_view& rest) {
  const bool sign = !rest.empty() && (rest[0] == '-' || rest[0] == '+');
  if (sign) rest.remove_prefix(1);
  return sign;
}

bool isNonFinite(std::string_view rest) {
  takeSign(rest);
  if (!rest.empty() && rest[0] == '.') rest.remove_prefix(1);
  std::string lower(rest);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

/// std::from_chars takes no plus sign.
std::string_view withoutPlus(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  return text;
}

template <class Number>
std::optional<Number> convert(const std::string& plain) {
  const std::string_view text = withoutPlus(plain);
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string inQuotes(const std::string& text, std::size_t most) {
  if (text.size() <= most) return '"' + text + '"';
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;
  return '"' + text.substr(0, end) + "...\"";
}

ScalarKind scalarKind(const std::string& plain) {
  if (plain == "true" || plain == "false") return ScalarKind::truth;
  if (isNonFinite(plain)) return ScalarKind::non_finite;
  std::string_view rest = plain;
  takeSign(rest);
  const bool zero_first = !rest.empty() && rest[0] == '0';
  const std::size_t whole = takeDigits(rest);
  const bool point = !rest.empty() && rest[0] == '.';
  if (point) rest.remove_prefix(1);
  const std::size_t fraction = point ? takeDigits(rest) : 0;
  if (whole + fraction == 0) return ScalarKind::text;
  bool exponent = false;
  if (!rest.empty() && (rest[0] == 'e' || rest[0] == 'E')) {
    exponent = true;
    rest.remove_prefix(1);
    takeSign(rest);
    if (takeDigits(rest) == 0) return ScalarKind::text;
  }
  if (!rest.empty()) return ScalarKind::text;
  if (zero_first && whole > 1) return ScalarKind::leading_zero;
  return point || exponent ? ScalarKind::real : ScalarKind::integer;
}

std::optional<double> toReal(const std::string& plain) {
  return convert<double>(plain);
}

std::optional<int> toInt(const std::string& plain) {
  return convert<int>(plain);
}

std::string formatReal(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  static_cast<void>(error);  // the shortest form of a double has at most 24 characters
  return {buffer, end};
}

std::string formatText(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '.' || c == '/' || c == '-';
  };
  const bool letter_first =
      !text.empty() && (std::isalpha(static_cast<unsigned char>(text[0])) || text[0] == '_');
  const bool null_word = text == "null" || text == "Null" || text == "NULL";
  if (letter_first && std::all_of(text.begin(), text.end(), plain) && !null_word &&
      scalarKind(text) == ScalarKind::text) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else if (c == '\t') {
      quoted += "\\t";
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace fissure
