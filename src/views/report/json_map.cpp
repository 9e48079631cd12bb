#include "report/json_map.h"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace fissure {

namespace {

constexpr int known_format_version = 1;
constexpr double most_counted = 1e6;

}  // namespace

void JsonMap::refuse(const char* key, const char* expected) const {
  const std::string found = map_->at(key).dump(-1, ' ', false, PageJson::error_handler_t::replace);
  throw InputError(fmt::format("\"{}\" is {}, expected {}", key, found.substr(0, 40), expected));
}

const PageJson& JsonMap::at(const char* key, const char* expected) const {
  if (!map_->is_object() || !map_->contains(key))
    throw InputError(fmt::format("missing \"{}\", expected {}", key, expected));
  return map_->at(key);
}

std::string JsonMap::text(const char* key, const char* expected) const {
  if (!at(key, expected).is_string()) refuse(key, expected);
  return at(key, expected).get<std::string>();
}

bool JsonMap::truth(const char* key) const {
  if (!at(key, "true or false").is_boolean()) refuse(key, "true or false");
  return at(key, "true or false").get<bool>();
}

std::size_t JsonMap::count(const char* key, const char* expected) const {
  const PageJson& entry = at(key, expected);
  const double value = entry.is_number_integer() ? entry.get<double>() : -1;
  if (value < 0 || value > most_counted) refuse(key, expected);
  return static_cast<std::size_t>(value);
}

double JsonMap::number(const char* key) const {
  const PageJson& entry = at(key, "a finite number");
  const double value = entry.is_number() ? entry.get<double>() : NAN;
  if (!std::isfinite(value)) refuse(key, "a finite number");
  return value;
}

PageJson JsonMap::numberOrNull(const char* key) const {
  const PageJson& entry = at(key, "a number or null");
  if (!entry.is_number() && !entry.is_null()) refuse(key, "a number or null");
  return entry.is_null() ? entry : shortNumber(entry.get<double>());
}

const PageJson& JsonMap::map(const char* key) const {
  if (!at(key, "a map").is_object()) refuse(key, "a map");
  return at(key, "a map");
}

const PageJson& JsonMap::list(const char* key) const {
  if (!at(key, "a list").is_array()) refuse(key, "a list");
  return at(key, "a list");
}

std::vector<std::string> JsonMap::texts(const char* key) const {
  std::vector<std::string> found;
  for (const PageJson& entry : list(key)) {
    if (!entry.is_string()) refuse(key, "a list of texts");
    found.push_back(entry.get<std::string>());
  }
  return found;
}

void JsonMap::each(const char* key, const std::function<void(const PageJson& entry)>& use) const {
  std::size_t index = 0;
  for (const PageJson& entry : list(key)) {
    try {
      use(entry);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}.{}: {}", key, index, error.text()));
    }
    ++index;
  }
}

void JsonMap::refuseOtherFormat(const char* format) const {
  const std::string expected = fmt::format("\"{}\"", format);
  const std::string found = text("format", expected.c_str());
  if (found != format) throw InputError(fmt::format("format is \"{}\", expected {}", found, expected));
  if (count("format_version", "1") > known_format_version)
    throw InputError(fmt::format("of a newer fissure, expected format_version {}", known_format_version));
}

}  // namespace fissure
